// Separating axes (thesis figure 4.5): both shapes projected on the normal of every edge, the shortest way out kept.
// A normal points one way, so what counts is how far the other shape begins before its own ends.

#include <algorithm>

#include "engine/collide.h"
#include "scenarios/demonstrations/algorithms.h"
#include "scenarios/demonstrations/bars.h"
#include "scenarios/demonstrations/shape_pair.h"

namespace proofreel {
namespace {

/// A line along `direction` that passes beside both shapes.
struct AxisLine {
  Vec2d direction;
  Vec2d across;  ///< away from the shapes
  double offset = 0;
  Vec2d at(double along, double further = 0) const { return along * direction + (offset + further) * across; }
};

class Axes {
 public:
  explicit Axes(const Demonstration& asked)
      : a_(asked.shapes[0].parts[0]), b_(asked.shapes[1].parts[0]), board_(asked.pace) {
    points_ = a_;
    points_.insert(points_.end(), b_.begin(), b_.end());
    unit_ = extent_of(points_);
    board_.pane("");
    bars_ = board_.pane("way out along each axis", 0.4, true);
    board_.heading("Separating axes");
    keep_pair(board_, asked);
  }

  void begin() {
    show_overlaps();
    board_.step("Do A and B overlap? If not, some edge normal separates them: try the normal of every edge.", 3);
  }

  void tell(const AxisTested& axis) {
    tested_.push_back(axis);
    const std::size_t current = tested_.size() - 1;
    if (axis.separation > tested_[least_].separation) least_ = current;
    show_axis(axis, current);
    show_edge(axis);
    show_overlaps(current);
    board_.step(caption(axis, current));
  }

  void tell(const AxisChosen& chosen) {
    const auto is_chosen = [&](const AxisTested& t) { return t.of_a == chosen.of_a && t.axis == chosen.axis; };
    least_ = static_cast<std::size_t>(std::find_if(tested_.begin(), tested_.end(), is_chosen) - tested_.begin());
  }

  Story finish(const Manifold& manifold) {
    if (manifold.count == 0) return finish_apart();
    const Vec2d normal(manifold.normal);
    const double depth = -tested_[least_].separation;
    show_axis(tested_[least_], least_);
    for (int i = 0; i < manifold.count; ++i) {
      const auto at = Vec2d(manifold.points[i].point);
      const auto inside = -static_cast<double>(manifold.points[i].separation);
      board_.show(arrow_mark(Role::alert, at, at + inside * normal));
      board_.show(dot_mark(Role::alert, at));
    }
    show_overlaps();
    board_.step(filled("No axis separates them. The shortest way out is along $%$: the normal from A to B is $n = %$, "
                       "the depth $%$ m.",
                       {name(least_), figure(normal), figure(depth)}),
                4);
    return board_.finish();
  }

 private:
  std::string caption(const AxisTested& axis, std::size_t current) const {
    const double end = axis.of_a ? axis.interval_a[1] : axis.interval_b[1];
    const double begin = axis.of_a ? axis.interval_b[0] : axis.interval_a[0];
    const std::string where =
        filled("Along $%$ % ends at $%$ and % begins at $%$: ",
               {name(current), axis.of_a ? "A" : "B", figure(end), axis.of_a ? "B" : "A", figure(begin)});
    if (axis.separation > 0) return filled("%a gap of $%$ m.", {where, figure(axis.separation)});
    const std::string way_out = filled("a way out of $%$ m", {figure(-axis.separation)});
    return where + way_out + (least_ == current ? ", the shortest so far." : ".");
  }

  Story finish_apart() {
    show_axis(tested_[least_], least_);
    show_overlaps();
    board_.step(filled("$%$ separates them: a gap of $%$ m. One such axis is enough, A and B do not touch.",
                       {name(least_), figure(tested_[least_].separation)}),
                4);
    return board_.finish();
  }

  /// Below the shapes, or where it is upright on their right.
  AxisLine line_of(Vec2d direction) const {
    AxisLine line{direction, perp(direction), 0};
    if (line.across.y > 1e-9 || (std::abs(line.across.y) <= 1e-9 && line.across.x < 0)) line.across = -line.across;
    for (const Vec2d p : points_) line.offset = std::max(line.offset, dot(line.across, p - points_[0]));
    line.offset += dot(line.across, points_[0]) + 0.12 * unit_;
    return line;
  }

