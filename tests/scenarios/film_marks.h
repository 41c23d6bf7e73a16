#pragma once

/// What the tests on lecture films share: shapes, stories, and the marks of a step.

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "scenarios/demonstration.h"

namespace proofreel::films {

using Points = std::vector<Vec2d>;

inline DemonstrationShape polygon_of(const Points& points) {
  DemonstrationShape shape;
  shape.parts = {points};
  return shape;
}

inline DemonstrationShape box_at(Vec2d at, double width, double height) {
  const double x = 0.5 * width, y = 0.5 * height;
  return polygon_of({{at.x - x, at.y - y}, {at.x + x, at.y - y}, {at.x + x, at.y + y}, {at.x - x, at.y + y}});
}

inline DemonstrationShape disc_at(Vec2d at, double radius) {
  DemonstrationShape shape;
  shape.parts = {{at}};
  shape.radius = radius;
  return shape;
}

inline Story told(const Demonstration& asked) {
  REQUIRE_FALSE(problem_with(asked));
  return story_of(asked);
}

inline Story told(Algorithm algorithm, const Points& points) { return told({algorithm, points, {}, 1, {}}); }

inline Story told(Algorithm algorithm, const std::vector<DemonstrationShape>& shapes) {
  return told({algorithm, {}, shapes, 1, {}});
}

inline std::vector<StoryMark> marks_of(const Step& step, MarkKind kind, Role role, int pane = 0) {
  std::vector<StoryMark> found;
  for (const StoryMark& mark : step.marks) {
    if (mark.kind == kind && mark.role == role && mark.pane == pane) found.push_back(mark);
  }
  return found;
}

inline const StoryMark* mark_called(const Step& step, MarkKind kind, const std::string& key) {
  const auto found = std::find_if(step.marks.begin(), step.marks.end(),
                                  [&](const StoryMark& mark) { return mark.kind == kind && mark.key == key; });
  return found == step.marks.end() ? nullptr : &*found;
}

inline const Step& step_saying(const Story& story, const std::string& words) {
  const auto found = std::find_if(story.steps.begin(), story.steps.end(),
                                  [&](const Step& step) { return step.caption.find(words) != std::string::npos; });
  REQUIRE(found != story.steps.end());
  return *found;
}

/// The way an arrow or the first piece of a path goes.
inline Vec2d tip(const StoryMark& arrow) { return arrow.points[1] - arrow.points[0]; }

/// The length of a bar in its diagram, whose full width is 1.
inline double bar_length(const Step& step, int pane, const std::string& key) {
  for (const StoryMark& mark : step.marks) {
    if (mark.kind == MarkKind::bar && mark.pane == pane && mark.key == key) return mark.points[1].x - mark.points[0].x;
  }
  return 0;
}

inline DemonstrationShape block_of(double friction_at_rest, double sliding) {
  DemonstrationShape block = box_at({0, 0}, 1.6, 0.8);
  block.friction = {friction_at_rest, sliding};
  return block;
}

inline const std::vector<DemonstrationShape> parts{box_at({-1.6, 0}, 0.8, 2.6), box_at({0.4, -0.9}, 3.2, 0.8),
                                                   disc_at({2.4, 0.2}, 0.7)};

}  // namespace proofreel::films
