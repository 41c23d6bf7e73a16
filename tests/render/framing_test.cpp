#include "render/framing.h"

#include <catch2/catch.hpp>

#include "render/draw.h"
#include "render/draw_layers.h"
#include "tests/render/painted.h"
#include "tests/render/sample_frame.h"

using namespace proofreel;
using namespace proofreel::painted;

namespace {

constexpr Size wide{1280, 720};

View view_made_for(Size size) { return {{3, -2}, 9, size}; }

/// A frame with that many plots at the top and at the bottom, of a view made for 16:9.
Frame with_plots(std::size_t above, std::size_t below) {
  Frame frame = sample_frame();
  frame.view.made_for = wide;
  const PlotView plot = frame.plots[0];
  frame.plots.assign(above, plot);
  frame.plots.resize(above + below, plot);
  for (std::size_t i = 0; i < frame.plots.size(); ++i)
    frame.plots[i].at = i < above ? Corner::top_right : Corner::bottom_left;
  return frame;
}

/// What of the picture the scenario's own picture shows.
Aabbd action_of(const Camera& camera, const View& view) {
  const Vec2d half{0.5 * view.height * view.made_for.width_px / view.made_for.height_px, 0.5 * view.height};
  const Vec2d a = camera.to_px({view.center.x - half.x, view.center.y + half.y});
  const Vec2d b = camera.to_px({view.center.x + half.x, view.center.y - half.y});
  return {a, b};
}

struct Framed {
  Framing framing;
  Aabbd action;
  Aabbd picture;
};

Framed framed(const Frame& frame, int width_px, int height_px) {
  Canvas canvas(context(), width_px, height_px);
  const Framing framing = framing_of(canvas, frame, sizes_of(width_px, height_px));
  return {framing, action_of(framing.camera, frame.view),
          Aabbd{{0, 0}, {static_cast<double>(width_px), static_cast<double>(height_px)}}};
}

}  // namespace

TEST_CASE("What the scenario's own picture shows is wholly in a picture of any proportions, as large as can be") {
  const View view = view_made_for(wide);
  for (const Size size : {Size{1080, 1920}, {1080, 1080}, {1440, 1080}, {1920, 1080}, {2560, 1080}, {31, 300}}) {
    const Aabbd action = action_of(Camera(view, size.width_px, size.height_px), view);
    INFO(size.width_px << "x" << size.height_px);
    CHECK(action.lower.x >= -1e-9);
    CHECK(action.lower.y >= -1e-9);
    CHECK(action.upper.x <= size.width_px + 1e-9);
    CHECK(action.upper.y <= size.height_px + 1e-9);
    const double gap = std::min(action.lower.x, action.lower.y);
    CHECK(gap == Approx(0).margin(1e-9));
  }
}

TEST_CASE("Of the same proportions, or wider, a picture shows the same height as ever, to the last bit") {
  const View made = view_made_for(wide);
  const View of_any = view_made_for({});
  for (const Size size : {Size{480, 270}, {640, 360}, {960, 540}, {1920, 1080}, {3840, 2160}, {2560, 1080}}) {
    const Camera a(made, size.width_px, size.height_px), b(of_any, size.width_px, size.height_px);
    CHECK(a.px(1) == b.px(1));
    CHECK(a.to_px({0.3, 0.7}) == b.to_px({0.3, 0.7}));
    CHECK(a.px(1) == size.height_px / 9.0);
  }
}

TEST_CASE("Letters follow the height of wide pictures and the area of narrow ones") {
  for (const Size size : {Size{480, 270}, {640, 360}, {1280, 720}, {1920, 1080}, {3840, 2160}, {2560, 1080}}) {
    CHECK(sizes_of(size.width_px, size.height_px).unit == size.height_px / 720.0);
    CHECK(sizes_of(size.width_px, size.height_px).title == std::max(9, (size.height_px + 9) / 18));
  }
  CHECK(sizes_of(1080, 1920).text == sizes_of(1920, 1080).text);
  CHECK(sizes_of(1080, 1080).text < sizes_of(1920, 1080).text);
  CHECK(sizes_of(100, 4000).unit == 100 / 720.0);
}

