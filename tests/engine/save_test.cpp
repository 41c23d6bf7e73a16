#include <catch2/catch.hpp>

#include "engine/scene_archive.h"
#include "tests/engine/random.h"
#include "tests/engine/saved_scenes.h"

using namespace proofreel;
using namespace proofreel::test;
using Catch::Matchers::Contains;

namespace {

constexpr Mark mark{'p', 'r', 'o', 'o', 'f', 'r', 's', 't'};
constexpr std::size_t head_size = 20;
constexpr std::uint8_t version = 5;

/// Everything a picture may show and a script may ask, as one number.
std::uint64_t seen_in(const Simulation& simulation) {
  ArchiveWriter all;
  Snapshot shot;
  simulation.observe(shot);
  all(simulation.state_hash(), shot.tick, shot.energy.kinetic, shot.energy.potential, shot.energy.booked_work);
  for (const BodyView& b : shot.bodies)
    all(b.state.position, b.state.angle, b.state.mass, b.state.inertia, b.force, b.sensor, b.color, b.shape_count);
  all(shot.points);
  for (const Aabbd& box : shot.aabbs) all(box);
  for (const ContactView& c : shot.contacts) {
    all(c.normal);
    for (const ContactPoint& p : c.points) all(p.point, p.separation, p.normal_impulse, p.tangent_impulse);
  }
  const auto joints = shot.joints.empty() ? 0U : static_cast<std::uint32_t>(shot.joints.back().id);
  for (std::uint32_t i = 0; i < joints; ++i) all(simulation.joint(JointId{i}).broken);  // those that are gone, too
  for (const JointView& j : shot.joints) all(j.anchor_a, j.reaction, j.torque, j.gap, j.broken);
  for (const TreeBoxView& box : shot.tree) all(box.box, box.depth);
  for (const ContactEvent& event : simulation.contact_events()) all(event.a, event.b, event.point, event.impulse);
  for (const SeparationEvent& event : simulation.separation_events()) all(event.a, event.b);
  for (const BreakEvent& event : simulation.break_events()) all(event.joint, event.point, event.reaction);
  return hash_of(all.bytes().data(), all.bytes().size());
}

std::vector<std::byte> busy_at(std::int64_t tick) {
  const auto simulation = simulate(busy_scene());
  while (simulation->tick() < tick) {
    act_in_busy_scene(*simulation, simulation->tick());
    simulation->step();
  }
  return simulation->save();
}

/// The bytes with another content behind a seal that fits it.
std::vector<std::byte> resealed(const std::vector<std::byte>& bytes) {
  return sealed(mark, version, std::span(bytes).subspan(head_size));
}

}  // namespace

/// Another simulation in its place, which took up its state.
void exchange_for_fresh(std::unique_ptr<Simulation>& simulation, const Scene& scene) {
  auto fresh = simulate(scene);
  fresh->keep_forces();
  REQUIRE_FALSE(fresh->restore(simulation->save()));
  REQUIRE(seen_in(*fresh) == seen_in(*simulation));
  simulation = std::move(fresh);
}

TEST_CASE("A simulation restored at any tick goes on as if it had never stopped", "[save]") {
  for (const SavedScene& saved : saved_scenes()) {
    auto restored = simulate(saved.scene);
    const auto reference = simulate(saved.scene);
    restored->keep_forces();
    reference->keep_forces();
    for (std::int64_t tick = 0; tick < 200; ++tick) {
      INFO(saved.name << ", tick " << tick);
      if (tick % 7 == 0 || !reference->break_events().empty()) exchange_for_fresh(restored, saved.scene);
      for (Simulation* each : {restored.get(), reference.get()}) saved.act(*each, tick);
      if (tick % 20 == 0) exchange_for_fresh(restored, saved.scene);  // with commands pending
      restored->step();
      reference->step();
      REQUIRE(seen_in(*restored) == seen_in(*reference));
    }
  }
}

TEST_CASE("What is saved of a restored simulation are the same bytes", "[save]") {
  const Scene scene = busy_scene();
  const std::vector<std::byte> bytes = busy_at(110);
  const auto restored = simulate(scene);
  REQUIRE_FALSE(restored->restore(bytes));
  REQUIRE(restored->save() == bytes);
}

