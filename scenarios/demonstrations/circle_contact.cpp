// A circle against a circle and against a polygon (thesis figures 4.3 and 4.4), special cases included.

#include <algorithm>

#include "engine/collide.h"
#include "scenarios/demonstrations/algorithms.h"
#include "scenarios/demonstrations/shape_pair.h"

namespace proofreel {
namespace {

constexpr const char* heading_of_circles = "Circle and circle";
constexpr const char* heading_of_polygon = "Circle and polygon";

/// What both films end with: how deep, and the normal at the contact point.
void show_contact(Storyboard& board, const Manifold& manifold, double depth, double arrow_length) {
  const Vec2d normal(manifold.normal);
  const auto at = Vec2d(manifold.points[0].point);
  board.show(labelled(arrow_mark(Role::result, at, at + arrow_length * normal), normal, "n"));
  board.show(path_mark(Role::alert, {at - 0.5 * depth * normal, at + 0.5 * depth * normal}));
  board.show(labelled(dot_mark(Role::alert, at), perp(normal), "d"));
}

class Circles {
 public:
  explicit Circles(const Demonstration& asked)
      : first_(asked.shapes[0].parts[0][0]),
        second_(asked.shapes[1].parts[0][0]),
        first_radius_(asked.shapes[0].radius),
        second_radius_(asked.shapes[1].radius),
        board_(asked.pace) {
    board_.pane("");
    board_.heading(heading_of_circles);
    board_.keep(shape_mark(Role::first, asked.shapes[0]));
    board_.keep(shape_mark(Role::second, asked.shapes[1]));
  }

  Story tell(const Manifold& manifold) {
    const double apart = distance(first_, second_);
    const std::string sum = figure(first_radius_ + second_radius_);
    show_centres();
    board_.step("Two circles overlap when their centres are nearer than the sum of their radii.", 3);
    show_centres();
    board_.show(path_mark(Role::candidate, {first_, second_}));
    board_.step(
        filled("$|\\vec{S_1S_2}| = %$ and $r_1 + r_2 = %$: %",
               {figure(apart), sum, apart < first_radius_ + second_radius_ ? "they overlap." : "they are apart."}),
        4);
    if (manifold.count == 0) return board_.finish();
    const double depth = -static_cast<double>(manifold.points[0].separation);
    show_centres();
    show_contact(board_, manifold, depth, first_radius_);
    board_.step(
        apart > 0
            ? filled("The normal points from $S_1$ to $S_2$, the depth is $d = r_1 + r_2 \u2212 |\\vec{S_1S_2}| = %$.",
                     {figure(depth)})
            : filled(
                  "$S_1 = S_2$: every way out is as short. Any normal will do, here $n = %$, and $d = r_1 + r_2 = %$.",
                  {figure(Vec2d(manifold.normal), 0), figure(depth)}),
        5);
    return board_.finish();
  }

 private:
  void show_centres() {
    const Vec2d aside = towards(second_, first_);
    board_.show(path_mark(Role::first, {first_, first_ + first_radius_ * aside}));
    board_.show(text_mark(Role::first, first_ + 0.5 * first_radius_ * aside, perp(aside), "$r_1$"));
    const Vec2d other = first_ == second_ ? perp(aside) : -aside;
    board_.show(path_mark(Role::second, {second_, second_ + second_radius_ * other}));
    board_.show(text_mark(Role::second, second_ + 0.5 * second_radius_ * other, perp(other), "$r_2$"));
    board_.show(labelled(dot_mark(Role::first, first_), {0, -1}, first_ == second_ ? "$S_1 = S_2$" : "$S_1$"));
    if (!(first_ == second_)) board_.show(labelled(dot_mark(Role::second, second_), {0, -1}, "$S_2$"));
  }

