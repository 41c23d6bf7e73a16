#include "lab/grid_table.h"

#include <catch2/catch.hpp>

#include "render/usage_error.h"
#include "tests/lab/grid_scenes.h"

namespace proofreel {
namespace {

using namespace test;
using Catch::Matchers::Contains;

const auto quietly = [](std::int64_t, std::int64_t) {};

/// How many runs are still to be done.
std::int64_t runs_left(const GridFolder& folder, const Grid& grid) {
  std::int64_t left = -1;
  work_off(grid, folder.work(), [&](std::int64_t, std::int64_t total) { left = total; });
  return left;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  REQUIRE(text.find(what) != std::string::npos);
  return text.replace(text.find(what), what.size(), by);
}

TEST_CASE("Fields with commas, quotes and line ends come back as they were", "[grid]") {
  const CsvRecord record{"", "plain", "a, b", "he said \"no\"", "two\nlines", "\"", ""};
  REQUIRE(csv_records(csv_line(record)) == std::vector<CsvRecord>{record});
  REQUIRE(csv_line({"a, b", "c"}) == "\"a, b\",c\n");
  REQUIRE(csv_line({"", "c"}) == ",c\n");
}

TEST_CASE("Lines may end as Windows ends them, and one that was cut off is left out", "[grid]") {
  REQUIRE(csv_records("a,b\r\nc,d\r\ne,") == std::vector<CsvRecord>{{"a", "b"}, {"c", "d"}});
  REQUIRE(csv_records("a,\"b\nc").empty());
}

TEST_CASE("Numbers read back exactly, and nothing else is a number", "[grid]") {
  for (const double value : {0.1, 1.0 / 3, -2.5e-300, 17.0}) REQUIRE(number_in(exact(value)) == value);
  for (const char* text : {"", "1x", "x", "1 "}) REQUIRE_FALSE(number_in(text));
}

TEST_CASE("A result comes back from its line as it was", "[grid]") {
  RunRequest request;
  request.scenario = "hard/stack";
  request.peer = Peer::box2d;
  request.values = {"", "60"};
  request.key = "abc";
  RunResult result;
  result.standing = Standing::degrades;
  result.why = "at 1 s: \"quality: a, b\"";
  result.at_s = 1;
  result.simulated_s = 2;
  result.cpu_s = 1.0 / 3;
  result.energy_drift_j = 1e-20;
  result.joint_gap_m = 0.1;
  result.trajectory_hash = "0123456789abcdef";
  result.same_twice = false;
  result.still = "stills/a.png";
  const CsvRecord record = csv_records(csv_line(record_of(request, result))).at(0);
  Grid grid;
  grid.keys = {"substeps", "rate"};
  REQUIRE(record.size() == header_of(grid).size());
  const StoredResult back = result_in(record, 2).value();
  REQUIRE(back.key == "abc");
  REQUIRE(record_of(request, back.result) == record);
  REQUIRE_FALSE(back.result.overlap_share);
  REQUIRE(back.result.same_twice == false);
}

TEST_CASE("What has its line is not run again, what has none is", "[grid]") {
  const GridFolder folder;
  const Grid grid = folder.grid_of({fall(expecting("a", true)), fall(expecting("b", false))});
  REQUIRE(runs_left(folder, grid) == 2);
  const std::string table = read_text(folder.table());
  REQUIRE(runs_left(folder, grid) == 0);
  REQUIRE(read_text(folder.table()) == table);  // CPU times never come out the same twice
  const std::size_t second_line_end = table.find('\n', table.find('\n') + 1) + 1;
  write_text(folder.table(), table.substr(0, second_line_end + 20));  // killed while it wrote
  REQUIRE(runs_left(folder, grid) == 1);
  REQUIRE(read_text(folder.table()).substr(0, second_line_end) == table.substr(0, second_line_end));
  REQUIRE(csv_records(read_text(folder.table())).size() == 3);
}

TEST_CASE("A changed scenario is run again, and its old line is gone", "[grid]") {
  const GridFolder folder;
  REQUIRE(runs_left(folder, folder.grid_of({fall(expecting("a", true))})) == 1);
  const Grid changed = folder.grid_of({fall(expecting("a", false))});
  REQUIRE(runs_left(folder, changed) == 1);
  REQUIRE(csv_records(read_text(folder.table())).size() == 2);
  REQUIRE_THAT(read_text(folder.table()), Contains("fails"));
}

TEST_CASE("A run whose picture is gone is run again", "[grid]") {
  const GridFolder folder;
  const Grid grid = folder.grid_of({fall(expecting("a", true))});
  const RunResult result = work_off(grid, folder.work(), quietly).front();
  std::filesystem::remove(folder.out() + "/" + result.still);
  REQUIRE(runs_left(folder, grid) == 1);
}

TEST_CASE("Runs that can only come out the same are done once", "[grid]") {
  const GridFolder folder;
  Grid grid = folder.grid_of({fall(expecting("a", true))});
  grid.rows.push_back(grid.rows.front());
  grid.runs.push_back(grid.runs.front());
  REQUIRE(runs_left(folder, grid) == 1);
  const std::vector<CsvRecord> records = csv_records(read_text(folder.table()));
  REQUIRE(records.size() == 3);
  REQUIRE(records[1] == records[2]);
}

TEST_CASE("Two runs at a time come out as one after the other", "[grid]") {
  const GridFolder folder;
  const Grid grid =
      folder.grid_of({fall(expecting("a", true)), fall(expecting("b", false)), fall(expecting("quality: c", false))});
  GridWork work = folder.work();
  work.at_once = 2;
  const std::vector<RunResult> results = work_off(grid, work, quietly);
  REQUIRE(results[0].standing == Standing::stands);
  REQUIRE(results[1].standing == Standing::fails);
  REQUIRE(results[2].standing == Standing::degrades);
}

TEST_CASE("A file that is another table is left alone", "[grid]") {
  const GridFolder folder;
  write_text(folder.table(), "name,colour\nstool,red\n");
  const Grid grid = folder.grid_of({fall(expecting("a", true))});
  REQUIRE_THROWS_AS(work_off(grid, folder.work(), quietly), UsageError);
  REQUIRE(read_text(folder.table()) == "name,colour\nstool,red\n");
}

TEST_CASE("A line that makes no sense is forgotten", "[grid]") {
  const GridFolder folder;
  const Grid grid = folder.grid_of({fall(expecting("a", true))});
  work_off(grid, folder.work(), quietly);
  write_text(folder.table(), replaced(read_text(folder.table()), ",stands,", ",wobbles,"));
  REQUIRE(runs_left(folder, grid) == 1);
}

}  // namespace
}  // namespace proofreel
