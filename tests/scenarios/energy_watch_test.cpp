#include "scenarios/energy_watch.h"

#include <catch2/catch.hpp>

#include "scene_text.h"

using namespace proofreel;
using Catch::Contains;

namespace {

/// A body of 1 kg whose energies are told by the test.
class Told : public FakeSimulation {
 public:
  explicit Told(const Scene& scene) : FakeSimulation(scene) {}
  Energy energy() const override { return told; }
  bool books_work() const override { return books; }
  bool is_settling() const override { return settling; }

  Energy told;
  bool books = true;
  bool settling = false;
};

Energy energy_of(double kinetic, double work = 0) {
  Energy e;
  e.kinetic = kinetic;
  e.booked_work = work;
  return e;
}

/// A watch over a scene without gravity that began at rest.
struct Watched {
  void look(double kinetic, double work = 0) {
    simulation.told = energy_of(kinetic, work);
    simulation.step();
    watch.look(simulation, simulation.energy());
  }
  Scene scene;
  Told simulation{scene};
  EnergyWatch watch{{0, 0}, 10};
};

}  // namespace

TEST_CASE("Energy that comes from nowhere is told with its first tick and its largest amount") {
  Watched w;
  w.look(0);
  w.look(0);
  w.look(2);
  w.look(5);
  w.look(1);
  REQUIRE(w.watch.growth());
  CHECK(w.watch.growth()->tick == 3);
  CHECK(w.watch.growth()->joules == 5);
}

TEST_CASE("Energy that was put in by work has not grown, nor has what is lost") {
  Watched w;
  w.look(0);
  w.look(7, 7);
  w.look(3, 7);
  w.look(7.006, 7);  // less than a thousandth of what moves
  CHECK_FALSE(w.watch.growth());
  w.look(7.1, 7);
  CHECK(w.watch.growth());
}

TEST_CASE("What is released while the start settles does not count, what comes after it does") {
  Watched w;
  w.simulation.settling = true;
  w.look(0);
  w.look(3);
  w.simulation.settling = false;
  w.look(4);
  w.look(4);
  CHECK_FALSE(w.watch.growth());
  w.look(5);
  REQUIRE(w.watch.growth());
  CHECK(w.watch.growth()->joules == Approx(1));
}

TEST_CASE("Who books no work cannot be told from who makes energy") {
  Watched w;
  w.simulation.books = false;
  for (const double kinetic : {0.0, 0.0, 5.0}) w.look(kinetic);
  CHECK_FALSE(w.watch.growth());
}

TEST_CASE("A run tells of energy that grew in one warning") {
  const auto scenario = load_text(
      "scenario{duration=1, rate=20, fps=20, gravity={0,0}, method={integrator='symplectic_euler', substeps=1}}\n"
      "local b = body{shape=circle{radius=1}, at={1,0}}\nspring{world, b, from={0,0}, to={1,0}, length=0, "
      "stiffness=4000}");
  Runner runner(*scenario);
  const RunReport report = runner.finish();
  REQUIRE(report.energy_grew);
  CHECK(report.energy_grew->joules > 0);
  REQUIRE(scenario->warnings.size() == 1);
  CHECK_THAT(scenario->warnings[0], Contains("energy grew by") && Contains("first seen at tick"));
}

TEST_CASE("A run that keeps its energy gives no warning") {
  const auto scenario = load_text(
      "scenario{duration=2}\nground{y=0}\nbody{shape=circle{radius=0.5}, at={0,3}, restitution=0.5}\n"
      "body{shape=box{width=1,height=1}, at={3,0.5}}");
  Runner runner(*scenario);
  CHECK_FALSE(runner.finish().energy_grew);
  CHECK(scenario->warnings.empty());
}

TEST_CASE("A force beyond all measure stops the run instead of passing unnoticed") {
  const auto scenario =
      load_text("scenario{}\nlocal b = body{shape=circle{radius=1}}\nat(0.5, function() b:force{1e300, 0} end)");
  Runner runner(*scenario);
  const RunReport report = runner.finish();
  REQUIRE(report.failure);
  CHECK(report.failure->tick == 121);
  CHECK(report.failure->what == "became too fast for its energy to be a number");
}