  Vec2d first_;
  Vec2d second_;
  double first_radius_;
  double second_radius_;
  Storyboard board_;
};

class CircleAndPolygon {
 public:
  explicit CircleAndPolygon(const Demonstration& asked)
      : centre_(asked.shapes[0].parts[0][0]),
        radius_(asked.shapes[0].radius),
        corners_(asked.shapes[1].parts[0]),
        board_(asked.pace) {
    board_.pane("");
    board_.heading(heading_of_polygon);
    board_.keep(shape_mark(Role::second, asked.shapes[1]));
    board_.keep(shape_mark(Role::first, asked.shapes[0]));
    board_.keep(labelled(dot_mark(Role::first, centre_), {0, 1}, "S"));
    board_.step("Which edge is the centre $S$ farthest in front of? Measure along the normal of every edge.", 3);
  }

  void tell(const AxisTested& axis) {
    const std::size_t edge = tested_++;
    const double in_front = axis.separation + radius_;
    if (edge == 0 || in_front > best_distance_) {
      best_ = edge;
      best_distance_ = in_front;
      normal_ = axis.axis;
    }
    show_edge(edge, Role::candidate);
    const Vec2d foot = centre_ - in_front * axis.axis;
    show_line_to(foot, edge);
    board_.show(arrow_mark(Role::candidate, foot, centre_));
    board_.step(filled("Edge %: $S$ is $%$ m in front of it%",
                       {figure(edge + 1), figure(in_front), best_ == edge ? ", the most so far." : "."}));
  }

  Story finish(const Manifold& manifold) {
    if (manifold.count == 0) {
      show_edge(best_, Role::chosen);
      board_.step(filled("$S$ is at least $%$ m away and the radius is $%$ m: they do not touch.",
                         {figure(best_distance_), figure(radius_)}),
                  5);
      return board_.finish();
    }
    tell_region(manifold);
    const double depth = -static_cast<double>(manifold.points[0].separation);
    show_contact(board_, manifold, depth, radius_);
    board_.step(filled("The normal is $n = %$ from the circle to the polygon, the depth $d = %$ m.",
                       {figure(Vec2d(manifold.normal)), figure(depth)}),
                5);
    return board_.finish();
  }

 private:
  /// In front of an edge, beyond one of its ends, or inside.
  void tell_region(const Manifold& manifold) {
    const bool on_edge = dot(Vec2d(manifold.normal), normal_) < -1 + 1e-12;
    show_edge(best_, Role::chosen);
    show_region();
    const std::string where =
        best_distance_ <= 0 ? "$S$ is inside: the nearest edge is the way out."
        : on_edge           ? "$S$ is in front of this edge: the normal is that of the edge."
                            : "$S$ is beyond the end of this edge: the corner is nearest, and the normal leads to it.";
    board_.step(where, 4);
    show_edge(best_, Role::chosen);
  }

  /// The lines that part what is in front of the edge from what is beyond its ends.
  void show_region() {
    for (const Vec2d end : {corners_[best_], corners_[(best_ + 1) % corners_.size()]})
      board_.show(path_mark(Role::quiet, {end, end + 1.6 * radius_ * normal_}));
  }

  /// From the nearer end of the edge to a foot on the line of the edge, where that lies beyond it.
  void show_line_to(Vec2d foot, std::size_t edge) {
    const Vec2d from = corners_[edge], to = corners_[(edge + 1) % corners_.size()];
    const double along = dot(foot - from, to - from) / dot(to - from, to - from);
    if (along < 0 || along > 1) board_.show(path_mark(Role::quiet, {along < 0 ? from : to, foot}));
  }

  void show_edge(std::size_t edge, Role role) {
    board_.show(path_mark(role, {corners_[edge], corners_[(edge + 1) % corners_.size()]}));
  }

  Vec2d centre_;
  double radius_;
  std::vector<Vec2d> corners_;
  Storyboard board_;
  std::size_t tested_ = 0;
  std::size_t best_ = 0;
  double best_distance_ = 0;
  Vec2d normal_;
};

}  // namespace

Story tell_circle_contact(const Demonstration& demonstration) {
  const Hull circle = hull_of(demonstration.shapes[0]);
  const Hull other = hull_of(demonstration.shapes[1]);
  if (other.count == 1) return Circles(demonstration).tell(collide(circle, Pose{}, other, Pose{}, 0));
  CircleAndPolygon story(demonstration);
  return story.finish(collide(circle, Pose{}, other, Pose{}, 0, telling(story)));
}

}  // namespace proofreel
