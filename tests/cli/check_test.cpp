#include <catch2/catch.hpp>

#include "golden/json.h"
#include "tests/cli/collection.h"

namespace proofreel {
namespace {

using Catch::Matchers::Contains;

TEST_CASE("check --hash-only finds missing references, and a scenario that asks for none", "[cli]") {
  const Collection c;
  c.write("ball", falling_ball());
  const Outcome missing = c.run({"check", "ball", "--hash-only"});
  REQUIRE(missing.status == 1);
  REQUIRE_THAT(missing.out, Contains("FAILED  ball") && Contains("missing"));
  c.write("free", "scenario { duration = 0.1 }\nbody { shape = circle { radius = 1 } }\n");
  REQUIRE(c.run({"check", "free", "--hash-only"}).status == 0);
}

TEST_CASE("An expectation that does not hold fails the check by name", "[cli]") {
  const Collection c;
  c.write("free", "scenario { duration = 0.1 }\nexpect(\"pigs fly\", function() return false end)\n");
  const Outcome o = c.run({"check", "--hash-only", "--json"});
  REQUIRE(o.status == 1);
  const Json json = Json::parse(o.out);
  REQUIRE(json.at("passed") == false);
  REQUIRE(json.at("scenarios").at(0).at("expectations").at(0).at("text") == "pigs fly");
  REQUIRE_THAT(c.run({"check", "--hash-only"}).err, Contains("pigs fly"));
}

TEST_CASE("A bad scenario among good ones exits with 2, and the good ones are still checked", "[cli]") {
  const Collection c;
  c.write("a_bad", "scenario {");
  c.write("free", "scenario { duration = 0.1 }\n");
  const Outcome o = c.run({"check", "--hash-only"});
  REQUIRE(o.status == 2);
  REQUIRE_THAT(o.err, Contains("a_bad.lua"));
  REQUIRE_THAT(o.out, Contains("passed  free"));
}

TEST_CASE("check without any golden folder says how to make one", "[cli]") {
  const ScratchFolder folder;
  write_text(folder / "x.lua", "scenario { duration = 0.1 }\n");
  const Outcome o = proofreel_program({"check", "x.lua", "--hash-only"}, folder.path().string());
  REQUIRE(o.status == 2);
  REQUIRE_THAT(o.err, Contains("golden") && Contains("--golden"));
  REQUIRE(proofreel_program({"check", "x.lua", "--hash-only", "--golden", "store"}, folder.path().string()).status ==
          0);
}

TEST_CASE("Nothing but bless writes references", "[cli]") {
  const Collection c;
  c.write("ball", falling_ball());
  c.run({"check", "--hash-only"});
  REQUIRE(std::filesystem::is_empty(c / "golden"));
}

}  // namespace
}  // namespace proofreel
