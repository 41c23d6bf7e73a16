#include "golden/store.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "golden/hex.h"
#include "tests/render/scratch_folder.h"

namespace proofreel {
namespace {

using Catch::Matchers::Contains;

Golden example() {
  Golden golden;
  golden.scenario = "hard/stack";
  golden.size = {480, 270};
  golden.renderer = "llvmpipe (LLVM 15.0.6, 256 bits)";
  golden.version = "4.5 (Core Profile) Mesa 22.3.6";
  golden.tolerance = {2, 10, "text rounds differently"};
  golden.ticks = 1200;
  golden.final_trajectory_hash = hex(0xffffffffffffffffU);
  golden.frames.push_back({0, hex(1), "ab", "frame_00000.png", "cd", {}});
  golden.frames.push_back(
      {60, hex(2), "ef", "frame_00060.png", "gh", {{1, "box \"1\"", 0.1, -0.0, 1e-300}, {7, "", 1e9, 3, 6}}});
  golden.frames[1].touching = {{1, 7}, {1, 9}, {7, 9}};
  golden.frames[1].owners = {
      Owner{}, {OwnerKind::body, 7}, {OwnerKind::contact, 1, 7}, {OwnerKind::label, 1, 0, "\"v\""}};
  return golden;
}

TEST_CASE("A golden file says again exactly what was put in", "[store]") {
  const Golden golden = example();
  const std::string text = to_json_text(golden);
  const Golden back = golden_from_json(text, "golden.json");
  REQUIRE(to_json_text(back) == text);
  REQUIRE(back.scenario == golden.scenario);
  REQUIRE(back.size == golden.size);
  REQUIRE(back.tolerance.pixels == 10);
  REQUIRE(back.final_trajectory_hash == "ffffffffffffffff");
  REQUIRE(back.frames.size() == 2);
  REQUIRE(back.frames[1].bodies.size() == 2);
  REQUIRE(back.frames[1].bodies[0].name == "box \"1\"");
  REQUIRE(back.frames[1].bodies[0].x == 0.1);
  REQUIRE(std::signbit(back.frames[1].bodies[0].y));
  REQUIRE(back.frames[1].bodies[0].angle == 1e-300);
}

TEST_CASE("Who touches whom and whose the pixels are comes back, and so does that it was not kept", "[store]") {
  const Golden back = golden_from_json(to_json_text(example()), "golden.json");
  CHECK(back.frames[1].touching == example().frames[1].touching);
  CHECK(back.frames[1].owners == example().frames[1].owners);
  CHECK_FALSE(back.frames[0].touching.has_value());
  CHECK(back.frames[0].owners.empty());
  Golden golden = example();
  golden.frames[0].touching.emplace();
  CHECK(golden_from_json(to_json_text(golden), "golden.json").frames[0].touching.has_value());
}

TEST_CASE("A tolerance of what is seen comes back, limit by limit", "[store]") {
  Golden golden = example();
  golden.tolerance = {0, 0, "another Mesa", SeenTolerance{0.2, {12, 5, 0.5}}};
  const Tolerance back = golden_from_json(to_json_text(golden), "g.json").tolerance;
  REQUIRE(back.seen.has_value());
  CHECK(back.seen->threshold == 0.2);
  CHECK(back.seen->limits.different == 12);
  CHECK(back.seen->limits.window == 5);
  CHECK(back.seen->limits.bias == 0.5);
  CHECK(back.reason == "another Mesa");
  golden.tolerance.seen->limits.window.reset();
  CHECK_FALSE(golden_from_json(to_json_text(golden), "g.json").tolerance.seen->limits.window.has_value());
}

TEST_CASE("A tolerance of what is seen needs a reason, sane limits, and no limit per channel beside it", "[store]") {
  const SeenTolerance sane{0.1, {3, std::nullopt, 1}};
  for (const SeenTolerance& seen : {SeenTolerance{1.5, {3, std::nullopt, 1}}, SeenTolerance{0.1, {-1, std::nullopt, 1}},
                                    SeenTolerance{0.1, {3, -1, 1}}, SeenTolerance{0.1, {3, std::nullopt, 300}}}) {
    Golden golden = example();
    golden.tolerance = {0, 0, "x", seen};
    CHECK_THROWS_WITH(golden_from_json(to_json_text(golden), "g.json"), Contains("g.json: a tolerance takes"));
  }
  Golden golden = example();
  golden.tolerance = {0, 0, "", sane};
  CHECK_THROWS_WITH(golden_from_json(to_json_text(golden), "g.json"), Contains("reason"));
  std::string both = to_json_text(example());
  both.replace(both.find("\"reason\""), 0, "\"different\": 3, ");
  CHECK_THROWS_WITH(golden_from_json(both, "g.json"), Contains("either max_channel and pixels, or different"));
}

TEST_CASE("Fingerprints of ticks are only used when they are of the run that was blessed", "[store]") {
  const ScratchFolder folder;
  const GoldenStore store(folder.path());
  Golden golden = example();
  golden.ticks = 2;
  golden.final_trajectory_hash = hex(0xabcdef0123456789U);
  const auto keep = [&](const TickTrace& trace) {
    const std::vector<std::uint8_t> bytes = bytes_of(trace);
    write_text(store.ticks_path("hard/stack"), {bytes.begin(), bytes.end()});
  };
  CHECK_FALSE(store.load_ticks(golden).has_value());
  keep({{1, 2, 0x6789}, {}});
  CHECK(store.load_ticks(golden).has_value());
  keep({{1, 2, 0x6780}, {}});
  CHECK_FALSE(store.load_ticks(golden).has_value());
  keep({{1, 2, 3, 0x6789}, {}});
  CHECK_FALSE(store.load_ticks(golden).has_value());
}

TEST_CASE("One body takes one line of a golden file, so that differences read well", "[store]") {
  Golden golden = example();
  const auto lines = [](const Golden& g) {
    const std::string text = to_json_text(g);
    return std::count(text.begin(), text.end(), '\n');
  };
  const auto before = lines(golden);
  golden.frames[1].bodies.push_back({8, "one more", 1, 2, 3});
  REQUIRE(lines(golden) == before + 1);
}

TEST_CASE("Hashes are written as 16 hex digits", "[store]") {
  REQUIRE(hex(0) == "0000000000000000");
  REQUIRE(hex(0x0123456789abcdefU) == "0123456789abcdef");
}

TEST_CASE("A golden file that is cut, of other format or without a key is refused by name", "[store]") {
  const std::string text = to_json_text(example());
  REQUIRE_THROWS_WITH(golden_from_json(text.substr(0, text.size() / 2), "g.json"), Contains("g.json is damaged"));
  REQUIRE_THROWS_WITH(golden_from_json("", "g.json"), "g.json is damaged: line 1 is no JSON.");
  REQUIRE_THROWS_WITH(golden_from_json("{\n\n1}", "g.json"), "g.json is damaged: line 3 is no JSON.");
  REQUIRE_THROWS_WITH(golden_from_json("{\"format\": 2}", "g.json"), Contains("format 2"));
  const std::string wrong = "g.json is damaged: a key in it is missing or has a value of the wrong kind.";
  REQUIRE_THROWS_WITH(golden_from_json("{\"format\": 1}", "g.json"), wrong);
  REQUIRE_THROWS_WITH(golden_from_json("[]", "g.json"), wrong);
}

TEST_CASE("A golden file with a size that no picture has is refused", "[store]") {
  for (const char* width : {"-1", "16385", "1e300", "480.5", "\"480\""}) {
    std::string text = to_json_text(example());
    text.replace(text.find("480"), 3, width);
    CAPTURE(width);
    REQUIRE_THROWS_WITH(golden_from_json(text, "g.json"),
                        "g.json is damaged: width_px and height_px are whole numbers up to 16384.");
  }
}

TEST_CASE("A tolerance without a reason, or out of range, is refused", "[store]") {
  for (const Tolerance& tolerance : {Tolerance{1, 0, ""}, Tolerance{0, 1, ""}, Tolerance{-1, 0, "x"},
                                     Tolerance{256, 0, "x"}, Tolerance{0, -1, "x"}}) {
    Golden golden = example();
    golden.tolerance = tolerance;
    REQUIRE_THROWS_WITH(golden_from_json(to_json_text(golden), "g.json"), Contains("tolerance"));
  }
}

TEST_CASE("A store finds its scenarios, and the pictures no frame uses", "[store]") {
  const ScratchFolder folder;
  const GoldenStore store(folder.path());
  REQUIRE(store.ids().empty());
  REQUIRE_FALSE(store.load("hard/stack").has_value());
  write_text(store.json_path("hard/stack"), to_json_text(example()));
  write_text(store.json_path("a"), to_json_text(example()));
  write_text(store.folder("hard/stack") / "frame_00060.png", "x");
  write_text(store.folder("hard/stack") / "frame_00061.png", "x");
  write_text(store.folder("hard/stack") / "frame_00060.owners.png", "x");
  REQUIRE(store.ids() == std::vector<std::string>{"a", "hard/stack"});
  REQUIRE(store.load("hard/stack")->ticks == 1200);
  REQUIRE(store.load("a")->scenario == "a");  // whatever it was called when it was written
  const auto orphans = store.orphan_files(example());
  REQUIRE(orphans.size() == 1);
  REQUIRE(orphans[0].filename() == "frame_00061.png");
}

TEST_CASE("The nearest golden folder above a scenario is its store", "[store]") {
  const ScratchFolder folder;
  write_text(folder / "golden/x", "");
  write_text(folder / "a/golden/x", "");
  write_text(folder / "a/b/c/s.lua", "");
  REQUIRE(nearest_store(folder / "a/b/c/s.lua")->root() == folder.path() / "a/golden");
  REQUIRE(nearest_store(folder / "s.lua")->root() == folder.path() / "golden");
  REQUIRE_FALSE(nearest_store("/s.lua").has_value());
}

}  // namespace
}  // namespace proofreel
