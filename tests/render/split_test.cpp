// Areas of a canvas, and the split screens drawn in them.

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "render/draw_layers.h"
#include "render/owners.h"
#include "tests/render/painted.h"
#include "tests/render/sample_frame.h"

using namespace proofreel;
using namespace proofreel::painted;

namespace {

constexpr PixelRect area{101, 57, 320, 180};

bool is_inside(int x, int y) {
  return x >= area.x_px && x < area.x_px + area.width_px && y >= area.y_px && y < area.y_px + area.height_px;
}

/// A frame of so many panes, all of which show the same.
Frame split(int panes) {
  Frame pane = sample_frame();
  pane.pane_title = "pane";
  Frame whole = pane;
  pane.captions.clear();
  whole.bands = {true, true};
  for (int i = 1; i < panes; ++i) whole.other_panes.push_back(pane);
  return whole;
}

Image drawn(const Frame& frame, int width_px, int height_px) {
  Canvas canvas(context(), width_px, height_px);
  Image image;
  draw_frame(canvas, frame, {Theme::light}, image);
  return image;
}

}  // namespace

TEST_CASE("What is drawn in an area is what a picture of its size holds, and nothing lies outside") {
  const Frame frame = sample_frame();
  const auto draw = [&frame](Canvas& canvas) { draw_layers(canvas, frame, {Theme::light}, nullptr); };
  const Image alone = picture(area.width_px, area.height_px, draw);
  const Image whole = picture(640, 360, [&](Canvas& canvas) {
    canvas.enter(area);
    CHECK(canvas.width_px() == area.width_px);
    CHECK(canvas.height_px() == area.height_px);
    draw(canvas);
    canvas.leave();
    CHECK(canvas.width_px() == 640);
  });
  int largest = 0;
  bool clean = true;
  for (int y = 0; y < 360; ++y) {
    for (int x = 0; x < 640; ++x) {
      const std::uint8_t* pixel = whole.row(y) + 4 * x;
      if (!is_inside(x, y)) {
        clean = clean && pixel[0] == 255 && pixel[1] == 255 && pixel[2] == 255;
        continue;
      }
      const std::uint8_t* same = alone.row(y - area.y_px) + 4 * (x - area.x_px);
      for (int c = 0; c < 3; ++c) largest = std::max(largest, std::abs(pixel[c] - same[c]));
    }
  }
  CHECK(clean);
  CHECK(largest <= 2);  // coordinates differ by the corner's, and so does their rounding
}

TEST_CASE("Shapes and letters larger than an area end exactly at its edges") {
  const Image image = picture(200, 100, [](Canvas& canvas) {
    canvas.enter({50, 20, 60, 40});
    canvas.disc({30, 20}, 500, solid);
    canvas.line({-100, 5}, {300, 35}, 9, black);
    canvas.text("WWWWWWWWWWWWWWWW", {-20, 35}, 40, Align::left, black);
  });
  CHECK(ink(image) == Approx(60 * 40));
}

TEST_CASE("Split screens of 2 to 9 panes leave their margin free, upright or not") {
  for (int panes = 2; panes <= 9; ++panes) {
    for (const auto& [width, height] : {std::pair{640, 360}, {360, 640}, {400, 400}}) {
      const Image image = drawn(split(panes), width, height);
      const Color background = palette_of(Theme::light).background;
      bool free = true;
      for (int x = 0; x < width; ++x) {
        for (const int y : {0, 5, height - 6, height - 1}) {
          const std::uint8_t* pixel = image.row(y) + 4 * x;
          free = free && Color{pixel[0], pixel[1], pixel[2], pixel[3]} == background;
        }
      }
      INFO(panes << " panes in " << width << " x " << height);
      CHECK(free);
    }
  }
}

TEST_CASE("Whose a pixel is tells the panes apart") {
  Canvas canvas(context(), 640, 360);
  const OwnerPicture picture = draw_owners(canvas, split(3), {Theme::light});
  for (const std::uint32_t pane : {0U, 1U, 2U}) {
    const auto of_pane = [pane](const Owner& owner) {
      return owner.kind == OwnerKind::body && owner.a / pane_stride == pane;
    };
    CHECK(std::count_if(picture.owners.begin(), picture.owners.end(), of_pane) > 3);
  }
}

