/// Drag_to: pulls a point of a body towards a point of the world as a hand would, by a critically damped spring
///
///   F = -m w^2 e - 2 m w de/dt,    e = anchor - target,    w = 2 pi * 5 Hz,    |F| <= max_force
///
/// of the body's own mass m, so that light and heavy bodies follow alike. It is taken implicitly (e and de/dt at the
/// end of the step, Catto 2011), and so is stable at any rate: with the point's mass matrix K the impulse solves
/// (K + g 1) P = -(v + b e),  g = 1 / (h (c + h k)),  b = k / (c + h k),  k = m w^2, c = 2 m w.

#include "engine/joints/kinds.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

constexpr real angular_frequency = real(31.415926535897932);  // five oscillations per second

Mat2 mass_matrix(const Motion& m, Vec2 arm, real extra) {
  const real xy = -m.inv_inertia * arm.x * arm.y;
  return {{m.inv_mass + m.inv_inertia * arm.y * arm.y + extra, xy},
          {xy, m.inv_mass + m.inv_inertia * arm.x * arm.x + extra}};
}

}  // namespace

double pull(Joint& joint, const std::vector<Body>& bodies, std::vector<Motion>& motions, real h) {
  const Body& body = bodies[joint.body_b];
  Motion& motion = motions[joint.body_b];
  if (motion.inv_mass <= 0) return 0;
  const Vec2 arm = rotate(motion.rotation, joint.local_b);
  const Vec2 error = (body.center - joint.target) + (motion.delta + arm);
  const real stiffness = body.mass * angular_frequency * angular_frequency;
  const real damping = 2 * body.mass * angular_frequency;
  const real give = 1 / (h * (damping + h * stiffness));
  const real pull_back = stiffness / (damping + h * stiffness);
  const Vec2 before = motion.velocity_at(arm);
  Vec2 impulse = solve(mass_matrix(motion, arm, give), -(before + pull_back * error));
  const real most = h * joint.max_force;
  if (length(impulse) > most) impulse = (most / length(impulse)) * impulse;
  motion.push(impulse, arm);
  joint.impulse += impulse;
  return 0.5 * static_cast<double>(dot(impulse, before + motion.velocity_at(arm)));
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
