#include <catch2/catch.hpp>

#include "golden/json.h"
#include "tests/cli/collection.h"

namespace proofreel {
namespace {

using Catch::Matchers::Contains;

const std::string good_expectation = "expect(\"the ball falls\", function() return ball:position().y < 5 end)\n";
const std::string bad_expectation = "expect(\"the ball rises\", function() return ball:position().y > 5 end)\n";

TEST_CASE("run tells measures, expectations and hashes, and exits with 0 when all hold", "[cli]") {
  const Collection c;
  c.write("ball", falling_ball(good_expectation));
  const Outcome o = c.run({"run", "ball"});
  REQUIRE(o.status == 0);
  REQUIRE(o.err.empty());
  REQUIRE_THAT(o.out, Contains("ball: 120 ticks") && Contains("measure y") && Contains("the ball falls"));
}

TEST_CASE("run says what a callback called for in vain", "[cli]") {
  const Collection c;
  c.write("late",
          "scenario{duration=1, effects={'gravity'}}\nlocal b = body{shape=circle{radius=1}}\n"
          "at(0.5, function() revolute{world, b, at={0, 1}} end)");
  const Outcome o = c.run({"run", "late"});
  REQUIRE(o.status == 0);
  REQUIRE_THAT(o.err, Contains("the scene calls for \"joints\", but the list of effects omits it"));
  REQUIRE(c.run({"run", "late", "--quiet"}).err.empty());
}

TEST_CASE("run --json prints one object with the documented keys", "[cli]") {
  const Collection c;
  c.write("hard/ball", falling_ball(good_expectation));
  const Outcome o = c.run({"run", "hard/ball", "--json"});
  REQUIRE(o.status == 0);
  const Json json = Json::parse(o.out);
  REQUIRE(json.at("scenario") == "hard/ball");
  REQUIRE(json.at("ticks") == 120);
  REQUIRE(json.at("trajectory_hash").get<std::string>().size() == 16);
  REQUIRE(json.at("state_hash").get<std::string>().size() == 16);
  const Json& y = json.at("measures").at("y");
  REQUIRE(y.at("final").get<double>() == Approx(5 - 0.5 * 9.81 * 0.25).epsilon(1e-6));
  REQUIRE(y.at("max") == 5.0);
  REQUIRE(y.at("min") == y.at("final"));
  REQUIRE(y.at("max_error").get<double>() < 1e-9);
  REQUIRE(json.at("expectations").at(0).at("held") == true);
  REQUIRE(json.at("expectations").at(0).at("text") == "the ball falls");
  REQUIRE(json.at("expectations").at(0).at("tick") == 120);
  REQUIRE(json.at("energy").at("max_drift").get<double>() < 1e-9);
  REQUIRE(json.at("energy").at("initial").get<double>() == Approx(json.at("energy").at("final").get<double>()));
  REQUIRE(json.at("wall_s").get<double>() >= 0);
}

TEST_CASE("A file name that is not UTF-8 does not spoil the JSON", "[cli]") {
  const Collection c;
  c.write("caf\xe9", falling_ball());
  const Outcome o = c.run({"run", "caf\xe9", "--json"});
  REQUIRE(o.status == 0);
  REQUIRE(Json::parse(o.out).at("ticks") == 120);
}

TEST_CASE("The same run gives the same hashes, another scene gives others", "[cli]") {
  const Collection c;
  c.write("ball", falling_ball());
  const auto hash = [&](std::vector<std::string> more) {
    std::vector<std::string> arguments{"run", "ball", "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return Json::parse(c.run(arguments).out).at("trajectory_hash").get<std::string>();
  };
  REQUIRE(hash({}) == hash({}));
  REQUIRE(hash({}) == hash({"--threads", "1"}));
  REQUIRE(hash({}) != hash({"--set", "gravity={0,-9.8}"}));
  REQUIRE(hash({}) != hash({"--set", "duration=0.25"}));
}

TEST_CASE("An expectation that does not hold is named, and the exit status is 1, with JSON too", "[cli]") {
  const Collection c;
  c.write("ball", falling_ball(bad_expectation));
  const Outcome text = c.run({"run", "ball"});
  REQUIRE(text.status == 1);
  REQUIRE_THAT(text.err, Contains("the ball rises"));
  const Outcome json = c.run({"run", "ball", "--json"});
  REQUIRE(json.status == 1);
  REQUIRE(Json::parse(json.out).at("expectations").at(0).at("held") == false);
}

TEST_CASE("--csv writes a header and one row per sample", "[cli]") {
  const Collection c;
  c.write("ball", falling_ball("measure(\"a,\\\"b\\\"\", function() return time() end)\n"));
  REQUIRE(c.run({"run", "ball", "--csv", "out.csv"}).status == 0);
  const std::string csv = read_text(c / "out.csv");
  REQUIRE_THAT(csv, Catch::Matchers::StartsWith("t,\"y\",\"a,\"\"b\"\"\"\n0,5,0\n"));
  REQUIRE(std::count(csv.begin(), csv.end(), '\n') == 32);
  REQUIRE_THAT(csv, Contains("\n0.5,"));
}

TEST_CASE("A table that cannot be written is an error of the environment", "[cli]") {
  const Collection c;
  c.write("ball", falling_ball());
  REQUIRE(c.run({"run", "ball", "--csv", "none/out.csv"}).status == 3);
  REQUIRE(c.run({"run", "ball", "--csv", "/dev/full"}).status == 3);
}

TEST_CASE("A scenario is found by path and by id, from below the collection too", "[cli]") {
  const Collection c;
  c.write("hard/ball", falling_ball());
  REQUIRE(c.run({"run", "scenarios/hard/ball.lua"}).status == 0);
  REQUIRE(c.run({"run", "hard/ball"}).status == 0);
  REQUIRE(proofreel_program({"run", "hard/ball"}, c / "scenarios/hard").status == 0);
  const Outcome none = c.run({"run", "hard/bal"});
  REQUIRE(none.status == 2);
  REQUIRE_THAT(none.err, Contains("hard/bal"));
  REQUIRE(c.run({"run", "none.lua"}).status == 2);
}

TEST_CASE("A bad scenario exits with 2 and names file and line", "[cli]") {
  const Collection c;
  c.write("bad", "scenario { title = \"x\", duration = 1 }\nbody { frcition = 1 }\n");
  const Outcome o = c.run({"run", "bad"});
  REQUIRE(o.status == 2);
  REQUIRE(o.out.empty());
  REQUIRE_THAT(o.err, Contains("bad.lua") && Contains("line 2") && Contains("frcition") && Contains("friction"));
}

TEST_CASE("--set needs KEY=VALUE, and does not swallow the scenario", "[cli]") {
  const Collection c;
  c.write("ball", falling_ball());
  REQUIRE(c.run({"run", "--set", "duration=0.25", "ball"}).status == 0);
  REQUIRE(c.run({"run", "ball", "--set", "duration=0.25", "--set", "substeps=8"}).status == 0);
  REQUIRE(c.run({"run", "ball", "--set", "duration"}).status == 2);
  REQUIRE(c.run({"run", "ball", "--set", "=3"}).status == 2);
  REQUIRE(c.run({"run", "ball", "--set", "duratoin=3"}).status == 2);
}

TEST_CASE("list shows every scenario, and those that cannot be loaded by name", "[cli]") {
  const Collection c;
  c.write("b/two", falling_ball());
  c.write("one", falling_ball());
  const Outcome good = c.run({"list"});
  REQUIRE(good.status == 0);
  REQUIRE_THAT(good.out, Contains("one") && Contains("b/two") && Contains("Falling ball") && Contains("gravity"));
  REQUIRE(good.out.find("b/two") < good.out.find("one"));
  c.write("bad", "scenario {");
  const Outcome bad = c.run({"list", "scenarios"});
  REQUIRE(bad.status == 2);
  REQUIRE_THAT(bad.out, Contains("one") && Contains("b/two"));
  REQUIRE_THAT(bad.err, Contains("bad.lua"));
  REQUIRE(c.run({"list", "nowhere"}).status == 2);
}

TEST_CASE("Every subcommand explains itself with an example", "[cli]") {
  for (const char* name : {"list", "run", "check"}) {
    const Outcome o = proofreel_program({name, "--help"});
    REQUIRE(o.status == 0);
    REQUIRE_THAT(o.out, Contains("Example: proofreel " + std::string(name)) && Contains("--set"));
  }
  REQUIRE(proofreel_program({"--help"}).status == 0);
  REQUIRE_THAT(proofreel_program({"--version"}).out, Catch::Matchers::Matches("[0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

TEST_CASE("Wrong use exits with 2 and says what is wrong on standard error", "[cli]") {
  const std::vector<std::vector<std::string>> wrong{{},
                                                    {"fly"},
                                                    {"run"},
                                                    {"run", "a", "b"},
                                                    {"run", "x", "--speed", "3"},
                                                    {"--quick"},
                                                    {"run", "--gl", "metal", "x"},
                                                    {"run", "x", "--threads", "0"},
                                                    {"run", "x", "--threads", "nan"},
                                                    {"run", "pendulum", "--set", "duration=nan"},
                                                    {"run", "pendulum", "--set", "contact_hz=inf"},
                                                    {"run", "pendulum", "--set", "gravity={0,nan}"}};
  for (const auto& arguments : wrong) {
    const Outcome o = proofreel_program(arguments);
    CAPTURE(arguments);
    REQUIRE(o.status == 2);
    REQUIRE_FALSE(o.err.empty());
    REQUIRE(o.out.empty());
  }
}

TEST_CASE("An option or a word with nothing in it is refused, and never counts as not given", "[cli]") {
  const Collection c;
  c.write("ball", falling_ball());
  const std::string advice = ": write there what is meant, or leave it out.\n";
  require_refused(c, {"run", "ball"},
                  {{{"--csv="}, "There is nothing after \"--csv=\"" + advice},
                   {{"--csv", ""}, "There is an empty word after \"--csv\"" + advice},
                   {{"--json="}, "nothing after \"--json=\""},
                   {{"--resume", ""}, "empty word after \"--resume\""},
                   {{"--set=", "--quiet"}, "nothing after \"--set=\""},
                   {{""}, "empty word after \"ball\""}});
  require_refused(c, {"check"},
                  {{{"--hash-only", "--golden", ""}, "empty word after \"--golden\""},
                   {{"--junit="}, "nothing after \"--junit=\""},
                   {{"--report", ""}, "empty word after \"--report\""}});
  require_refused(c, {"list"}, {{{""}, "empty word after \"list\""}});
}

}  // namespace
}  // namespace proofreel