TEST_CASE("Captions of a split screen stay on their band, in smaller letters where need be, or are refused") {
  Canvas canvas(context(), 360, 640);
  const auto owners_with = [&](std::size_t words, Corner at) {
    Frame frame = split(9);
    frame.captions.clear();
    if (words == 0) return draw_owners(canvas, frame, {Theme::light});
    std::string text;
    for (std::size_t i = 0; i < words; ++i) text += "momentum ";
    frame.captions = {{text, at, "ball.lua: line 7: "}};
    return draw_owners(canvas, frame, {Theme::light});
  };
  for (const Corner at : {Corner::bottom, Corner::top}) {
    const OwnerPicture picture = owners_with(9, at);
    const OwnerPicture without = owners_with(0, at);
    std::size_t covered = 0, own = 0;
    for (std::size_t i = 0; i < picture.indices.size(); ++i) {
      const bool caption = picture.owners[picture.indices[i]].kind == OwnerKind::caption;
      own += caption ? 1 : 0;
      covered += caption && without.owners[without.indices[i]].kind != OwnerKind::nothing ? 1 : 0;
    }
    CHECK(own > 500);
    CHECK(covered == 0);
    CHECK_THROWS_WITH(owners_with(30, at), Catch::StartsWith("ball.lua: line 7: the text of this caption"));
  }
}

TEST_CASE("Two captions of one place are both shown on their band, or the second is refused") {
  Canvas canvas(context(), 1280, 720);
  Frame frame = split(2);
  frame.captions = {{"one line", Corner::bottom, ""}, {"another", Corner::bottom, "ball.lua: line 9: "}};
  CHECK_NOTHROW(draw_owners(canvas, frame, {Theme::light}));
  std::string text;
  for (int i = 0; i < 40; ++i) text += "momentum ";
  frame.captions[1].text = text;
  CHECK_THROWS_WITH(draw_owners(canvas, frame, {Theme::light}), Catch::StartsWith("ball.lua: line 9: the text"));
}

TEST_CASE(
    "A plot takes no more of its pane than leaves room for the action, and none where there is room for one only") {
  Frame frame = split(4);
  const OwnerPicture picture = [&] {
    Canvas canvas(context(), 640, 480);
    return draw_owners(canvas, frame, {Theme::light});
  }();
  int widest = 0;
  for (int y = 0; y < 480; ++y) {
    int plot = 0;
    for (int x = 0; x < 320; ++x) {
      const auto owner = picture.indices[static_cast<std::size_t>(y) * 640 + static_cast<std::size_t>(x)];
      plot += picture.owners[owner].kind == OwnerKind::plot ? 1 : 0;
    }
    widest = std::max(widest, plot);
  }
  CHECK(widest > 100);
  CHECK(widest <= 0.58 * 320);
  Canvas small(context(), 320, 180);
  const OwnerPicture crowded = draw_owners(small, split(9), {Theme::light});
  CHECK(std::none_of(crowded.owners.begin(), crowded.owners.end(),
                     [](const Owner& owner) { return owner.kind == OwnerKind::plot; }));
}

TEST_CASE("A pane shows in upright pictures what it shows in one of the film's own proportions") {
  Frame frame = split(4);
  frame.captions.clear();
  for (Frame& pane : frame.other_panes) pane.plots.clear();
  frame.plots.clear();
  frame.view.made_for = {1280, 720};
  for (Frame& pane : frame.other_panes) pane.view.made_for = {1280, 720};
  const auto seen = [&](int width_px, int height_px) {
    Canvas canvas(context(), width_px, height_px);
    const OwnerPicture picture = draw_owners(canvas, frame, {Theme::light});
    std::set<std::uint32_t> bodies;
    for (const std::uint32_t index : picture.indices) {
      const Owner& owner = picture.owners[index];
      if (owner.kind == OwnerKind::body) bodies.insert(owner.a);
    }
    return bodies;
  };
  const auto wide = seen(1280, 720), upright = seen(720, 1280);
  CHECK(std::includes(upright.begin(), upright.end(), wide.begin(), wide.end()));
}

TEST_CASE("The title of a pane ends where its pane does") {
  Frame frame = split(2);
  frame.other_panes[0].pane_title.clear();
  frame.pane_title = std::string(300, 'w');
  const Image with = drawn(frame, 640, 360);
  frame.pane_title.clear();
  const Image without = drawn(frame, 640, 360);
  int last = -1;
  for (int y = 0; y < 360; ++y) {
    for (int x = 0; x < 640; ++x) {
      if (red(with, x, y) != red(without, x, y)) last = std::max(last, x);
    }
  }
  CHECK(last > 250);
  CHECK(last < 320);
}
