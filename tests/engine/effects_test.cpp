#include "engine/effects.h"

#include <catch2/catch.hpp>

#include "tests/engine/scenes.h"

using namespace proofreel;
using namespace proofreel::test;

namespace {

Scene falling_disc() {
  Scene scene;
  scene.bodies = {body_with(disc_shape(0.5), {0, 3})};
  return scene;
}

}  // namespace

TEST_CASE("A lone body calls for gravity and nothing else", "[effects]") {
  EffectSet gravity_only;
  gravity_only.add(Effect::gravity);
  CHECK(effects_of(falling_disc()) == gravity_only);
}

TEST_CASE("Without gravity a lone body calls for nothing", "[effects]") {
  Scene scene = falling_disc();
  scene.gravity = {0, 0};
  CHECK(effects_of(scene) == EffectSet{});
}

TEST_CASE("A second shape calls for contacts, and contacts bring continuous collision", "[effects]") {
  Scene scene = falling_disc();
  scene.bodies.push_back(floor_body());
  CHECK(effects_of(scene).has(Effect::contacts));
  CHECK(effects_of(scene).has(Effect::ccd));
  CHECK(effects_of(scene).has(Effect::friction));
  CHECK_FALSE(effects_of(scene).has(Effect::restitution));
  scene.bodies[0].shapes[0].restitution = 0.1;
  CHECK(effects_of(scene).has(Effect::restitution));
}

TEST_CASE("Bodies that nothing moves never call for contacts", "[effects]") {
  Scene scene;
  scene.bodies = {floor_body(), floor_body()};
  CHECK_FALSE(effects_of(scene).has(Effect::contacts));
}

TEST_CASE("Bodies whose filters keep them apart call for no contacts", "[effects]") {
  Scene scene = falling_disc();
  scene.bodies.push_back(falling_disc().bodies[0]);
  CHECK(effects_of(scene).has(Effect::contacts));
  scene.bodies[0].filter.group = scene.bodies[1].filter.group = -1;
  CHECK_FALSE(effects_of(scene).has(Effect::contacts));
  scene.bodies.push_back(floor_body());
  CHECK(effects_of(scene).has(Effect::contacts));
}

TEST_CASE("Springs and rigid joints are told apart", "[effects]") {
  Scene scene = falling_disc();
  scene.joints = {joint_between(JointKind::spring, BodyId::world, {0, 0}, BodyId{1}, {0, 0}, 1)};
  CHECK(effects_of(scene).has(Effect::springs));
  CHECK_FALSE(effects_of(scene).has(Effect::joints));
}

TEST_CASE("A listed set is taken as it is", "[effects]") {
  Scene scene = falling_disc();
  scene.effects = EffectSet{};
  CHECK(effects_of(scene) == EffectSet{});
  auto simulation = simulate(scene);
  run(*simulation, 1);
  CHECK(simulation->body(BodyId{1}).position == Vec2d{0, 3});
}

TEST_CASE("An effect with nothing to act on changes no bit", "[effects]") {
  Scene scene = falling_disc();
  EffectSet set;
  set.add(Effect::gravity);
  scene.effects = set;
  auto plain = simulate(scene);
  for (int e = 0; e < effect_count; ++e) set.add(static_cast<Effect>(e));
  scene.effects = set;
  auto full = simulate(scene);
  for (int i = 0; i < 240; ++i) {
    plain->step();
    full->step();
    REQUIRE(plain->state_hash() == full->state_hash());
  }
}

TEST_CASE("Every effect is decided once, and the decisions are what is inferred", "[effects]") {
  const Scene scene = falling_disc();
  const std::vector<EffectDecision> decisions = simulate(scene)->effects();
  REQUIRE(decisions.size() == effect_count);
  EffectSet on;
  for (const EffectDecision& decision : decisions) {
    CHECK_FALSE(decision.why.empty());
    if (decision.on) on.add(decision.effect);
  }
  CHECK(on == effects_of(scene));
}

TEST_CASE("Being timed changes no bit, and what is off takes no time", "[effects]") {
  const Scene scene = falling_disc();
  const auto plain = simulate(scene);
  const auto timed = simulate(scene);
  StageTimes times;
  timed->time_stages(&times);
  for (int i = 0; i < 240; ++i) {
    plain->step();
    timed->step();
    REQUIRE(plain->state_hash() == timed->state_hash());
  }
  CHECK(times.of(StepStage::motion) > 0);
  CHECK(times.of(StepStage::broad_phase) == 0);
  CHECK(times.of(StepStage::drag) == 0);
}
