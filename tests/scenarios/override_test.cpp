#include "scenarios/overrides.h"

#include <catch2/catch.hpp>

#include "scene_text.h"

using namespace proofreel;
using Catch::Contains;
using Catch::StartsWith;

namespace {

const std::string scene = "scenario{title='t', duration=5, view={center={1,2}, height=3}, method={substeps=4}}";

std::unique_ptr<Scenario> with(const std::string& key, const std::string& value) {
  return load_text(scene, {{key, value}});
}

}  // namespace

TEST_CASE("Overrides replace what scenario{} says") {
  CHECK(with("duration", "2")->duration == 2);
  CHECK(with("rate", "480")->scene.rate == 480);
  CHECK(with("seed", "99")->seed == 99);
  CHECK(with("gravity", "{0,-3}")->scene.gravity == Vec2d{0, -3});
  CHECK(with("theme", "dark")->picture.theme == Theme::dark);
  CHECK(with("size", "640x480")->picture.size == Size{640, 480});
  CHECK(with("size", "{640, 480}")->picture.size == Size{640, 480});
  CHECK(with("title", "another one")->title == "another one");
  // Marks (trails, vectors, labels) are shown whenever a script sets them.
  CHECK(with("layers", "{bodies, bvh}")->picture.layers ==
        std::vector{Layer::trails, Layer::vectors, Layer::labels, Layer::bodies, Layer::bvh});
  CHECK(with("effects", "{gravity}")->scene.effects->has(Effect::gravity));
  CHECK_FALSE(with("effects", "auto")->scene.effects);
  CHECK(with("golden.frames", "{0, 10}")->golden->frames == std::vector<std::int64_t>{0, 10});
}

TEST_CASE("Overriding one entry of a table keeps the others") {
  const auto scenario = with("view.height", "7.5");
  CHECK(scenario->picture.view.height == 7.5);
  CHECK(scenario->picture.view.center == Vec2d{1, 2});
}

TEST_CASE("Methods may be named in short or in full") {
  CHECK(with("substeps", "8")->scene.method.substeps == 8);
  CHECK(with("method.substeps", "8")->scene.method.substeps == 8);
  CHECK(with("integrator", "symplectic_euler")->scene.method.integrator == Integrator::symplectic_euler);
  CHECK(with("precision", "single")->scene.method.precision == Precision::float32);
}

TEST_CASE("Of two overrides of one key the last holds") {
  CHECK(load_text(scene, {{"duration", "2"}, {"duration", "3"}})->duration == 3);
}

TEST_CASE("Overrides leave the table of the script alone") {
  const auto scenario = load_text("local t = {duration=5}\nscenario(t)\nmeasure('d', function() return t.duration end)",
                                  {{"duration", "1"}});
  CHECK(scenario->script->measure(0) == 5);
}

TEST_CASE("Wrong overrides are named as they were written") {
  const auto [key, value, problem] = GENERATE(table<std::string, std::string, std::string>({
      {"duration", "abc", "--set duration=abc: duration must be a number, got \"abc\""},
      {"duration", "-1", "--set duration=-1: duration must be a positive number, got -1"},
      {"duration", "", "--set duration=: duration must be a number, got \"\""},
      {"substeps", "1.5", "--set substeps=1.5: method.substeps must be a whole number, got 1.5"},
      {"gravity", "3", "--set gravity=3: gravity must be a vector {x, y}, got 3"},
      {"gravity", "{0,inf}", "--set gravity={0,inf}: gravity must be finite"},
      {"view.height", "0", "--set view.height=0: view.height must be a positive number, got 0"},
      {"theme", "drak", "--set theme=drak: theme cannot be \"drak\", did you mean \"dark\"?"},
      {"size", "100000x100000",
       "--set size=100000x100000: size must be two whole numbers between 1 and 16384 (pixels)"},
      {"contact_solver", "exat",
       "--set contact_solver=exat: method.contact_solver cannot be \"exat\", did you mean \"exact\"?"},
      {"layers", "{bodys}", "--set layers={bodys}: layers cannot hold \"bodys\""},
      {"duratoin", "1", "--set duratoin=1: unknown key \"duratoin\", did you mean \"duration\"?"},
      {"sbsteps", "1", "did you mean \"substeps\"?"},
  }));
  CHECK_THAT(error_of(scene, {{key, value}}), StartsWith("--set " + key + "=" + value) && Contains(problem));
}
