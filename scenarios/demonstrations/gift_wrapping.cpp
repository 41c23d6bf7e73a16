// Gift wrapping (thesis figures 3.6 to 3.8, table 3.1): the hull corner by corner, every comparison counted.

#include "engine/elementary.h"
#include "engine/polygon.h"
#include "scenarios/demonstrations/algorithms.h"
#include "scenarios/demonstrations/bars.h"

namespace proofreel {
namespace {

class Wrapping {
 public:
  explicit Wrapping(const Demonstration& asked) : points_(asked.points), board_(asked.pace) {
    board_.pane("");
    bars_ = board_.pane("", 0.42, true);
    board_.heading("Gift wrapping");
    for (const Vec2d p : points_) board_.keep(dot_mark(Role::first, p));
  }

  void begin() {
    show_cost();
    board_.step(filled("% points. Which of them are corners of their convex hull?", {figure(points_.size())}), 5);
  }

  void tell(const HullCorner& event) {
    hull_.push_back(event.corner);
    show_hull();
    board_.show(labelled(keyed(dot_mark(Role::result, event.corner), "P"), outward(event.corner), "P"));
    show_cost();
    board_.step(event.number == 0
                    ? "The leftmost point is a corner for sure. Start here: it is the first $P$."
                    : filled("No point lies right of $\\vec{PQ}$: $Q$ is corner % of the hull, and the next $P$.",
                             {figure(event.number + 1)}),
                3);
  }

  void tell(const HullCandidate& event) {
    ++comparisons_;
    show_hull();
    const double turn = orientation(event.from, event.best, event.candidate);
    board_.show(
        keyed(region_mark(event.better ? Role::alert : Role::quiet, {event.from, event.best, event.candidate}), "PQR"));
    board_.show(keyed(arrow_mark(Role::chosen, event.from, event.best), "PQ"));
    board_.show(keyed(arrow_mark(Role::candidate, event.from, event.candidate), "PR"));
    board_.show(labelled(keyed(dot_mark(Role::result, event.from), "P"), outward(event.from), "P"));
    board_.show(labelled(keyed(dot_mark(Role::chosen, event.best), "Q"), outward(event.best), "Q"));
    board_.show(labelled(keyed(dot_mark(Role::candidate, event.candidate), "R"), outward(event.candidate), "R"));
    show_cost();
    board_.step(filled("$\\vec{PQ} \u00d7 \\vec{PR} = %$: %", {figure(turn), verdict(turn, event.better)}));
  }

  Story finish(const std::vector<Vec2d>& hull) {
    board_.show(region_mark(Role::result, hull));
    board_.show(closed_path(Role::result, hull));
    for (const Vec2d corner : hull) board_.show(dot_mark(Role::result, corner));
    show_cost();
    board_.step(filled("Back at the start. $h = %$ corners took $(n \u2212 2)\u2009h = %$ comparisons, so gift "
                       "wrapping is $O(n\u2009h)$.",
                       {figure(hull.size()), figure(comparisons_)}),
                7);
    return board_.finish();
  }

 private:
  static std::string verdict(double turn, bool better) {
    if (turn == 0)
      return better ? "$R$ is in line and farther away. It takes $Q$'s place." : "$R$ is in line and nearer.";
    return better ? "$R$ lies right of $\\vec{PQ}$. It takes $Q$'s place." : "$R$ lies left of $\\vec{PQ}$. $Q$ stays.";
  }

  void show_hull() {
    for (std::size_t i = 1; i < hull_.size(); ++i) board_.show(path_mark(Role::result, {hull_[i - 1], hull_[i]}));
    for (const Vec2d corner : hull_) board_.show(dot_mark(Role::result, corner));
  }

  void show_cost() {
    const auto n = static_cast<double>(points_.size());
    const auto h = static_cast<double>(hull_.size());
    const double sorted = n * elementary::log(n) / elementary::log(2.0);
    board_.counters({{"n", figure(points_.size())}, {"h", figure(hull_.size())}});
    show_bars(
        board_, bars_,
        {{Role::candidate, static_cast<double>(comparisons_), filled("comparisons: %", {figure(comparisons_)}), "done"},
         {Role::chosen, n * h, filled("$n\u2009h$ so far: %", {figure(points_.size() * hull_.size())}), "nh"},
         {Role::rejected, sorted, filled("$n\u2009log_2\u2009n$ (Graham): %", {figure(sorted, 0)}), ""},
         {Role::rejected, n * n, filled("$n^2$: %", {figure(points_.size() * points_.size())}), ""}},
        n * n);
  }

  Vec2d outward(Vec2d p) const { return towards(middle_of(points_), p); }

  std::vector<Vec2d> points_;
  Storyboard board_;
  int bars_ = 0;
  std::vector<Vec2d> hull_;
  std::size_t comparisons_ = 0;
};

}  // namespace

Story tell_gift_wrapping(const Demonstration& demonstration) {
  Wrapping wrapping(demonstration);
  wrapping.begin();
  return wrapping.finish(convex_hull(demonstration.points, telling(wrapping)));
}

}  // namespace proofreel
