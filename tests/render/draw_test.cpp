#include "render/draw.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "render/draw_layers.h"
#include "tests/render/painted.h"
#include "tests/render/sample_frame.h"

using namespace proofreel;
using namespace proofreel::painted;

namespace {

Image drawn(const Frame& frame, Theme theme = Theme::light, int width_px = 480, int height_px = 270) {
  Canvas canvas(context(), width_px, height_px);
  Image image;
  draw_frame(canvas, frame, {theme}, image);
  return image;
}

/// One body of the given shape in the middle of a view 4 m high.
Frame lone_body(const std::vector<std::vector<Vec2d>>& shapes, double radius) {
  Frame frame;
  frame.view = {{0, 0}, 4};
  frame.layers = {Layer::bodies};
  BodyView body;
  body.id = static_cast<BodyId>(1);
  body.shape_count = static_cast<std::uint32_t>(shapes.size());
  for (const std::vector<Vec2d>& points : shapes) {
    frame.snapshot.shapes.push_back(
        {static_cast<std::uint32_t>(frame.snapshot.points.size()), static_cast<std::uint32_t>(points.size()), radius});
    frame.snapshot.points.insert(frame.snapshot.points.end(), points.begin(), points.end());
  }
  frame.snapshot.bodies.push_back(body);
  return frame;
}

Color pixel(const Image& image, int x, int y) {
  const std::size_t at = 4 * static_cast<std::size_t>(y * image.width_px + x);
  return {image.rgba[at], image.rgba[at + 1], image.rgba[at + 2], image.rgba[at + 3]};
}

}  // namespace

TEST_CASE("A frame drawn twice has the same bytes") { CHECK(drawn(sample_frame()).rgba == drawn(sample_frame()).rgba); }

TEST_CASE("Every layer changes the picture") {
  const Image everything = drawn(sample_frame());
  for (const Layer layer : all_layers()) {
    std::vector<Layer> others = all_layers();
    others.erase(std::find(others.begin(), others.end(), layer));
    INFO("layer " << name_of(layer));
    // Islands are bodies of another colour: where they show, bodies add nothing.
    const bool same = drawn(with_layers(sample_frame(), others)).rgba == everything.rgba;
    CHECK(same == (layer == Layer::bodies));
  }
}

TEST_CASE("The order in which layers are asked for does not matter") {
  std::vector<Layer> backwards = all_layers();
  std::reverse(backwards.begin(), backwards.end());
  CHECK(drawn(sample_frame()).rgba == drawn(with_layers(sample_frame(), backwards)).rgba);
}

TEST_CASE("The three themes differ, and print is gray throughout") {
  const Image light = drawn(sample_frame());
  const Image dark = drawn(sample_frame(), Theme::dark);
  Frame colourless = sample_frame();
  const Image print = drawn(colourless, Theme::print);
  CHECK(light.rgba != dark.rgba);
  CHECK(light.rgba != print.rgba);
  for (std::size_t i = 0; i < print.rgba.size(); i += 4) {
    REQUIRE(print.rgba[i] == print.rgba[i + 1]);
    REQUIRE(print.rgba[i] == print.rgba[i + 2]);
  }
}

TEST_CASE("Every pixel of a frame is opaque") {
  const Image image = drawn(sample_frame(), Theme::dark);
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) REQUIRE(image.rgba[i] == 255);
}

TEST_CASE("A frame without anything is the background alone, in any size") {
  const Palette& palette = palette_of(Theme::light);
  for (const int height : {1, 31, 270}) {
    Frame frame;
    const Image image =
        drawn(with_layers(frame, {Layer::bodies, Layer::contacts, Layer::labels}), Theme::light, 2 * height, height);
    CHECK(pixel(image, height, height / 2) == palette.background);
    CHECK(std::count(image.rgba.begin(), image.rgba.end(), palette.background.b) >= 2 * height * height);
  }
}

