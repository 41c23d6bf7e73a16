// The centre of mass (thesis figures 3.1 and 3.2, equations 3.1 and 3.2): two masses on a beam and where it balances,
// then a body put together shape by shape. All masses and centres are those of engine/mass.h.

#include <algorithm>
#include <cmath>

#include "scenarios/demonstrations/algorithms.h"
#include "scenarios/demonstrations/bars.h"
#include "scenarios/demonstrations/weighed.h"

namespace proofreel {
namespace {

/// To two digits: figures of it and of its half are exact.
double rounded(double length) {
  double digit = 1;
  while (digit > 0.1 * length) digit *= 0.1;
  while (digit < 0.01 * length) digit *= 10;
  return digit * std::floor(length / digit);
}

class Balance {
 public:
  explicit Balance(const Demonstration& asked) : asked_(asked), masses_(weighed(asked)), board_(asked.pace) {
    board_.pane("");
    bars_ = board_.pane("", 0.5, true);
    for (const DemonstrationShape& shape : asked.shapes)
      bounds_ = merged(bounds_, expanded(bounds_of(shape.parts[0]), shape.radius));
    unit_ = rounded(0.5 * (bounds_.upper.x - bounds_.lower.x + bounds_.upper.y - bounds_.lower.y));
  }

  Story tell() {
    tell_beam();
    tell_body();
    return board_.finish();
  }

 private:
  /// The first shape's mass at the left end, and at the right one a mass that grows to four times as much.
  void tell_beam() {
    board_.heading("Centre of mass: two masses on a beam");
    const double m = masses_[0].mass;
    show_beam(m, m);
    board_.step("Two equal masses on a weightless beam: it balances in the middle.", 4);
    board_.glide(
        "While one mass grows, the point of balance moves towards it: $m_1\u2009l_1 = m_2\u2009l_2$ all the time.", 6,
        60, [&](double part) { show_beam(m, m * (1 + 3 * part)); });
    const Vec2d center = show_beam(m, 4 * m);
    board_.step(filled("$x_{com} = \\frac{m_1 x_1 + m_2 x_2}{m_1 + m_2}$, measured from the left end: $\\frac{% \u00b7 "
                       "0 + % \u00b7 %}{%} = "
                       "%$ m",
                       {figure(m), figure(4 * m), figure(unit_), figure(5 * m), figure(center.x - end_of_beam(-1).x)}),
                7);
  }

  Vec2d end_of_beam(int side) const {
    const Vec2d middle = center(bounds_);
    return middle + Vec2d{0.5 * side * unit_, 0};
  }

  /// Discs have areas by their masses. Returns the point of balance.
  Vec2d show_beam(double left, double right) {
    const Vec2d from = end_of_beam(-1), to = end_of_beam(1);
    const std::vector<MassProperties> both{{left, from, 0}, {right, to, 0}};
    const Vec2d balance = combined(both).center;
    for (std::size_t i = 0; i < 2; ++i) {
      const double radius = 0.07 * unit_ * std::sqrt(both[i].mass / masses_[0].mass);
      const Vec2d at = both[i].center + Vec2d{0, radius};
      DemonstrationShape disc{{{at}}, radius};
      board_.show(keyed(shape_mark(i == 0 ? Role::first : Role::second, disc), numbered("m", i)));
      board_.show(
          keyed(text_mark(Role::first, at + Vec2d{0, radius + 0.06 * unit_}, {}, filled("$%$", {numbered("m", i)})),
                numbered("m", i)));
    }
    board_.show(path_mark(Role::chosen, {from, to}));
    board_.show(keyed(region_mark(Role::result, {balance, balance + Vec2d{-0.06 * unit_, -0.12 * unit_},
                                                 balance + Vec2d{0.06 * unit_, -0.12 * unit_}}),
                      "wedge"));
    board_.show(keyed(dot_mark(Role::result, balance), "balance"));
    const Vec2d down{0, -0.2 * unit_};
    for (std::size_t i = 0; i < 2; ++i) {
      const Vec2d end = both[i].center;
      const std::string name = numbered("l", i);
      board_.show(keyed(path_mark(Role::quiet, {end + down, balance + down}), name));
      board_.show(keyed(text_mark(Role::first, 0.5 * (end + balance) + 1.3 * down, {}, filled("$%$", {name})), name));
    }
    show_moments(both, balance);
    return balance;
  }

