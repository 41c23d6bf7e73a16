#include "engine/contact.h"

#include <algorithm>
#include <cmath>

#include "engine/collide_smooth.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

/// Of a pair's thickness: with more overlap than that from the start, bodies were put inside each other; with no more
/// than that, they have come apart again.
constexpr real deep_part = real(0.03);
constexpr real parted_part = real(0.001);

/// How far the pair may approach within `dt` at even speeds.
real approach_bound(const Motion& a, real reach_a, const Motion& b, real reach_b, real dt) {
  return dt * (length(b.velocity - a.velocity) + std::abs(a.spin) * reach_a + std::abs(b.spin) * reach_b);
}

/// What drives B towards A along the normal the most, m/s^2. Something else may hold one of the two while the other one
/// falls, and nobody knows that yet: so it is what they do both, or only one of them.
Vec2 driving(const Contact& contact, const Foresight& foresight) {
  if (foresight.accelerations.empty()) return {};
  const Vec2 a = foresight.accelerations[contact.body_a];
  const Vec2 b = foresight.accelerations[contact.body_b];
  const Vec2 n = contact.manifold.normal;
  Vec2 most = b - a;
  if (dot(b, n) < dot(most, n)) most = b;
  if (dot(-a, n) < dot(most, n)) most = -a;
  return most;
}

/// A bound on how far the pair falls towards each other within a tick, m.
real fall_bound(const Contact& contact, const Foresight& foresight) {
  if (foresight.accelerations.empty()) return 0;
  return fall_within(foresight.dt, foresight.accelerations[contact.body_a]) +
         fall_within(foresight.dt, foresight.accelerations[contact.body_b]);
}

Manifold narrow_phase(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, real margin) {
  if (a.seam == nullptr && b.seam == nullptr) return collide(a.hull, pose_a, b.hull, pose_b, margin);
  return collide_smooth({a.hull, a.seam.get()}, pose_a, {b.hull, b.seam.get()}, pose_b, margin);
}

/// A speculative contact is a wall across the way. Before it is built, the two bodies are moved on at their present
/// speeds until they touch, step by step as far as they can go without touching (conservative advancement, Mirtich
/// 1996): if they pass each other there is none, and otherwise it stands where they will meet. Its points and `a_to_b`
/// are those of that moment, so that the impulse acts where the bodies will touch and not where they are now.
Manifold predicted(const Manifold& now, const Shape& a, Pose pose_a, const Motion& ma, const Shape& b, Pose pose_b,
                   const Motion& mb, real near, real dt, real bound, Vec2& a_to_b) {
  Manifold m = now;
  real t = 0;
  for (int step = 0; step < 32; ++step) {
    const real gap = deepest(m);
    if (gap <= near) break;
    const real advance = dt * (gap - real(0.5) * near) / bound;
    t += advance;
    if (t > dt) return {};
    pose_a = {pose_a.position + advance * ma.velocity, turned(pose_a.rotation, advance * ma.spin)};
    pose_b = {pose_b.position + advance * mb.velocity, turned(pose_b.rotation, advance * mb.spin)};
    m = narrow_phase(a, pose_a, b, pose_b, bound + near);
    if (m.count == 0) return {};
  }
  if (deepest(m) > near) return {};
  a_to_b = pose_b.position - pose_a.position;
  for (int k = 0; k < m.count; ++k) {
    const Vec2 arm = m.points[k].point;
    const real approach = dot(mb.velocity_at(arm - a_to_b) - ma.velocity_at(arm), m.normal);
    m.points[k].separation -= t * approach;
  }
  return m;
}

void carry_over(const Manifold& old, const PointImpulse (&old_impulses)[2], Contact& contact) {
  for (int i = 0; i < contact.manifold.count; ++i) {
    contact.impulses[i] = {};
    for (int j = 0; j < old.count; ++j) {
      if (old.points[j].feature != contact.manifold.points[i].feature) continue;
      contact.impulses[i].normal = old_impulses[j].normal;
      contact.impulses[i].tangent = old_impulses[j].tangent;
    }
  }
}

}  // namespace

void mix_materials(Contact& contact, const Shape& a, const Shape& b) {
  contact.friction_at_rest = std::sqrt(a.friction_at_rest * b.friction_at_rest);
  contact.friction_sliding = std::sqrt(a.friction_sliding * b.friction_sliding);
  contact.restitution = std::max(a.restitution, b.restitution);
  contact.rolling_resistance = std::max(a.rolling_resistance, b.rolling_resistance);
  contact.surface_speed = a.surface_speed + b.surface_speed;
}

real approach_speed(const Contact& contact, const Motion& a, const Motion& b) {
  const Manifold& m = contact.manifold;
  const bool second = m.count > 1 && m.points[1].separation < m.points[0].separation;
  const Vec2 arm = m.points[second ? 1 : 0].point;
  return dot(a.velocity_at(arm) - b.velocity_at(arm - contact.a_to_b), m.normal);
}

real gap_between(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, real margin) {
  return deepest(narrow_phase(a, pose_a, b, pose_b, margin));
}

void update_manifold(Contact& contact, const std::vector<Shape>& shapes, const std::vector<Body>& bodies,
                     const std::vector<Motion>& motions, const Foresight& foresight) {
  const real dt = foresight.dt;
  const Shape& a = shapes[contact.shape_a];
  const Shape& b = shapes[contact.shape_b];
  const Body& body_a = bodies[contact.body_a];
  const Body& body_b = bodies[contact.body_b];
  const Motion& ma = motions[contact.body_a];
  const Motion& mb = motions[contact.body_b];
  const real thin = pair_length(a, b);
  const real near = near_part * thin;
  const bool always =
      body_a.type != BodyType::dynamic || body_b.type != BodyType::dynamic || body_a.bullet || body_b.bullet;
  const real bound = approach_bound(ma, a.reach, mb, b.reach, dt) + fall_bound(contact, foresight);
  const real margin = near + (foresight.ccd && always ? bound : std::min(bound, thin));
  const Manifold old = contact.manifold;
  const PointImpulse old_impulses[2] = {contact.impulses[0], contact.impulses[1]};
  const Pose pose_a{body_a.center + ma.delta, ma.rotation};
  const Pose pose_b{body_b.center + mb.delta, mb.rotation};
  contact.manifold = narrow_phase(a, pose_a, b, pose_b, margin);
  contact.a_to_b = pose_b.position - pose_a.position;
  if (contact.manifold.count > 0 && deepest(contact.manifold) > near) {
    Motion falling = mb;
    falling.velocity += dt * driving(contact, foresight);
    const real way = approach_bound(ma, a.reach, falling, b.reach, dt);
    contact.manifold = predicted(contact.manifold, a, pose_a, ma, b, pose_b, falling, near, dt, way, contact.a_to_b);
  }
  const real overlap = contact.manifold.count > 0 ? -deepest(contact.manifold) : real(0);
  const bool met_now = old.count == 0 && !contact.touching;
  contact.parting = met_now ? overlap > deep_part * thin : contact.parting && overlap > parted_part * thin;
  carry_over(old, old_impulses, contact);
  if (!contact.touching && contact.manifold.count > 0) contact.approach = approach_speed(contact, ma, mb);
  if (contact.manifold.count == 0) contact.rolling_impulse = 0;
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
