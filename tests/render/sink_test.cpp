#include "render/sink.h"

#include <catch2/catch.hpp>

#include "render/pixel_hash.h"
#include "render/png.h"
#include "scenarios/environment_error.h"
#include "tests/render/scratch_folder.h"
#include "tests/render/test_image.h"

namespace proofreel {
namespace {

using Catch::Matchers::Contains;

FilmSettings settings_for(int width, int height) {
  FilmSettings settings;
  settings.size = {width, height};
  return settings;
}

TEST_CASE("A single PNG keeps the last picture and appears at the end", "[sink]") {
  const ScratchFolder folder;
  const std::unique_ptr<Sink> sink = make_sink(folder / "a.png", settings_for(5, 3));
  sink->frame(noise_image(5, 3, 1, true));
  sink->frame(noise_image(5, 3, 2, true));
  REQUIRE(folder.file_count() == 0);
  sink->finish();
  REQUIRE(read_png(folder / "a.png").rgba == noise_image(5, 3, 2, true).rgba);
}

TEST_CASE("A sequence writes one file per picture, numbered by film frame", "[sink]") {
  const ScratchFolder folder;
  FilmSettings settings = settings_for(5, 3);
  settings.first_frame = 99;
  const std::unique_ptr<Sink> sink = make_sink(folder / "f_%04d.png", settings);
  for (unsigned i = 0; i < 3; ++i) sink->frame(noise_image(5, 3, i, true));
  sink->finish();
  REQUIRE(folder.file_count() == 3);
  REQUIRE(read_png(folder / "f_0099.png").rgba == noise_image(5, 3, 0, true).rgba);
  REQUIRE(read_png(folder / "f_0101.png").rgba == noise_image(5, 3, 2, true).rgba);
}

TEST_CASE("A number may be unpadded, and longer than its padding", "[sink]") {
  const ScratchFolder folder;
  FilmSettings settings = settings_for(1, 1);
  settings.first_frame = 123;
  make_sink(folder / "%d.png", settings)->frame(Image(1, 1));
  make_sink(folder / "x%02d.png", settings)->frame(Image(1, 1));
  REQUIRE_NOTHROW(read_png(folder / "123.png"));
  REQUIRE_NOTHROW(read_png(folder / "x123.png"));
}

TEST_CASE("Any other pattern than one frame number is refused", "[sink]") {
  const ScratchFolder folder;
  for (const char* name : {"%s.png", "%n.png", "%04d_%04d.png", "%%.png", "%4d.png", "%-4d.png", "%04ld.png", "%.png",
                           "%x.png", "%0d.png", "100%.png", "%012d.png", "%1$d.png"}) {
    CAPTURE(name);
    REQUIRE_THROWS_AS(make_sink(folder / name, settings_for(2, 2)), UsageError);
  }
  REQUIRE_THROWS_AS(make_sink(folder / "film_%04d.mp4", settings_for(2, 2)), UsageError);
}

TEST_CASE("A hash file has one line per picture, equal exactly for equal pictures", "[sink]") {
  const ScratchFolder folder;
  FilmSettings settings = settings_for(4, 4);
  settings.first_frame = 7;
  const std::unique_ptr<Sink> sink = make_sink(folder / "a.hash", settings);
  for (const unsigned seed : {1U, 2U, 1U}) sink->frame(noise_image(4, 4, seed, true));
  sink->finish();
  const std::string a = pixel_hash(noise_image(4, 4, 1, true)), b = pixel_hash(noise_image(4, 4, 2, true));
  REQUIRE(a != b);
  REQUIRE(a.size() == 32);
  REQUIRE(read_text(folder / "a.hash") == "7 " + a + "\n8 " + b + "\n9 " + a + "\n");
}

TEST_CASE("Pictures of other shape have other hashes though their bytes are equal", "[sink]") {
  REQUIRE(pixel_hash(Image(2, 8)) != pixel_hash(Image(8, 2)));
}

TEST_CASE("Unknown endings get the list of those that are known", "[sink]") {
  const ScratchFolder folder;
  for (const char* name : {"a.avi", "a", "a.mp4.txt", ".mp4"}) {
    CAPTURE(name);
    REQUIRE_THROWS_WITH(make_sink(folder / name, settings_for(2, 2)), Contains(name) && Contains(".mkv"));
  }
}

TEST_CASE("Sizes nobody can draw are refused", "[sink]") {
  const ScratchFolder folder;
  for (const Size size : {Size{0, 0}, Size{-2, 2}, Size{100000, 100000}, Size{max_image_side_px + 1, 2}}) {
    FilmSettings settings;
    settings.size = size;
    REQUIRE_THROWS_AS(make_sink(folder / "a.png", settings), UsageError);
  }
  REQUIRE_NOTHROW(make_sink(folder / "odd.png", settings_for(1921, 1081)));
}

TEST_CASE("A folder that is not there is found before anything is drawn", "[sink]") {
  const ScratchFolder folder;
  for (const char* name : {"none/a.png", "none/%d.png", "none/a.hash", "none/a.mp4"}) {
    REQUIRE_THROWS_AS(make_sink(folder / name, settings_for(2, 2)), EnvironmentError);
  }
}

TEST_CASE("A name holds one picture exactly when it is a PNG without number", "[sink]") {
  REQUIRE(is_single_picture("out/a.png"));
  REQUIRE_FALSE(is_single_picture("out/a%04d.png"));
  REQUIRE_FALSE(is_single_picture("a.mp4"));
  REQUIRE_FALSE(is_single_picture("-"));
}

}  // namespace
}  // namespace proofreel
