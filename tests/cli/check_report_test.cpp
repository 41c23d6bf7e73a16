#include <catch2/catch.hpp>
#include <set>

#include "golden/json.h"
#include "tests/cli/collection.h"

namespace proofreel {
namespace {

using Catch::Matchers::Contains;

/// Two that pass, and one whose ball falls from elsewhere than it did when it was blessed.
void write_collection(const Collection& c) {
  for (const char* id : {"a/ball", "b/ball", "c/ball"}) c.write(id, falling_ball());
  REQUIRE(c.run({"bless"}).status == 0);
  c.write("b/ball", falling_ball("ball:set { at = {0.5, 5} }\n"));
}

std::set<std::string> checked(const Outcome& outcome) {
  std::set<std::string> ids;
  const Json json = Json::parse(outcome.out);
  for (const Json& scenario : json.at("scenarios")) ids.insert(scenario.at("scenario"));
  return ids;
}

TEST_CASE("check --report writes a page and --junit a file, named in --json, whatever the verdict", "[report]") {
  const Collection c;
  write_collection(c);
  const Outcome failed = c.run({"check", "--report", "out", "--junit", "out.xml", "--json"});
  REQUIRE(failed.status == 1);
  const Json json = Json::parse(failed.out);
  REQUIRE(json.at("report") == "out/index.html");
  REQUIRE(json.at("counts") == Json{{"passed", 2}, {"failed", 1}, {"total", 3}});
  REQUIRE_THAT(read_text(c / "out.xml"), Contains("<testsuite name=\"b/ball\" tests=\"4\" failures=\"4\""));
  const Json report = Json::parse(read_text(c / "out/report.json"));
  REQUIRE(report.at("entries").at(1).at("reproduce") == "proofreel check b/ball");
  REQUIRE(report.at("entries").at(1).at("bless") == "proofreel bless b/ball");
  for (const char* picture : {"expected", "actual", "heat"}) {
    const std::string file = report.at("entries").at(1).at("items").at(1).at(picture);
    REQUIRE(std::filesystem::exists(c / ("out/" + file)));
  }
  const Outcome passed = c.run({"check", "a/ball", "--report", "out"});
  REQUIRE(passed.status == 0);
  REQUIRE_THAT(passed.err, Contains("out/index.html"));
  REQUIRE_FALSE(std::filesystem::exists(c / "out/pictures"));
}

TEST_CASE("What cannot be run, and what no scenario asks for, are in the report, too", "[report]") {
  const Collection c;
  write_collection(c);
  c.write("bad", "scenario {");
  std::filesystem::remove(c / "scenarios/c/ball.lua");
  REQUIRE(c.run({"check", "--report", "out"}).status == 2);
  std::string verdicts;
  const Json report = Json::parse(read_text(c / "out/report.json"));
  for (const Json& entry : report.at("entries")) {
    verdicts +=
        entry.at("name").get<std::string>() + " " + entry.at("items").at(0).at("verdict").get<std::string>() + " ";
  }
  REQUIRE(verdicts == "a/ball exact b/ball physics bad error c/ball orphan ");
}

TEST_CASE("A report is refused before anything is run where it cannot be written", "[report]") {
  const Collection c;
  write_collection(c);
  const Outcome home = c.run({"check", "--report", "scenarios"});
  REQUIRE(home.status == 2);
  REQUIRE_THAT(home.err, Contains("holds other things than a report"));
  REQUIRE(home.out.empty());
  std::filesystem::create_directories(c / "odd/report.json");
  const Outcome odd = c.run({"check", "--report", "odd"});
  REQUIRE(odd.status == 2);
  REQUIRE_THAT(odd.err, Contains("holds other things than a report"));
  REQUIRE(c.run({"check", "--junit", "nowhere/out.xml"}).status == 3);
}

TEST_CASE("Every scenario and every orphan is in exactly one shard", "[shard]") {
  const Collection c;
  write_collection(c);
  for (int i = 0; i < 6; ++i) c.write("free_" + std::to_string(i), "scenario { duration = 0.1 }\n");
  std::filesystem::remove(c / "scenarios/c/ball.lua");
  std::set<std::string> all;
  std::size_t sum = 0, orphans = 0;
  for (const char* shard : {"1/3", "2/3", "3/3"}) {
    const Outcome part = c.run({"check", "--hash-only", "--shard", shard, "--json"});
    all.merge(checked(part));
    sum += checked(part).size();
    orphans += Json::parse(part.out).at("orphans").size();
  }
  REQUIRE(all == checked(c.run({"check", "--hash-only", "--json"})));
  REQUIRE(sum == all.size());
  REQUIRE(orphans == 1);
}

TEST_CASE("A shard that is not one of so many is refused", "[shard]") {
  const Collection c;
  c.write("free", "scenario { duration = 0.1 }\n");
  for (const char* wrong : {"0/2", "3/2", "1", "1/", "/2", "1/2/3", "x/2", "1/100000", "-1/2", ""}) {
    const Outcome o = c.run({"check", "--hash-only", "--shard", wrong});
    REQUIRE(o.status == 2);
    REQUIRE(o.out.empty());
  }
  REQUIRE_THAT(c.run({"check", "--shard", "3/2"}).err, Contains("2/4") && Contains("3/2"));
}

TEST_CASE("report-merge joins the shards to what one check would have reported", "[shard]") {
  const Collection c;
  write_collection(c);
  c.run({"check", "--report", "whole"});
  for (const char* number : {"1", "2"}) {
    c.run({"check", "--shard", std::string(number) + "/2", "--report", std::string("part") + number});
  }
  const Outcome merged = c.run({"report-merge", "part1", "part2", "-o", "joint", "--junit", "joint.xml"});
  REQUIRE(merged.status == 1);
  REQUIRE_THAT(merged.out, Contains("FAILED  b/ball frame 0: physics") && Contains("1 of 3 failed: joint/index.html"));
  REQUIRE(read_text(c / "joint/index.html") == read_text(c / "whole/index.html"));
  REQUIRE(read_text(c / "joint/report.json") == read_text(c / "whole/report.json"));
  REQUIRE(std::filesystem::exists(c / "joint/pictures/b/ball/frame_0-heat.png"));
  REQUIRE_THAT(read_text(c / "joint.xml"), Contains("tests=\"12\" failures=\"4\""));
}

TEST_CASE("report-merge refuses a missing shard, what is no report, and to replace its own parts", "[shard]") {
  const Collection c;
  write_collection(c);
  c.run({"check", "--hash-only", "--shard", "1/2", "--report", "part"});
  REQUIRE_THAT(c.run({"report-merge", "part", "-o", "joint"}).err, Contains("Shard 2/2 is missing"));
  REQUIRE_THAT(c.run({"report-merge", "scenarios", "-o", "joint"}).err, Contains("There is no report in scenarios"));
  REQUIRE_THAT(c.run({"report-merge", "part", "-o", "./part"}).err, Contains("another folder"));
  REQUIRE_THAT(c.run({"report-merge", "part"}).err, Contains("-o DIR"));
  REQUIRE_FALSE(std::filesystem::exists(c / "joint"));
}

TEST_CASE("In GitHub Actions what failed is annotated on standard error, with its file", "[annotations]") {
  const Collection c;
  write_collection(c);
  const Outcome o =
      c.run({"check", "--hash-only", "--json"}, {{"GITHUB_ACTIONS", "true"}, {"GITHUB_WORKSPACE", c.path()}});
  REQUIRE_THAT(o.err, Contains("::error file=scenarios/b/ball.lua,title=b/ball frame 0%3A physics::"));
  REQUIRE_THAT(o.err, Contains("To reproduce: proofreel check b/ball --hash-only") && !Contains("a/ball"));
  REQUIRE(Json::parse(o.out).at("passed") == false);
  REQUIRE_THAT(c.run({"check", "--hash-only"}).err, !Contains("::error"));
}

}  // namespace
}  // namespace proofreel
