#include <catch2/catch.hpp>
#include <tuple>

#include "golden/json.h"
#include "render/png.h"
#include "render/sink.h"
#include "tests/cli/collection.h"
#include "tests/render/scratch_folder.h"
#include "tests/render/test_image.h"

namespace proofreel {
namespace {

using Catch::Matchers::Contains;

/// Some pictures in a folder, and diff called in it.
class PictureFolder {
 public:
  PictureFolder() {
    write_png(folder_ / "a.png", base());
    write_png(folder_ / "same.png", base());
    write_png(folder_ / "spot.png", spotted(7));
    write_png(folder_ / "tint.png", filled_image(160, 90, 200, 200, 192));
    write_png(folder_ / "small.png", filled_image(80, 90, 200, 200, 200));
  }
  static Image base() { return filled_image(160, 90, 200, 200, 200); }
  /// The base with a dark block of 3 x 3 pixels, the further right the larger `x`.
  static Image spotted(int x) {
    Image image = base();
    for (int y = 40; y < 43; ++y) std::fill_n(image.row(y) + 4 * x, 12, std::uint8_t{40});
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) image.rgba[i] = 255;
    return image;
  }
  Outcome diff(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "diff");
    return proofreel_program(arguments, folder_.path().string());
  }
  Json json(std::vector<std::string> arguments) const {
    arguments.push_back("--json");
    return Json::parse(diff(arguments).out);
  }
  std::string operator/(const std::string& name) const { return folder_ / name; }
  const ScratchFolder& folder() const { return folder_; }

 private:
  ScratchFolder folder_;
};

/// A film of `frames` in which the block shows from frame `from` on.
void write_clip(const std::string& path, int frames, int from) {
  FilmSettings settings;
  settings.size = {160, 90};
  settings.fps = 25;
  settings.quality = Quality::lossless;
  const std::unique_ptr<Sink> sink = make_sink(path, settings);
  for (int i = 0; i < frames; ++i) sink->frame(i < from ? PictureFolder::base() : PictureFolder::spotted(i));
  sink->finish();
}

TEST_CASE("diff says 0 for equal pictures and 1 for different ones, with figures", "[cli]") {
  const PictureFolder p;
  const Outcome same = p.diff({"a.png", "same.png"});
  REQUIRE(same.status == 0);
  REQUIRE_THAT(same.out, Contains("equal: 0 of 14400 pixels differ"));
  const Outcome spot = p.diff({"a.png", "spot.png"});
  REQUIRE(spot.status == 1);
  REQUIRE_THAT(spot.out, Contains("different: 9 of 14400 pixels differ") && Contains("up to 160 of 255"));
  REQUIRE(p.diff({"a.png", "same.png", "--quiet"}).out.empty());
}

TEST_CASE("diff --json has the documented keys, equal or not", "[cli]") {
  const PictureFolder p;
  const Json json = p.json({"a.png", "spot.png"});
  REQUIRE(json.at("verdict") == "different");
  REQUIRE(json.at("different") == 9);
  REQUIRE(json.at("antialiased") == 0);
  REQUIRE(json.at("total") == 14400);
  REQUIRE(json.at("max_channel") == 160);
  REQUIRE(json.at("mean_bias").at(1).get<double>() == Approx(-160.0 * 9 / 14400));
  REQUIRE(json.at("densest").at("different") == 9);
  REQUIRE(p.json({"a.png", "same.png"}).at("verdict") == "equal");
  REQUIRE(p.json({"a.png", "small.png"}).at("verdict") == "size");
  REQUIRE_THAT(p.diff({"a.png", "small.png"}).out, Contains("160x90 is expected, 80x90 is there"));
  REQUIRE(p.diff({"a.png", "small.png"}).status == 1);
}

