#include "engine/impact.h"

#include <algorithm>
#include <cmath>

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

/// A cluster of bodies bounces itself to rest in ever shorter steps (inelastic collapse); the rest is left to the
/// contact solver.
constexpr int max_sweeps = 100;

/// The two bodies of a constraint and what accelerates them.
struct Pair {
  const ContactConstraint& c;
  Motion& a;
  Motion& b;
  Vec2 acceleration;  ///< of b relative to a
  real wanted_slip;   ///< of moving surfaces, m/s

  real separation(int k) const { return separation_of(c, c.points[k], a, b); }
  real approach(int k, real t) const {
    const ConstraintPoint& p = c.points[k];
    return dot(b.velocity_at(p.arm_b) - a.velocity_at(p.arm_a) + t * acceleration, c.normal);
  }
};

/// When point `k` closes its gap: the first root of s + v t + a t^2 / 2. Nothing if it does not within `h`, or too
/// gently to bounce.
bool time_of_impact(const Pair& pair, int k, real h, real resting_speed, real& t) {
  const real v = pair.approach(k, 0);
  const real a = dot(pair.acceleration, pair.c.normal);
  if (std::min(v, v + a * h) >= -resting_speed) return false;  // most pairs, most of the time
  const real s = pair.separation(k);
  t = 0;
  if (s > 0) {
    const real discriminant = v * v - 2 * a * s;
    if (discriminant < 0) return false;
    const real root = std::sqrt(discriminant) - v;  // 2 s / root is the smaller positive root, without cancellation
    if (root <= 0) return false;
    t = 2 * s / root;
  }
  return t <= h && pair.approach(k, t) < -resting_speed;
}

real response(const Pair& pair, const ConstraintPoint& p, const ConstraintPoint& q, Vec2 n) {
  return pair.a.inv_mass + pair.b.inv_mass + pair.a.inv_inertia * cross(p.arm_a, n) * cross(q.arm_a, n) +
         pair.b.inv_inertia * cross(p.arm_b, n) * cross(q.arm_b, n);
}

/// Both points at once, so that a box that lands flat bounces without turning. False when one of them would have to
/// pull.
bool impulses_of_both(const Pair& pair, real t, real (&impulse)[2]) {
  const ConstraintPoint& p = pair.c.points[0];
  const ConstraintPoint& q = pair.c.points[1];
  const Vec2 n = pair.c.normal;
  const real k12 = response(pair, p, q, n);
  const Mat2 k{{response(pair, p, p, n), k12}, {k12, response(pair, q, q, n)}};
  if (determinant(k) <= real(1e-6) * k.ex.x * k.ey.y) return false;
  const real gain = 1 + pair.c.restitution;
  const Vec2 x = solve(k, Vec2{-gain * pair.approach(0, t), -gain * pair.approach(1, t)});
  impulse[0] = x.x;
  impulse[1] = x.y;
  return x.x >= 0 && x.y >= 0;
}

void rub(const Pair& pair, const ConstraintPoint& p, real normal_impulse, real& total) {
  const Vec2 tangent = perp(pair.c.normal);
  const real slip = dot(pair.b.velocity_at(p.arm_b) - pair.a.velocity_at(p.arm_a), tangent) - pair.wanted_slip;
  const real wanted = -p.tangent_mass * slip;
  const real held = pair.c.friction_at_rest * normal_impulse;
  const real limit = std::abs(wanted) <= held ? held : pair.c.friction_sliding * normal_impulse;
  const real impulse = std::clamp(wanted, -limit, limit);
  pair.a.push(-impulse * tangent, p.arm_a);
  pair.b.push(impulse * tangent, p.arm_b);
  total += impulse;
}

void set_back(Motion& m, Vec2 velocity_before, real spin_before, real t) {
  m.delta -= t * (m.velocity - velocity_before);
  const real turn = t * (m.spin - spin_before);
  if (turn == 0) return;
  m.rotation = turned(m.rotation, -turn);
  m.angle -= turn;
}

/// The impact of one pair within the substep, if there is one.
bool bounce(ContactConstraint& c, Pair pair, real h, real resting_speed, bool friction) {
  real time[2] = {h, h};
  bool hits[2] = {false, false};
  for (int k = 0; k < c.count; ++k) hits[k] = time_of_impact(pair, k, h, resting_speed, time[k]);
  if (!hits[0] && !hits[1]) return false;
  const int first = hits[0] && (!hits[1] || time[0] <= time[1]) ? 0 : 1;
  const real t = hits[first] ? time[first] : 0;

  real impulse[2] = {0, 0};
  const bool together = hits[0] && hits[1] && std::abs(time[0] - time[1]) <= real(0.5) * h;
  if (!together || !impulses_of_both(pair, t, impulse)) {
    impulse[0] = impulse[1] = 0;
    impulse[first] = -(1 + c.restitution) * c.points[first].normal_mass * pair.approach(first, t);
  }
  const Motion a_before = pair.a;
  const Motion b_before = pair.b;
  for (int k = 0; k < c.count; ++k) {
    ConstraintPoint& p = c.points[k];
    pair.a.push(-impulse[k] * c.normal, p.arm_a);
    pair.b.push(impulse[k] * c.normal, p.arm_b);
    p.normal_total += impulse[k];
    p.normal_impulse = p.tangent_impulse = 0;  // a bounce is no load to start the next substep from
  }
  for (int k = 0; friction && k < c.count; ++k) rub(pair, c.points[k], impulse[k], c.points[k].tangent_total);
  set_back(pair.a, a_before.velocity, a_before.spin, t);
  set_back(pair.b, b_before.velocity, b_before.spin, t);
  return true;
}

}  // namespace

void resolve_impacts(std::vector<ContactConstraint>& constraints, std::span<const Vec2> accelerations,
                     std::vector<Motion>& motions, real h, real resting_speed, bool friction,
                     std::span<const real> surface_speeds) {
  bool any = true;
  for (int sweep = 0; any && sweep < max_sweeps; ++sweep) {
    any = false;
    for (std::size_t i = 0; i < constraints.size(); ++i) {
      ContactConstraint& c = constraints[i];
      if (c.restitution <= 0) continue;
      const Vec2 acceleration = accelerations.empty() ? Vec2{} : accelerations[c.body_b] - accelerations[c.body_a];
      const real wanted_slip = surface_speeds.empty() ? real(0) : surface_speeds[i];
      const Pair pair{c, motions[c.body_a], motions[c.body_b], acceleration, wanted_slip};
      any |= bounce(c, pair, h, resting_speed, friction);
    }
  }
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