  void show_axis(const AxisTested& axis, std::size_t number) {
    const AxisLine line = line_of(axis.axis);
    const double low = std::min(axis.interval_a[0], axis.interval_b[0]);
    const double high = std::max(axis.interval_a[1], axis.interval_b[1]);
    show_projection(line, a_);
    show_projection(line, b_);
    board_.show(arrow_mark(Role::candidate, line.at(low - 0.06 * unit_), line.at(high + 0.12 * unit_)));
    board_.show(
        text_mark(Role::candidate, line.at(high + 0.12 * unit_), line.direction, filled("$%$", {name(number)})));
    show_interval(line, Role::first, axis.interval_a, 0.025);
    show_interval(line, Role::second, axis.interval_b, 0.075);
    const double nearest = axis.of_a ? axis.interval_b[0] : axis.interval_a[0];
    const double farthest = axis.of_a ? axis.interval_a[1] : axis.interval_b[1];
    if (farthest > nearest) show_interval(line, Role::alert, {nearest, farthest}, -0.025);
  }

  /// The edge whose normal the axis is.
  void show_edge(const AxisTested& axis) {
    const std::vector<Vec2d>& corners = axis.of_a ? a_ : b_;
    std::size_t best = 0;
    const auto middle = [&](std::size_t i) { return 0.5 * (corners[i] + corners[(i + 1) % corners.size()]); };
    for (std::size_t i = 1; i < corners.size(); ++i) {
      if (dot(axis.axis, middle(i)) > dot(axis.axis, middle(best))) best = i;
    }
    board_.show(path_mark(Role::candidate, {corners[best], corners[(best + 1) % corners.size()]}));
    board_.show(arrow_mark(Role::candidate, middle(best), middle(best) + 0.12 * unit_ * axis.axis));
  }

  /// Lines from the two outermost corners down to the axis.
  void show_projection(const AxisLine& line, const std::vector<Vec2d>& corners) {
    const auto further = [&](Vec2d p, Vec2d q) { return dot(p, line.direction) < dot(q, line.direction); };
    const auto [low, high] = std::minmax_element(corners.begin(), corners.end(), further);
    for (const Vec2d p : {*low, *high})
      board_.show(path_mark(Role::quiet, {p, line.at(dot(p, line.direction), 0.1 * unit_)}));
  }

  void show_interval(const AxisLine& line, Role role, std::array<double, 2> interval, double further) {
    const double near = (further - 0.02) * unit_;
    const double far = (further + 0.02) * unit_;
    board_.show(bar_mark(role, {line.at(interval[0], near), line.at(interval[1], near), line.at(interval[1], far),
                                line.at(interval[0], far)}));
  }

  void show_overlaps(std::size_t current = SIZE_MAX) {
    std::vector<Bar> bars;
    for (std::size_t i = 0; i < a_.size() + b_.size(); ++i) {
      if (i >= tested_.size()) {
        bars.push_back({Role::quiet, 0, filled("$%$", {name(i)}), ""});
        continue;
      }
      const double overlap = -tested_[i].separation;
      const Role role = i == least_ ? Role::chosen : i == current ? Role::candidate : Role::rejected;
      const std::string value = overlap < 0 ? filled("gap %", {figure(-overlap)}) : figure(overlap);
      bars.push_back({role, overlap, filled("$%$: %", {name(i), value}), ""});
    }
    board_.counters({{"axes", figure(tested_.size())}});
    show_bars(board_, bars_, bars, unit_);
  }

  std::string name(std::size_t axis) const {
    return axis < a_.size() ? filled("a_{%}", {std::to_string(axis + 1)})
                            : filled("b_{%}", {std::to_string(axis - a_.size() + 1)});
  }

  std::vector<Vec2d> a_;
  std::vector<Vec2d> b_;
  Storyboard board_;
  std::vector<Vec2d> points_;
  double unit_ = 1;
  int bars_ = 0;
  std::vector<AxisTested> tested_;
  std::size_t least_ = 0;
};

}  // namespace

Story tell_separating_axes(const Demonstration& demonstration) {
  Axes axes(demonstration);
  axes.begin();
  return axes.finish(
      collide(hull_of(demonstration.shapes[0]), Pose{}, hull_of(demonstration.shapes[1]), Pose{}, 0, telling(axes)));
}

}  // namespace proofreel
