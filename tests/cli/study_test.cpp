#include <algorithm>
#include <catch2/catch.hpp>
#include <csignal>
#include <filesystem>
#include <thread>

#include "golden/json.h"
#include "lab/csv.h"
#include "tests/cli/collection.h"
#include "tests/cli/program.h"
#include "tests/render/decoded_film.h"

namespace proofreel {
namespace {

using Catch::Matchers::Contains;

/// A ball on a spring for a second, and where it should be: `more` follows.
std::string swing(const std::string& more = "") {
  return "scenario { duration = 1, rate = 60, gravity = {0, 0}, view = { center = {0, 0}, height = 8 } }\n"
         "local ball = body { name = \"ball\", at = {1, 0}, mass = 1, shape = circle { radius = 0.1 } }\n"
         "spring { world, ball, from = {0, 0}, to = {1, 0}, stiffness = 100, damping = 0, length = 0 }\n"
         "measure(\"x\", function() return ball:position().x end)\n"
         "measure(\"v\", function() return ball:velocity().x end)\n" +
         more;
}
std::string known_swing() { return swing("reference(\"x\", function(t) return math.cos(10 * t) end)\n"); }

std::vector<CsvRecord> records_of(const Collection& c, const std::string& file) {
  return std::filesystem::exists(c / file) ? csv_records(read_text(c / file)) : std::vector<CsvRecord>();
}

TEST_CASE("A study leaves a table, a page and diagrams, and says who is cheapest", "[study]") {
  const Collection c;
  c.write("swing", known_swing());
  const Outcome o = c.run({"study", "swing", "--vary", "integrator=verlet,rk4", "--vary", "rate=60,120,240,480",
                           "--against", "box2d,chipmunk", "-o", "out"});
  REQUIRE(o.status == 0);
  REQUIRE(o.err.empty());
  REQUIRE_THAT(o.out, Contains("For an error of 1e-") && Contains("Chipmunk, accurate") &&
                          Contains("left out: Box2D cannot step joint 0 (spring): it is shorter than 5 mm"));
  for (const char* file : {"study.csv", "study.json", "study.html", "work_precision.png", "work_precision.svg",
                           "error_over_time.png", "energy_drift.svg"}) {
    INFO(file);
    REQUIRE(std::filesystem::file_size(c / (std::string("out/") + file)) > 500);
  }
  REQUIRE(records_of(c, "out/study.csv").size() == 1 + 2 * 4 + 2 * 4);
  const Json json = Json::parse(read_text(c / "out/study.json"));
  REQUIRE(json.at("methods")[1].at("order").get<double>() == Approx(4).margin(0.15));
  REQUIRE(json.at("runs").size() == 16);
  REQUIRE(json.at("runs")[0].at("errors").at("x").get<double>() > 0);
}

TEST_CASE("A measure may be chosen; without a reference the page says what it is compared with", "[study]") {
  const Collection c;
  c.write("swing", swing());
  const Outcome o = c.run({"study", "swing", "--vary", "rate=60,120", "--measure", "v", "--json", "-o", "out"});
  REQUIRE(o.status == 0);
  const Json json = Json::parse(o.out);
  REQUIRE(json.at("measures").size() == 1);
  REQUIRE(json.at("measures")[0].at("name") == "v");
  REQUIRE_THAT(read_text(c / "out/study.html"), Contains("compared with itself at a step 16 times smaller"));
}

TEST_CASE("A killed sweep goes on where it was, without repeating what had ended", "[study]") {
  const Collection c;
  c.write("swing", known_swing());
  const std::vector<std::string> words{"study",  "swing",
                                       "--vary", "substeps=1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16",
                                       "--vary", "rate=60,120,240,480,960,1920,3840,7680,9600,10200",
                                       "-o",     "out"};
  Program program(words, c.path());
  while (records_of(c, "out/study.csv").size() < 40) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  program.send(SIGKILL);
  REQUIRE(program.wait().signal == SIGKILL);
  const std::vector<CsvRecord> before = records_of(c, "out/study.csv");
  REQUIRE(before.size() < 320);
  REQUIRE(c.run(words).status == 0);
  const std::vector<CsvRecord> after = records_of(c, "out/study.csv");
  REQUIRE(after.size() == 1 + 160);
  const auto error_of = [](const CsvRecord& record) { return record[record.size() - 13]; };
  for (const CsvRecord& record : before) {
    const auto same_run = [&](const CsvRecord& other) {
      return other.back() == record.back() && error_of(other) == error_of(record);
    };
    REQUIRE(std::any_of(after.begin(), after.end(), same_run));
  }
}

TEST_CASE("The planner prints the line to paste, and fails when nobody reaches the error", "[study]") {
  const Collection c;
  c.write("swing", known_swing());
  const Outcome o = c.run({"study", "swing", "--target", "1e-3", "--vary", "integrator=verlet,rk4"});
  REQUIRE(o.status == 0);
  REQUIRE_THAT(o.out, Contains("For scenario{}:  method = { integrator = \""));
  const Outcome json = c.run({"study", "swing", "--target", "1e-3", "--vary", "integrator=rk4", "--json"});
  const Json method = Json::parse(json.out).at("methods")[0];
  REQUIRE(method.at("error").get<double>() <= 1e-3);
  c.write("wrong", swing("reference(\"x\", function(t) return 7 end)\n"));
  REQUIRE(c.run({"study", "wrong", "--target", "1e-3", "--vary", "integrator=verlet"}).status == 1);
}

TEST_CASE("Instructions are counted, and come out the same again", "[study]") {
  const Collection c;
  c.write("swing", known_swing());
  std::vector<std::string> counts;
  for (const char* folder : {"a", "b"}) {
    REQUIRE(c.run({"study", "swing", "--vary", "rate=60", "--set", "duration=0.1", "--instructions", "-o", folder})
                .status == 0);
    const std::vector<CsvRecord> records = records_of(c, std::string(folder) + "/study.csv");
    const auto column = std::find(records[0].begin(), records[0].end(), "instructions") - records[0].begin();
    counts.push_back(records[1][static_cast<std::size_t>(column)]);
  }
  REQUIRE(std::stoll(counts[0]) > 100);
  REQUIRE(counts[0] == counts[1]);
}

TEST_CASE("A film shows the methods side by side for as long as the scene lasts", "[study]") {
  const Collection c;
  c.write("swing", known_swing());
  REQUIRE(c.run({"study", "swing", "--vary", "integrator=verlet,rk4", "--vary", "rate=60,120,240", "--film", "--set",
                 "duration=0.2", "-o", "out"})
              .status == 0);
  const DecodedFilm film = decode_film(c / "out/film.mp4");
  REQUIRE(film.frames.size() == 12);
  REQUIRE(film.frames.front().width_px == 1920);
  REQUIRE(film.frames.front().height_px == 1080);
  const bool moves = film.frames.front().rgba != film.frames.back().rgba;
  REQUIRE(moves);
}

TEST_CASE("What a study cannot do is refused in a sentence, and leaves nothing behind", "[study]") {
  const Collection c;
  c.write("swing", known_swing());
  c.write("mute", "scenario { duration = 1 }\nbody { shape = circle { radius = 1 } }\n");
  const auto refused = [&](const std::vector<std::string>& words, const std::string& why) {
    const Outcome o = c.run(words);
    INFO(why);
    REQUIRE(o.status == 2);
    REQUIRE_THAT(o.err, Contains(why));
    REQUIRE_FALSE(std::filesystem::exists(c / "x"));
  };
  c.write("split", known_swing() + "pane{title='a'} pane{title='b'}\n");
  refused({"study", "split", "-o", "x"}, "with one scene only");
  refused({"study", "split", "--map", "-o", "x"}, "with one scene only");
  refused({"study", "split", "--target", "1e-3"}, "with one scene only");
  refused({"scorecard", "split", "-o", "x"}, "with one scene only");
  refused({"study", "swing"}, "Name a folder");
  refused({"study", "mute", "-o", "x"}, "measures nothing");
  refused({"study", "swing", "--measure", "y", "-o", "x"}, "has no such measure; known are");
  refused({"study", "swing", "--vary", "integrater=rk4", "-o", "x"}, "did you mean \"integrator\"?");
  refused({"study", "swing", "--vary", "integrator=rk5", "-o", "x"}, "did you mean \"rk4\"?");
  refused({"study", "swing", "--against", "havok", "-o", "x"}, "There is no peer \"havok\"");
  refused({"study", "swing", "--film", "--vary", "integrator=rk4", "--vary", "rate=60", "-o", "x"},
          "two to six methods");
  refused({"study", "swing", "--vary", "gravity={0,-1},{0,-2}", "-o", "x"}, "compares methods on one scene");
  refused({"study", "swing", "--target", "nothing"}, "--target takes");
  refused({"study", "swing", "--target", "0"}, "--target takes");
  const auto values = [](int count) {
    std::string text;
    for (int i = 1; i <= count; ++i) text += (i > 1 ? "," : "") + std::to_string(i);
    return text;
  };
  std::vector<std::string> many{"study",  "swing",
                                "--vary", "contact_hz=" + values(40),
                                "--vary", "substeps=" + values(16),
                                "--vary", "rate=" + values(20),
                                "-o",     "x"};
  refused(many, "say --yes");
  many[1] = "mute";
  refused(many, "say --yes");
  many.emplace_back("--yes");
  refused(many, "measures nothing");
}

TEST_CASE("A folder in the place of a study's table is an error of the environment that names it", "[study]") {
  const Collection c;
  c.write("swing", known_swing());
  std::filesystem::create_directories(c / "x/study.csv");
  const Outcome o = c.run({"study", "swing", "--vary", "rate=60,120", "-o", "x"});
  REQUIRE(o.status == 3);
  REQUIRE_THAT(o.err, Contains("Cannot write") && Contains("study.csv: it is a folder."));
}

}  // namespace
}  // namespace proofreel
