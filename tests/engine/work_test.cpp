#include <catch2/catch.hpp>

#include "tests/engine/scenes.h"

namespace proofreel {
namespace {

using namespace test;

Scene with(std::vector<BodyDef> bodies) {
  Scene scene;
  scene.bodies = std::move(bodies);
  return scene;
}

WorkDone work_of(const Scene& scene, int ticks) {
  const auto simulation = simulate(scene);
  simulation->count_work();
  for (int i = 0; i < ticks; ++i) simulation->step();
  return simulation->work_done().value();
}

TEST_CASE("A body in free flight is asked once per substep what moves it, by rk4 four times", "[work]") {
  Scene scene = with({body_with(disc_shape(0.5), {0, 10})});
  scene.method.substeps = 3;
  REQUIRE(work_of(scene, 5).evaluations == 15);
  REQUIRE(work_of(scene, 5).row_updates == 0);
  AttractorDef attractor;
  attractor.strength = 1;
  scene.attractors = {attractor};
  scene.method.integrator = Integrator::rk4;
  REQUIRE(work_of(scene, 5).evaluations == 60);
}

TEST_CASE("A sweep updates two rows at every point of a contact, and soft contacts are swept twice", "[work]") {
  Scene scene = with({body_with(box_shape(1, 1), {0, 0.5}), floor_body()});
  scene.method.contact_solver = ContactMethod::soft_step;
  scene.method.substeps = 4;
  // Two points, two rows each, in two sweeps before the drift and two after it.
  REQUIRE(work_of(scene, 10).row_updates == 10 * 4 * 2 * 2 * 4);
  scene.method.contact_solver = ContactMethod::sequential_impulses;
  scene.method.iterations = 1;
  REQUIRE(work_of(scene, 10).row_updates == 10 * 4 * 2 * 2 * 2);
}

TEST_CASE("Who does not ask for the work is told none, and steps to the same bits", "[work]") {
  const Scene scene = with({body_with(box_shape(1, 1), {0, 0.5}), floor_body()});
  const auto silent = simulate(scene);
  const auto counting = simulate(scene);
  counting->count_work();
  for (int i = 0; i < 20; ++i) {
    silent->step();
    counting->step();
  }
  REQUIRE_FALSE(silent->work_done());
  REQUIRE(counting->work_done()->row_updates > 0);
  REQUIRE(silent->state_hash() == counting->state_hash());
}

TEST_CASE("A rigid joint's rows are solved in every substep", "[work]") {
  Scene scene = with({body_with(disc_shape(0.2), {1, 0})});
  scene.joints = {joint_between(JointKind::distance, BodyId::world, {0, 0}, BodyId{1}, {0, 0}, 1)};
  scene.method.substeps = 2;
  const WorkDone work = work_of(scene, 10);
  REQUIRE(work.row_updates >= 20);
  REQUIRE(work.row_updates <= 200);
}

}  // namespace
}  // namespace proofreel
