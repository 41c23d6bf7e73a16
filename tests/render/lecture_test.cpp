#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>

#include "render/draw.h"
#include "render/draw_text.h"
#include "render/theme.h"
#include "render/typeset.h"
#include "scenarios/runner.h"
#include "tests/render/painted.h"

using namespace proofreel;
using namespace proofreel::painted;

namespace {

/// Those that demonstrate an algorithm; others show bodies.
std::vector<std::string> lecture_scenarios() {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::directory_iterator("scenarios/lecture")) {
    const std::string path = entry.path().string();
    if (!path.ends_with(".lua")) continue;
    if (!load_scenario(path, {})->stories.empty()) paths.push_back(path);
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

Canvas& canvas() {
  static auto& made = *new Canvas(context(), 320, 180);  // like its context never let go
  return made;
}

Image drawn(const Frame& frame, Theme theme, int width_px, int height_px) {
  Canvas large(context(), width_px, height_px);
  Image image;
  draw_frame(large, frame, {theme}, image);
  return image;
}

/// The pixels of a strip that are not the background.
int painted_pixels(const Image& image, int from_x, int from_y, int to_x, int to_y) {
  int count = 0;
  for (int y = from_y; y < to_y; ++y) {
    for (int x = from_x; x < to_x; ++x) {
      const std::uint8_t* pixel =
          &image.rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width_px) +
                           static_cast<std::size_t>(x))];
      count += std::equal(pixel, pixel + 3, image.rgba.begin()) ? 0 : 1;
    }
  }
  return count;
}

}  // namespace

TEST_CASE("A text without formulas is set as it always was") {
  const std::string text = "A caption that is long enough for two lines, with a_1 in it";
  const auto lines = typeset(canvas(), text, 20, 300);
  const auto expected = wrapped(canvas(), text, 20, 300);
  REQUIRE(lines.size() == expected.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    REQUIRE(lines[i].texts.size() == 1);
    CHECK(lines[i].texts[0].text == expected[i]);
    CHECK(lines[i].width == canvas().text_width(expected[i], 20));
  }
}

TEST_CASE("Balanced lines are as few as can be, and none of them is a single word left over") {
  const std::string text = "A caption of two lines that would leave just one word of it alone";
  const double width = canvas().text_width(text, 20) - 5;
  REQUIRE(typeset(canvas(), text, 20, width).size() == 2);
  const auto lines = balanced(canvas(), text, 20, width);
  REQUIRE(lines.size() == 2);
  CHECK(lines[1].width > 0.6 * lines[0].width);
  CHECK(balanced(canvas(), text, 20, 2 * width).size() == 1);
}

TEST_CASE("The letters of a denominator do not touch the line below") {
  const int size = 40;
  const auto lines = typeset(canvas(), "$\\frac{1}{g}$ next", size, canvas().text_width("next", size) + 1);
  REQUIRE(lines.size() == 2);
  const double baselines = height_of(lines, size) - lines[0].ascent;
  constexpr double hang = 0.25;  // em: of a g
  CHECK(baselines > lines[0].descent + (hang + cap_height) * size);
}

TEST_CASE("A subscript is smaller and lower, a superscript smaller and higher") {
  const TypesetLine line = typeset_line(canvas(), "$a_1b^2$", 40);
  REQUIRE(line.texts.size() == 4);
  CHECK(line.texts[1].size_px < 40);
  CHECK(line.texts[1].at.y > 0);
  CHECK(line.texts[1].at.x >= canvas().text_width("a", 40));
  CHECK(line.texts[3].at.y < 0);
  CHECK(line.texts[3].at.x > line.texts[2].at.x);
  CHECK(line.width > line.texts[3].at.x);
}

TEST_CASE("A fraction stands around its line, and a vector's arrow above its letters") {
  const TypesetLine fraction = typeset_line(canvas(), "$\\frac{1}{22}$", 40);
  REQUIRE(fraction.strokes.size() == 1);
  const double line = fraction.strokes[0].from.y;
  CHECK(fraction.texts[0].at.y < line);
  CHECK(fraction.texts[1].at.y - cap_height * fraction.texts[1].size_px > line);
  CHECK(fraction.descent > 0);
  const TypesetLine vector = typeset_line(canvas(), "$\\vec{AB}$", 40);
  REQUIRE(vector.strokes.size() == 1);
  CHECK(vector.strokes[0].arrow);
  CHECK(vector.strokes[0].from.y < -cap_height * 40);
  CHECK(vector.width == canvas().text_width("AB", 40));
}

TEST_CASE("Lines with formulas break at spaces and keep what hangs together") {
  const auto lines = typeset(canvas(), "one $a = b$, two $c_1$ three", 20, 80);
  CHECK(lines.size() >= 3);
  for (const TypesetLine& line : lines) {
    CHECK(line.width <= 80);
    CHECK(line.texts.front().text != ",");
  }
}

TEST_CASE("A formula is broken only where it is wider than a line") {
  const auto ends_of = [](const char* text, double width) {
    std::string ends;
    for (const TypesetLine& line : typeset(canvas(), text, 20, width)) ends += line.texts.back().text + "/";
    return ends;
  };
  const double formula = typeset_line(canvas(), "$a = b + c$", 20).width;
  const double begun = typeset_line(canvas(), "words and $a = b$", 20).width;
  REQUIRE(begun > formula);
  CHECK(ends_of("words and $a = b + c$", begun) == "and/c/");
  CHECK(ends_of("$a = b + c$", 0.5 * formula) != "c/");
}

