#pragma once

/// When do two bodies meet that do not fly straight? Within a substep of verlet every body moves as under a constant
/// acceleration, and turns as under a constant angular one.

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/body.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

/// The way of one body from where it was to where a substep has brought it.
class Flight {
 public:
  /// `span` is the substep's length, s. `before` has not moved yet: its `delta` is 0.
  Flight(const Motion& before, const Motion& after, real span)
      : start_(before),
        acceleration_(2 / span * (1 / span * after.delta - before.velocity)),
        turning_(2 / span * ((after.angle - before.angle) / span - before.spin)) {}

  /// Where it is after `t` seconds.
  Motion at(real t) const {
    Motion m = start_;
    m.delta = t * start_.velocity + real(0.5) * t * t * acceleration_;
    const real turn = t * start_.spin + real(0.5) * t * t * turning_;
    m.rotation = turned(start_.rotation, turn);
    m.angle += turn;
    return m;
  }
  Vec2 velocity() const { return start_.velocity; }
  Vec2 acceleration() const { return acceleration_; }
  /// The fastest that it turns until `span`, rad/s.
  real fastest_turn(real span) const {
    return std::max(std::abs(start_.spin), std::abs(start_.spin + span * turning_));
  }

 private:
  Motion start_;
  Vec2 acceleration_;
  real turning_;
};

/// The first time in 0..span at which a gap is no wider than `closed`: that far the time is advanced, step by step,
/// which a gap that closes at no more than `speed` allows (conservative advancement, Mirtich 1996). Where it hardly
/// gets on, bodies pass each other closely: if the gap is closed at the end, its closing is found by halving.
/// Infinite when it stays open. `gap` tells its width after t seconds; only its sign counts where bodies overlap.
template <typename Gap>
real time_of_closing(const Gap& gap, real speed, real span, real closed) {
  constexpr real never = std::numeric_limits<real>::infinity();
  constexpr int most_steps = 40;
  real open = 0;
  for (int step = 0; step < most_steps; ++step) {
    const real width = gap(open);
    if (width <= closed) return open;
    open += width / speed;
    if (!(open <= span)) return never;
  }
  if (gap(span) > closed) return never;
  real shut = span;
  for (int step = 0; step < most_steps && gap(open) > closed; ++step) {
    const real middle = real(0.5) * (open + shut);
    (gap(middle) > 0 ? open : shut) = middle;
  }
  return shut;
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
