// The cross product in the plane (thesis figure 2.3, equation 2.10): the signed area of a parallelogram, and on which
// side of a line a point lies.

#include <algorithm>

#include "engine/predicates.h"
#include "scenarios/demonstrations/algorithms.h"
#include "scenarios/demonstrations/turning.h"

namespace proofreel {
namespace {

double product(Vec2d a, Vec2d b) { return cross(a, b); }

class SignedArea {
 public:
  explicit SignedArea(const Demonstration& asked)
      : a_(asked.points[0]), board_(asked.pace), turning_(board_, a_, asked.points[1], product, "\u00d7") {
    board_.pane("");
    board_.pane("", 0.55, true);
    board_.keep(origin_mark({0, 0}));
    for (std::size_t i = 2; i < asked.points.size(); ++i) points_.push_back({asked.points[i], 0, "", Role::first});
    reach_ = length(a_);
    for (const LookedAt& point : points_) {
      reach_ = std::max(reach_, length(point.at));
      largest_ = std::max(largest_, std::abs(cross(a_, point.at)));
    }
  }

  Story tell() {
    tell_area();
    board_.counters({});
    tell_sides();
    return board_.finish();
  }

 private:
  void tell_area() {
    board_.heading("Cross product: a signed area");
    const Vec2d b = turning_.given_b();
    const double largest = length(a_) * length(b);
    const auto more = [this](Vec2d now) { show_area(now); };
    turning_.begin(filled("$\\vec{a} \u00d7 \\vec{b} = a_x b_y \u2212 a_y b_x = %$: in the plane a number, the signed "
                          "area of the parallelogram on $\\vec{a}$ and $\\vec{b}$.",
                          {figure(cross(a_, b))}),
                   more);
    turning_.turn(
        {{"$\\vec{b}$ is counter-clockwise of $\\vec{a}$: the area is positive, and grows up to 90\u00b0.",
          "Beyond 90\u00b0 the area gets smaller again. It stays positive: $\\vec{b}$ is on the left of $\\vec{a}$.",
          "Now $\\vec{b}$ is on the right of $\\vec{a}$: the same areas again, but negative.",
          "On the right all the way round to $\\vec{a}$: negative, and smaller and smaller."},
         {filled("$\u03b1 = 90\u00b0$: a rectangle, the largest area there is. $\\vec{a} \u00d7 \\vec{b} = |\\vec{a}| "
                 "|\\vec{b}| sin\u2009\u03b1 = |\\vec{a}| |\\vec{b}| = %$",
                 {figure(largest)}),
          "$\u03b1 = 180\u00b0$: nothing is left of the parallelogram. The cross product of parallel vectors is 0.",
          filled("$\u03b1 = 270\u00b0$: $\\vec{a} \u00d7 \\vec{b} = \u2212|\\vec{a}| |\\vec{b}| = %$. Changing places "
                 "changes the sign: $\\vec{b} \u00d7 \\vec{a} = \u2212\\vec{a} \u00d7 \\vec{b}$.",
                 {figure(-largest)}),
          "Back on $\\vec{a}$: 0. Where the dot product is largest the cross product is 0, and the other way round."}},
        more);
  }

  void show_area(Vec2d b) {
    const double area = cross(a_, b);
    if (std::abs(area) > 1e-9 * length(a_) * length(b)) {
      const Role role = area > 0 ? Role::result : Role::alert;
      board_.show(keyed(region_mark(role, {{0, 0}, a_, a_ + b, b}), "area"));
    }
    board_.show(keyed(path_mark(Role::quiet, {a_, a_ + b, b}), "far sides"));
  }

  void show_line() {
    const Vec2d way = reach_ * normalized(a_);
    board_.show(path_mark(Role::quiet, {-way, way}));
    show_vector(board_, Role::chosen, {}, a_, "a", -1);
    board_.show(text_mark(Role::first, 0.08 * reach_ * -perp(normalized(a_)), {}, "O"));
  }

  void tell_sides() {
    board_.heading("On which side of a line?");
    show_line();
    show_looked_at(board_, points_);
    board_.step(
        "A line through $O$ along $\\vec{a}$. The sign of $\\vec{a} \u00d7 \\vec{OP}$ tells on which side of it "
        "$P$ lies.",
        4);
    for (std::size_t i = 0; i < points_.size(); ++i) tell_side(i);
    show_line();
    show_looked_at(board_, points_);
    const auto on_left = std::count_if(points_.begin(), points_.end(), [](const LookedAt& p) { return p.part > 0; });
    board_.step(filled("% of % on the left. Convex hulls, convexity and triangle areas all rest on this one test.",
                       {figure(static_cast<std::size_t>(on_left)), figure(points_.size())}),
                5);
  }

  void tell_side(std::size_t index) {
    LookedAt& point = points_[index];
    const double area = orientation({0, 0}, a_, point.at);  // exact in its sign, as everywhere in the engine
    point.part = largest_ > 0 ? std::clamp(area / largest_, -1.0, 1.0) : 0;
    point.value = figure(area);
    point.role = area > 0 ? Role::result : area < 0 ? Role::alert : Role::chosen;
    show_line();
    if (area != 0) board_.show(region_mark(point.role, {{0, 0}, a_, point.at}));
    board_.show(keyed(arrow_mark(Role::candidate, {}, point.at), "look"));
    show_looked_at(board_, points_);
    const std::string name = point_name(index);
    board_.step(filled("$\\vec{a} \u00d7 \\vec{O%} = %%", {name, point.value,
                                                           area > 0   ? filled(" > 0$: $%$ is on the left.", {name})
                                                           : area < 0 ? filled(" < 0$: $%$ is on the right.", {name})
                                                                      : filled("$: $%$ is on the line.", {name})}),
                3);
  }

  Vec2d a_;
  Storyboard board_;
  Turning turning_;
  std::vector<LookedAt> points_;
  double reach_ = 0;
  double largest_ = 0;  ///< area with a_, without its sign
};

}  // namespace

Story tell_cross_product(const Demonstration& demonstration) { return SignedArea(demonstration).tell(); }

}  // namespace proofreel
