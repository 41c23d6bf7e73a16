#include "lab/effect_by_hand.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

void measured_steps_by_hand(std::vector<Body>& bodies, std::vector<Motion>& motions,
                            const std::vector<Vec2>& accelerations, const HandSteps& steps) {
  for (int tick = 0; tick < steps.ticks; ++tick) {
    const Vec2* acceleration = accelerations.data();
    Body* body = bodies.data();
    for (Motion& m : motions) {
      const Vec2 gain = real(0.5) * steps.h * *acceleration++;
      Vec2 velocity = m.velocity;
      Vec2 way;
      for (int k = 0; k < steps.substeps; ++k) {
        velocity += gain;
        way += steps.h * velocity;
        velocity += gain;
      }
      for (int k = 0; m.spin != 0 && k < steps.substeps; ++k) turn_on(m, steps.h);
      m.velocity = velocity;
      (body++)->center += way;
    }
  }
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
