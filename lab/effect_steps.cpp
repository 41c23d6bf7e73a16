// effect_steps SCENE BODIES: steps one of the effect scenes, for valgrind to count the instructions of. SCENE "by hand"
// is what bodies under gravity take when somebody writes the loop for just them.

#include <cstdio>
#include <cstdlib>
#include <string>

#include "engine/free_motion.h"
#include "engine/simulation.h"
#include "lab/effect_scenes.h"

using namespace proofreel;

namespace {

constexpr int warm_up_ticks = 4;  // contacts and impulses settle
constexpr int measured_ticks = 16;

[[gnu::noinline]] void measured_steps(Simulation& simulation) {
  for (int i = 0; i < measured_ticks; ++i) simulation.step();
}

/// Verlet, on the same numbers: half a kick, drift, half a kick. Not specialised for the one caller it has here, who
/// knows the number of substeps.
[[gnu::noipa]] void measured_steps(std::vector<Body>& bodies, std::vector<Motion>& motions,
                                   const std::vector<Vec2>& accelerations, int substeps, real h) {
  for (int tick = 0; tick < measured_ticks; ++tick) {
    const Vec2* acceleration = accelerations.data();
    Body* body = bodies.data();
    for (Motion& m : motions) {
      const Vec2 gain = real(0.5) * h * *acceleration++;
      Vec2 velocity = m.velocity;
      Vec2 way;
      for (int k = 0; k < substeps; ++k) {
        velocity += gain;
        way += h * velocity;
        velocity += gain;
      }
      for (int k = 0; m.spin != 0 && k < substeps; ++k) turn_on(m, h);
      m.velocity = velocity;
      (body++)->center += way;
    }
  }
}

int step_by_hand(int count) {
  Scene scene;
  std::vector<Body> bodies(static_cast<std::size_t>(count) + 1);
  std::vector<Motion> motions(bodies.size());
  for (Motion& motion : motions) motion.velocity = {real(0.5), real(0.25)};
  const std::vector<Vec2> accelerations(bodies.size(), Vec2(scene.gravity));
  measured_steps(bodies, motions, accelerations, scene.method.substeps,
                 real(1) / static_cast<real>(scene.rate * scene.method.substeps));
  return bodies.back().center.y == 0 ? 1 : 0;
}

int step_scene(const EffectScene& scene, int count) {
  const auto simulation = make_simulation(scene.make(count));
  for (int i = 0; i < warm_up_ticks; ++i) simulation->step();
  measured_steps(*simulation);
  return simulation->failure() ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string name = argc == 3 ? argv[1] : "";
  const int count = argc == 3 ? std::atoi(argv[2]) : 0;
  if (name == "by hand") return step_by_hand(count);
  for (const EffectScene& scene : effect_scenes()) {
    if (scene.name == name) return step_scene(scene, count);
  }
  std::fputs("usage: effect_steps SCENE BODIES\n", stderr);
  return 2;
}