TEST_CASE("diff finds a tint that no single pixel shows, and can be told to let it pass", "[cli]") {
  const PictureFolder p;
  const Json json = p.json({"a.png", "tint.png"});
  REQUIRE(json.at("verdict") == "different");
  REQUIRE(json.at("different") == 0);
  REQUIRE(json.at("mean_bias").at(2) == -8);
  REQUIRE_THAT(json.at("reason").get<std::string>(), Contains("blue"));
  REQUIRE(p.diff({"a.png", "tint.png", "--max-bias", "8"}).status == 0);
  REQUIRE(p.json({"a.png", "tint.png", "--threshold", "0.001"}).at("different") == 14400);
}

TEST_CASE("diff ignores rectangles and what a mask leaves out", "[cli]") {
  const PictureFolder p;
  REQUIRE(p.diff({"a.png", "spot.png", "--ignore", "0,0,160,40", "--ignore", "7,40,3,3"}).status == 0);
  REQUIRE(p.json({"a.png", "spot.png", "--ignore", "7,40,1,50"}).at("different") == 6);
  Image mask = filled_image(160, 90, 255, 255, 255);
  std::fill_n(mask.row(41), mask.row_bytes(), std::uint8_t{0});
  write_png(p / "mask.png", mask);
  REQUIRE(p.json({"a.png", "spot.png", "--mask", "mask.png"}).at("different") == 6);
  REQUIRE(p.diff({"a.png", "spot.png", "--mask", "small.png"}).status == 2);
}

TEST_CASE("diff lets as many pixels pass as it is told, and so many in one window", "[cli]") {
  const PictureFolder p;
  REQUIRE(p.diff({"a.png", "spot.png", "--max-different", "9"}).status == 0);
  REQUIRE(p.diff({"a.png", "spot.png", "--max-different", "8"}).status == 1);
  REQUIRE(p.diff({"a.png", "spot.png", "--max-different", "9", "--max-window", "8"}).status == 1);
  REQUIRE(p.diff({"a.png", "spot.png", "--max-different", "9", "--max-window", "8", "--window", "2"}).status == 0);
  REQUIRE(p.json({"spot.png", "a.png", "--shift", "3"}).at("different") == 9);
}

TEST_CASE("diff -o draws the difference in every style", "[cli]") {
  const PictureFolder p;
  REQUIRE(p.diff({"a.png", "spot.png", "-o", "side.png"}).status == 1);
  REQUIRE(read_png(p / "side.png").width_px == 3 * 160 + 8);
  for (const char* style : {"overlay", "heat", "mask"}) {
    REQUIRE(p.diff({"a.png", "spot.png", "-o", "d.png", "--style", style}).status == 1);
    REQUIRE(read_png(p / "d.png").width_px == 160);
  }
  REQUIRE(p.diff({"a.png", "small.png", "-o", "sizes.png", "--style", "mask"}).status == 1);
  REQUIRE(read_png(p / "sizes.png").width_px == 160 + 4 + 80);
}

TEST_CASE("diff says 2, and why, for what it cannot use", "[cli]") {
  const PictureFolder p;
  write_text(p / "damaged.png", read_text(p / "a.png").substr(0, 100));
  write_text(p / "text.png", "not a picture");
  write_text(p / "folder/a.png", "x");
  const auto refused = [&p](const std::vector<std::string>& arguments, const std::string& why) {
    const Outcome o = p.diff(arguments);
    CAPTURE(o.err);
    return o.status == 2 && o.err.find(why) != std::string::npos && o.out.empty();
  };
  REQUIRE(refused({"a.png", "none.png"}, "none.png"));
  REQUIRE(refused({"damaged.png", "a.png"}, "damaged.png"));
  REQUIRE(refused({"a.png", "text.png", "--json"}, "text.png is not a PNG"));
  REQUIRE(refused({"a.png", "folder"}, "not of one kind"));
  REQUIRE(refused({"a.png", "film.mp4"}, "not of one kind"));
  REQUIRE(refused({"a.png", "spot.png", "-o", "d.jpg"}, ".png"));
  REQUIRE(refused({"a.png", "spot.png", "--style", "loud"}, "loud"));
  REQUIRE(refused({"a.png", "spot.png", "--ignore", "1,2,3"}, "--ignore"));
  REQUIRE(refused({"a.png", "spot.png", "--ignore", "1,2,0,5"}, "--ignore"));
  REQUIRE(refused({"a.png", "spot.png", "--threshold", "nan"}, "threshold"));
  REQUIRE(p.diff({"a.png", "spot.png", "--threshold", "1.5"}).status == 2);
  REQUIRE(p.diff({"a.png"}).status == 2);
  REQUIRE(p.diff({"a.png", "spot.png", "-o", "no/folder/d.png"}).status == 3);
}