TEST_CASE("Every integrator goes on where it was", "[save]") {
  const auto integrator = GENERATE(Integrator::symplectic_euler, Integrator::verlet, Integrator::suzuki4,
                                   Integrator::rk4, Integrator::implicit_midpoint, Integrator::gauss_legendre6);
  Scene scene;
  scene.method.integrator = integrator;
  scene.bodies = {body_with(disc_shape(0.5), {1, 0}), body_with(box_shape(1, 0.5), {4, 0})};
  for (BodyDef& body : scene.bodies) body.filter.group = -1;
  scene.joints = {joint_between(JointKind::spring, BodyId{1}, {0.1, 0.2}, BodyId{2}, {}, 2)};
  scene.joints[0].stiffness = 30;
  if (integrator != Integrator::suzuki4)
    scene.fields = {[](Vec2d at, Vec2d v, double t) { return Vec2d{v.y - at.x, t}; }};
  scene = in_this_precision(scene);
  const auto reference = simulate(scene);
  run(*reference, 0.25);
  const auto restored = simulate(scene);
  REQUIRE_FALSE(restored->restore(reference->save()));
  for (int i = 0; i < 60; ++i) {
    reference->step();
    restored->step();
    REQUIRE(seen_in(*restored) == seen_in(*reference));
  }
}

TEST_CASE("A failed simulation stays failed, and one about to fail fails", "[save]") {
  const Scene scene = in_this_precision(with_floor(body_with(disc_shape(0.5), {0, 3})));
  const auto failed = simulate(scene);
  failed->apply(ApplyForce{BodyId{2}, {std::numeric_limits<double>::infinity(), 0}, {}});
  failed->step();
  REQUIRE(failed->failure());
  const auto restored = simulate(scene);
  REQUIRE_FALSE(restored->restore(failed->save()));
  REQUIRE(restored->failure());
  REQUIRE(restored->failure()->stage == failed->failure()->stage);
  Scene free = scene;  // whose numbers nobody looks at unless a command was given
  for (BodyDef& body : free.bodies) body.filter.group = -1;
  const auto failing = simulate(free);
  failing->apply(ApplyImpulse{BodyId{2}, {pick(1e308, 2e38), 0}, {}});
  failing->apply(ApplyImpulse{BodyId{2}, {pick(1e308, 2e38), 0}, {}});
  const auto saved_free = simulate(free);
  REQUIRE_FALSE(saved_free->restore(failing->save()));
  for (Simulation* each : {failing.get(), saved_free.get()}) each->step();
  REQUIRE(failing->failure());
  REQUIRE(saved_free->failure());
}

TEST_CASE("Bytes of another scene, another precision or another version are refused by name", "[save]") {
  const Scene scene = in_this_precision(with_floor(body_with(disc_shape(0.5), {0, 3})));
  const auto saved = simulate(scene);
  run(*saved, 0.05);
  const std::vector<std::byte> bytes = saved->save();
  Scene other = scene;
  other.bodies[1].position.x = 0.25;
  REQUIRE_THAT(simulate(other)->restore(bytes).value(), Contains("is of another scene"));
  std::vector<std::byte> changed = bytes;
  changed[head_size] = std::byte{is_double ? 0 : 1};
  REQUIRE_THAT(simulate(scene)->restore(resealed(changed)).value(),
               Contains(is_double ? "is in single precision" : "is in double precision"));
  changed = bytes;
  changed[sizeof(Mark)] = std::byte{version + 1};
  REQUIRE_THAT(simulate(scene)->restore(changed).value(), Contains("newer version"));
  changed[0] = std::byte{'q'};
  REQUIRE_THAT(simulate(scene)->restore(changed).value(), Contains("was not written by this program"));
}

TEST_CASE("Damaged and shortened bytes are refused, and nothing has changed", "[save]") {
  const Scene scene = busy_scene();
  const std::vector<std::byte> bytes = busy_at(30);
  const auto simulation = simulate(scene);
  const std::uint64_t before = seen_in(*simulation);
  for (std::size_t length = 0; length < bytes.size(); length += 1 + bytes.size() / 50) {
    REQUIRE(simulation->restore(std::span(bytes).first(length)));
  }
  for (std::size_t at = 0; at < bytes.size(); at += 1 + bytes.size() / 50) {
    std::vector<std::byte> changed = bytes;
    changed[at] ^= std::byte{16};
    REQUIRE(simulation->restore(changed));
  }
  REQUIRE(seen_in(*simulation) == before);
}

TEST_CASE("Bytes that were made to do harm do none", "[save]") {
  const Scene scene = busy_scene();
  const std::vector<std::byte> bytes = busy_at(60);
  constexpr std::size_t first = head_size + 9;  // behind precision and scene
  Random random(7);
  int accepted = 0;
  for (int i = 0; i < 400; ++i) {
    std::vector<std::byte> changed = bytes;
    const std::size_t at = first + random.below(static_cast<std::uint32_t>(bytes.size() - first));
    changed[at] = static_cast<std::byte>(random.below(256));
    if (i % 5 == 0) changed.resize(at);
    const auto simulation = simulate(scene);
    if (simulation->restore(resealed(changed))) continue;
    ++accepted;
    for (int k = 0; k < 3; ++k) simulation->step();
    simulation->apply(RemoveBody{BodyId{2}});
    simulation->step();
    Snapshot shot;
    simulation->observe(shot);
  }
  REQUIRE(accepted > 50);
  REQUIRE(accepted < 400);
}
