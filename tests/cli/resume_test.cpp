#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include "golden/json.h"
#include "tests/cli/collection.h"

namespace proofreel {
namespace {

namespace fs = std::filesystem;
using Catch::Matchers::Contains;

const std::string kicked =
    "local n = 0\nevery(0.1, function() ball:impulse{0.1, 0}; n = n + 1 end)\n"
    "measure(\"x\", function() return ball:position().x end)\nmeasure(\"n\", function() return n end)\n"
    "expect(\"it is kicked\", function() return n == 4 end)\nexpect(\"it falls\", function() return time() > 0 end)\n";

std::size_t files_beside(const Collection& c) {
  std::size_t count = 0;
  for (const auto& entry : fs::directory_iterator(c.path())) count += entry.is_regular_file() ? 1 : 0;
  return count;
}

TEST_CASE("A resumed run ends with the hashes and measures of the unbroken one", "[cli]") {
  const Collection c;
  c.write("ball", falling_ball(kicked));
  const Json whole = Json::parse(c.run({"run", "ball", "--json"}).out);
  const Outcome saving =
      c.run({"run", "ball", "--json", "--save", "0:0.run", "--save", "0.251:a.run", "--save=0.5:b.run"});
  REQUIRE(saving.status == 0);
  REQUIRE(Json::parse(saving.out).at("trajectory_hash") == whole.at("trajectory_hash"));
  const std::vector<std::pair<std::string, int>> files{{"0.run", 0}, {"a.run", 60}, {"b.run", 120}};
  for (const auto& [file, tick] : files) {
    const Outcome o = c.run({"run", "ball", "--json", "--resume", file});
    REQUIRE(o.status == 0);
    const Json json = Json::parse(o.out);
    REQUIRE(json.at("resumed_at") == tick);
    for (const char* key : {"ticks", "trajectory_hash", "state_hash"}) REQUIRE(json.at(key) == whole.at(key));
    REQUIRE(json.at("measures").at("x").at("final") == whole.at("measures").at("x").at("final"));
    REQUIRE(json.at("energy").at("initial") == whole.at("energy").at("initial"));
  }
  REQUIRE(files_beside(c) == 3);
}

TEST_CASE("What is not known after resuming is null, empty or said to be", "[cli]") {
  const Collection c;
  c.write("ball", falling_ball(kicked));
  REQUIRE(c.run({"run", "ball", "--save", "0.25:a.run"}).status == 0);
  const Outcome o = c.run({"run", "ball", "--json", "--csv", "a.csv", "--resume", "a.run"});
  REQUIRE(o.status == 0);
  REQUIRE_THAT(o.err, Contains("measure \"n\" is not known after resuming: it can see the variable \"n\"") &&
                          Contains("whether \"it is kicked\" holds is not known"));
  const Json json = Json::parse(o.out);
  REQUIRE(json.at("measures").at("n").at("final").is_null());
  REQUIRE(json.at("expectations").at(0).at("held").is_null());
  REQUIRE(json.at("expectations").at(1).at("held") == true);
  REQUIRE_THAT(read_text(c / "a.csv"), Catch::Matchers::EndsWith(",\n"));
  const Outcome text = c.run({"run", "ball", "--quiet", "--resume", "a.run"});
  REQUIRE(text.err.empty());
  REQUIRE_THAT(text.out, Contains("measure n: not known") && Contains("not known: it is kicked") &&
                             Contains("120 ticks (from 60 on)"));
}

TEST_CASE("What cannot be saved or resumed is refused with the reason, and no file is left", "[cli]") {
  const Collection c;
  c.write("ball", falling_ball(kicked));
  c.write("other", falling_ball());
  REQUIRE(c.run({"run", "ball", "--save", "0.25:a.run"}).status == 0);
  std::ofstream(c / "text.run") << "hello";
  const Refusals cases{{{"--save", "1:b.run"}, "the run ends before that"},
                       {{"--save", "b.run"}, "--save takes T:FILE"},
                       {{"--save", "x:b.run"}, "--save takes T:FILE"},
                       {{"--save", "-1:b.run"}, "--save takes T:FILE"},
                       {{"--save", "nan:b.run"}, "--save takes T:FILE"},
                       {{"--save", "0.1:"}, "--save takes T:FILE"},
                       {{"--save", "0.1:b.run", "--save", "0.2:b.run"}, "twice"},
                       {{"--save", "0.1:b.run", "--resume", "a.run"}, "--save"},
                       {{"--resume", "none.run"}, "there is no such file"},
                       {{"--resume", "scenarios"}, "there is no such file"},
                       {{"--resume", "text.run"}, "it was not written by this program"},
                       {{"--resume", "a.run", "--set", "duration=1"}, "callbacks were not logged beyond t=0.5 s"},
                       {{"--resume", "a.run", "--set", "substeps=3"}, "saved with no --set"},
                       {{"--resume", "a.run", "--set", "duration=0.1"}, "after the end of this run"}};
  require_refused(c, {"run", "ball"}, cases);
  REQUIRE_THAT(c.run({"run", "other", "--resume", "a.run"}).err, Contains("text is another one"));
  REQUIRE(c.run({"run", "ball", "--save", "0.1:none/b.run"}).status == 3);
  REQUIRE(files_beside(c) == 2);
}

TEST_CASE("A script that fails after the time to save at leaves no file, and an old one as it was", "[cli]") {
  const Collection c;
  c.write("ball", falling_ball("at(0.4, function() error('out of luck') end)\n"));
  std::ofstream(c / "a.run") << "old";
  REQUIRE(c.run({"run", "ball", "--save", "0.1:a.run", "--save", "0.2:b.run"}).status == 2);
  REQUIRE(read_text(c / "a.run") == "old");
  REQUIRE(files_beside(c) == 1);
}

TEST_CASE("A run whose expectations fail is saved all the same", "[cli]") {
  const Collection c;
  c.write("ball", falling_ball("expect('it rises', function() return time() < 0.4 end)\n"));
  REQUIRE(c.run({"run", "ball", "--save", "0.1:a.run"}).status == 1);
  REQUIRE(c.run({"run", "ball", "--resume", "a.run"}).status == 1);
}

TEST_CASE("A run to be saved that is interrupted leaves nothing and dies of the signal", "[cli]") {
  const Collection c;
  c.write("long",
          "scenario { duration = 100000 }\nbody { shape = circle { radius = 1 } }\nevery(0.01, function() end)\n");
  Program program({"run", "long", "--save", "1:a.run"}, c.path());
  std::this_thread::sleep_for(std::chrono::milliseconds(100));  // whenever it comes, the same must hold
  program.send(SIGINT);
  REQUIRE(program.wait().signal == SIGINT);
  REQUIRE(files_beside(c) == 0);
}

}  // namespace
}  // namespace proofreel
