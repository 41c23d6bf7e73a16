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
  REQUIRE_THROWS_WITH(golden_from_json("", "g.json"), Contains("g.json"));
  REQUIRE_THROWS_WITH(golden_from_json("{\"format\": 2}", "g.json"), Contains("format 2"));
  REQUIRE_THROWS_WITH(golden_from_json("{\"format\": 1}", "g.json"), Contains("g.json is damaged"));
  REQUIRE_THROWS_WITH(golden_from_json("[]", "g.json"), Contains("g.json is damaged"));
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
  REQUIRE(store.ids() == std::vector<std::string>{"a", "hard/stack"});
  REQUIRE(store.load("hard/stack")->ticks == 1200);
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
