#include "golden/report.h"

#include <catch2/catch.hpp>

#include "golden/annotations.h"
#include "golden/junit.h"
#include "render/usage_error.h"

namespace proofreel {
namespace {

using Catch::Matchers::Contains;
using Catch::Matchers::Message;

Report report_of(const std::vector<std::string>& names, Shard shard = {}) {
  Report report{"proofreel 0.1.0", shard, {}};
  for (const std::string& name : names) report.entries.push_back({name, name + ".lua", "check " + name, "", {}});
  return report;
}

Report failing_report() {
  Report report = report_of({"ball"});
  report.entries[0].items = {
      {"frame 0", "exact", true, ""},
      {"frame 9", "drawing", false, "5 < 6 & \"more\": 100 %\nof it", 5, 6, 7, PixelRect{1, 2, 3, 4}},
      {"final state", "physics", false, "differs."}};
  return report;
}

TEST_CASE("A report written as JSON reads back as it was", "[report]") {
  const std::string text = to_json_text(failing_report());
  const Report back = report_from_json(text, "report.json");
  REQUIRE(to_json_text(back) == text);
  REQUIRE(back.entries.at(0).items.at(1).place == PixelRect{1, 2, 3, 4});
  REQUIRE(back.entries.at(0).items.at(1).max_channel == 7);
}

TEST_CASE("What is no report, unfinished or damaged is refused with a sentence", "[report]") {
  REQUIRE_THROWS_WITH(report_from_json("{}", "x.json"), Contains("x.json is not the report of a check"));
  REQUIRE_THROWS_WITH(report_from_json("[]", "x.json"), Contains("not the report"));
  REQUIRE_THROWS_WITH(report_from_json("{", "x.json"),
                      "x.json is damaged: line 1 is no JSON; let check write that report again.");
  REQUIRE_THROWS_WITH(report_from_json("{\"format\": 1, \"kind\": \"proofreel report\"}", "x"), Contains("unfinished"));
  REQUIRE_THROWS_WITH(report_from_json("{\"format\": 2, \"kind\": \"proofreel report\"}", "x"), Contains("format 2"));
  REQUIRE_THROWS_AS(report_from_json("{\"format\": 1, \"kind\": \"proofreel report\", \"entries\": 3}", "x"),
                    UsageError);
}

TEST_CASE("The status is 1 when something failed, and 2 when something could not be run", "[report]") {
  REQUIRE(report_of({"a", "b"}).status() == 0);
  Report report = failing_report();
  REQUIRE(report.status() == 1);
  REQUIRE(report.failed() == 1);
  report.entries.push_back({"bad", "", "", "", {{"scenario", "error", false, "line 1"}}});
  REQUIRE(report.status() == 2);
}

TEST_CASE("Every name is in exactly one of the shards, and no shard is empty or has most", "[report]") {
  for (const int count : {1, 2, 7}) {
    std::vector<int> sizes(static_cast<std::size_t>(count));
    for (int i = 0; i < 1000; ++i) {
      int owners = 0;
      for (int number = 1; number <= count; ++number) {
        if (!is_in({number, count}, "hard/scene_" + std::to_string(i))) continue;
        ++owners;
        ++sizes[static_cast<std::size_t>(number - 1)];
      }
      REQUIRE(owners == 1);
    }
    for (const int size : sizes) REQUIRE(std::abs(size - 1000 / count) < 200 / count + 40);
  }
}

TEST_CASE("Shards join into one report in the order of names, whatever order they come in", "[report]") {
  const Report whole = merged({report_of({"d", "b"}, {2, 2}), report_of({"c", "a"}, {1, 2})});
  REQUIRE(to_json_text(whole) == to_json_text(report_of({"a", "b", "c", "d"})));
}

TEST_CASE("A shard that is missing, there twice, or of another run is refused", "[report]") {
  REQUIRE_THROWS_WITH(merged({report_of({"a"}, {1, 3}), report_of({"b"}, {3, 3})}), Contains("Shard 2/3 is missing"));
  REQUIRE_THROWS_WITH(merged({report_of({"a"}, {1, 2}), report_of({"b"}, {1, 2})}), Contains("1/2 is there twice"));
  REQUIRE_THROWS_WITH(merged({report_of({"a"}, {1, 2}), report_of({"b"}, {2, 3})}), Contains("does not belong"));
  REQUIRE_THROWS_WITH(merged({report_of({"a"}), report_of({"a"})}), Contains("\"a\" is in two"));
  REQUIRE(merged({report_of({"a"}), report_of({"b"})}).entries.size() == 2);
}

TEST_CASE("JUnit has a suite for each entry and a case for each item; text is escaped", "[junit]") {
  Report report = failing_report();
  report.entries.push_back({"bad\x01name\xff", "", "", "", {{"scenario", "error", false, "line 1"}}});
  report.entries.push_back({"free", "", "", "", {}});
  const std::string xml = junit_of(report);
  REQUIRE_THAT(xml, Contains("<testsuites name=\"proofreel 0.1.0\" tests=\"5\" failures=\"2\" errors=\"1\">"));
  REQUIRE_THAT(xml, Contains("<testsuite name=\"ball\" tests=\"3\" failures=\"2\" errors=\"0\">"));
  REQUIRE_THAT(xml, Contains("<testcase classname=\"golden.ball\" name=\"frame 0\"/>"));
  REQUIRE_THAT(xml, Contains("<failure type=\"drawing\" message=\"5 &lt; 6 &amp; &quot;more&quot;: 100 %"));
  REQUIRE_THAT(xml, Contains("<error type=\"error\" message=\"line 1\">"));
  REQUIRE_THAT(xml,
               Contains("bad name\xEF\xBF\xBD") && Contains("<testcase classname=\"golden.free\" name=\"runs\"/>"));
}

TEST_CASE("GitHub gets one annotation for each failing entry, escaped as it wants", "[annotations]") {
  Report report = failing_report();
  report.entries[0].name = "a,b:c";
  report.entries.push_back({"calm", "", "", "", {{"frame 0", "exact", true, ""}}});
  REQUIRE(annotations_of(report, ".") ==
          std::vector<std::string>{
              "::error file=ball.lua,title=a%2Cb%3Ac frame 9%3A drawing::5 < 6 & \"more\": 100 %25%0Aof "
              "it%0Aand 1 more.%0ATo reproduce: check ball"});
}

}  // namespace
}  // namespace proofreel
