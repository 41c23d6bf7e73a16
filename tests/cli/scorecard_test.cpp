#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <thread>

#include "golden/json.h"
#include "lab/csv.h"
#include "tests/cli/collection.h"

namespace proofreel {
namespace {

using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

std::string drop(const std::string& height) {
  return "scenario { title = \"A drop\", duration = 0.5, rate = 60, view = { center = {0, 1}, height = 4 } }\n"
         "ground { y = 0 }\nlocal ball = body { at = {0, " +
         height +
         "}, shape = circle { radius = 0.5 } }\n"
         "expect(\"it never sinks\", function() return ball:position().y > 0.49 end, { always = true })\n"
         "expect(\"quality: it lies\", function() return ball:position().y < 0.51 end)\n";
}

std::vector<CsvRecord> records_of(const Collection& c, const std::string& file) {
  return csv_records(read_text(c / file));
}

TEST_CASE("A scorecard is a table, a page, a map and stills, and passes when the default method stands", "[score]") {
  const Collection c;
  c.write("hard/rest", drop("0.5"));
  const Outcome o = c.run({"scorecard", "--against", "box2d,chipmunk", "-o", "card", "--json"});
  REQUIRE(o.err.empty());
  REQUIRE(o.status == 0);
  const Json json = Json::parse(o.out);
  REQUIRE(json.at("passed") == true);
  REQUIRE(json.at("scenarios") == 1);
  const Json first = json.at("methods").front();
  REQUIRE(first.at("method") == "default, own, double");
  REQUIRE(first.at("stands") == 1);
  REQUIRE(first.at("to_box2d").get<double>() > 0);
  REQUIRE(json.at("methods").back().at("engine") == "Chipmunk");

  const std::vector<CsvRecord> records = records_of(c, "card/scorecard.csv");
  REQUIRE(records.size() == 1 + json.at("methods").size());
  REQUIRE(records[0][0] == "scenario");
  REQUIRE(records[1][7] == "stands");
  REQUIRE(std::find(records[1].begin(), records[1].end(), "yes") != records[1].end());  // the same bits twice
  REQUIRE(std::filesystem::exists(c / "card/scorecard.png"));
  REQUIRE_THAT(read_text(c / "card/scorecard.html"),
               Contains("proofreel scorecard --against box2d,chipmunk -o card --json"));
}

TEST_CASE("A scorecard fails when the default method does not stand, and says where", "[score]") {
  const Collection c;
  c.write("hard/high", drop("2.5"));
  const Outcome o = c.run({"scorecard", "hard/high", "scenarios/hard", "-o", "card"});
  REQUIRE(o.status == 1);
  REQUIRE_THAT(o.out, Contains("default, own, double") && Contains("0 of   1"));
  REQUIRE_THAT(o.out, Contains("hard/high degrades: at 0.5 s: quality: it lies"));
}

TEST_CASE("Parts that scenarios include are no scenarios", "[score]") {
  const Collection c;
  c.write("hard/include/part", "nothing here describes a scene\n");
  c.write("hard/rest", drop("0.5"));
  REQUIRE(c.run({"list"}).status == 0);
  REQUIRE_THAT(c.run({"list"}).out, Contains("hard/rest") && !Contains("part"));
}

TEST_CASE("A killed study goes on where it was", "[score]") {
  const Collection c;
  c.write("rest", drop("0.5"));
  const std::vector<std::string> words{"study", "rest", "--map", "--vary", "seed=1,2,3,4,5,6,7,8,9", "-o", "map"};
  Program program(words, c.path());
  while (records_of(c, "map/map.csv").size() < 4) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  program.send(SIGKILL);
  REQUIRE(program.wait().signal == SIGKILL);
  const std::string before = read_text(c / "map/map.csv");
  REQUIRE(c.run(words).status == 0);
  const std::vector<CsvRecord> after = records_of(c, "map/map.csv");
  REQUIRE(after.size() == 1 + 9 * 3);
  for (const CsvRecord& record : csv_records(before)) {  // CPU times never come out the same twice
    REQUIRE(std::find(after.begin(), after.end(), record) != after.end());
  }
}

TEST_CASE("A map tells where a scenario stands, and the cheapest", "[score]") {
  const Collection c;
  c.write("rest", drop("0.5"));
  const Outcome o =
      c.run({"study", "rest", "--map", "--vary", "rate=60,120", "--vary", "substeps=1,2", "-o", "map", "--json"});
  REQUIRE(o.status == 0);
  const Json json = Json::parse(o.out);
  REQUIRE(json.at("runs").size() == 4);
  int cheapest = 0;
  for (const Json& run : json.at("runs")) cheapest += run.at("cheapest") == true ? 1 : 0;
  REQUIRE(cheapest == 1);
  REQUIRE(json.at("runs")[1].at("set").at("rate") == "120");
  REQUIRE(std::filesystem::exists(c / "map/map.png"));
}

TEST_CASE("Threads change what runs at a time, not what comes out", "[score]") {
  const Collection c;
  c.write("rest", drop("0.5"));
  const std::vector<std::string> words{"study", "rest", "--map", "--vary", "substeps=1,2", "--vary", "rate=60"};
  const auto hashes = [&](const std::string& folder, const std::vector<std::string>& more) {
    std::vector<std::string> all = words;
    all.insert(all.end(), {"-o", folder});
    all.insert(all.end(), more.begin(), more.end());
    REQUIRE(c.run(all).status == 0);
    std::vector<std::string> found;
    for (const CsvRecord& record : records_of(c, folder + "/map.csv")) found.push_back(record[14]);
    return found;
  };
  const std::vector<std::string> alone = hashes("one", {});
  REQUIRE(alone.front() == "trajectory_hash");
  REQUIRE(alone == hashes("two", {"--threads", "2"}));
}

TEST_CASE("What cannot be done is refused in one sentence", "[score]") {
  const Collection c;
  c.write("rest", drop("0.5"));
  c.write("blank", "scenario { duration = 1 }\n");
  const auto refused = [&](const std::vector<std::string>& words, int status, const std::string& sentence) {
    const Outcome o = c.run(words);
    CAPTURE(o.err);
    REQUIRE(o.status == status);
    REQUIRE_THAT(o.err, Contains(sentence));
    REQUIRE(o.out.empty());
  };
  refused({"scorecard", "rest", "--against", "havok", "-o", "x"}, 2, "There is no peer \"havok\"");
  refused({"scorecard", "-o", "x"}, 2, "There is no folder");
  refused({"scorecard", "nowhere", "-o", "x"}, 2, "There is no scenario \"nowhere\"");
  refused({"scorecard", "blank", "-o", "x"}, 2, "has no expectation");
  refused({"scorecard", "rest"}, 2, "Name a folder");
  refused({"scorecard", "rest", "-o", "/proc/x"}, 3, "Cannot make the folder /proc/x");
  refused({"study", "rest", "--map"}, 2, "Name a folder");
  refused({"study", "rest", "--map", "--vary", "ratee=1", "-o", "x"}, 2, "did you mean \"rate\"?");
  refused({"study", "rest", "--map", "--vary", "rate=0", "-o", "x"}, 2, "--vary rate=0: rate must lie between");
  for (const char* limit : {"0", "-1", "nan", "-nan", "inf", "1e400", "9s", ""}) {
    refused({"study", "rest", "--map", "-o", "x", "--limit", limit}, 2, "--limit");
    refused({"scorecard", "rest", "-o", "x", "--limit", limit}, 2, "--limit");
  }
  refused({"study", "rest", "--map", "--vary", "duration=nan", "-o", "x"}, 2, "duration");
  REQUIRE_THAT(c.run({"study", "--help"}).out, Contains("Example: proofreel study"));
  REQUIRE_THAT(c.run({"scorecard", "--help"}).out, Contains("Example: proofreel scorecard"));
}

}  // namespace
}  // namespace proofreel
