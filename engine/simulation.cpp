#include "engine/simulation.h"

#include "engine/mass.h"
#include "engine/rot.h"

namespace proofreel {

// The engine's two compilations. Their headers cannot both be included here, so their one entry point is declared by
// hand.
namespace float32 {
std::unique_ptr<Simulation> make_world(const Scene& scene);
}
namespace float64 {
std::unique_ptr<Simulation> make_world(const Scene& scene);
}

std::unique_ptr<Simulation> make_simulation(const Scene& scene) {
  return scene.method.precision == Precision::float32 ? float32::make_world(scene) : float64::make_world(scene);
}

BodyState initial_state(const BodyDef& body) {
  const MassProperties mass = mass_of(body);
  BodyState state;
  state.position = body.position;
  state.center = body.position + rotate(Rotd(body.angle), mass.center);
  state.angle = body.angle;
  if (body.type != BodyType::fixed) {
    state.velocity = body.velocity;
    state.spin = body.spin;
  }
  state.mass = mass.mass;
  state.inertia = mass.inertia;
  return state;
}

}  // namespace proofreel
