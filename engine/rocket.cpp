#include "engine/rocket.h"

#include <algorithm>

#include "engine/elementary.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

double kinetic_energy(const Body& body, const Motion& motion) {
  const Vec2d velocity(motion.velocity);
  const auto spin = static_cast<double>(motion.spin);
  return 0.5 *
         (static_cast<double>(body.mass) * length_squared(velocity) + static_cast<double>(body.inertia) * spin * spin);
}

void scale_mass(Body& body, Motion& motion, double factor) {
  const auto scale = static_cast<real>(factor);
  body.given_mass = body.given_mass.value_or(static_cast<double>(body.mass)) * factor;
  body.mass = static_cast<real>(*body.given_mass);
  body.inertia *= scale;
  if (body.given_inertia) *body.given_inertia *= factor;
  motion.inv_mass = real(1) / body.mass;
  motion.inv_inertia /= scale;
}

}  // namespace

double burn(Rocket& rocket, Body& body, Motion& motion, real h) {
  if (rocket.fuel <= 0 || !body.alive || motion.inv_mass <= 0) return 0;
  const double before = kinetic_energy(body, motion);
  const double burnt = std::min(rocket.fuel, rocket.burn_rate * static_cast<double>(h));
  const double mass = body.given_mass.value_or(static_cast<double>(body.mass));
  const double factor = 1 - burnt / mass;
  // The impulse that gives this gain in speed to the mass of now.
  const double impulse = mass * rocket.thrust / rocket.burn_rate * -elementary::log(factor);
  const Rotd rotation(motion.rotation);
  motion.push(Vec2(rotate(rotation, Vec2d{0, impulse})), Vec2(rotate(rotation, rocket.at)));
  scale_mass(body, motion, factor);
  rocket.fuel -= burnt;
  return kinetic_energy(body, motion) - before;
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
