// SVG: the same picture as in pixels.

#include "render/svg.h"

#include <catch2/catch.hpp>

#include "render/draw.h"
#include "tests/render/painted.h"
#include "tests/render/sample_frame.h"

using namespace proofreel;
using namespace proofreel::painted;
using Catch::Contains;

namespace {

std::string drawn(const std::function<void(Canvas&)>& draw) {
  Canvas canvas(200, 100);
  canvas.clear(white);
  draw(canvas);
  return canvas.svg();
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

}  // namespace

TEST_CASE("A document is as large as the canvas, and what is drawn later comes later") {
  const std::string text = drawn([](Canvas& canvas) {
    canvas.disc({50, 40}, 10, solid);
    canvas.rectangle({1, 2}, {31, 22}, 0, {white, black, 2});
  });
  CHECK_THAT(text, Contains("width=\"200\" height=\"100\" viewBox=\"0 0 200 100\""));
  CHECK(text.find("<circle") < text.find("<rect x="));
  CHECK_THAT(text, Contains("<circle cx=\"50\" cy=\"40\" r=\"10\" fill=\"#000000\"/>"));
  CHECK_THAT(
      text,
      Contains(
          "<rect x=\"2\" y=\"3\" width=\"28\" height=\"18\" fill=\"#ffffff\" stroke=\"#000000\" stroke-width=\"2\"/>"));
}

TEST_CASE("Outlines lie inside the edge") {
  const std::string disc = drawn([](Canvas& canvas) { canvas.disc({50, 40}, 10, {white, black, 4}); });
  CHECK_THAT(disc, Contains("r=\"8\"") && Contains("stroke-width=\"4\""));  // from 6 to 10
  const std::vector<Vec2d> corners{{10, 10}, {60, 10}, {30, 50}};
  const std::string sharp = drawn([&](Canvas& canvas) { canvas.polygon(corners, 0, {white, black, 3}); });
  CHECK_THAT(sharp,
             Contains("<clipPath id=\"c1\"><polygon points=\"10,10 60,10 30,50\"/>") && Contains("stroke-width=\"6\""));
  const std::string round = drawn([&](Canvas& canvas) { canvas.polygon(corners, 5, {white, black, 2}); });
  CHECK_THAT(round, Contains("stroke-width=\"10\"") && Contains("stroke-width=\"6\"") &&
                        Contains("stroke-linejoin=\"round\""));
}

TEST_CASE("Letters are outlines as wide as they are in pixels") {
  const std::string text = drawn([](Canvas& canvas) {
    canvas.text("Hi \xCE\xB1", {100, 50}, 20, Align::right, black);
  });
  CHECK(count(text, "<path") == 1);
  CHECK(count(text, "M") >= 4);  // H, the dot and the stem of i, and alpha
  CHECK_THAT(text, !Contains("<text"));
  Canvas pixels(context(), 10, 10);
  Canvas lines(10, 10);
  CHECK(lines.text_width("Hi", 20) == pixels.text_width("Hi", 20));
}

TEST_CASE("What is not a shape writes nothing") {
  const std::string empty = drawn([](Canvas&) {});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(drawn([&](Canvas& canvas) {
          canvas.disc({nan, 0}, 1, solid);
          canvas.disc({0, 0}, 0, solid);
          canvas.line({nan, 0}, {1, 1}, 2, black);
          canvas.polygon(std::vector<Vec2d>{{0, 0}, {1, 1}, {2, 2}}, 0, solid);
          canvas.rectangle({5, 5}, {5, 9}, 0, solid);
          canvas.text("", {0, 0}, 12, Align::left, black);
        }) == empty);
}

TEST_CASE("Everything a frame may show is well-formed, with every group closed and every clip there") {
  const Theme theme = GENERATE(Theme::light, Theme::dark, Theme::print);
  Frame frame = sample_frame();
  Frame pane = frame;
  frame.other_panes.push_back(pane);
  for (const Frame& one : {pane, frame}) {
    const std::string text = svg_of(one, {theme}, {640, 360});
    CHECK(count(text, "<g ") == count(text, "</g>"));
    CHECK(count(text, "<clipPath ") == count(text, "</clipPath>"));
    CHECK(count(text, "<svg ") == 1);
    CHECK(text.ends_with("</svg>\n"));
    for (std::size_t at = text.find("url(#"); at != std::string::npos; at = text.find("url(#", at + 1)) {
      const std::string id = text.substr(at + 5, text.find(')', at) - at - 5);
      REQUIRE(text.find("<clipPath id=\"" + id + "\"") != std::string::npos);
    }
    CHECK_THAT(text, !Contains("nan") && !Contains("inf"));
  }
}

TEST_CASE("Without a background nothing lies behind what is drawn") {
  const Frame frame;
  CHECK(count(svg_of(frame, {Theme::light, true}, {64, 64}), "<rect") == 0);
  CHECK(count(svg_of(frame, {Theme::light, false}, {64, 64}), "<rect") == 1);
}

TEST_CASE("A caption that does not fit is refused wherever it is drawn") {
  Frame frame = sample_frame();
  frame.captions = {{std::string(2000, 'w'), Corner::bottom, "ball.lua: line 7: "}};
  CHECK_THROWS_WITH(
      svg_of(frame, {Theme::light}, {640, 360}),
      Catch::StartsWith("ball.lua: line 7: the text of this caption does not fit") && Contains("640x360"));
}
