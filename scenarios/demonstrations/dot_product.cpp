// The dot product (thesis figures 2.1 and 2.2, equations 2.5 to 2.7) as a projection, and what its sign tells: what
// lies in front, within a field of view, and nearest in a direction.

#include <algorithm>
#include <numbers>

#include "engine/elementary.h"
#include "scenarios/demonstrations/algorithms.h"
#include "scenarios/demonstrations/turning.h"

namespace proofreel {
namespace {

constexpr double half_field = 0.25 * std::numbers::pi;  // 45 degrees to each side

double product(Vec2d a, Vec2d b) { return dot(a, b); }

class Shadow {
 public:
  explicit Shadow(const Demonstration& asked)
      : a_(asked.points[0]), board_(asked.pace), turning_(board_, a_, asked.points[1], product, "\u00b7") {
    board_.pane("");
    board_.pane("", 0.55, true);
    board_.keep(origin_mark({0, 0}));
    for (std::size_t i = 2; i < asked.points.size(); ++i) points_.push_back({asked.points[i], 0, "", Role::first});
    for (const LookedAt& point : points_) reach_ = std::max(reach_, 1.1 * length(point.at));
    reach_ = std::max(reach_, 1.2 * length(a_));
    for (const LookedAt& point : points_) largest_ = std::max(largest_, std::abs(dot(point.at, a_)));
  }

  Story tell() {
    tell_projection();
    board_.counters({});
    tell_front();
    tell_field();
    tell_nearest();
    return board_.finish();
  }

 private:
  void tell_projection() {
    board_.heading("Dot product: the length of a shadow");
    const Vec2d b = turning_.given_b();
    const std::string longest = figure(length(a_) * length(b));
    const auto more = [this](Vec2d now) { show_shadow(now); };
    turning_.begin(
        filled("$\\vec{a} \u00b7 \\vec{b} = a_x b_x + a_y b_y = %$. Light square to $\\vec{a}$ gives $\\vec{b}$ a "
               "shadow on its line. The product is $|\\vec{a}|$ times how long that is.",
               {figure(dot(a_, b))}),
        more);
    turning_.turn(
        {{"Below 90\u00b0 the shadow falls along $\\vec{a}$: the product is positive.",
          "Beyond 90\u00b0 the shadow falls the other way: the product is negative.",
          "Farther round, the shadow gets shorter again; still it falls the other way.",
          "Below 90\u00b0 on the other side: the cosine is even, and the product positive again."},
         {"$\u03b1 = 90\u00b0$: no shadow. The dot product of vectors that stand square to each other is 0.",
          filled(
              "$\u03b1 = 180\u00b0$, the least there is: $\\vec{a} \u00b7 \\vec{b} = \u2212|\\vec{a}| |\\vec{b}| = %$",
              {figure(-length(a_) * length(b))}),
          "$\u03b1 = 270\u00b0$ is square again: 0.",
          filled("The same direction, the most there is: $\\vec{a} \u00b7 \\vec{b} = |\\vec{a}| |\\vec{b}| "
                 "cos\u2009\u03b1 "
                 "= |\\vec{a}| |\\vec{b}| = %$",
                 {longest})}},
        more);
  }

  void show_shadow(Vec2d b) {
    const Vec2d unit = normalized(a_);
    const Vec2d foot = dot(b, unit) * unit;
    const Vec2d across = perp(unit);
    const double thick = 0.035 * length(a_);
    if (length(foot) > 1e-9 * length(b)) {
      const Role role = dot(a_, b) > 0 ? Role::result : Role::alert;
      board_.show(keyed(
          bar_mark(role, {-thick * across, foot - thick * across, foot - 3 * thick * across, -3 * thick * across}),
          "shadow"));
    }
    board_.show(keyed(path_mark(Role::quiet, {b, foot}), "ray"));
    board_.show(
        keyed(path_mark(Role::quiet, {std::min(0.0, dot(b, unit)) * unit, std::max(length(a_), dot(b, unit)) * unit}),
              "line"));
  }

