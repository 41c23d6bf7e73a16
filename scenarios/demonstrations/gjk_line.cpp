// GJK in one dimension (thesis figures 4.6 to 4.8): two intervals, the interval of their differences, and a simplex of
// its ends around the origin. The engine's GJK is run on two segments of the x axis.

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/gjk.h"
#include "scenarios/demonstrations/algorithms.h"
#include "scenarios/demonstrations/shape_pair.h"

namespace proofreel {
namespace {

struct Interval {
  double low = 0;
  double high = 0;
};

Interval interval_of(const DemonstrationShape& segment) {
  const auto [low, high] = std::minmax(segment.parts[0][0].x, segment.parts[0][1].x);
  return {low, high};
}

/// A segment as the shape of a body: about its middle.
PlacedHull placed_segment(const DemonstrationShape& segment) {
  const Vec2d middle = middle_of(segment.parts[0]);
  ShapeDef def;
  def.points = segment.parts[0];
  return {make_hull(def, middle), {Vec2(middle), Rot{}}};
}

class Line {
 public:
  explicit Line(const Demonstration& asked)
      : a_(interval_of(asked.shapes[0])),
        b_(interval_of(asked.shapes[1])),
        frame_(middle_of(asked.shapes[0].parts[0]).x),
        board_(asked.pace) {
    const double low = std::min({a_.low, b_.low, difference().low, 0.0});
    const double high = std::max({a_.high, b_.high, difference().high, 0.0});
    unit_ = (high - low) / 16;
    board_.pane("");
    board_.heading("GJK on a line");
    for (const double y : {upper(), lower()}) keep_number_line(y, low, high);
    keep_interval(Role::first, a_, upper(), 1.4, "A");
    keep_interval(Role::second, b_, upper(), 0.5, "B");
    board_.keep(text_mark(Role::quiet, {low - 2.2 * unit_, lower()}, {}, "$b \u2212 a$"));
    board_.keep(text_mark(Role::quiet, {low - 2.2 * unit_, upper()}, {}, "$x$"));
  }

  void begin() {
    board_.step("Two intervals of a line. Do they have a point in common? One with $b = a$, that is $b \u2212 a = 0$?",
                3);
    show_difference();
    board_.step(filled("The differences $b \u2212 a$ of all their points fill an interval too: from $%$ to $%$.",
                       {figure(difference().low), figure(difference().high)}),
                3);
    show_difference();
    board_.step(
        "Only its ends matter, and whether $0$ lies between them. GJK looks for two ends around $0$: a simplex.", 3);
  }

  void tell(const SimplexReduced& event) {
    simplex_.assign(event.points.begin(), event.points.begin() + event.count);
    closest_ = event.closest.x;
    show_difference();
    show_simplex(Role::chosen);
    const std::string where = filled("$%$", {figure(simplex_.back().x)});
    if (event.count == 2) {
      board_.step("$0$ lies between the two: they are a simplex around it.", 4);
    } else if (told_++ == 0) {
      board_.step(
          filled("It starts from the difference of two ends, %%",
                 {where, closest_ == 0 ? ": that is $0$ itself." : ". The way to $0$ is the direction to look in."}),
          4);
    } else {
      board_.step(
          filled("$0$ is not between them. The end nearer to it is kept, %, and the other one let go.", {where}), 3);
    }
  }

  void tell(const SupportFound& event) {
    show_difference();
    show_simplex(Role::chosen);
    if (event.direction.x == 0) return tell_across();
    const double way = event.direction.x > 0 ? 1 : -1;
    const double on_a = event.on_a.x + frame_, on_b = event.on_b.x + frame_;
    board_.show(labelled(dot_mark(Role::candidate, {on_a, upper() + 1.4 * unit_}), {0, 1}, "a"));
    board_.show(labelled(dot_mark(Role::candidate, {on_b, upper() + 0.5 * unit_}), {0, 1}, "b"));
    const Vec2d from{simplex_.back().x, lower() + 0.9 * unit_};
    board_.show(labelled(arrow_mark(Role::candidate, from, from + Vec2d{1.5 * way * unit_, 0}), {way, 0}, "d"));
    board_.show(labelled(dot_mark(Role::candidate, {event.difference.x, lower()}), {0, -1}, "$b \u2212 a$"));
    board_.step(
        filled("Support function: $b$ is the end of B farthest along $d$, $a$ that of A farthest the other way. "
               "$b \u2212 a = %$",
               {figure(event.difference.x)}),
        5);
  }

