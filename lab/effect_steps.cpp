// effect_steps SCENE BODIES: steps one of the effect scenes, for valgrind to count the instructions of. SCENE "by hand"
// is what bodies under gravity take when somebody writes the loop for just them.

#include <cstdio>
#include <cstdlib>
#include <string>

#include "engine/simulation.h"
#include "lab/effect_by_hand.h"
#include "lab/effect_scenes.h"

using namespace proofreel;

namespace {

constexpr int warm_up_ticks = 4;  // contacts and impulses settle
constexpr int measured_ticks = 16;

[[gnu::noinline]] void measured_steps(Simulation& simulation) {
  for (int i = 0; i < measured_ticks; ++i) simulation.step();
}

int step_by_hand(int count) {
  Scene scene;
  std::vector<Body> bodies(static_cast<std::size_t>(count) + 1);
  std::vector<Motion> motions(bodies.size());
  for (Motion& motion : motions) motion.velocity = {real(0.5), real(0.25)};
  const std::vector<Vec2> accelerations(bodies.size(), Vec2(scene.gravity));
  const real h = real(1) / static_cast<real>(scene.rate * scene.method.substeps);
  measured_steps_by_hand(bodies, motions, accelerations, {measured_ticks, scene.method.substeps, h});
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
