#include "scenarios/demonstrations/storyboard.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>

#include "engine/pose.h"

namespace proofreel {
namespace {

StoryMark mark_of(MarkKind kind, Role role, std::vector<Vec2d> points) {
  StoryMark mark;
  mark.kind = kind;
  mark.role = role;
  mark.points = std::move(points);
  return mark;
}

/// A side of zero would show nothing.
Aabbd with_area(const Aabbd& bounds) {
  const Vec2d size = bounds.upper - bounds.lower;
  return expanded(bounds, std::max(0.02 * std::max(size.x, size.y), 1e-9));
}

}  // namespace

StoryMark shape_mark(Role role, const DemonstrationShape& shape, std::size_t part) {
  StoryMark mark = mark_of(MarkKind::shape, role, shape.parts[part]);
  mark.radius = shape.radius;
  return mark;
}

StoryMark region_mark(Role role, std::vector<Vec2d> points) {
  return mark_of(MarkKind::region, role, std::move(points));
}

StoryMark bar_mark(Role role, std::vector<Vec2d> points) { return mark_of(MarkKind::bar, role, std::move(points)); }

std::vector<StoryMark> shape_marks(Role role, const DemonstrationShape& shape, int group) {
  std::vector<StoryMark> marks;
  for (std::size_t i = 0; i < shape.parts.size(); ++i) {
    marks.push_back(shape_mark(role, shape, i));
    if (shape.parts.size() > 1) marks.back().group = group;
  }
  return marks;
}

StoryMark path_mark(Role role, std::vector<Vec2d> points) { return mark_of(MarkKind::path, role, std::move(points)); }

StoryMark closed_path(Role role, std::vector<Vec2d> points) {
  points.push_back(points.front());
  return path_mark(role, std::move(points));
}

StoryMark arrow_mark(Role role, Vec2d from, Vec2d to) { return mark_of(MarkKind::arrow, role, {from, to}); }

StoryMark dot_mark(Role role, Vec2d at) { return mark_of(MarkKind::dot, role, {at}); }

StoryMark origin_mark(Vec2d at) { return mark_of(MarkKind::crosswise, Role::quiet, {at}); }

StoryMark text_mark(Role role, Vec2d at, Vec2d side, std::string text) {
  return labelled(mark_of(MarkKind::text, role, {at}), side, std::move(text));
}

StoryMark box_mark(Role role, const Aabbd& box) {
  return closed_path(role, {box.lower, {box.upper.x, box.lower.y}, box.upper, {box.lower.x, box.upper.y}});
}

StoryMark labelled(StoryMark mark, Vec2d side, std::string text) {
  mark.side = side;
  mark.text = std::move(text);
  return mark;
}

StoryMark keyed(StoryMark mark, std::string key) {
  mark.key = std::move(key);
  return mark;
}

StoryMark in_pane(StoryMark mark, int pane) {
  mark.pane = pane;
  return mark;
}

int Storyboard::pane(std::string title, double share, bool diagram) {
  story_.panes.push_back({std::move(title), diagram, share, {}});
  return static_cast<int>(story_.panes.size()) - 1;
}

void Storyboard::step(std::string caption, double paces) {
  Step step{heading_, std::move(caption), counters_, kept_, paces * pace_};
  step.marks.insert(step.marks.end(), shown_.begin(), shown_.end());
  shown_.clear();
  story_.steps.push_back(std::move(step));
}

Story Storyboard::finish() {
  for (const Step& step : story_.steps) {
    for (const StoryMark& mark : step.marks) {
      Aabbd& bounds = story_.panes[static_cast<std::size_t>(mark.pane)].bounds;
      bounds = merged(bounds, expanded(bounds_of(mark.points), mark.radius));
    }
  }
  Aabbd world;
  for (const Pane& pane : story_.panes) world = pane.diagram ? world : merged(world, pane.bounds);
  for (Pane& pane : story_.panes) pane.bounds = with_area(shares_bounds_ && !pane.diagram ? world : pane.bounds);
  return std::move(story_);
}

std::string figure(double value, int decimals) {
  std::array<char, 400> buffer{};
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals);
  std::string text(buffer.data(), end.ptr);
  if (text.front() != '-') return text;
  const bool zero = text.find_first_of("123456789") == std::string::npos;
  return text.replace(0, 1, zero ? "" : "\u2212");
}

std::string figure(std::size_t count) { return std::to_string(count); }

std::string figure(Vec2d v, int decimals) {
  return filled("(%,\u2009%)", {figure(v.x, decimals), figure(v.y, decimals)});
}

std::string filled(std::string_view pattern, std::initializer_list<std::string> values) {
  std::string text;
  const std::string* value = values.begin();
  for (const char c : pattern) {
    if (c == '%') {
      text += *value++;
    } else {
      text += c;
    }
  }
  assert(value == values.end());
  return text;
}

std::string letter(std::size_t index) { return std::string(1, static_cast<char>('A' + static_cast<int>(index % 26))); }

DemonstrationShape turned(DemonstrationShape shape, Vec2d about, double angle) {
  const Posed pose{about, Rotd(angle)};
  for (std::vector<Vec2d>& part : shape.parts) {
    for (Vec2d& p : part) p = to_world(pose, p - about);
  }
  return shape;
}

Vec2d middle_of(const std::vector<Vec2d>& points) {
  Vec2d sum;
  for (const Vec2d p : points) sum += p;
  return 1.0 / static_cast<double>(points.size()) * sum;
}

Vec2d towards(Vec2d from, Vec2d to) {
  const Vec2d way = normalized(to - from);
  return way == Vec2d{} ? Vec2d{0, 1} : way;
}

Aabbd bounds_of(const std::vector<Vec2d>& points) {
  Aabbd bounds;
  for (const Vec2d p : points) bounds = merged(bounds, p);
  return bounds;
}

double extent_of(const std::vector<Vec2d>& points) {
  const Aabbd bounds = bounds_of(points);
  return std::max(bounds.upper.x - bounds.lower.x, bounds.upper.y - bounds.lower.y);
}

}  // namespace proofreel
