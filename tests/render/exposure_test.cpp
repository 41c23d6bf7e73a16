#include "render/exposure.h"

#include <catch2/catch.hpp>

#include "render/draw.h"
#include "render/usage_error.h"
#include "scenarios/timeline.h"
#include "tests/render/painted.h"
#include "tests/render/sample_frame.h"
#include "tests/render/scratch_folder.h"
#include "tests/render/test_image.h"

using namespace proofreel;
using namespace proofreel::painted;
using Catch::Matchers::Contains;

namespace {

std::unique_ptr<Scenario> loaded(const ScratchFolder& folder, const std::string& text) {
  write_text(folder / "scene.lua", text);
  return load_scenario(folder / "scene.lua", {});
}

std::vector<std::int64_t> exposed(const Scenario& scenario, double degrees) {
  return exposures(scenario, film_timeline(scenario), degrees);
}

Image mean_of(const std::vector<Image>& images) {
  Exposure exposure;
  for (const Image& image : images) exposure.add(image);
  Image mean = Image::uncleared(images[0].width_px, images[0].height_px);
  exposure.develop(mean);
  return mean;
}

bool same(const Image& a, const Image& b) { return a.rgba == b.rgba; }

}  // namespace

TEST_CASE("Pictures that are all alike come out as they went in, whatever their colours and their number") {
  const Image noise = noise_image(64, 64, 5, true);
  for (const std::size_t count : {1U, 2U, 3U, 16U, 255U}) {
    INFO(count);
    CHECK(same(mean_of(std::vector<Image>(count, noise)), noise));
  }
}

TEST_CASE("Half black and half white is the gray that gives off half the light") {
  const Image mean = mean_of({filled_image(2, 2, 0, 0, 0), filled_image(2, 2, 255, 255, 255)});
  CHECK(static_cast<int>(mean.rgba[0]) == 188);  // IEC 61966-2-1: 0.5 -> 0.7354
  CHECK(static_cast<int>(mean.rgba[3]) == 255);
  const Image three =
      mean_of({filled_image(2, 2, 255, 0, 0), filled_image(2, 2, 0, 255, 0), filled_image(2, 2, 0, 0, 255)});
  for (const std::size_t channel : {0U, 1U, 2U}) CHECK(static_cast<int>(three.rgba[channel]) == 156);  // 1/3 -> 0.6124
}

TEST_CASE("The mean does not depend on the order of the pictures, and a second one knows nothing of the first") {
  const Image a = noise_image(16, 16, 1, true), b = noise_image(16, 16, 2, true), c = noise_image(16, 16, 3, true);
  const Image mean = mean_of({a, b, c});
  CHECK(same(mean_of({c, a, b}), mean));
  Exposure exposure;
  Image image = Image::uncleared(16, 16);
  exposure.add(c);
  exposure.develop(image);
  for (const Image& part : {a, b, c}) exposure.add(part);
  exposure.develop(image);
  CHECK(same(image, mean));
}

TEST_CASE("The shutter is open for its part of the way to the next frame, slow motion included") {
  const ScratchFolder folder;
  const auto scenario = loaded(folder, "scenario{duration=0.5, rate=1920}\nslow{from=0.25, to=0.5, factor=0.5}");
  const auto half = exposed(*scenario, 180);
  REQUIRE(half.size() == 15 + 30);
  CHECK(half.front() == 16);
  CHECK(half[14] == 16);
  CHECK(half[15] == 8);
  CHECK(half.back() == 8);
  CHECK(exposed(*scenario, 360).front() == 32);
  CHECK(exposed(*scenario, 90).front() == 8);
}

TEST_CASE("Where the film stands still the shutter sees one moment") {
  const ScratchFolder folder;
  const auto scenario = loaded(folder, "scenario{duration=0.5, rate=480}\nfreeze{at=0.25, seconds=0.1}");
  const auto open = exposed(*scenario, 180);
  REQUIRE(open.size() == 36);
  CHECK(open[14] == 4);
  for (std::size_t i = 15; i < 21; ++i) CHECK(open[i] == 1);
  CHECK(open[21] == 4);  // the last of the frozen frames, from which the film goes on
}

TEST_CASE("Fewer than four ticks are refused with a rate that works, and that one does") {
  const ScratchFolder folder;
  const auto refused = [&](const std::string& keys, double degrees) {
    try {
      exposed(*loaded(folder, "scenario{duration=0.5, " + keys), degrees);
    } catch (const UsageError& error) {
      return std::string(error.what());
    }
    return std::string("nothing");
  };
  CHECK_THAT(refused("rate=240}", 180), Contains("only 2 lie within") && Contains("--set rate=480 works"));
  CHECK(refused("rate=480}", 180) == "nothing");
  CHECK_THAT(refused("rate=60}", 1), Contains("only 1 lies within") && Contains("rate=64860 works"));
  CHECK(refused("rate=64860}", 1) == "nothing");
  CHECK_THAT(refused("rate=480}\nslow{from=0.1, to=0.2, factor=0.25}", 180), Contains("rate=1920 works"));
  CHECK(refused("rate=1920}\nslow{from=0.1, to=0.2, factor=0.25}", 180) == "nothing");
}

TEST_CASE("A picture of the world with what is written on it is the whole picture, in every theme") {
  const Theme theme = GENERATE(Theme::light, Theme::dark, Theme::print);
  Frame frame = sample_frame();
  Canvas canvas(context(), 481, 270);
  Image whole, world, both;
  draw_frame(canvas, frame, {theme}, whole);
  draw_world(canvas, frame, {theme}, world);
  draw_written(canvas, frame, {theme}, world, both);
  CHECK(same(both, whole));
  CHECK_FALSE(same(world, whole));
}

TEST_CASE("A canvas that begins with a picture shows it, and forgets it") {
  const Image noise = noise_image(33, 17, 9, true);
  Canvas canvas(context(), 33, 17);
  Image image;
  canvas.clear(noise);
  canvas.finish(image);
  CHECK(same(image, noise));
  canvas.clear(white);
  canvas.finish(image);
  CHECK(same(image, filled_image(33, 17, 255, 255, 255)));
}

TEST_CASE("The shutter looks at the pane with the fewest ticks, and says whose rate would have to be another") {
  const ScratchFolder folder;
  const auto open = [&](const std::string& slow) {
    const std::string panes = "pane{title='fine', rate=960}\npane{title='coarse'" + slow + "}\n";
    return exposed(*loaded(folder, "scenario{duration=0.5, rate=480}\n" + panes), 180);
  };
  CHECK(open("").front() == 8);
  CHECK_THROWS_WITH(open(", rate=60"), Contains("only 1 lies within") && Contains("rate=420 in pane \"coarse\" works"));
  CHECK_NOTHROW(open(", rate=420"));
}
