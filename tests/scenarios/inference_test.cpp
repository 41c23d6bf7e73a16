#include <catch2/catch.hpp>

#include "scenarios/runner.h"
#include "tests/scenarios/scene_text.h"

using namespace proofreel;

namespace {

/// All effects that a run has called for in the end, as `--set effects=` wants them.
std::string effects_of_run(const Runner& runner) {
  std::string list;
  for (const EffectDecision& decision : runner.simulation().effects()) {
    if (decision.on) list += (list.empty() ? "{" : ",") + std::string(name_of(decision.effect));
  }
  return list.empty() ? "{}" : list + "}";
}

}  // namespace

TEST_CASE("What is inferred from a scenario is what its explicit list gives, to the last bit") {
  constexpr std::int64_t ticks = 400;
  const auto step = [](Runner& runner) {
    while (!runner.finished() && runner.tick() < ticks) runner.step();
  };
  for (const std::string& path : all_scenarios()) {
    INFO(path);
    std::vector<Override> set = shortened(path);
    const auto inferred = load_scenario(path, set);
    Runner runner(*inferred);
    step(runner);
    set.push_back({"effects", effects_of_run(runner)});
    const auto listed = load_scenario(path, set);
    Runner same(*listed);
    step(same);
    CHECK(same.trajectory_hash() == runner.trajectory_hash());
  }
}
