#include "lab/score_page.h"

#include <catch2/catch.hpp>

#include "lab/html.h"
#include "lab/score_map.h"
#include "lab/score_text.h"
#include "tests/browser.h"

namespace proofreel {
namespace {

using Catch::Matchers::Contains;
using test::in_browser;

/// Two scenarios by two methods: stands and degrades, fails and is not offered.
Grid small_grid() {
  Grid grid;
  grid.title = "Card <1>";
  grid.row_axis = "scenario";
  grid.column_axis = "substeps";
  grid.columns = {{"soft_step", "2", "double"}, {"Box2D", "60 Hz", "single"}};
  grid.rows = {{"", "hard/a", "A & B"}, {"", "hard/b", "B"}};
  grid.runs.resize(4);
  return grid;
}

std::vector<RunResult> small_results() {
  std::vector<RunResult> results(4);
  const Standing standings[] = {Standing::stands, Standing::degrades, Standing::fails, Standing::not_offered};
  for (std::size_t i = 0; i < 4; ++i) {
    results[i].standing = standings[i];
    results[i].simulated_s = 1;
    results[i].cpu_s = 1e-3 * static_cast<double>(i + 1);
  }
  results[2].why = "at 1 s: \"x < y\" & more";
  results[0].still = "stills/a.png";
  return results;
}

std::string page() {
  return page_of(small_grid(), small_results(), {},
                 {"proofreel scorecard -o 'a<b'", "0.1.0", "Z80", {"s.png"}, "s.csv"});
}

int count(const std::string& text, const std::string& what) {
  int found = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
  return found;
}

/// The pixel's colour as 0xRRGGBB.
unsigned color_at(const Image& image, int x, int y) {
  const std::size_t i =
      4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width_px) + static_cast<std::size_t>(x));
  return static_cast<unsigned>(image.rgba[i] << 16U | image.rgba[i + 1] << 8U | image.rgba[i + 2]);
}

int pixels_of(const Image& image, unsigned color) {
  int found = 0;
  for (int y = 0; y < image.height_px; ++y) {
    for (int x = 0; x < image.width_px; ++x) found += color_at(image, x, y) == color;
  }
  return found;
}

TEST_CASE("Whatever text comes into the page stays text", "[page]") {
  REQUIRE(html_escaped("<a href=\"x\">&</a>") == "&lt;a href=&quot;x&quot;&gt;&amp;&lt;/a&gt;");
  const std::string html = page();
  REQUIRE_THAT(html, Contains("<h1>Card &lt;1&gt;</h1>") && Contains("-o 'a&lt;b'") && Contains("A &amp; B</small>"));
  REQUIRE_THAT(html, Contains("at 1 s: &quot;x &lt; y&quot; &amp; more") && !Contains("x < y"));
}

TEST_CASE("Every cell has a sign and words, its cost, its figures, and leads to its picture", "[page]") {
  const std::string html = page();
  REQUIRE(count(html, "class=\"stands best\"") == 1);
  REQUIRE_THAT(html,
               Contains("href=\"stills/a.png\" title=") && Contains("<span class=\"vh\">degrades</span><b>2.0</b>"));
  REQUIRE_THAT(html, Contains("<span class=\"vh\">not offered</span><b></b>"));
  REQUIRE(count(html, "tabindex=\"0\" title=") == 3);
}

TEST_CASE("The page asks for nothing from elsewhere", "[page]") {
  const std::string html = page();
  for (const char* word : {"http:", "https:", "src=", "<link", "@import", "url("}) REQUIRE(count(html, word) == 0);
}

TEST_CASE("In a browser headings sort the rows of their table, upwards and then downwards", "[page]") {
  const std::string script =
      "const names = () => [...document.querySelectorAll('#runs tbody th')].map(h => h.firstChild.data).join(' ');"
      "const heads = document.querySelectorAll('#runs thead button');"
      "const notes = [names()];"
      "for (const i of [0, 0, 1, 1, 2, 2]) {"
      "  heads[i].click();"
      "  notes.push(names() + ' ' + heads[i].closest('th').getAttribute('aria-sort'));"
      "}"
      "notes.push(document.querySelectorAll('#runs [aria-sort]').length);"
      "document.title = notes.join(', ');";
  // What has no cost, the last cell of b, comes last both ways.
  REQUIRE_THAT(in_browser(page(), script),
               Contains("<title>hard/a hard/b, hard/a hard/b ascending, hard/b hard/a descending, "
                        "hard/a hard/b ascending, hard/b hard/a descending, "
                        "hard/a hard/b ascending, hard/a hard/b descending, 1</title>"));
}

TEST_CASE("Costs are written with as many digits as they are good for", "[page]") {
  REQUIRE(cost_text(0.4249) == "0.42");
  REQUIRE(cost_text(0.0424) == "0.042");
  REQUIRE(cost_text(0.0996) == "0.10");
  REQUIRE(cost_text(0.999) == "1.0");
  REQUIRE(cost_text(3.14) == "3.1");
  REQUIRE(cost_text(9.96) == "10");
  REQUIRE(cost_text(250.4) == "250");
  REQUIRE(cost_text({}).empty());
}

TEST_CASE("The map has each standing's fill, one frame around the cheapest, and nothing at its edge", "[map]") {
  const Image map = draw_map(small_grid(), small_results(), {});
  constexpr int cell = 152 * 98;
  REQUIRE(pixels_of(map, 0xCDE9E3) > cell / 2);
  REQUIRE(pixels_of(map, 0xF0BE52) > cell / 2);
  REQUIRE(pixels_of(map, 0x9B332B) > cell / 2);
  for (int x = 0; x < map.width_px; ++x) {
    REQUIRE(color_at(map, x, 20) == 0xFFFFFF);
    REQUIRE(color_at(map, x, map.height_px - 20) == 0xFFFFFF);
  }
  std::vector<RunResult> none = small_results();
  none[0].standing = Standing::degrades;
  constexpr unsigned ink = 0x1F2A36;
  REQUIRE(pixels_of(map, ink) > pixels_of(draw_map(small_grid(), none, {}), ink) + 2000);
}

}  // namespace
}  // namespace proofreel