TEST_CASE("diff of folders names what was added, removed and changed", "[cli]") {
  const PictureFolder p;
  for (const char* name : {"then/same.png", "now/same.png", "then/sub/spot.png", "then/gone.png"}) {
    std::filesystem::create_directories(std::filesystem::path(p / name).parent_path());
    write_png(p / name, PictureFolder::base());
  }
  std::filesystem::create_directories(p / "now/sub");
  write_png(p / "now/sub/spot.png", PictureFolder::spotted(3));
  write_png(p / "now/new.png", PictureFolder::base());
  const Outcome text = p.diff({"then", "now", "-o", "out"});
  REQUIRE(text.status == 1);
  REQUIRE_THAT(text.out,
               Contains("changed  sub/spot.png") && Contains("removed  gone.png") && Contains("added    new.png"));
  REQUIRE_THAT(text.out, Contains("1 equal, 1 changed, 1 removed, 1 added"));
  REQUIRE(read_png(p / "out/sub/spot.png").width_px == 3 * 160 + 8);
  REQUIRE_FALSE(std::filesystem::exists(p / "out/same.png"));
  const Json json = p.json({"then", "now"});
  REQUIRE(json.at("verdict") == "different");
  REQUIRE(json.at("different") == 9);
  REQUIRE(json.at("changed").at(0).at("name") == "sub/spot.png");
  REQUIRE(json.at("changed").at(0).at("different") == 9);
  REQUIRE(json.at("added") == Json::array({"new.png"}));
  REQUIRE(json.at("removed") == Json::array({"gone.png"}));
  REQUIRE(json.at("equal") == 1);
  REQUIRE(p.diff({"then", "then"}).status == 0);
}

TEST_CASE("A damaged picture in a folder is named, and the others are compared all the same", "[cli]") {
  const PictureFolder p;
  for (const char* name : {"then/a.png", "then/b.png", "now/a.png"}) {
    std::filesystem::create_directories(std::filesystem::path(p / name).parent_path());
    write_png(p / name, PictureFolder::base());
  }
  write_text(p / "now/b.png", "no picture");
  const Outcome o = p.diff({"then", "now", "--json"});
  REQUIRE(o.status == 2);
  REQUIRE(Json::parse(o.out).at("equal") == 1);
  REQUIRE(Json::parse(o.out).at("errors").size() == 1);
  REQUIRE_THAT(o.err, Contains("b.png is not a PNG"));
}

TEST_CASE("diff of clips finds the first frame that differs, and draws a film of it", "[cli]") {
  const PictureFolder p;
  write_clip(p / "then.mkv", 12, 100);
  write_clip(p / "now.mkv", 12, 5);
  const Outcome o = p.diff({"then.mkv", "now.mkv", "-o", "d.mkv"});
  REQUIRE(o.status == 1);
  REQUIRE_THAT(o.out, Contains("different from frame 5 on") && Contains("7 of 12 frames"));
  const Json json = p.json({"then.mkv", "now.mkv"});
  REQUIRE(json.at("first_different") == 5);
  REQUIRE(json.at("frames").size() == 12);
  REQUIRE(json.at("frames").at(4).at("different") == 0);
  REQUIRE(json.at("frames").at(5).at("different") == 9);
  REQUIRE(json.at("different") == 63);
  REQUIRE(p.json({"now.mkv", "d.mkv"}).at("verdict") == "size");  // three panels
  REQUIRE(p.json({"d.mkv", "d.mkv"}).at("frames").size() == 12);
  REQUIRE(p.diff({"then.mkv", "now.mkv", "-o", "first.png"}).status == 1);
  REQUIRE(read_png(p / "first.png").width_px == 3 * 160 + 8);
}

