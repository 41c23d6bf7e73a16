#include "engine/sleep.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

constexpr real pi = real(3.14159265358979324);
constexpr real sqrt_2 = real(1.41421356237309505);
/// Of a body's size: so far may it stray and still be at rest. Piles of boxes tremble by a hundredth of it.
constexpr real leeway = real(0.02);
/// Of a body's size: whoever travels no farther in his rest time stands still.
constexpr real standstill = real(1e-4);
/// Of the way that the greatest speed would lead: what trembles comes less far. Boxes that tremble in a pile come to
/// 0.05 of it, at most to 0.2; what rolls comes to 1.
constexpr real most_of_trembling = real(0.25);
/// Of a body's coordinates: so far may rounding alone carry it.
constexpr real rounding = 64 * std::numeric_limits<real>::epsilon();
constexpr real without_gravity = real(0.5);  // s

/// As large as the square of that reach.
real size_of(real reach) { return sqrt_2 * reach; }

}  // namespace

real half_swing(real length, real gravity) { return pi * std::sqrt(length / gravity); }

real half_swing_on_spring(real mass, real stiffness) { return pi * std::sqrt(mass / stiffness); }

real standing_rest_time(real reach, real gravity) {
  return gravity > 0 ? half_swing(real(0.25) * size_of(reach), gravity) : without_gravity;
}

bool RestClock::look(const Body& body, const Motion& motion, const RestScale& scale, real dt) {
  const real strayed = length(body.center - center_) + scale.reach * std::abs(motion.angle - angle_);
  if (ticks_ == 0 || strayed > leeway * size_of(scale.reach)) {
    *this = {};
    center_ = body.center;
    angle_ = motion.angle;
  }
  fastest_ = std::max(fastest_, length(motion.velocity) + scale.reach * std::abs(motion.spin));
  ++ticks_;
  if (ticks_ <= scale.ticks) return false;
  // What sways has to come back before this tells it from what goes away: its clock runs on.
  const real way_at_fastest = fastest_ * dt * static_cast<real>(ticks_ - 1);
  const real nothing = standstill * size_of(scale.reach) + rounding * length(body.center);
  return strayed <= std::max(nothing, most_of_trembling * way_at_fastest);
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
