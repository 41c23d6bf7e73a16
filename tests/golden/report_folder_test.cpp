#include "golden/report_folder.h"

#include <catch2/catch.hpp>

#include "render/usage_error.h"
#include "tests/golden/report_examples.h"

namespace proofreel {
namespace {

using Catch::Matchers::Contains;
using namespace test;
namespace fs = std::filesystem;

TEST_CASE("A report is a page, its JSON, and the pictures of what failed", "[report]") {
  const ScratchFolder folder;
  write_example(folder / "out", folder / "references");
  const Report report = read_report(folder / "out");
  const ReportItem& item = report.entries.at(0).items.at(1);
  REQUIRE(read_png(folder / "out/" + item.expected).rgba == square_at(10, 10).rgba);
  REQUIRE(read_png(folder / "out/" + item.actual).rgba == square_at(12, 10).rgba);
  REQUIRE(read_png(folder / "out/" + item.heat).width_px == 64);
  REQUIRE(item.different == 2 * 2 * 8);
  REQUIRE(item.total == 64 * 40);
  REQUIRE(item.max_channel == 230);
  REQUIRE(item.place);
  REQUIRE(item.place->x_px <= 10);
  REQUIRE(item.place->x_px + item.place->width_px >= 20);
  REQUIRE(fs::exists(folder / "out/index.html"));
}

TEST_CASE("A second report takes the place of the first, leaving nothing of it", "[report]") {
  const ScratchFolder folder;
  write_example(folder / "out", folder / "references");
  ReportFolder(folder / "out").finish({"proofreel 0.1.0", {}, {}});
  REQUIRE(read_report(folder / "out").entries.empty());
  REQUIRE_FALSE(fs::exists(folder / "out/pictures"));
}

TEST_CASE("A report that was not finished has no page, can be written anew, and cannot be merged", "[report]") {
  const ScratchFolder folder;
  write_example(folder / "out", folder / "references");
  { const ReportFolder killed(folder / "out"); }
  REQUIRE_FALSE(fs::exists(folder / "out/index.html"));
  REQUIRE_THROWS_WITH(read_report(folder / "out"), Contains("unfinished"));
  write_example(folder / "out", folder / "references");
  REQUIRE(fs::exists(folder / "out/index.html"));
}

TEST_CASE("A folder that holds anything but a report is left alone", "[report]") {
  const ScratchFolder folder;
  write_text(folder / "home/pictures/holiday.png", "precious");
  REQUIRE_THROWS_WITH(ReportFolder(folder / "home"), Contains("holds other things"));
  write_text(folder / "home/report.json", "{\"tool\": \"another\"}");
  REQUIRE_THROWS_AS(ReportFolder(folder / "home"), UsageError);
  REQUIRE(read_text(folder / "home/pictures/holiday.png") == "precious");
  REQUIRE_THROWS_WITH(read_report(folder / "nowhere"), Contains("There is no report in"));
}

TEST_CASE("Names lead nowhere outside of the folder, and different names to different files", "[report]") {
  const ScratchFolder folder;
  const ReportFolder out(folder / "out");
  std::vector<std::string> files;
  for (const char* name : {"../../x", "/x", "x y", "x_y", "x/y", "x//y", "x/", "", "..", "\xff"}) {
    ReportItem item{"picture", "missing", false, ""};
    out.add_pictures(item, name, {}, square_at(0, 0));
    REQUIRE(fs::exists(folder / "out/" + item.actual));
    REQUIRE_THAT(item.actual, !Contains("..") && !Contains(" ") && !Contains("//"));
    files.push_back(item.actual);
  }
  std::sort(files.begin(), files.end());
  REQUIRE(std::unique(files.begin(), files.end()) == files.end());
}

TEST_CASE("A merged report whose JSON names files elsewhere is refused", "[report]") {
  const ScratchFolder folder;
  write_text(folder / "secret.png", "x");
  const ReportFolder out(folder / "out");
  for (const char* file : {"../secret.png", "pictures/../../secret.png", "/etc/passwd"}) {
    Report other = example_report();
    other.entries[0].items[0].actual = file;
    REQUIRE_THROWS_WITH(out.add_pictures_of(other, folder / "part"), Contains("outside of its folder"));
  }
}

TEST_CASE("A reference that cannot be read, or of another size, leaves the other picture to be seen", "[report]") {
  const ScratchFolder folder;
  const ReportFolder out(folder / "out");
  write_text(folder / "bad.png", "no picture");
  ReportItem damaged{"frame 0", "missing", false, "damaged."};
  out.add_pictures(damaged, "a", folder / "bad.png", square_at(0, 0));
  REQUIRE(damaged.expected.empty());
  REQUIRE_FALSE(damaged.actual.empty());
  write_png(folder / "small.png", plain_picture(8, 8, 0));
  ReportItem other_size{"frame 0", "size", false, "other size."};
  out.add_pictures(other_size, "b", folder / "small.png", square_at(0, 0));
  REQUIRE_FALSE(other_size.expected.empty());
  REQUIRE(other_size.heat.empty());
}

}  // namespace
}  // namespace proofreel