TEST_CASE("diff of equal clips is 0, of clips of other length 1", "[cli]") {
  const PictureFolder p;
  write_clip(p / "a.mkv", 6, 3);
  write_clip(p / "long.mkv", 9, 3);
  REQUIRE(p.diff({"a.mkv", "a.mkv"}).status == 0);
  REQUIRE(p.json({"a.mkv", "a.mkv"}).at("first_different") == nullptr);
  const Json json = p.json({"a.mkv", "long.mkv"});
  REQUIRE(json.at("verdict") == "different");
  REQUIRE(json.at("first_different") == 6);
  REQUIRE((json.at("expected_frames") == 6 && json.at("actual_frames") == 9));
}

TEST_CASE("A frame of another size is a difference, of which only single pictures are drawn", "[cli]") {
  const PictureFolder p;
  write_clip(p / "a.mkv", 4, 4);
  std::filesystem::create_directories(p / "frames");
  for (int i = 0; i < 4; ++i) {
    write_png(p / ("frames/f" + std::to_string(i) + ".png"), i == 2 ? Image(50, 200) : PictureFolder::base());
  }
  const Json json = p.json({"a.mkv", "frames"});
  REQUIRE(json.at("verdict") == "size");
  REQUIRE(json.at("first_different") == 2);
  REQUIRE(json.at("frames").at(3).at("verdict") == "equal");
  REQUIRE(p.diff({"a.mkv", "frames", "-o", "d.png"}).status == 1);
  REQUIRE(p.diff({"a.mkv", "frames", "-o", "d.mkv"}).status == 2);
  REQUIRE_FALSE(std::filesystem::exists(p / "d.mkv"));
}

TEST_CASE("A clip is compared with a folder of its frames", "[cli]") {
  const PictureFolder p;
  write_clip(p / "a.mkv", 11, 2);
  std::filesystem::create_directories(p / "frames");
  for (int i = 0; i < 11; ++i) {
    write_png(p / ("frames/f" + std::to_string(i) + ".png"), i < 2 ? PictureFolder::base() : PictureFolder::spotted(i));
  }
  REQUIRE(p.diff({"a.mkv", "frames"}).status == 0);
  REQUIRE(p.diff({"frames", "a.mkv"}).status == 0);
  write_png(p / "frames/f10.png", PictureFolder::base());
  REQUIRE(p.json({"frames", "a.mkv"}).at("first_different") == 10);
}

TEST_CASE("A number of pixels that makes no sense is refused with the numbers that do", "[cli]") {
  const Collection c;
  const std::string sentence = "it is a whole number from 0 on, so not ";
  require_refused(c, {"diff", "a.png", "b.png"},
                  {{{"--max-different", "-1"}, "--max-different: " + sentence + "-1"},
                   {{"--max-window", "0.5"}, "--max-window: " + sentence + "0.5"},
                   {{"--max-window", "many"}, sentence + "many"}});
}

TEST_CASE("Smoothed edges count as different only with --include-aa", "[cli]") {
  const ScratchFolder folder;
  const auto edge = [](std::uint8_t gray) {
    Image image = filled_image(20, 20, 0, 0, 0);
    for (int y = 0; y < 20; ++y) {
      std::fill_n(image.row(y) + 4 * 10, 4 * 10, std::uint8_t{255});
      std::fill_n(image.row(y) + 4 * 9, 3, gray);
    }
    return image;
  };
  write_png(folder / "a.png", edge(90));
  write_png(folder / "b.png", edge(190));
  const auto counts = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"diff", "a.png", "b.png", "--max-bias", "255", "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome o = proofreel_program(arguments, folder.path().string());
    const Json json = Json::parse(o.out);
    return std::tuple(o.status, json.at("different").get<int>(), json.at("antialiased").get<int>());
  };
  REQUIRE(counts({}) == std::tuple(0, 0, 20));
  REQUIRE(counts({"--include-aa"}) == std::tuple(1, 20, 0));
}

}  // namespace
}  // namespace proofreel
