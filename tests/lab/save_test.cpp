#include <catch2/catch.hpp>

#include "engine/archive.h"
#include "engine/simulation.h"
#include "engine/state_hash.h"
#include "lab/mixed_scenes.h"

namespace proofreel {
namespace {

constexpr int bodies = 24;

/// Motion, energies, contacts, joints, tree and events, as one number.
std::uint64_t seen_in(const Simulation& simulation) {
  ArchiveWriter all;
  Snapshot shot;
  simulation.observe(shot);
  all(simulation.state_hash(), shot.energy.kinetic, shot.energy.potential, shot.energy.booked_work);
  for (const BodyView& body : shot.bodies) all(body.force);
  for (const ContactView& contact : shot.contacts) {
    for (const ContactPoint& p : contact.points) all(p.point, p.separation, p.normal_impulse, p.tangent_impulse);
  }
  for (const JointView& joint : shot.joints) all(joint.anchor_b, joint.reaction, joint.torque, joint.gap);
  for (const TreeBoxView& node : shot.tree) all(node.box, node.depth);
  for (const ContactEvent& event : simulation.contact_events()) all(event.point, event.impulse);
  for (const BreakEvent& event : simulation.break_events()) all(event.reaction);
  return hash_of(all.bytes().data(), all.bytes().size());
}

void check_saving(Scene scene, Precision precision, int ticks) {
  scene.method.precision = precision;
  const auto unbroken = make_simulation(scene);
  auto moving = make_simulation(scene);
  for (Simulation* each : {unbroken.get(), moving.get()}) each->keep_forces();
  for (int i = 0; i < ticks; ++i) {
    if (i % 29 == 0) {
      auto fresh = make_simulation(scene);
      fresh->keep_forces();
      REQUIRE(fresh->restore(moving->save()) == std::nullopt);
      moving = std::move(fresh);
    }
    unbroken->step();
    moving->step();
    INFO("tick " << i + 1);
    REQUIRE(seen_in(*moving) == seen_in(*unbroken));
  }
}

TEST_CASE("Scenes of every effect go on from any tick as if they had never stopped", "[lab]") {
  const auto precision = GENERATE(Precision::float32, Precision::float64);
  for (const EffectScene& scene : effect_scenes()) {
    INFO(scene.name);
    check_saving(scene.make(bodies), precision, 120);
  }
}

TEST_CASE("Heaps and linkages go on from any tick as if they had never stopped", "[lab]") {
  const auto precision = GENERATE(Precision::float32, Precision::float64);
  for (const EffectScene& scene : mixed_scenes()) {
    INFO(scene.name);
    check_saving(scene.make(bodies), precision, 480);
  }
}

}  // namespace
}  // namespace proofreel
