#include "golden/ticks.h"

#include <catch2/catch.hpp>

#include "engine/state_hash.h"

namespace proofreel {
namespace {

/// Twelve balls that fly, of which commands may change some, for 20 ticks.
TickTrace trace_of(const std::vector<std::pair<std::int64_t, Command>>& commands, int balls = 12) {
  Scene scene;
  for (int i = 0; i < balls; ++i) {
    BodyDef ball;
    ball.position = {3.0 * i, 0};
    ball.shapes.emplace_back();
    ball.shapes.back().points = {{0, 0}};
    ball.shapes.back().radius = 0.5;
    scene.bodies.push_back(ball);
  }
  const auto simulation = make_simulation(scene);
  TickRecorder recorder;
  std::uint64_t chain = chained_hash(0, simulation->state_hash());
  recorder.record(*simulation, scene.bodies.size(), chain);
  while (simulation->tick() < 20) {
    for (const auto& [tick, command] : commands) {
      if (tick == simulation->tick()) simulation->apply(command);
    }
    simulation->step();
    chain = chained_hash(chain, simulation->state_hash());
    recorder.record(*simulation, scene.bodies.size(), chain);
  }
  return recorder.trace();
}

Command push(std::uint32_t body) { return ApplyImpulse{static_cast<BodyId>(body), {1e-9, 0}, std::nullopt}; }

TEST_CASE("Equal runs have equal traces and nowhere part", "[ticks]") {
  CHECK(trace_of({}) == trace_of({}));
  CHECK_FALSE(first_divergence(trace_of({}), trace_of({}), 12).has_value());
}

TEST_CASE("A push of one body is found at its tick and in that body", "[ticks]") {
  for (const std::uint32_t body : {1U, 7U, 12U}) {
    const auto divergence = first_divergence(trace_of({}), trace_of({{9, push(body)}}), 12);
    REQUIRE(divergence.has_value());
    CHECK(divergence->tick == 10);
    CHECK(divergence->bodies == std::vector<std::uint32_t>{body});
  }
}

TEST_CASE("Two bodies pushed at once are both named; of three, none is", "[ticks]") {
  const auto two = first_divergence(trace_of({}), trace_of({{4, push(3)}, {4, push(11)}}), 12);
  REQUIRE(two.has_value());
  CHECK(two->tick == 5);
  CHECK(two->bodies == std::vector<std::uint32_t>{3, 11});
  const auto three = first_divergence(trace_of({}), trace_of({{4, push(3)}, {4, push(5)}, {4, push(11)}}), 12);
  REQUIRE(three.has_value());
  CHECK(three->tick == 5);
  CHECK(three->bodies.empty());
}

TEST_CASE("A body that goes away is the first to differ", "[ticks]") {
  const auto divergence = first_divergence(trace_of({}), trace_of({{6, RemoveBody{static_cast<BodyId>(4)}}}), 12);
  REQUIRE(divergence.has_value());
  CHECK(divergence->tick == 7);
  CHECK(divergence->bodies == std::vector<std::uint32_t>{4});
}

TEST_CASE("A scene of one body keeps no sums, and still names it", "[ticks]") {
  const TickTrace trace = trace_of({}, 1);
  CHECK(trace.body_sums.empty());
  CHECK(bytes_of(trace).size() == 5 + 2 * 21);
  const auto divergence = first_divergence(trace, trace_of({{2, push(1)}}, 1), 1);
  REQUIRE(divergence.has_value());
  CHECK(divergence->tick == 3);
  CHECK(divergence->bodies == std::vector<std::uint32_t>{1});
}

TEST_CASE("Runs of different length are compared as far as both go", "[ticks]") {
  TickTrace shorter = trace_of({});
  shorter.pieces.resize(15);
  shorter.body_sums.resize(15 * TickTrace::sums);
  CHECK_FALSE(first_divergence(shorter, trace_of({}), 12).has_value());
  CHECK(first_divergence(shorter, trace_of({{9, push(2)}}), 12)->tick == 10);
  CHECK_FALSE(first_divergence(shorter, trace_of({{14, push(2)}}), 12).has_value());
}

TEST_CASE("A trace comes back from its bytes, and nothing from other bytes", "[ticks]") {
  for (const int balls : {1, 12}) {
    const TickTrace trace = trace_of({}, balls);
    std::vector<std::uint8_t> bytes = bytes_of(trace);
    CHECK(tick_trace_from(bytes) == trace);
    bytes.pop_back();
    CHECK_FALSE(tick_trace_from(bytes).has_value());
    bytes.resize(4);
    CHECK_FALSE(tick_trace_from(bytes).has_value());
    bytes = bytes_of(trace);
    bytes[4] = 3;
    CHECK_FALSE(tick_trace_from(bytes).has_value());
    bytes[0] = 'X';
    CHECK_FALSE(tick_trace_from(bytes).has_value());
  }
  CHECK_FALSE(tick_trace_from({}).has_value());
}

}  // namespace
}  // namespace proofreel
