#include <catch2/catch.hpp>

#include "render/draw_text.h"
#include "render/font.h"
#include "tests/render/painted.h"

using namespace proofreel;
using namespace proofreel::painted;

namespace {

struct Columns {
  int first = -1;
  int last = -1;
};

/// The columns that have ink.
Columns inked_columns(const Image& image) {
  Columns columns;
  for (int x = 0; x < image.width_px; ++x) {
    for (int y = 0; y < image.height_px; ++y) {
      if (red(image, x, y) == 255) continue;
      if (columns.first < 0) columns.first = x;
      columns.last = x;
    }
  }
  return columns;
}

Image written(const std::string& text, Vec2d at, int size_px, Align align) {
  return picture(400, 60, [&](Canvas& canvas) { canvas.text(text, at, size_px, align, black); });
}

}  // namespace

TEST_CASE("The width of a text without kerning pairs is the sum of its parts") {
  Canvas canvas(context(), 8, 8);
  for (const int size : {9, 18, 40}) {
    CHECK(canvas.text_width("123456", size) ==
          Approx(canvas.text_width("123", size) + canvas.text_width("456", size)).margin(1e-12));
  }
  CHECK(canvas.text_width("", 18) == 0);
}

TEST_CASE("Kerning brings pairs together") {
  Canvas canvas(context(), 8, 8);
  CHECK(canvas.text_width("AV", 40) < canvas.text_width("A", 40) + canvas.text_width("V", 40));
}

TEST_CASE("All digits are equally wide, so that a clock does not jitter") {
  Canvas canvas(context(), 8, 8);
  for (char digit = '1'; digit <= '9'; ++digit) {
    CHECK(canvas.text_width(std::string(1, digit), 19) == canvas.text_width("0", 19));
  }
}

TEST_CASE("Text is drawn inside its measured width, left, centred and right of its point") {
  for (const std::string text : {"Kinetic energy", "θ = 60°, ½mv²", "žltý kôň", "L₁ → L₂"}) {
    Canvas canvas(context(), 8, 8);
    const double width = canvas.text_width(text, 24);
    const double left = 200 - width;
    const Columns l = inked_columns(written(text, {left, 40}, 24, Align::left));
    CHECK(l.first >= left - 2);
    CHECK(l.last <= 200 + 2);
    const Columns c = inked_columns(written(text, {200, 40}, 24, Align::center));
    CHECK(c.first >= 200 - 0.5 * width - 2);
    CHECK(c.last <= 200 + 0.5 * width + 2);
    const Columns r = inked_columns(written(text, {200, 40}, 24, Align::right));
    CHECK(r.last <= 202);
    CHECK(r.first >= left - 2);
    CHECK(r.last - r.first == Approx(width).margin(6));
  }
}

TEST_CASE("Text moved by whole pixels draws the same letters") {
  const Image here = written("Moved", {20, 40}, 22, Align::left);
  const Image there = written("Moved", {27, 44}, 22, Align::left);
  for (int y = 0; y < 50; ++y) {
    for (int x = 0; x < 300; ++x) REQUIRE(red(here, x, y) == red(there, x + 7, y + 4));
  }
}

TEST_CASE("A letter the font lacks is drawn as a box of ink, and so are bytes that are not UTF-8") {
  CHECK(ink(written("\U0001F9FF", {20, 40}, 30, Align::left)) > 20);
  CHECK(ink(written("\xC3", {20, 40}, 30, Align::left)) > 20);
  CHECK(ink(written(" ", {20, 40}, 30, Align::left)) == 0);
}

TEST_CASE("UTF-8 is taken apart into characters, broken bytes one by one") {
  std::string_view text = "a\xCE\xB1\xE2\x82\x81\xF0\x9F\x98\x80\xC0\xCE";
  CHECK(take_character(text) == U'a');
  CHECK(take_character(text) == U'\u03B1');
  CHECK(take_character(text) == U'\u2081');
  CHECK(take_character(text) == U'\U0001F600');
  CHECK(take_character(text) == U'\uFFFD');
  CHECK(take_character(text) == U'\uFFFD');
  CHECK(text.empty());
}

TEST_CASE("Ticks are round, inside the range, and no more than asked for") {
  const Ticks ticks = ticks_in(0.3, 10.4, 6);
  CHECK(ticks.step == 2);
  CHECK(ticks.first == 2);
  CHECK(ticks.count == 5);
  CHECK(ticks.decimals == 0);
  const Ticks small = ticks_in(-0.0021, 0.0049, 5);
  CHECK(small.step == Approx(0.002));
  CHECK(small.first == Approx(-0.002));
  CHECK(small.decimals == 3);
  for (const double span : {1e-9, 0.37, 1.0, 99.0, 1e12}) {
    const Ticks any = ticks_in(-0.4 * span, 0.6 * span, 5);
    CHECK(any.count >= 2);
    CHECK(any.count <= 5);
    CHECK(any.at(any.count - 1) <= 0.6 * span * (1 + 1e-9));
  }
}

TEST_CASE("An empty or broken range has one tick") {
  CHECK(ticks_in(3, 3, 5).count == 1);
  CHECK(ticks_in(0, std::numeric_limits<double>::infinity(), 5).count == 1);
}

TEST_CASE("Numbers have as many decimals as asked for, a real minus, and never a negative zero") {
  CHECK(number_text(1.5, 2) == "1.50");
  CHECK(number_text(-3, 0) == "\u22123");
  CHECK(number_text(-0.0, 1) == "0.0");
  CHECK(number_text(-0.001, 1) == "0.0");
  CHECK(number_text(123456789012.0, 0) == "1.23e+11");
}

TEST_CASE("Lines break at spaces and nowhere else") {
  Canvas canvas(context(), 8, 8);
  const double width = canvas.text_width("one two", 18) + 1;
  CHECK(wrapped(canvas, "one two three", 18, width) == std::vector<std::string>{"one two", "three"});
  CHECK(wrapped(canvas, "one\ntwo", 18, 1000) == std::vector<std::string>{"one", "two"});
  CHECK(wrapped(canvas, "unbreakable", 18, 5) == std::vector<std::string>{"unbreakable"});
  CHECK(wrapped(canvas, "", 18, 100).empty());
}

TEST_CASE("What is too long for a line ends in three dots, after a whole character") {
  Canvas canvas(context(), 8, 8);
  CHECK(shortened(canvas, "two\nlines", 20, 1000) == "two lines");
  const std::string greek = "\u03b1\u03b2\u03b3\u03b4\u03b5";
  for (double width = 0; width < 100; width += 3) {
    const std::string line = shortened(canvas, greek, 20, width);
    if (line == greek) {
      CHECK(canvas.text_width(line, 20) <= width);
      continue;
    }
    CHECK(line.ends_with("\u2026"));
    CHECK(greek.starts_with(line.substr(0, line.size() - 3)));
    CHECK(line.size() % 2 == 1);  // each letter has two bytes, the dots three
    if (line.size() > 3) CHECK(canvas.text_width(line, 20) <= width);
  }
}