  void show_eye(double half_angle) {
    board_.show(sector_mark(Role::chosen, normalized(a_), reach_, half_angle));
    show_vector(board_, Role::chosen, {}, a_, "f", -1);
    board_.show(text_mark(Role::first, -0.12 * a_, {}, "Q"));
  }

  void tell_front() {
    board_.heading("In front or behind?");
    show_eye(2 * half_field);
    show_looked_at(board_, points_);
    board_.step("Somebody at $Q$ looks along $\\vec{f}$, which was $\\vec{a}$. Which points lie in front?", 4);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      LookedAt& point = points_[i];
      const double here = dot(point.at, a_);
      take_product(point);
      point.role = here > 0 ? Role::result : Role::alert;
      show_eye(2 * half_field);
      board_.show(keyed(arrow_mark(Role::candidate, {}, point.at), "look"));
      show_looked_at(board_, points_);
      board_.step(filled("$\\vec{Q%} \u00b7 \\vec{f} = %%",
                         {point_name(i), point.value,
                          here > 0   ? filled(" > 0$: $%$ is in front.", {point_name(i)})
                          : here < 0 ? filled(" < 0$: $%$ is behind.", {point_name(i)})
                                     : filled("$: $%$ is neither in front nor behind.", {point_name(i)})}),
                  3);
    }
  }

  /// Its bar is the product, beside the largest there is.
  void take_product(LookedAt& point) const {
    const double here = dot(point.at, a_);
    point.part = largest_ > 0 ? here / largest_ : 0;
    point.value = figure(here);
  }

  /// Its bar is the cosine, so that the lengths of the vectors do not matter.
  void take_cosine(LookedAt& point) const {
    point.part = dot(point.at, a_) / (length(point.at) * length(a_));
    point.value = figure(point.part);
  }

  void tell_field() {
    board_.heading("Within the field of view?");
    const double limit = elementary::cos(half_field);
    std::size_t seen = 0;
    for (LookedAt& point : points_) {
      take_cosine(point);
      const bool sees = point.part > limit;
      seen += sees ? 1 : 0;
      point.role = sees ? Role::result : Role::rejected;
    }
    show_eye(half_field);
    show_looked_at(board_, points_, limit);
    board_.step(filled("45\u00b0 to each side: $P$ is seen when $\\vec{QP} \u00b7 \\vec{f} > |\\vec{QP}| |\\vec{f}| "
                       "cos\u200945\u00b0$. The bars are cosines now: % of % reach beyond the second line.",
                       {figure(seen), figure(points_.size())}),
                6);
  }

  void tell_nearest() {
    board_.heading("Nearest in a direction");
    const LookedAt* nearest = nullptr;
    for (LookedAt& point : points_) {
      take_product(point);
      point.role = point.part > 0 ? Role::first : Role::rejected;
      if (point.part > 0 && (nearest == nullptr || dot(point.at, a_) < dot(nearest->at, a_))) nearest = &point;
    }
    show_eye(2 * half_field);
    if (nearest == nullptr) {
      show_looked_at(board_, points_);
      board_.step("No product is positive: nothing lies in front.", 5);
      return;
    }
    const auto index = static_cast<std::size_t>(nearest - points_.data());
    points_[index].role = Role::result;
    const Vec2d foot = dot(nearest->at, normalized(a_)) * normalized(a_);
    board_.show(path_mark(Role::candidate, {nearest->at, foot}));
    show_looked_at(board_, points_);
    board_.step(filled("The least of the positive products is $%$: along $\\vec{f}$, $%$ is the nearest. Support "
                       "functions look for the farthest in the same way.",
                       {nearest->value, point_name(index)}),
                6);
  }

  Vec2d a_;
  Storyboard board_;
  Turning turning_;
  std::vector<LookedAt> points_;
  double reach_ = 0;
  double largest_ = 0;  ///< product with a_, without its sign
};

}  // namespace

Story tell_dot_product(const Demonstration& demonstration) { return Shadow(demonstration).tell(); }

}  // namespace proofreel
