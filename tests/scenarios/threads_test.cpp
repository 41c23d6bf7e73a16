#include <catch2/catch.hpp>
#include <future>

#include "scenarios/runner.h"
#include "tests/scenarios/scene_text.h"

using namespace proofreel;

namespace {

std::uint64_t hash_of_run(const char* method) {
  const auto scenario = load_text(std::string("scenario{duration=1, method={") + method + R"(}}
    ground{y=0}
    for i = 1, 12 do body{at={0.3 * math.random(), 0.6 * i}, shape=regular{sides=3 + i % 4, radius=0.25}} end
    local a = body{at={3, 3}, shape=box{width=1, height=0.2}}
    revolute{world, a, at={2.5, 3}}
    every(0.1, function() body{at={-1, 4}, shape=circle{radius=0.2}, restitution=0.5} end))");
  return Runner(*scenario).finish().trajectory_hash;
}

}  // namespace

TEST_CASE("Runs beside each other on two and on four threads give the bits of a run alone") {
  const char* method = GENERATE("", "precision='single'", "contact_solver='exact'");
  const std::uint64_t alone = hash_of_run(method);
  for (const int threads : {2, 4}) {
    std::vector<std::future<std::uint64_t>> runs;
    for (int i = 0; i < threads; ++i) runs.push_back(std::async(std::launch::async, hash_of_run, method));
    for (auto& run : runs) CHECK(run.get() == alone);
  }
}
