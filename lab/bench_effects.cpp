#include <cstdio>
#include <fstream>
#include <map>
#include <string>

#include "lab/bench.h"
#include "lab/effect_cost.h"
#include "lab/effect_scenes.h"

namespace proofreel {
namespace {

/// The committed slopes: a name, a tab, a number.
std::map<std::string, double> committed_slopes() {
  std::ifstream file(PROOFREEL_EFFECT_COSTS);
  std::map<std::string, double> slopes;
  std::string name;
  double value = 0;
  while (std::getline(file, name, '\t') && file >> value) {
    slopes[name] = value;
    file.ignore(1);
  }
  return slopes;
}

void print_row(const std::string& name, double measured, const std::map<std::string, double>& committed) {
  const auto known = committed.find(name);
  if (known == committed.end()) {
    std::printf("  %-20s %9.2f  not committed\n", name.c_str(), measured);
  } else {
    std::printf("  %-20s %9.2f  %9.2f  %+.2f\n", name.c_str(), measured, known->second, measured - known->second);
  }
}

}  // namespace

void bench_effects() {
  const std::map<std::string, double> committed = committed_slopes();
  std::printf("  instructions per body and substep (double; valgrind)\n");
  std::printf("  %-20s %9s  %9s  change\n", "effect", "measured", "committed");
  print_row("by hand", effect_cost("by hand"), committed);
  for (const EffectScene& scene : effect_scenes()) print_row(scene.name, effect_cost(scene.name), committed);
}

}  // namespace proofreel