TEST_CASE("A body is filled by its type or its own colour") {
  const std::vector<Vec2d> box{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  const Palette& palette = palette_of(Theme::light);
  Frame frame = lone_body({box}, 0);
  CHECK(pixel(drawn(frame), 240, 135) == palette.dynamic.fill);
  frame.snapshot.bodies[0].type = BodyType::fixed;
  CHECK(pixel(drawn(frame), 240, 135) == palette.fixed.fill);
  frame.snapshot.bodies[0].type = BodyType::kinematic;
  CHECK(pixel(drawn(frame), 240, 135) == palette.kinematic.fill);
  frame.snapshot.bodies[0].has_color = true;
  frame.snapshot.bodies[0].color = 0x12AB34;
  CHECK(pixel(drawn(frame), 240, 135) == Color{0x12, 0xAB, 0x34, 255});
  const Color awake = pixel(drawn(frame), 240, 135);
  frame.snapshot.bodies[0].asleep = true;
  CHECK(pixel(drawn(frame), 240, 135).r > awake.r);
}

TEST_CASE("Pieces that share edges are outlined as one body") {
  const std::vector<Vec2d> left{{-1, -1}, {0, -1}, {0, 1}, {-1, 1}};
  const std::vector<Vec2d> right{{0, -1}, {1, -1}, {1, 1}, {0, 1}};
  const std::vector<Vec2d> lower_right{{0, -1}, {1, -1}, {1, 0}, {0, 0}};
  const Color fill = palette_of(Theme::light).dynamic.fill;
  const Image halves = drawn(lone_body({left, right}, 0));
  for (int x = 190; x < 290; ++x) REQUIRE(pixel(halves, x, 135) == fill);
  const Image step = drawn(lone_body({left, lower_right}, 0));
  for (int x = 190; x < 290; ++x) REQUIRE(pixel(step, x, 170) == fill);
}

TEST_CASE("Pieces that overlap are outlined as one body") {
  const std::vector<Vec2d> flat{{-1.2, -0.3}, {1.2, -0.3}, {1.2, 0.3}, {-1.2, 0.3}};
  const std::vector<Vec2d> upright{{-0.3, -1.2}, {0.3, -1.2}, {0.3, 1.2}, {-0.3, 1.2}};
  const Image image = drawn(lone_body({flat, upright}, 0));
  for (int x = 170; x < 310; ++x) REQUIRE(pixel(image, x, 135) == palette_of(Theme::light).dynamic.fill);
}

TEST_CASE("The camera puts its centre in the middle, y up, and metres to scale") {
  const Camera camera({{3, -2}, 9}, 1280, 720);
  CHECK(camera.to_px({3, -2}) == Vec2d{640, 360});
  CHECK(camera.to_px({4, -1}) == Vec2d{720, 280});
  CHECK(camera.px(2) == 160);
  const Vec2d back = camera.to_world(camera.to_px({1.25, 7.5}));
  CHECK(distance(back, {1.25, 7.5}) < 1e-12);
}

TEST_CASE("Cards keep the margin and never cover one another while there is room") {
  const Aabbd safe{{29, 29}, {1251, 691}};
  Cards cards(safe);
  std::vector<Aabbd> placed;
  for (const Corner at : {Corner::top_right, Corner::top_right, Corner::top_right, Corner::top, Corner::bottom,
                          Corner::bottom, Corner::bottom_left, Corner::top_left, Corner::bottom_right}) {
    placed.push_back(cards.place({at == Corner::bottom ? 400.0 : 300.0, 150}, at));
  }
  for (std::size_t i = 0; i < placed.size(); ++i) {
    CHECK(contains(expanded(safe, 1.0), placed[i]));
    for (std::size_t k = 0; k < i; ++k) CHECK_FALSE(overlaps(placed[i], placed[k]));
  }
}

TEST_CASE("Labels of crowded bodies neither cover each other nor leave the margin") {
  Frame frame;
  frame.view = {{0, 0}, 8};
  for (int i = 0; i < 12; ++i) frame.labels.push_back({{-6.9 + 0.2 * i, 3.8}, 0.1, "body " + std::to_string(i)});
  frame.layers = {Layer::labels};
  const Image image = drawn(frame, Theme::light, 1280, 720);
  const Color background = palette_of(Theme::light).background;
  int inked = 0;
  for (int y = 0; y < 720; ++y) {
    for (int x = 0; x < 1280; ++x) {
      if (pixel(image, x, y) == background) continue;
      ++inked;
      REQUIRE(x >= 28);
      REQUIRE(y >= 28);
    }
  }
  CHECK(inked > 1000);
}

TEST_CASE("Curves of a plot survive values that are not finite and times without samples") {
  Frame frame = sample_frame();
  frame.plots[0].values[0][10] = std::numeric_limits<double>::quiet_NaN();
  frame.plots[0].values[1][20] = std::numeric_limits<double>::infinity();
  frame.plots[1].times.clear();
  frame.plots[1].values = {{}, {}};
  CHECK_NOTHROW(drawn(frame));
}

TEST_CASE("Water is drawn from its level down, behind the bodies, in every theme") {
  const Theme theme = GENERATE(Theme::light, Theme::dark, Theme::print);
  Frame frame = lone_body({{{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}}, 0);
  const Image dry = drawn(frame, theme);
  frame.snapshot.water_level = 1;
  const Image wet = drawn(frame, theme);
  CHECK(pixel(wet, 40, 20) == pixel(dry, 40, 20));          // 1.7 m up: air
  CHECK_FALSE(pixel(wet, 40, 200) == pixel(dry, 40, 200));  // 1 m down
  CHECK(pixel(wet, 240, 135) == pixel(dry, 240, 135));      // the body in the middle
}

TEST_CASE("Water above or below the picture fills it or leaves it alone") {
  Frame frame = lone_body({{{0, 0}}}, 0.1);
  const Image dry = drawn(frame);
  frame.snapshot.water_level = -100;
  CHECK(drawn(frame).rgba == dry.rgba);
  frame.snapshot.water_level = 100;
  const Image flooded = drawn(frame);
  CHECK_FALSE(pixel(flooded, 0, 0) == pixel(dry, 0, 0));
  CHECK(pixel(flooded, 0, 0) == pixel(flooded, 479, 269));
}
