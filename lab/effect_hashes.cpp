// effect_hashes: steps small scenes that together call for every effect and prints the hash of each one's trajectory.
// Run natively and in WebAssembly, it must print the same.

#include <cstdio>
#include <string>
#include <vector>

#include "engine/simulation.h"
#include "lab/effect_scenes.h"

using namespace proofreel;

namespace {

constexpr int bodies = 24;
constexpr int ticks = 480;

/// Discs, capsules, triangles and rounded boxes that fall into a heap, with everything contacts can do.
Scene heap(int count) {
  const std::vector<std::vector<Vec2d>> outlines{{{0, 0}},
                                                 {{-0.3, 0}, {0.3, 0}},
                                                 {{-0.4, -0.3}, {0.4, -0.3}, {0, 0.5}},
                                                 {{-0.3, -0.2}, {0.3, -0.2}, {0.3, 0.2}, {-0.3, 0.2}}};
  Scene scene;
  BodyDef floor;
  floor.type = BodyType::fixed;
  floor.shapes.emplace_back().points = {{-20, -1}, {20, -1}, {20, 0}, {-20, 0}};
  scene.bodies.push_back(floor);
  for (int i = 0; i < count; ++i) {
    BodyDef body;
    body.position = {0.3 * (i % 4), 1 + 0.7 * i};
    body.spin = 1 - 0.1 * i;
    ShapeDef& shape = body.shapes.emplace_back();
    shape.points = outlines[static_cast<std::size_t>(i) % outlines.size()];
    shape.radius = shape.points.size() == 3 ? 0 : 0.2;
    shape.friction = {0.6, 0.4};
    shape.restitution = i % 3 == 0 ? 0.5 : 0;
    scene.bodies.push_back(body);
  }
  return scene;
}

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
  std::printf("%-18s %016llx %016llx\n", scene.name.c_str(), single, full);
}

}  // namespace

int main() {
  for (const EffectScene& scene : effect_scenes()) print_hashes(scene);
  print_hashes({"heap", heap});
  return 0;
}
