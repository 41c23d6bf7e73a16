#include "engine/buoyancy.h"

#include <algorithm>
#include <cmath>

#include "engine/elementary.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

/// The solution of dp/dt = -(a p + b q), dq/dt = -(b p + d q) after `h` seconds, for a matrix without negative
/// eigenvalues: those are slow and fast, and with their mean m and half distance r the exponential of -h X is
/// (e_slow + e_fast) / 2 - (e_slow - e_fast) / (2 r) (X - m).
void decay(double a, double b, double d, double h, double& p, double& q) {
  const double mean = (a + d) / 2;
  const double lean = (a - d) / 2;
  const double r = std::sqrt(lean * lean + b * b);
  const double fast = mean + r;
  const double slow = std::max(0.0, a * d - b * b) / fast;  // mean - r without loss of digits
  const double e_slow = elementary::exp(-slow * h);
  const double e_fast = elementary::exp(-fast * h);
  const double even = (e_slow + e_fast) / 2;
  const double odd = r > 0 ? (e_slow - e_fast) / (2 * r) : 0;
  const double p_before = p;
  p = even * p - odd * (lean * p + b * q);
  q = even * q - odd * (b * p_before - lean * q);
}

}  // namespace

Wetted wetted_part(const WaterDef& water, const Body& body, const Motion& motion, const std::vector<Shape>& shapes) {
  const auto delta = static_cast<double>(motion.delta.y);
  const double level = (water.level - static_cast<double>(body.center.y)) - delta;
  Wetted sum;
  for (const ShapeIndex i : body.shapes) sum += wetted_part(shapes[i].hull, motion.rotation, level);
  return sum;
}

void lift(Motion& motion, const WaterDef& water, const Wetted& wetted, double gravity, real h) {
  const double per_area = static_cast<double>(h) * water.density * gravity;
  motion.velocity.y += motion.inv_mass * static_cast<real>(per_area * wetted.area);
  motion.spin += motion.inv_inertia * static_cast<real>(per_area * wetted.first.x);
}

double water_potential(const WaterDef& water, const Wetted& wetted, double depth_of_center, double gravity) {
  return water.density * gravity * (depth_of_center * wetted.area - wetted.first.y);
}

/// Along the way from the centre of mass to the wetted centroid, velocity decays by itself; across it, together with
/// the spin. That pair is told in the same unit, in which its matrix is symmetric.
void resist(Motion& motion, const WaterDef& water, const Wetted& wetted, real h) {
  if (wetted.area <= 0) return;
  const auto inv_mass = static_cast<double>(motion.inv_mass);
  const auto inv_inertia = static_cast<double>(motion.inv_inertia);
  const auto seconds = static_cast<double>(h);
  const double slowing = water.drag * wetted.area * inv_mass;
  if (inv_inertia <= 0) {
    motion.velocity *= static_cast<real>(elementary::exp(-slowing * seconds));
    return;
  }
  const double arm = length(wetted.first);
  const Vec2d along = arm > 0 ? (1 / arm) * wetted.first : Vec2d{1, 0};
  const Vec2d velocity(motion.velocity);
  const double straight = dot(velocity, along) * elementary::exp(-slowing * seconds);
  const double radius_of_gyration = std::sqrt(inv_mass / inv_inertia);
  double across = dot(velocity, perp(along));
  double turning = radius_of_gyration * static_cast<double>(motion.spin);
  const double coupling = water.drag * arm * std::sqrt(inv_mass * inv_inertia);
  decay(slowing, coupling, water.drag * wetted.second * inv_inertia, seconds, across, turning);
  motion.velocity = Vec2(straight * along + across * perp(along));
  motion.spin = static_cast<real>(turning / radius_of_gyration);
}

void add_resistance(const Motion& motion, const WaterDef& water, const Wetted& wetted, Slope& slope) {
  const auto spin = static_cast<double>(motion.spin);
  const Vec2d velocity(motion.velocity);
  const Vec2d force = -water.drag * (wetted.area * velocity + cross(spin, wetted.first));
  const double torque = -water.drag * (cross(wetted.first, velocity) + wetted.second * spin);
  slope.acceleration += motion.inv_mass * Vec2(force);
  slope.angular_acceleration += motion.inv_inertia * static_cast<real>(torque);
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