TEST_CASE("In upright and square pictures plots lie beside each other's edges, not over the action nor each other") {
  const auto [above, below] = GENERATE(table<std::size_t, std::size_t>({{1, 0}, {0, 1}, {1, 1}, {2, 0}, {2, 1}}));
  for (const Size size : {Size{1080, 1920}, {1080, 1080}, {720, 1280}, {540, 960}}) {
    const Framed f = framed(with_plots(above, below), size.width_px, size.height_px);
    INFO(above << " above, " << below << " below, " << size.width_px << "x" << size.height_px);
    REQUIRE(f.framing.plots.size() == above + below);
    for (std::size_t i = 0; i < f.framing.plots.size(); ++i) {
      const Aabbd& plot = f.framing.plots[i];
      CHECK(contains(f.picture, plot));
      CHECK(plot.upper.y - plot.lower.y > 100 * size.width_px / 1080.0);
      CHECK((i < above ? plot.upper.y <= f.action.lower.y + 1 : plot.lower.y >= f.action.upper.y - 1));
      for (std::size_t k = 0; k < i; ++k) CHECK_FALSE(overlaps(plot, f.framing.plots[k]));
    }
    CHECK(contains(expanded(f.picture, 1.0), f.action));
  }
}

TEST_CASE("A plot alone is as wide as an upright picture") {
  const Framed f = framed(with_plots(1, 0), 1080, 1920);
  CHECK(f.framing.plots[0].upper.x - f.framing.plots[0].lower.x > 0.9 * 1080);
}

TEST_CASE("However many plots there are, half of the action's size is left") {
  const Framed alone = framed(with_plots(0, 0), 1080, 1080);
  const Framed crowded = framed(with_plots(12, 12), 1080, 1080);
  CHECK(crowded.action.upper.x - crowded.action.lower.x >= 0.5 * (alone.action.upper.x - alone.action.lower.x) - 1e-6);
}

TEST_CASE("In wide pictures plots stay in their corners") {
  CHECK(framed(with_plots(2, 1), 1920, 1080).framing.plots.empty());
  CHECK(framed(with_plots(2, 1), 1440, 1080).framing.plots.empty());
}

TEST_CASE("An upright view that was made so is left alone") {
  Frame frame = with_plots(1, 0);
  frame.view.made_for = {1080, 1920};
  CHECK(framed(frame, 1080, 1920).framing.plots.empty());
}

TEST_CASE("A caption is wrapped, then made smaller, and then refused at its place in the file") {
  Canvas canvas(context(), 640, 360);
  const auto caption = [](std::size_t words) {
    std::string text;
    for (std::size_t i = 0; i < words; ++i) text += "momentum ";
    return CaptionView{text, Corner::bottom, "ball.lua: line 7: "};
  };
  for (const std::size_t words : {1U, 8U, 30U, 38U}) CHECK_NOTHROW(require_room(canvas, {caption(words)}));
  CHECK_THROWS_WITH(require_room(canvas, {caption(3), caption(100)}),
                    Catch::StartsWith("ball.lua: line 7: the text of this caption does not fit") &&
                        Catch::Contains("640x360") && Catch::Contains("follow each other"));
  const CaptionView endless{std::string(200, 'w'), Corner::top, "ball.lua: line 9: "};
  CHECK_THROWS_WITH(require_room(canvas, {endless}), Catch::StartsWith("ball.lua: line 9: "));
}

TEST_CASE("In print the curves of a plot differ by their dashes, not by their grays alone") {
  Frame frame = with_plots(1, 0);
  frame.layers = {};
  frame.captions.clear();
  frame.plots[0].curves = {"a", "b"};
  frame.plots[0].values = {std::vector<double>(240, 1.4), std::vector<double>(240, 2)};
  frame.plots[0].values[0][0] = 1;
  Canvas canvas(context(), 1280, 720);
  Image image;
  draw_frame(canvas, frame, {Theme::print}, image);
  // Dark runs along the longest rows: the solid curve is one, the dashed one many.
  int unbroken = 0, dashed = 0;
  for (int y = 0; y < image.height_px; ++y) {
    int runs = 0, dark = 0;
    for (int x = 960; x < 1200; ++x) {
      const bool is_dark = red(image, x, y) < 0x80;
      runs += is_dark && red(image, x - 1, y) >= 0x80 ? 1 : 0;
      dark += is_dark ? 1 : 0;
    }
    if (runs <= 1 && dark > 180) ++unbroken;
    if (runs > 10 && dark > 80) ++dashed;
  }
  CHECK(unbroken >= 3);  // the axis is one
  CHECK(dashed > 0);
}
