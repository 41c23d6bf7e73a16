#include "engine/time_of_impact.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

namespace {

constexpr real half = real(0.5);
/// How many runs of GJK, and how many windows for each of them.
constexpr int most_runs = 256;
constexpr int most_windows = 64;

/// sin and cos of an angle of at most an eighth of a turn, by Taylor's series.
Rot small_turn(real angle) {
  constexpr int terms = sizeof(real) == sizeof(double) ? 9 : 5;
  const real square = angle * angle;
  real sine = 1;
  real cosine = 1;
  for (int k = terms; k > 0; --k) {
    const auto n = static_cast<real>(2 * k);
    sine = 1 - sine * (square * (1 / (n * (n + 1))));
    cosine = 1 - cosine * (square * (1 / (n * (n - 1))));
  }
  return {cosine, angle * sine};
}

/// The whole number below. Where it can, without std::floor, which is a call on a processor without SSE4.1.
real rounded_down(real x) {
  if (!(std::abs(x) < real(1e9))) return std::floor(x);
  const auto towards_zero = static_cast<real>(static_cast<std::int32_t>(x));
  return towards_zero - (towards_zero > x ? real(1) : real(0));
}

/// The rotation by an angle to the last digits but one: elementary::sin and cos are exact to the last, but take several
/// times as long, and here they would take most of the time.
Rot turn_by(real angle) {
  constexpr real quarter = real(1.57079632679489661923);
  const real quarters = rounded_down(angle / quarter + half);
  const Rot rest = small_turn(angle - quarters * quarter);
  switch (static_cast<int>(quarters - 4 * rounded_down(quarters / 4))) {
    case 0:
      return rest;
    case 1:
      return {-rest.s, rest.c};
    case 2:
      return {-rest.c, -rest.s};
    default:
      return {rest.s, -rest.c};
  }
}

Rot rotation_at(const Sweep& sweep, real fraction) {
  return sweep.turn == 0 ? sweep.start.rotation : turn_by(fraction * sweep.turn) * sweep.start.rotation;
}

/// How much the arms of a turning body bend its corners' paths: the largest second derivative of any of them.
real bend_of(const Hull& hull, real turn) {
  if (turn == 0) return 0;
  real farthest = 0;
  for (int i = 0; i < hull.count; ++i) farthest = std::max(farthest, length_squared(hull.points[i]));
  return turn * turn * std::sqrt(farthest);
}

/// How both bodies stand at a time. B's position is relative to A's.
struct Moment {
  real time = 0;
  Rot a;
  Rot b;
  Vec2 offset;
};

/// The two sweeps as one relative motion, in world axes.
class Motion {
 public:
  Motion(const Hull& a, const Sweep& sweep_a, const Hull& b, const Sweep& sweep_b)
      : a_(a),
        b_(b),
        sweep_a_(sweep_a),
        sweep_b_(sweep_b),
        offset_(sweep_b.start.position - sweep_a.start.position),
        way_(sweep_b.displacement - sweep_a.displacement),
        bend_(bend_of(a, sweep_a.turn) + bend_of(b, sweep_b.turn)) {}

  Moment start() const { return {0, sweep_a_.start.rotation, sweep_b_.start.rotation, offset_}; }
  Moment at(real time) const {
    return {time, rotation_at(sweep_a_, time), rotation_at(sweep_b_, time), offset_ + time * way_};
  }
  HullPair pair_at(const Moment& m) const { return {a_, b_, {inverse_rotate(m.a, m.offset), inverse(m.a) * m.b}}; }
  /// The separation of the cores along a unit direction: at most their distance.
  real along(Vec2 direction, const Moment& m) const {
    return dot(direction, m.offset) - support_extent(b_, inverse_rotate(m.b, -direction)) -
           support_extent(a_, inverse_rotate(m.a, direction));
  }
  real bend() const { return bend_; }
  /// What separations may be off by.
  real rounding() const { return 4 * rounding_of(offset_, way_) + 4 * rounding_of(a_.points[0], b_.points[0]); }