  void tell(const DistanceFound& event) {
    show_difference();
    const bool apart = event.distance > 0;
    show_simplex(apart ? Role::alert : Role::result);
    if (!apart) {
      show_common();
      board_.step(a_.high == b_.low || b_.high == a_.low
                      ? "$0$ is an end of the difference: A and B have just one point in common. They touch."
                      : filled("$0$ is in the difference, so A and B overlap: they have the points from $%$ to $%$ in "
                               "common.",
                               {figure(std::max(a_.low, b_.low)), figure(std::min(a_.high, b_.high))}),
                  5);
      return;
    }
    board_.show(path_mark(Role::result, {{0, lower()}, {closest_, lower()}}));
    board_.show(path_mark(Role::result, {{event.on_a.x + frame_, upper()}, {event.on_b.x + frame_, upper()}}));
    board_.step(filled("No end is nearer to $0$, which lies outside: A and B are $%$ m apart, as far as the difference "
                       "is from $0$.",
                       {figure(event.distance)}),
                6);
  }

  Story finish() { return board_.finish(); }

 private:
  Interval difference() const { return {b_.low - a_.high, b_.high - a_.low}; }
  double upper() const { return 1.2 * unit_; }
  double lower() const { return -2.6 * unit_; }

  /// Having two ends, the algorithm in the plane still looks square to them; having the origin itself, nowhere.
  void tell_across() {
    board_.step(simplex_.size() == 2
                    ? "In the plane GJK would go on square to the two. On a line there is nothing more to find."
                    : "It is there: no direction is left to look in.",
                3);
  }

  void keep_number_line(double y, double low, double high) {
    const Vec2d margin{unit_, 0};
    board_.keep(path_mark(Role::quiet, {Vec2d{low, y} - margin, Vec2d{high, y} + margin}));
    for (int i = static_cast<int>(std::ceil(low / tick())); i * tick() <= high; ++i) {
      const Vec2d at{i * tick(), y};
      board_.keep(path_mark(Role::quiet, {at - Vec2d{0, 0.15 * unit_}, at + Vec2d{0, 0.15 * unit_}}));
      board_.keep(text_mark(Role::quiet, at - Vec2d{0, 0.55 * unit_}, {}, figure(i * tick(), tick() < 1 ? 1 : 0)));
    }
    board_.keep(origin_mark({0, y}));
  }

  /// Steps of 1, 2 or 5 times a power of ten, about ten of them.
  double tick() const {
    constexpr std::array<double, 3> factors{2, 2.5, 2};
    double step = 1e-9;
    for (std::size_t i = 0; 16 * unit_ > 9 * step; ++i) step *= factors[i % 3];
    return step;
  }

  void keep_interval(Role role, Interval interval, double y, double above, const std::string& name) {
    const double middle = y + above * unit_;
    const double half = 0.22 * unit_;
    board_.keep(bar_mark(role, {{interval.low, middle - half},
                                {interval.high, middle - half},
                                {interval.high, middle + half},
                                {interval.low, middle + half}}));
    board_.keep(text_mark(role, {interval.low - 0.6 * unit_, middle}, {}, name));
  }

  void show_difference() {
    const Interval d = difference();
    const double half = 0.22 * unit_;
    board_.show(bar_mark(
        Role::rejected,
        {{d.low, lower() - half}, {d.high, lower() - half}, {d.high, lower() + half}, {d.low, lower() + half}}));
  }

  void show_simplex(Role role) {
    if (simplex_.size() == 2) board_.show(path_mark(role, {{simplex_[0].x, lower()}, {simplex_[1].x, lower()}}));
    for (const Vec2d corner : simplex_) board_.show(dot_mark(role, {corner.x, lower()}));
  }

  void show_common() {
    const double low = std::max(a_.low, b_.low), high = std::min(a_.high, b_.high);
    if (high > low) board_.show(path_mark(Role::result, {{low, upper()}, {high, upper()}}));
    for (const double x : {low, high}) board_.show(dot_mark(Role::result, {x, upper()}));
  }

  Interval a_;
  Interval b_;
  double frame_;  ///< where the origin of A's frame is, in which events speak of points of A and B
  Storyboard board_;
  double unit_ = 1;
  std::vector<Vec2d> simplex_;
  double closest_ = 0;
  int told_ = 0;
};

}  // namespace

Story tell_gjk_line(const Demonstration& demonstration) {
  Line line(demonstration);
  line.begin();
  const PlacedHull a = placed_segment(demonstration.shapes[0]);
  const PlacedHull b = placed_segment(demonstration.shapes[1]);
  SimplexCache cache;
  distance(a.hull, a.pose, b.hull, b.pose, cache, telling(line));
  return line.finish();
}

}  // namespace proofreel