TEST_CASE("Lines are balanced without breaking formulas that fit") {
  const char* text = "these are some words, $a + b + c + d = e$";
  const double width = 0.99 * typeset_line(canvas(), text, 20).width;
  const auto lines = balanced(canvas(), text, 20, width);
  REQUIRE(lines.size() == 2);
  CHECK(lines[0].texts.back().text == "words,");
  for (const TypesetLine& line : lines) CHECK(line.width <= width);
}

TEST_CASE("Every caption of the lecture films fits its band in two lines") {
  for (const std::string& path : lecture_scenarios()) {
    const auto scenario = load_scenario(path, {});
    for (const Story& story : scenario->stories) {
      for (const Step& step : story.steps) {
        const Sizes sizes = sizes_of(1280, 720);
        const double width = 1280 - 2 * sizes.margin - 1.6 * sizes.text;
        INFO(path << ": " << step.caption);
        CHECK(typeset(canvas(), step.caption, sizes.text, width).size() <= 2);
      }
    }
  }
}

TEST_CASE("Nothing of a lecture film reaches into the margin") {
  for (const std::string& path : lecture_scenarios()) {
    const auto scenario = load_scenario(path, {});
    Frame frame;
    for (const double part : {0.1, 0.5, 0.999}) {
      frame.demonstration = view_of(scenario->stories, part * scenario->duration);
      for (const auto& [width, height] : {std::pair{640, 360}, {360, 640}, {540, 540}}) {
        const Image image = drawn(frame, Theme::light, width, height);
        const int margin = 8;
        INFO(path << " " << width << "x" << height);
        CHECK(painted_pixels(image, 0, 0, width, margin) == 0);
        CHECK(painted_pixels(image, 0, height - margin, width, height) == 0);
        CHECK(painted_pixels(image, 0, 0, margin, height) == 0);
        CHECK(painted_pixels(image, width - margin, 0, width, height) == 0);
        CHECK(painted_pixels(image, 0, 0, width, height) > 500);
      }
    }
  }
}

TEST_CASE("Counters never lie on the heading, however narrow the picture") {
  const auto picture_of = [](bool heading, bool counters, int width, int height) {
    Frame frame;
    frame.demonstration = DemonstrationView{};
    frame.demonstration->panes.push_back({"", false, 1, {{0, 0}, {4, 3}}});
    if (heading) frame.demonstration->heading = "Centroid by triangulation";
    if (counters) frame.demonstration->counters = {{"S so far", "10.62 m\u00b2"}, {"C so far", "(-0.37, -0.03)"}};
    return drawn(frame, Theme::light, width, height);
  };
  for (const auto& [width, height] : {std::pair{640, 360}, {360, 640}, {486, 864}, {540, 540}}) {
    const Image none = picture_of(false, false, width, height);
    const Image heading = picture_of(true, false, width, height), counters = picture_of(false, true, width, height);
    const Image both = picture_of(true, true, width, height);
    int shared = 0, written = 0;
    for (std::size_t i = 0; i < none.rgba.size(); i += 4) {
      const bool first = heading.rgba[i] != none.rgba[i], second = counters.rgba[i] != none.rgba[i];
      shared += first && second ? 1 : 0;
      written += both.rgba[i] != none.rgba[i] ? 1 : 0;
    }
    INFO(width << "x" << height);
    CHECK(written > 200);
    if (height > width) CHECK(shared == 0);  // in wide pictures the heading gives way when there are counters
  }
}

TEST_CASE("Lecture films are gray throughout in print, and the same bytes twice") {
  const auto scenario = load_scenario("scenarios/lecture/gjk_epa.lua", {});
  Frame frame;
  frame.demonstration = view_of(scenario->stories, 0.7 * scenario->duration);
  const Image print = drawn(frame, Theme::print, 640, 360);
  for (std::size_t i = 0; i < print.rgba.size(); i += 4) {
    REQUIRE(print.rgba[i] == print.rgba[i + 1]);
    REQUIRE(print.rgba[i] == print.rgba[i + 2]);
  }
  CHECK(drawn(frame, Theme::print, 640, 360).rgba == print.rgba);
}

TEST_CASE("A mark's role decides how it looks, and what has not appeared is not drawn") {
  const auto picture_of = [](Role role, double presence) {
    Frame frame;
    frame.demonstration = DemonstrationView{};
    frame.demonstration->panes.push_back({"", false, 1, {{0, 0}, {4, 3}}});
    StoryMark mark;
    mark.kind = MarkKind::path;
    mark.role = role;
    mark.points = {{0, 0}, {4, 3}};
    mark.presence = presence;
    frame.demonstration->marks.push_back(mark);
    return drawn(frame, Theme::light, 320, 180);
  };
  CHECK(picture_of(Role::result, 1).rgba != picture_of(Role::alert, 1).rgba);
  CHECK(picture_of(Role::chosen, 1).rgba != picture_of(Role::candidate, 1).rgba);
  CHECK(picture_of(Role::result, 0).rgba == picture_of(Role::alert, 0).rgba);
}