  void show_moments(const std::vector<MassProperties>& both, Vec2d balance) {
    std::vector<Bar> bars;
    const auto arm = [&](std::size_t i) { return std::abs(both[i].center.x - balance.x); };
    for (std::size_t i = 0; i < 2; ++i) {
      bars.push_back({i == 0 ? Role::first : Role::second, both[i].mass / (4 * masses_[0].mass),
                      filled("$%$: % kg", {numbered("m", i), figure(both[i].mass)}), numbered("m", i)});
    }
    for (std::size_t i = 0; i < 2; ++i)
      bars.push_back(
          {Role::chosen, arm(i) / unit_, filled("$%$: % m", {numbered("l", i), figure(arm(i))}), numbered("l", i)});
    for (std::size_t i = 0; i < 2; ++i) {
      const double moment = both[i].mass * arm(i);
      bars.push_back({Role::result, moment / (masses_[0].mass * unit_),
                      filled("$%\u2009%$: % kg\u2009m", {numbered("m", i), numbered("l", i), figure(moment)}),
                      filled("moment %", {figure(i)})});
    }
    show_bars(board_, bars_, bars, 1);
  }

  void tell_body() {
    board_.heading("Centre of mass: a body put together");
    show_parts(0);
    board_.step("Now shapes of one body. Each acts as if its mass sat in its own centre $C_i$.", 4);
    for (std::size_t count = 1; count <= masses_.size(); ++count) tell_added(count);
    show_parts(masses_.size());
    const MassProperties whole = combined(masses_);
    board_.step(filled("$C = \\frac{1}{M} \u2211 m_i C_i = %$ with $M = \u2211 m_i = %$ kg",
                       {figure(whole.center), figure(whole.mass)}),
                6);
    show_parts(masses_.size());
    board_.step("Gravity acts on the whole body in $C$. That need not lie in any of its shapes.", 4);
  }

  void tell_added(std::size_t count) {
    const MassProperties& added = masses_[count - 1];
    const MassProperties so_far = combined(std::span(masses_).first(count));
    show_parts(count);
    const std::string part = filled("$%$ = % kg in $%$ = %", {numbered("m", count - 1), figure(added.mass),
                                                              numbered("C", count - 1), figure(added.center)});
    board_.step(
        count == 1 ? part + ": alone it is the whole body, and $C = C_1$."
                   : filled("%: $C$ moves towards $%$, to %.", {part, numbered("C", count - 1), figure(so_far.center)}),
        4);
  }

  /// The first `count` shapes belong to the body, the others are only outlined.
  void show_parts(std::size_t count) {
    std::vector<Bar> bars;
    const double all = combined(masses_).mass;
    for (std::size_t i = 0; i < masses_.size(); ++i) {
      const DemonstrationShape& shape = asked_.shapes[i];
      board_.show(shape_mark(i < count ? Role::first : Role::second, shape));
      board_.show(labelled(dot_mark(i < count ? Role::first : Role::rejected, masses_[i].center), {0, -1},
                           filled("$%$", {numbered("C", i)})));
      bars.push_back({i < count ? Role::first : Role::rejected, masses_[i].mass / all,
                      filled("$%$: % kg", {numbered("m", i), figure(masses_[i].mass)}), ""});
    }
    if (count > 0) {
      const MassProperties so_far = combined(std::span(masses_).first(count));
      board_.show(labelled(keyed(dot_mark(Role::result, so_far.center), "balance"), {0, 1}, "C"));
      bars.push_back({Role::result, so_far.mass / all, filled("$M$ so far: % kg", {figure(so_far.mass)}), "sum"});
    } else {
      bars.push_back({Role::result, 0, "$M$ so far: 0 kg", "sum"});
    }
    show_bars(board_, bars_, bars, 1);
  }

  const Demonstration& asked_;
  std::vector<MassProperties> masses_;
  Storyboard board_;
  int bars_ = 0;
  Aabbd bounds_;
  double unit_ = 1;  ///< m, the length of the beam
};

}  // namespace

Story tell_center_of_mass(const Demonstration& demonstration) { return Balance(demonstration).tell(); }

}  // namespace proofreel
