#include "lab/effect_cost.h"

#include "engine/scene.h"
#include "lab/callgrind.h"

namespace proofreel {
namespace {

constexpr int few = 64;
constexpr int many = 192;
constexpr int measured_ticks = 16;  // as in effect_steps.cpp

std::int64_t count(const std::string& scene, int bodies) {
  return instructions({PROOFREEL_EFFECT_STEPS, scene, std::to_string(bodies)}, "*measured_steps*");
}

}  // namespace

double effect_cost(const std::string& scene) {
  const int steps = (many - few) * measured_ticks * Method{}.substeps;
  return static_cast<double>(count(scene, many) - count(scene, few)) / steps;
}

}  // namespace proofreel
