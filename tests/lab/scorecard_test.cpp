#include "lab/scorecard.h"

#include <catch2/catch.hpp>

#include "lab/score_files.h"
#include "lab/study_map.h"
#include "render/png.h"
#include "render/usage_error.h"
#include "tests/lab/grid_scenes.h"

namespace proofreel {
namespace {

using namespace test;
using Catch::Matchers::Contains;

TEST_CASE("The first column is the default method, and peers come last at 60 ticks a second", "[scorecard]") {
  const GridFolder folder;
  const std::string file = folder.write("one", fall(expecting("x", true), ", rate = 240, method = { substeps = 3 }"));
  const Grid grid = scorecard_grid({file}, {Peer::box2d, Peer::chipmunk}, {{"rate", "120"}});
  REQUIRE(grid.runs.size() == grid.columns.size());
  REQUIRE(grid.runs.front().values == std::vector<std::string>{"auto", "direct", "3", "double", "120"});
  REQUIRE(grid.runs.front().repeated);
  REQUIRE(grid.columns[grid.columns.size() - 2].group == "Box2D");
  REQUIRE(grid.runs.back().peer == Peer::chipmunk);
  REQUIRE(grid.runs.back().values.back() == "120");
  REQUIRE(scorecard_grid({file}, {Peer::chipmunk}, {}).runs.back().values.back() == "60");
}

TEST_CASE("What the user sets gives way to what a method is", "[scorecard]") {
  const GridFolder folder;
  const std::string file = folder.write("one", fall(expecting("x", true)));
  const Grid grid = scorecard_grid({file}, {}, {{"method.precision", "single"}, {"substeps", "5"}});
  REQUIRE(grid.runs[0].values[3] == "double");
  REQUIRE(grid.runs[0].values[2] == "5");
  REQUIRE(grid.runs[2].values[2] == "1");
}

TEST_CASE("Of two settings of one key the one above holds, by its short name or its full one", "[scorecard]") {
  const std::vector<Override> all = overlaid({{"method.substeps", "1"}, {"rate", "60"}}, {{"substeps", "2"}});
  REQUIRE(all.size() == 2);
  REQUIRE(all[0].key == "rate");
  REQUIRE(all[1].value == "2");
}

TEST_CASE("Scores count outcomes and hold costs against Box2D's where both came to an end", "[scorecard]") {
  Grid grid;
  grid.rows.resize(3);
  grid.columns = {{"", "ours", ""}, {"", "theirs", ""}};
  grid.runs.resize(6);
  for (const std::size_t i : {1U, 3U, 5U}) grid.runs[i].peer = Peer::box2d;
  const std::vector<RunResult> results{costing(4), costing(2, Standing::fails),    costing(8, Standing::degrades),
                                       costing(2), costing(7, Standing::too_slow), costing(9, Standing::stands)};
  const std::vector<MethodScore> scores = scores_of(grid, results);
  REQUIRE(scores[0].count(Standing::stands) == 1);
  REQUIRE(scores[0].count(Standing::degrades) == 1);
  REQUIRE(scores[0].count(Standing::too_slow) == 1);
  REQUIRE(scores[0].cost_ms == Approx(12));
  REQUIRE(scores[0].costed == 2);
  REQUIRE(scores[0].shared == 2);
  REQUIRE(scores[0].to_box2d.value() == Approx(3));
  REQUIRE(scores[1].to_box2d.value() == Approx(1));
  REQUIRE(scores[1].engine == "Box2D");
  REQUIRE_FALSE(default_stands(grid, results));
  const std::vector<RunResult> good{costing(1), costing(1, Standing::fails), costing(1), costing(1), costing(1),
                                    costing(1)};
  REQUIRE(default_stands(grid, good));
}

TEST_CASE("Without Box2D there is nothing to hold costs against", "[scorecard]") {
  Grid grid;
  grid.rows.resize(1);
  grid.columns.resize(1);
  grid.runs.resize(1);
  REQUIRE_FALSE(scores_of(grid, {costing(1)}).front().to_box2d);
}

TEST_CASE("More rows than a sheet holds are dealt out to several maps", "[scorecard]") {
  const GridFolder folder;
  std::filesystem::create_directories(folder.out());
  const auto write = [&](std::size_t rows) {
    Grid grid;
    grid.columns.resize(2);
    grid.rows.resize(rows);
    grid.runs.resize(2 * rows);
    write_score_files(grid, std::vector<RunResult>(2 * rows, costing(1)), {}, folder.work(), "", "");
    return read_text(folder.out() + "/runs.html");
  };
  REQUIRE_THAT(write(44), Contains("href=\"runs.png\"") && !Contains("runs-1.png"));
  REQUIRE_THAT(write(45), Contains("href=\"runs-1.png\"") && Contains("href=\"runs-2.png\""));
  const int first = read_png(folder.out() + "/runs-1.png").height_px;
  const int second = read_png(folder.out() + "/runs-2.png").height_px;
  REQUIRE(second - first == 106);  // a row: 22 of them, and 23
  REQUIRE_THAT(write(0), Contains("href=\"runs.png\""));
}

TEST_CASE("An axis is a key and its values; commas within braces do not divide", "[study]") {
  const Axis axis = parse_axis("gravity={0,-1},{0, -9.81}");
  REQUIRE(axis.key == "gravity");
  REQUIRE(axis.values == std::vector<std::string>{"{0,-1}", "{0, -9.81}"});
}

TEST_CASE("Axes that make no sense are refused", "[study]") {
  for (const char* text : {"rate", "=1,2", "rate=", "rate=1,,2", "rate=60,60"}) {
    CAPTURE(text);
    REQUIRE_THROWS_AS(parse_axis(text), UsageError);
  }
  REQUIRE_THROWS_WITH(map_axes({"ratee=60"}), Contains("--vary ratee=60") && Contains("did you mean \"rate\"?"));
  REQUIRE_THROWS_WITH(map_axes({"rate=60", "rate=120"}), Contains("twice"));
  REQUIRE_THROWS_WITH(map_axes({"substeps=1", "method.substeps=2"}), Contains("twice"));
  REQUIRE_THROWS_WITH(map_axes({"rate=60", "substeps=1", "seed=1"}), Contains("two axes"));
}

TEST_CASE("Missing axes are rate and substeps", "[study]") {
  REQUIRE(map_axes({})[0].key == "rate");
  REQUIRE(map_axes({})[1].values == std::vector<std::string>{"1", "2", "4", "8"});
  REQUIRE(map_axes({"method.substeps=3"})[1].key == "rate");
  REQUIRE(map_axes({"precision=single,double"})[1].key == "rate");
}

TEST_CASE("A map has a column per value of the first axis and a row per value of the second", "[study]") {
  const GridFolder folder;
  const std::string file = folder.write("one", fall(expecting("x", true)));
  const Grid grid = map_grid(file, map_axes({"substeps=1,2,4", "rate=60,120"}), {});
  REQUIRE(grid.columns.size() == 3);
  REQUIRE(grid.rows.size() == 2);
  REQUIRE(grid.one_scenario);
  REQUIRE(grid.runs[grid.index(1, 2)].values == std::vector<std::string>{"4", "120"});
}

TEST_CASE("A value that scenario{} does not take is refused before anything runs", "[study]") {
  const GridFolder folder;
  const std::string file = folder.write("one", fall(expecting("x", true)));
  REQUIRE_THROWS_WITH(map_grid(file, map_axes({"rate=60,0"}), {}), Contains("--vary rate=0"));
}

TEST_CASE("A value that does not go with the scene is a result", "[study]") {
  const GridFolder folder;
  const std::string two = "body { at = {3, 5}, shape = circle { radius = 0.5 } }\n";
  const std::string file = folder.write("one", fall(two + expecting("x", true)));
  const Grid grid = map_grid(file, map_axes({"integrator=verlet,rk4", "substeps=1"}), {});
  const std::vector<RunResult> results = work_off(grid, folder.work(), [](auto, auto) {});
  REQUIRE(results[0].standing == Standing::stands);
  REQUIRE(results[1].standing == Standing::not_offered);
}

}  // namespace
}  // namespace proofreel
