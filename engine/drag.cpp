#include "engine/drag.h"

#include "engine/elementary.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

/// (1 - exp(-x)) / x for x >= 0, without the loss of digits near 0.
double decay_mean(double x) {
  if (x > 0.01) return (1 - elementary::exp(-x)) / x;
  return 1 - x / 2 * (1 - x / 3 * (1 - x / 4 * (1 - x / 5 * (1 - x / 6))));
}

/// The part of the speed that is left: with k = linear / m and q = quadratic / m, the Bernoulli equation
/// ds/dt = -(k + q s) s has the solution s(h) = s e / (1 + q s h (1 - e) / (k h)), e = exp(-k h).
double speed_left(double k, double q, double speed, double h) {
  return elementary::exp(-k * h) / (1 + q * speed * h * decay_mean(k * h));
}

}  // namespace

void apply_drag(Motion& motion, const DragDef& drag, Vec2 wind, real h) {
  const Vec2 relative = motion.velocity - wind;
  const auto inv_mass = static_cast<double>(motion.inv_mass);
  const double left = speed_left(drag.linear * inv_mass, drag.quadratic * inv_mass,
                                 static_cast<double>(length(relative)), static_cast<double>(h));
  motion.velocity = wind + static_cast<real>(left) * relative;
  const double turning = drag.angular * static_cast<double>(motion.inv_inertia);
  motion.spin *= static_cast<real>(elementary::exp(-turning * static_cast<double>(h)));
}

void add_drag(const Motion& motion, const DragDef& drag, Vec2 wind, Slope& slope) {
  const Vec2 relative = motion.velocity - wind;
  const real factor = static_cast<real>(drag.linear) + static_cast<real>(drag.quadratic) * length(relative);
  slope.acceleration -= factor * motion.inv_mass * relative;
  slope.angular_acceleration -= static_cast<real>(drag.angular) * motion.inv_inertia * motion.spin;
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
