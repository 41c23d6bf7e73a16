#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>

#include "golden/report_folder.h"
#include "proofreel/golden.h"
#include "render/png.h"
#include "tests/golden/report_examples.h"

namespace proofreel {
namespace {

using Catch::Matchers::Contains;
using namespace test;
namespace fs = std::filesystem;

/// A variable of the environment for as long as this lives.
class Variable {
 public:
  Variable(const char* name, const char* value) : name_(name) { ::setenv(name, value, 1); }
  ~Variable() { ::unsetenv(name_); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
};

Pixels pixels_of(const Image& image) { return {image.rgba.data(), image.width_px, image.height_px}; }

/// A folder with one reference, "ui/square".
struct Store {
  ScratchFolder folder;
  Image then = square_at(10, 10);
  Store() {
    ::unsetenv("CI");
    fs::create_directories(folder / "golden/ui");
    write_png(folder / "golden/ui/square.png", then);
  }
  std::string golden() const { return folder / "golden"; }
};

TEST_CASE("A picture that equals its reference is exact, rows with gaps between them included", "[goldens]") {
  const Store store;
  Goldens goldens(store.golden());
  const PictureCheck check = goldens.check("ui/square", pixels_of(store.then));
  REQUIRE(check.verdict == PictureVerdict::exact);
  REQUIRE(check.message.empty());
  std::vector<std::uint8_t> gappy(40 * 300, 77);
  for (int y = 0; y < 40; ++y) std::copy_n(store.then.row(y), 256, &gappy[static_cast<std::size_t>(y) * 300]);
  REQUIRE(goldens.check("ui/square", {gappy.data(), 64, 40, 300}).verdict == PictureVerdict::exact);
}

TEST_CASE("Other pixels are a drawing that differs, with figures and what to do", "[goldens]") {
  const Store store;
  const PictureCheck check = Goldens(store.golden()).check("ui/square", pixels_of(square_at(12, 10)));
  REQUIRE(check.verdict == PictureVerdict::drawing);
  REQUIRE_FALSE(check.passed());
  REQUIRE_THAT(check.message,
               Contains("32 of 2560 pixels differ, by up to 230 of 255 (at 10,10)") && Contains("PROOFREEL_BLESS=1"));
}

TEST_CASE("A tolerance needs a reason, lets through what is within it, and tells the headroom", "[goldens]") {
  const Store store;
  Goldens goldens(store.golden());
  const Image other = square_at(12, 10);
  const PictureCheck within = goldens.check("ui/square", pixels_of(other), {0, 40, "a jittery font"});
  REQUIRE(within.verdict == PictureVerdict::tolerated);
  REQUIRE_THAT(within.message, Contains("40 pixels beyond, of which 32 are used"));
  REQUIRE(goldens.check("ui/square", pixels_of(other), {0, 31, "x"}).verdict == PictureVerdict::drawing);
  REQUIRE(goldens.check("ui/square", pixels_of(other), {230, 0, "x"}).verdict == PictureVerdict::tolerated);
  REQUIRE_THROWS_WITH(goldens.check("ui/square", pixels_of(other), {1, 0}), Contains("reason"));
  REQUIRE_THROWS_WITH(goldens.check("ui/square", pixels_of(other), {256, 0, "x"}), Contains("0..255"));
}

TEST_CASE("A reference that is missing or damaged fails, and one of another size is a size", "[goldens]") {
  const Store store;
  Goldens goldens(store.golden());
  const PictureCheck missing = goldens.check("new", pixels_of(store.then));
  REQUIRE(missing.verdict == PictureVerdict::missing);
  REQUIRE_THAT(missing.message, Contains("there is no reference") && Contains("new.png"));
  REQUIRE_FALSE(fs::exists(store.folder / "golden/new.png"));
  write_text(store.folder / "golden/bad.png", "no picture");
  REQUIRE(goldens.check("bad", pixels_of(store.then)).verdict == PictureVerdict::missing);
  REQUIRE_THAT(goldens.check("ui/square", pixels_of(plain_picture(8, 9, 0))).message,
               Contains("the picture is 8x9, golden is 64x40"));
}

TEST_CASE("Blessing writes what fails, touches nothing that passes, and is told", "[goldens]") {
  const Store store;
  const Variable bless("PROOFREEL_BLESS", "1");
  const auto before = fs::last_write_time(store.folder / "golden/ui/square.png");
  Goldens goldens(store.golden());
  REQUIRE(goldens.check("ui/square", pixels_of(store.then)).verdict == PictureVerdict::exact);
  REQUIRE(fs::last_write_time(store.folder / "golden/ui/square.png") == before);
  const PictureCheck anew = goldens.check("a/b/new", pixels_of(store.then));
  REQUIRE(anew.verdict == PictureVerdict::blessed);
  REQUIRE(anew.passed());
  REQUIRE_THAT(anew.message, Contains("written; before, there is no reference"));
  REQUIRE(goldens.check("ui/square", pixels_of(square_at(0, 0))).verdict == PictureVerdict::blessed);
  REQUIRE(read_png(store.folder / "golden/ui/square.png").rgba == square_at(0, 0).rgba);
  REQUIRE(goldens.check("a/b/new", pixels_of(store.then)).verdict == PictureVerdict::exact);
}

TEST_CASE("With CI=true nothing is blessed", "[goldens]") {
  const Store store;
  const Variable bless("PROOFREEL_BLESS", "1"), ci("CI", "true");
  REQUIRE_THROWS_WITH(Goldens(store.golden()), Contains("CI=true"));
}

TEST_CASE("References nobody asked for are orphans", "[goldens]") {
  const Store store;
  write_png(store.folder / "golden/old.png", store.then);
  Goldens goldens(store.golden());
  goldens.check("ui/square", pixels_of(store.then));
  const std::vector<PictureCheck> orphans = goldens.check_orphans();
  REQUIRE(orphans.size() == 1);
  REQUIRE(orphans[0].name == "old");
  REQUIRE_FALSE(orphans[0].passed());
}

TEST_CASE("The report holds every picture once, as it was found last, and is written at the end", "[goldens]") {
  const Store store;
  {
    Goldens goldens(store.golden(), store.folder / "out");
    goldens.check("ui/square", pixels_of(store.then));
    goldens.check("ui/square", pixels_of(square_at(12, 10)));
    goldens.check("new", pixels_of(store.then));
    REQUIRE_FALSE(fs::exists(store.folder / "out/index.html"));
  }
  const Report report = read_report(store.folder / "out");
  REQUIRE(report.entries.size() == 2);
  REQUIRE(report.failed() == 2);
  REQUIRE_THAT(report.entries[0].bless, Contains("PROOFREEL_BLESS=1 ") && Contains("golden_tests"));
  REQUIRE(fs::exists(store.folder / "out/" + report.entries[0].items[0].heat));
  REQUIRE(report.entries[1].items[0].expected.empty());
}

TEST_CASE("Names that lead elsewhere, and pictures without pixels, are refused", "[goldens]") {
  const Store store;
  Goldens goldens(store.golden());
  for (const char* name : {"", "/x", "../x", "a/../x", "x/", "a//b", "x.png", "a b"}) {
    REQUIRE_THROWS_AS(goldens.check(name, pixels_of(store.then)), std::runtime_error);
  }
  const std::uint8_t pixel[4] = {};
  REQUIRE_THROWS_AS(goldens.check("x", {nullptr, 1, 1}), std::runtime_error);
  REQUIRE_THROWS_AS(goldens.check("x", {pixel, 0, 1}), std::runtime_error);
  REQUIRE_THROWS_AS(goldens.check("x", {pixel, 1, -1}), std::runtime_error);
  REQUIRE_THROWS_AS(goldens.check("x", {pixel, 1, 1, 3}), std::runtime_error);
}

}  // namespace
}  // namespace proofreel
