#include <catch2/catch.hpp>

#include "golden/json.h"
#include "golden/store.h"
#include "render/pixel_hash.h"
#include "render/png.h"
#include "tests/cli/collection.h"

namespace proofreel {
namespace {

namespace fs = std::filesystem;
using Catch::Matchers::Contains;

/// A collection with one blessed scenario, "hard/ball": golden frames 0, 15 and 29.
class BlessedCollection : public Collection {
 public:
  BlessedCollection() {
    write("hard/ball", falling_ball());
    REQUIRE(run({"bless"}).status == 0);
  }
  std::string golden(const std::string& file) const { return *this / ("golden/images/hard/ball/" + file); }
  Golden load() const { return *GoldenStore(*this / "golden").load("hard/ball"); }
  void store(const Golden& g) const { write_text(golden("golden.json"), to_json_text(g)); }
  /// The verdict of each finding of a check: those of the frames, then the end's.
  std::vector<std::string> verdicts(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"check", "hard/ball", "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome o = run(arguments);
    const Json json = Json::parse(o.out);
    std::vector<std::string> list;
    bool all_pass = true;
    for (const Json& finding : json.at("scenarios").at(0).at("findings")) {
      list.push_back(finding.at("verdict"));
      all_pass = all_pass && (list.back() == "exact" || list.back() == "tolerated");
    }
    REQUIRE(o.status == (all_pass ? 0 : 1));
    REQUIRE(json.at("passed") == all_pass);
    return list;
  }
};

using Words = std::vector<std::string>;

void change_pixels(const std::string& file, int by) {
  Image image = read_png(file);
  for (std::size_t i = 0; i < 40; i += 4) image.rgba[i] = static_cast<std::uint8_t>(image.rgba[i] ^ by);
  write_png(file, image);
}

TEST_CASE("What was just blessed checks as exact, with pictures and without", "[golden]") {
  const BlessedCollection c;
  REQUIRE(c.verdicts() == Words(4, "exact"));
  REQUIRE(c.verdicts({"--hash-only"}) == Words(4, "exact"));
  REQUIRE(c.run({"check"}).status == 0);
  const Golden golden = c.load();
  REQUIRE(golden.size == Size{96, 64});
  REQUIRE(golden.frames.size() == 3);
  REQUIRE(golden.frames[1].file == "frame_00015.png");
  REQUIRE(golden.frames[1].bodies.at(0).name == "ball");
  REQUIRE(golden.frames[1].bodies.at(0).y == Approx(5 - 0.5 * 9.81 * 0.0625));
  REQUIRE_THAT(golden.version, Contains("Mesa"));
  REQUIRE(read_png(c.golden("frame_00029.png")).width_px == 96);
}

TEST_CASE("Blessing again changes nothing and says so", "[golden]") {
  const BlessedCollection c;
  const auto written = fs::last_write_time(c.golden("golden.json"));
  const Outcome o = c.run({"bless"});
  REQUIRE(o.status == 0);
  REQUIRE_THAT(o.out, Contains("hard/ball: unchanged"));
  REQUIRE(fs::last_write_time(c.golden("golden.json")) == written);
}

TEST_CASE("Other physics is called physics, naming the body and the tick at which it began", "[golden]") {
  const BlessedCollection c;
  REQUIRE(c.verdicts({"--set", "gravity={0,-9.7}"}) == Words{"exact", "physics", "physics", "physics"});
  REQUIRE(c.verdicts({"--hash-only", "--set", "gravity={0,-9.7}"}) == Words{"exact", "physics", "physics", "physics"});
  const Outcome o = c.run({"check", "hard/ball", "--set", "gravity={0,-9.7}"});
  REQUIRE_THAT(o.out, Contains("FAILED  hard/ball") && Contains("since tick 1 (first ball). ball moved"));
}

TEST_CASE("Other drawing is called drawing, and passes where nothing is drawn", "[golden]") {
  const BlessedCollection c;
  REQUIRE(c.verdicts({"--set", "theme=dark"}) == Words{"drawing", "drawing", "drawing", "exact"});
  REQUIRE(c.verdicts({"--hash-only", "--set", "theme=dark"}) == Words(4, "exact"));
}

TEST_CASE("Other physics and other drawing together are called both", "[golden]") {
  const BlessedCollection c;
  REQUIRE(c.verdicts({"--set", "theme=dark", "--set", "gravity={0,-9}"}) ==
          Words{"drawing", "both", "both", "physics"});
}

TEST_CASE("A reference picture that is missing, cut or replaced is found though all hashes agree", "[golden]") {
  const BlessedCollection c;
  const std::string file = c.golden("frame_00015.png");
  const std::string bytes = read_text(file);
  fs::remove(file);
  REQUIRE(c.verdicts() == Words{"exact", "missing", "exact", "exact"});
  write_text(file, bytes.substr(0, bytes.size() / 2));
  REQUIRE(c.verdicts() == Words{"exact", "missing", "exact", "exact"});
  REQUIRE_THAT(c.run({"check"}).out, Contains("frame_00015.png") && Contains("damaged"));
  change_pixels(c.golden("frame_00000.png"), 1);
  REQUIRE(c.verdicts() == Words{"missing", "missing", "exact", "exact"});
}

TEST_CASE("Pixels within the tolerance are tolerated, with the headroom told; beyond it they are not", "[golden]") {
  const BlessedCollection c;
  const std::string file = c.golden("frame_00015.png");
  change_pixels(file, 2);  // of ten pixels, one channel
  Golden golden = c.load();
  const std::string bytes = read_text(file);
  golden.frames[1].pixel_hash = pixel_hash(read_png(file));
  golden.frames[1].file_hash = bytes_hash({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
  const auto verdict_with = [&](const Tolerance& tolerance) {
    golden.tolerance = tolerance;
    c.store(golden);
    return c.verdicts()[1];
  };
  REQUIRE(verdict_with({}) == "drawing");
  REQUIRE_THAT(c.run({"check"}).out, Contains("10 of 6,144 pixels differ, by up to 2 of 255 (at 0,0)"));
  REQUIRE(verdict_with({1, 0, "why"}) == "drawing");
  REQUIRE(verdict_with({2, 0, "why"}) == "tolerated");
  REQUIRE(verdict_with({0, 9, "why"}) == "drawing");
  REQUIRE(verdict_with({0, 10, "why"}) == "tolerated");
  REQUIRE_THAT(c.run({"check"}).out, Contains("passed") && Contains("10 pixels beyond, of which 10 are used"));
  REQUIRE(c.verdicts({"--set", "gravity={0,-9}"})[1] == "physics");
}

TEST_CASE("A tolerance of what is seen is held by its limits, with the headroom told", "[golden]") {
  const BlessedCollection c;
  const std::string file = c.golden("frame_00015.png");
  change_pixels(file, 0xff);  // of ten pixels side by side, one channel
  Golden golden = c.load();
  const std::string bytes = read_text(file);
  golden.frames[1].pixel_hash = pixel_hash(read_png(file));
  golden.frames[1].file_hash = bytes_hash({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
  const auto verdict_with = [&](const DifferenceLimits& limits) {
    golden.tolerance = {0, 0, "why", SeenTolerance{0.1, limits}};
    c.store(golden);
    return c.verdicts()[1];
  };
  REQUIRE(verdict_with({10, std::nullopt, 2}) == "tolerated");
  REQUIRE_THAT(c.run({"check"}).out, Contains("10 of 10 visibly different pixels are used"));
  REQUIRE(verdict_with({9, std::nullopt, 2}) == "drawing");
  REQUIRE_THAT(c.run({"check"}).out, Contains("beyond what is tolerated: 10 pixels differ, 9 may"));
  REQUIRE(verdict_with({10, 10, 2}) == "tolerated");
  REQUIRE(verdict_with({10, 9, 2}) == "drawing");
  REQUIRE(verdict_with({10, std::nullopt, 0.1}) == "drawing");
}

TEST_CASE("Pictures are judged alike on one thread and on several, in the same order", "[golden]") {
  const Collection c;
  for (const char* id : {"a", "b", "c", "d", "e"}) c.write(id, falling_ball());
  REQUIRE(c.run({"bless"}).status == 0);
  c.write("b", falling_ball("ball:set { velocity = {1, 0} }\n"));
  c.write("d", "scenario {");
  const Outcome one = c.run({"check", "--jobs", "1"});
  REQUIRE(one.status == 2);
  REQUIRE_THAT(one.out, Contains("passed  a\nFAILED  b\n  frame 0: physics: since tick 0 (first ball)."));
  for (const char* jobs : {"2", "5"}) {
    const Outcome more = c.run({"check", "--jobs", jobs});
    REQUIRE(more.status == 2);
    REQUIRE(more.out == one.out);
    REQUIRE(more.err == one.err);
  }
}

TEST_CASE("A picture of other size is called size", "[golden]") {
  const BlessedCollection c;
  std::string lua = falling_ball();
  lua.replace(lua.rfind("{96, 64}"), 8, "{98, 64}");
  c.write("hard/ball", lua);
  REQUIRE(c.verdicts() == Words{"size", "size", "size", "exact"});
}

TEST_CASE("A frame newly asked for is missing, one no longer asked for an orphan, until blessed and pruned",
          "[golden]") {
  const BlessedCollection c;
  std::string lua = falling_ball();
  lua.replace(lua.find("{0, 15, 29}"), 11, "{0, 16, 29}");
  c.write("hard/ball", lua);
  REQUIRE(c.verdicts() == Words{"orphan", "exact", "missing", "exact", "exact"});
  const Outcome bless = c.run({"bless"});
  REQUIRE_THAT(bless.out, Contains("frame 16: new") && Contains("frame_00015.png") && Contains("--prune"));
  REQUIRE(c.verdicts() == Words{"exact", "exact", "exact", "exact", "orphan", "orphan"});
  REQUIRE_THAT(c.run({"bless", "--prune"}).out, Contains("frame_00015.png is removed"));
  REQUIRE(c.verdicts() == Words(4, "exact"));
}

TEST_CASE("A reference whose scenario is gone is an orphan of the collection", "[golden]") {
  const BlessedCollection c;
  c.write("other", "scenario { duration = 0.1 }\n");
  fs::remove(c / "scenarios/hard/ball.lua");
  const Outcome o = c.run({"check"});
  REQUIRE(o.status == 1);
  REQUIRE_THAT(o.out, Contains("orphan  hard/ball"));
  REQUIRE(c.run({"check", "other"}).status == 0);
}

TEST_CASE("A damaged golden.json fails the check by name, and blessing writes it anew", "[golden]") {
  const BlessedCollection c;
  write_text(c.golden("golden.json"), "{\"format\": 1,");
  const Outcome o = c.run({"check", "hard/ball"});
  REQUIRE(o.status == 1);
  REQUIRE_THAT(o.out,
               Contains("golden.json is damaged: line 1 is no JSON. Take it from the repository, or run bless."));
  REQUIRE(c.run({"bless"}).status == 0);
  REQUIRE(c.verdicts() == Words(4, "exact"));
}

TEST_CASE("bless says what changed, keeps the tolerance, and writes only pictures that changed", "[golden]") {
  const BlessedCollection c;
  Golden golden = c.load();
  golden.tolerance = {3, 5, "a reason"};
  c.store(golden);
  const auto first = fs::last_write_time(c.golden("frame_00000.png"));
  std::string lua = falling_ball();
  lua.replace(lua.find("duration = 0.5"), 14, "duration = 0.5, gravity = {0, -9}");
  c.write("hard/ball", lua);
  const Outcome o = c.run({"bless", "hard/ball"});
  REQUIRE(o.status == 0);
  REQUIRE_THAT(o.out, Contains("frame 29: other state and other pixels"));
  REQUIRE_THAT(o.out, !Contains("frame 0:"));
  REQUIRE(fs::last_write_time(c.golden("frame_00000.png")) == first);
  REQUIRE(c.load().tolerance.max_channel == 3);
  REQUIRE(c.load().tolerance.reason == "a reason");
  REQUIRE(c.verdicts() == Words(4, "exact"));
}

TEST_CASE("bless leaves a frame alone whose difference is tolerated", "[golden]") {
  const BlessedCollection c;
  const std::string file = c.golden("frame_00015.png");
  change_pixels(file, 2);
  Golden golden = c.load();
  const std::string bytes = read_text(file);
  golden.frames[1].pixel_hash = pixel_hash(read_png(file));
  golden.frames[1].file_hash = bytes_hash({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
  golden.tolerance = {2, 0, "why"};
  c.store(golden);
  REQUIRE_THAT(c.run({"bless"}).out, Contains("hard/ball: unchanged"));
  REQUIRE(read_text(file) == bytes);
}

TEST_CASE("bless adds what only explains failures where it is missing, and touches no picture", "[golden]") {
  const BlessedCollection c;
  const std::string kept = read_text(c.golden("golden.json"));
  const auto written = fs::last_write_time(c.golden("frame_00015.png"));
  fs::remove(c.golden("ticks.bin"));
  REQUIRE_THAT(c.run({"bless"}).out, Contains("hard/ball: the fingerprints of its ticks are added."));
  fs::remove(c.golden("frame_00015.owners.png"));
  Golden golden = c.load();
  golden.frames[2].touching.reset();
  c.store(golden);
  REQUIRE(c.verdicts() == Words(4, "exact"));
  REQUIRE_THAT(c.run({"bless"}).out, Contains("hard/ball: frames 15, 29: whose its pixels are"));
  REQUIRE(fs::exists(c.golden("frame_00015.owners.png")));
  REQUIRE(fs::last_write_time(c.golden("frame_00015.png")) == written);
  REQUIRE(read_text(c.golden("golden.json")) == kept);
  REQUIRE_THAT(c.run({"bless"}).out, Contains("unchanged"));
}

TEST_CASE("bless says what it will change before it writes anything", "[golden]") {
  const Collection c;
  c.write("ball", falling_ball());
  fs::create_directories(c / "golden/images");
  write_text(c / "golden/images/ball", "a file where the folder should be");
  const Outcome o = c.run({"bless"});
  REQUIRE(o.status == 3);
  REQUIRE_THAT(o.out, Contains("ball: frame 0: new.") && Contains("ball: frame 29: new."));
  REQUIRE_THAT(o.err, Contains("golden/images/ball"));
}

TEST_CASE("References of a scenario that is gone are told about, and removed with --prune", "[golden]") {
  const BlessedCollection c;
  c.write("hard/ball/inner", falling_ball());
  c.write("hard/other", falling_ball());
  REQUIRE(c.run({"bless"}).status == 0);
  fs::remove(c / "scenarios/hard/ball.lua");
  REQUIRE_THAT(c.run({"bless"}).out, Contains("hard/ball: no scenario asks for it any more; --prune removes it."));
  REQUIRE(fs::exists(c.golden("golden.json")));
  REQUIRE_THAT(c.run({"bless", "hard/other", "--prune"}).out, !Contains("hard/ball"));
  REQUIRE_THAT(c.run({"bless", "--prune"}).out,
               Contains("hard/ball: no scenario asks for it any more; it is removed."));
  REQUIRE_FALSE(fs::exists(c.golden("golden.json")));
  REQUIRE_FALSE(fs::exists(c.golden("frame_00015.owners.png")));
  REQUIRE(fs::exists(c.golden("inner/golden.json")));
  REQUIRE(c.run({"check"}).status == 0);
}

TEST_CASE("bless refuses with CI=true", "[golden]") {
  const Collection c;
  c.write("ball", falling_ball());
  const Outcome o = c.run({"bless"}, {{"CI", "true"}});
  REQUIRE(o.status == 2);
  REQUIRE_THAT(o.err, Contains("CI=true"));
  REQUIRE(fs::is_empty(c / "golden"));
  REQUIRE(c.run({"bless"}, {{"CI", "false"}}).status == 0);
}

TEST_CASE("bless takes no --set, because no file would say what the reference shows", "[golden]") {
  const Collection c;
  const Outcome o = c.run({"bless", "--set", "duration=1"});
  REQUIRE(o.status == 2);
  REQUIRE_THAT(o.err, Contains("--set"));
}

TEST_CASE("A golden frame beyond the film is a bad scenario", "[golden]") {
  const Collection c;
  std::string lua = falling_ball();
  lua.replace(lua.find("{0, 15, 29}"), 11, "{0, 15, 30}");
  c.write("ball", lua);
  const Outcome o = c.run({"check", "ball"});
  REQUIRE(o.status == 2);
  REQUIRE_THAT(o.err, Contains("golden frame 30") && Contains("0 to 29"));
}

TEST_CASE("A scenario that is not golden keeps its final state only", "[golden]") {
  const Collection c;
  c.write("free", "scenario { duration = 0.1 }\nbody { at = {0, 1}, shape = circle { radius = 1 } }\n");
  REQUIRE(c.run({"bless"}).status == 0);
  REQUIRE(c.run({"check"}).status == 0);
  const Outcome o = c.run({"check", "free", "--set", "gravity={0,-1}"});
  REQUIRE(o.status == 1);
  REQUIRE_THAT(o.out, Contains("physics"));
}

TEST_CASE("Two files that would share a reference are refused before anything is written", "[golden]") {
  const BlessedCollection c;
  for (const char* folder : {"one", "two"}) {
    fs::create_directories(c / folder);
    write_text(c / (std::string(folder) + "/ball.lua"), falling_ball());
  }
  const Outcome both = c.run({"bless", "one", "two"});
  REQUIRE(both.status == 2);
  REQUIRE_THAT(both.err, Contains("one/ball.lua") && Contains("two/ball.lua") && Contains("share the reference"));
  REQUIRE_FALSE(fs::exists(c / "golden/images/ball"));
  REQUIRE(c.run({"bless", "one"}).status == 0);
}

TEST_CASE("A scenario named twice is checked once", "[golden]") {
  const BlessedCollection c;
  const Outcome twice = c.run({"check", "hard/ball", "scenarios/hard/ball.lua", "--json"});
  REQUIRE(twice.status == 0);
  REQUIRE(Json::parse(twice.out).at("scenarios").size() == 1);
}

TEST_CASE("A folder in the place of golden.json or of its ticks is no reference", "[golden]") {
  const BlessedCollection c;
  fs::remove(c.golden("ticks.bin"));
  fs::create_directory(c.golden("ticks.bin"));
  REQUIRE(c.verdicts() == Words(4, "exact"));
  fs::remove(c.golden("ticks.bin"));
  fs::remove(c.golden("golden.json"));
  fs::create_directory(c.golden("golden.json"));
  const Outcome o = c.run({"check", "hard/ball"});
  REQUIRE(o.status == 1);
  REQUIRE_THAT(o.out, Contains("missing: there is no reference for this frame"));
  const Outcome blessing = c.run({"bless"});
  REQUIRE(blessing.status == 3);
  REQUIRE_THAT(blessing.err, Contains("golden.json") && Contains("it is a folder"));
}

TEST_CASE("References that were moved together with their scenario are still its own", "[golden]") {
  const BlessedCollection c;
  fs::create_directories(c / "golden/images/soft");
  fs::rename(c / "golden/images/hard/ball", c / "golden/images/soft/ball");
  fs::create_directories(c / "scenarios/soft");
  fs::rename(c / "scenarios/hard/ball.lua", c / "scenarios/soft/ball.lua");
  REQUIRE(c.run({"check", "soft/ball"}).status == 0);
  const Outcome o = c.run({"check", "soft/ball", "--set", "gravity={0,-5}"});
  REQUIRE(o.status == 1);
  REQUIRE_THAT(o.out, Contains("physics: since tick") && !Contains("missing") && !Contains("damaged"));
}

}  // namespace
}  // namespace proofreel
