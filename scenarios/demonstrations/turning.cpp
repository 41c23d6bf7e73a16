#include "scenarios/demonstrations/turning.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/elementary.h"
#include "engine/rot.h"

namespace proofreel {
namespace {

constexpr double quarter = 0.5 * std::numbers::pi;

double quarters_from(Vec2d a, Vec2d b) {
  const double angle = elementary::atan2(cross(a, b), dot(a, b));
  return (angle < 0 ? angle + 4 * quarter : angle) / quarter;
}

Vec2d turned_by(Vec2d v, double quarters) {
  const double whole = std::floor(quarters);
  for (int i = 0; i < static_cast<int>(whole); ++i) v = perp(v);
  return quarters == whole ? v : rotate(Rotd((quarters - whole) * quarter), v);
}

}  // namespace

Turning::Turning(Storyboard& board, Vec2d a, Vec2d b, Product product, std::string sign)
    : board_(board),
      a_(a),
      length_b_(length(b)),
      start_(quarters_from(a, b)),
      product_(product),
      sign_(std::move(sign)),
      drawn_to_(start_) {}

Vec2d Turning::b_at(double quarters) const { return length_b_ / length(a_) * turned_by(a_, quarters); }

void Turning::begin(const std::string& caption, const ShowMore& more) {
  show(start_, more);
  board_.step(caption, 5);
}

void Turning::turn(const TurningWords& words, const ShowMore& more) {
  for (int i = static_cast<int>(start_); i < 4; ++i) {
    const double from = std::max(start_, static_cast<double>(i));
    const double way = i + 1 - from;
    const int steps = std::max(1, static_cast<int>(24 * way));
    const auto at = static_cast<std::size_t>(i);
    board_.glide(words.underway[at], 3.6 * way, steps, [&](double part) { show(from + part * way, more); });
    show(i + 1, more);
    board_.step(words.arrived[at], 4);
  }
}

void Turning::show(double quarters, const ShowMore& more) {
  const Vec2d b = b_at(quarters);
  more(b);
  show_angle(quarters);
  show_vector(board_, Role::first, {}, a_, "a", -1);
  show_vector(board_, Role::second, {}, b, "b", 1);
  show_curve(quarters);
  board_.counters(
      {{"\u03b1", filled("%\u00b0", {figure(90 * quarters, 0)})}, {filled("a % b", {sign_}), figure(product_(a_, b))}});
}

/// An arc from a to b with its name in the middle.
void Turning::show_angle(double quarters) {
  constexpr int pieces = 32;
  const double radius = 0.3 * std::min(length(a_), length_b_);
  const Vec2d way = radius / length(a_) * a_;
  std::vector<Vec2d> arc;
  for (int i = 0; i <= pieces; ++i) arc.push_back(turned_by(way, quarters * i / pieces));
  board_.show(keyed(path_mark(Role::quiet, arc), "arc"));
  board_.show(keyed(text_mark(Role::quiet, 1.4 * turned_by(way, 0.5 * quarters), {}, "$\u03b1$"), "alpha"));
}

double Turning::height_of_curve(double quarters) const {
  return product_(a_, b_at(quarters)) / (length(a_) * length_b_);
}

/// In pieces: those that were there before stay as they are.
void Turning::show_curve(double quarters) {
  if (quarters > drawn_to_) {
    const std::vector<Vec2d> piece{{drawn_to_, height_of_curve(drawn_to_)}, {quarters, height_of_curve(quarters)}};
    curve_.push_back(in_pane(path_mark(Role::chosen, piece), curve_pane));
    drawn_to_ = quarters;
  }
  const std::string title = filled("$\\vec{a} % \\vec{b}$ over $\u03b1$", {sign_});
  board_.show(in_pane(text_mark(Role::quiet, {0, 1.3}, {1, 0}, title), curve_pane));
  board_.show(in_pane(text_mark(Role::quiet, {4, 1.3}, {-1, 0}, "$|\\vec{a}| |\\vec{b}|$"), curve_pane));
  for (const double y : {-1.0, 0.0, 1.0}) board_.show(in_pane(path_mark(Role::quiet, {{0, y}, {4, y}}), curve_pane));
  for (int i = 0; i <= 4; ++i) {
    board_.show(in_pane(path_mark(Role::quiet, {{i * 1.0, -1}, {i * 1.0, 1}}), curve_pane));
    board_.show(in_pane(text_mark(Role::quiet, {i * 1.0, -1.03}, {0, -1}, filled("%\u00b0", {figure(90.0 * i, 0)})),
                        curve_pane));
  }
  for (const StoryMark& piece : curve_) board_.show(piece);
  const double height = height_of_curve(quarters);
  const Role role = height < 0 ? Role::alert : Role::result;
  board_.show(in_pane(keyed(path_mark(role, {{quarters, 0}, {quarters, height}}), "height"), curve_pane));
  board_.show(in_pane(keyed(dot_mark(role, {quarters, height}), "now"), curve_pane));
}

void show_vector(Storyboard& board, Role role, Vec2d from, Vec2d to, const std::string& name, double side) {
  board.show(keyed(arrow_mark(role, from, to), name));
  const Vec2d way = to - from;
  const Vec2d beyond = to + 0.08 * way + 0.12 * side * perp(way);
  board.show(keyed(text_mark(role, beyond, {}, filled("$\\vec{%}$", {name})), name));
}

StoryMark sector_mark(Role role, Vec2d middle, double radius, double half_angle) {
  constexpr int pieces = 14;
  std::vector<Vec2d> points{{0, 0}};
  for (int i = 0; i <= pieces; ++i)
    points.push_back(radius * rotate(Rotd(half_angle * (2.0 * i / pieces - 1)), middle));
  return region_mark(role, points);
}

std::string point_name(std::size_t index) { return filled("P_{%}", {figure(index + 1)}); }

void show_looked_at(Storyboard& board, const std::vector<LookedAt>& points, double limit) {
  const double row = 2.2 / static_cast<double>(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const LookedAt& point = points[i];
    const std::string name = point_name(i);
    board.show(labelled(keyed(dot_mark(point.role, point.at), name), towards({}, point.at), filled("$%$", {name})));
    const double top = 1.1 - row * static_cast<double>(i);
    const double end = 2 + 2 * point.part;
    const auto box = {Vec2d{2, top - 0.85 * row}, Vec2d{end, top - 0.85 * row}, Vec2d{end, top - 0.5 * row},
                      Vec2d{2, top - 0.5 * row}};
    if (point.part != 0) board.show(in_pane(keyed(bar_mark(point.role, box), name), curve_pane));
    const std::string text = filled("$%$%%", {name, point.value.empty() ? "" : ": ", point.value});
    board.show(in_pane(text_mark(point.value.empty() ? Role::quiet : Role::first, {0, top - 0.28 * row}, {1, 0}, text),
                       curve_pane));
  }
  for (const double x : {2.0, 2 + 2 * limit})
    board.show(in_pane(path_mark(Role::quiet, {{x, -1.1}, {x, 1.1}}), curve_pane));
  for (const double x : {0.0, 4.0}) board.show(in_pane(path_mark(Role::quiet, {{x, -1.1}, {x, -1.1}}), curve_pane));
}

}  // namespace proofreel