 private:
  const Hull& a_;
  const Hull& b_;
  const Sweep& sweep_a_;
  const Sweep& sweep_b_;
  Vec2 offset_;
  Vec2 way_;
  real bend_;
};

/// A stretch of time from `from`, where the separation along a direction is `before` above the goal, to `to`, where it
/// is `after` above (or below) it.
struct Window {
  real from = 0;
  real before = 0;
  Moment to;
  real after = 0;
};

/// The part of the window after which the lower bound, chord minus sag, first reaches the goal; 1 when it never does.
/// The bound is before + (after - before - sag) x + sag x^2.
real first_crossing(const Window& w, real sag) {
  const real fall = w.before - w.after + sag;
  const real discriminant = fall * fall - 4 * sag * w.before;
  if (fall <= 0 || discriminant < 0) return 1;
  return std::min(2 * w.before / (fall + std::sqrt(discriminant)), real(1));
}

/// The time up to which the separation along `direction` stays above `goal`, proven; nearly the time when it falls
/// there (to `slack`), unless something else comes nearer before.
Moment safe_until(const Motion& motion, Vec2 direction, real from, real before, real goal, real slack, real& last) {
  Window w{from, before - goal, motion.at(1), 0};
  for (int i = 0;; ++i) {
    w.after = motion.along(direction, w.to) - goal;
    const real size = w.to.time - w.from;
    const real sag = half * motion.bend() * size * size;
    const real x = first_crossing(w, sag);
    last = w.after + goal;
    if (x >= 1 && w.after >= 0) return w.to;
    if (sag * x * (1 - x) <= slack || i == most_windows) return motion.at(w.from + x * size);
    const real shrunk = w.after < 0 ? w.before / (w.before - w.after) : half;
    w.to = motion.at(w.from + shrunk * size);
  }
}

}  // namespace

Pose pose_at(const Sweep& sweep, real fraction) {
  return {sweep.start.position + fraction * sweep.displacement, rotation_at(sweep, fraction)};
}

template <typename Observer>
TimeOfImpact time_of_impact(const Hull& a, const Sweep& sweep_a, const Hull& b, const Sweep& sweep_b, real target,
                            real tolerance, Observer observer) {
  const Motion motion(a, sweep_a, b, sweep_b);
  const real radii = a.radius + b.radius;
  const real near = std::max(tolerance, 4 * motion.rounding());
  SimplexCache cache;
  TimeOfImpact result;
  Moment now = motion.start();
  while (result.iterations < most_runs) {
    const CoreDistance core = core_distance(motion.pair_at(now), cache, observer);
    ++result.iterations;
    result.fraction = now.time;
    result.separation = core.distance - radii;
    if constexpr (Observer::watches)
      observer([&] {
        return Advanced{static_cast<double>(now.time), static_cast<double>(result.separation), Vec2d(core.on_a),
                        Vec2d(core.on_b)};
      });
    if (result.separation <= target + near) {
      result.state = now.time > 0 ? ImpactState::hit : ImpactState::touching_at_start;
      return result;
    }
    if (now.time >= 1) {
      result.state = ImpactState::separated;
      return result;
    }
    const real goal = target + radii + half * near;
    real last = 0;
    now = safe_until(motion, rotate(now.a, core.normal), now.time, core.distance, goal, real(0.25) * near, last);
    if (now.time >= 1) {
      result.fraction = 1;
      result.separation = last - radii;
      result.state = ImpactState::separated;
      return result;
    }
  }
  result.state = ImpactState::unfinished;
  return result;
}

template TimeOfImpact time_of_impact<NoObserver>(const Hull&, const Sweep&, const Hull&, const Sweep&, real, real,
                                                 NoObserver);
template TimeOfImpact time_of_impact<Observer>(const Hull&, const Sweep&, const Hull&, const Sweep&, real, real,
                                               Observer);

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
