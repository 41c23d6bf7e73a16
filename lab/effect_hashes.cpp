// effect_hashes: steps small scenes that together call for every effect and prints the hash of each one's trajectory.
// Run natively and in WebAssembly, it must print the same.

#include <cstdio>

#include "engine/simulation.h"
#include "lab/effect_scenes.h"
#include "lab/mixed_scenes.h"

using namespace proofreel;

namespace {

constexpr int bodies = 24;
constexpr int ticks = 480;

std::uint64_t trajectory_hash(Scene scene, Precision precision) {
  scene.method.precision = precision;
  const auto simulation = make_simulation(scene);
  std::uint64_t hash = chained_hash(0, simulation->state_hash());
  for (int i = 0; i < ticks; ++i) {
    simulation->step();
    hash = chained_hash(hash, simulation->state_hash());
  }
  return hash;
}

void print_hashes(const EffectScene& scene) {
  const auto single = static_cast<unsigned long long>(trajectory_hash(scene.make(bodies), Precision::float32));
  const auto full = static_cast<unsigned long long>(trajectory_hash(scene.make(bodies), Precision::float64));
  std::printf("%-20s %016llx %016llx\n", scene.name.c_str(), single, full);
}

}  // namespace

int main() {
  for (const EffectScene& scene : effect_scenes()) print_hashes(scene);
  for (const EffectScene& scene : mixed_scenes()) print_hashes(scene);
  return 0;
}
