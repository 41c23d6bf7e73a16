#pragma once

/// Pairs of shapes that are near each other, kept from step to step, so that the solver starts from the impulses it
/// found last time (warm starting).

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "engine/body.h"
#include "engine/broad_phase.h"
#include "engine/collide.h"
#include "engine/simulation.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

/// What a contact point remembers. Impulses in N s.
struct PointImpulse {
  real normal = 0;        ///< of the last substep
  real tangent = 0;       ///< along the normal turned a quarter counter-clockwise
  real normal_total = 0;  ///< over the last tick
  real tangent_total = 0;
};

/// How exact contacts have fared with the group of a contact (exact_contacts.h).
struct Patience {
  std::uint8_t failures = 0;    ///< ticks in which it has not settled, less those in which it has
  std::uint8_t soft_ticks = 0;  ///< for so many more it is left to the sweeps
};

struct Contact {
  ShapeIndex shape_a = 0;
  ShapeIndex shape_b = 0;
  BodyIndex body_a = 0;
  BodyIndex body_b = 0;
  bool sensor = false;
  bool touching = false;
  bool parting = false;  ///< they were deep inside each other when they met, and have not come apart yet
  bool sliding = false;  ///< of the two coefficients of friction the kinetic one counts
  Patience patience;
  std::uint32_t number = 0;  ///< in order of creation
  real friction_at_rest = 0;
  real friction_sliding = 0;
  real restitution = 0;
  real rolling_resistance = 0;  ///< lever, m
  real surface_speed = 0;       ///< of A's surface and B's together, against each other, m/s
  real approach = 0;            ///< speed at which they met, m/s along the normal; until they touch, that of now
  Manifold manifold;
  Vec2 a_to_b;  ///< from A's centre to B's when they touch as the manifold says: now, or at the predicted impact
  PointImpulse impulses[2];
  real rolling_impulse = 0;  ///< N m s on B in the last substep
};

/// Whether one side has pushed the other during the last tick.
inline bool pushes(const Contact& contact) {
  bool any = false;
  for (int k = 0; k < contact.manifold.count; ++k) any |= contact.impulses[k].normal_total > 0;
  return any;
}

inline SeparationEvent separation_of(const Contact& contact) {
  return {static_cast<BodyId>(contact.body_a), static_cast<BodyId>(contact.body_b)};
}

/// Coefficients of two shapes together: friction sqrt(a b), static with static and kinetic with kinetic; restitution
/// and rolling resistance the larger; surface speeds summed.
void mix_materials(Contact& contact, const Shape& a, const Shape& b);

/// How fast the shapes come together along the normal, m/s, where they will touch or do; there must be a point.
real approach_speed(const Contact& contact, const Motion& a, const Motion& b);

/// How far two shapes are apart, m; negative on overlap, and without bound from `margin` on.
real gap_between(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, real margin);

/// How near each other two shapes are looked at whether or not anything moves, as a part of the pair's thickness.
inline constexpr real near_part = real(0.02);

/// How far a tick can be foreseen.
struct Foresight {
  real dt = 0;                          ///< a tick, s
  bool ccd = false;                     ///< as far as the bodies may move
  std::span<const Vec2> accelerations;  ///< of the bodies, m/s^2; none where nothing accelerates
};

/// A bound on how far a body falls within a tick, m. Clamped, since boxes must stay finite: no scene is larger.
inline real fall_within(real dt, Vec2 acceleration) {
  return std::min(dt * dt * (std::abs(acceleration.x) + std::abs(acceleration.y)), real(1e9));
}

/// Runs the narrow phase for one contact and carries the impulses over to the points that are still the same. Surfaces
/// that may meet within a tick are in the manifold too (speculative contacts): by the speeds of now, and by what
/// accelerates the bodies, so that what lies a hair's breadth above another does not begin to fall.
void update_manifold(Contact& contact, const std::vector<Shape>& shapes, const std::vector<Body>& bodies,
                     const std::vector<Motion>& motions, const Foresight& foresight);

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
