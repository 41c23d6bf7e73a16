#include "engine/contact.h"

#include <algorithm>
#include <cmath>

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

/// How far the pair may approach within `dt`, at the speeds of now.
real approach_bound(const Motion& a, real reach_a, const Motion& b, real reach_b, real dt) {
  return dt * (length(b.velocity - a.velocity) + std::abs(a.spin) * reach_a + std::abs(b.spin) * reach_b);
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
}

void update_manifold(Contact& contact, const std::vector<Shape>& shapes, const std::vector<Body>& bodies,
                     const std::vector<Motion>& motions, real dt, bool ccd) {
  const Shape& a = shapes[contact.shape_a];
  const Shape& b = shapes[contact.shape_b];
  const Body& body_a = bodies[contact.body_a];
  const Body& body_b = bodies[contact.body_b];
  const Motion& ma = motions[contact.body_a];
  const Motion& mb = motions[contact.body_b];
  const real thin = pair_length(a, b);
  const bool always =
      body_a.type != BodyType::dynamic || body_b.type != BodyType::dynamic || body_a.bullet || body_b.bullet;
  const real bound = approach_bound(ma, a.reach, mb, b.reach, dt);
  const real margin = real(0.02) * thin + (ccd && always ? bound : std::min(bound, thin));
  const Manifold old = contact.manifold;
  const PointImpulse old_impulses[2] = {contact.impulses[0], contact.impulses[1]};
  contact.manifold =
      collide(a.hull, Pose{body_a.center, ma.rotation}, b.hull, Pose{body_b.center, mb.rotation}, margin);
  carry_over(old, old_impulses, contact);
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
