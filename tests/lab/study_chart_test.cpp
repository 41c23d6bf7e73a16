#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <set>

#include "lab/study_charts.h"
#include "lab/study_page.h"
#include "render/context.h"
#include "render/png.h"
#include "tests/browser.h"
#include "tests/lab/study_scenes.h"
#include "tests/render/scratch_folder.h"

namespace proofreel {
namespace {

using namespace test;
using Catch::Matchers::Contains;

/// Orders 1, 2 and 4 (with a floor at 1e-9), and a method that fails at its largest step.
std::vector<StudyResult> some_results(int runs_each) {
  std::vector<StudyResult> results;
  const double orders[] = {1, 2, 4, 2};
  for (int m = 0; m < 4; ++m) {
    for (int i = 0; i < runs_each; ++i) {
      const double error = std::max(0.2 * std::pow(0.5, orders[m] * i) / (m + 1), 1e-9 * (1 + i));
      results.push_back(result_of(error, 0.02 * (m + 1) * std::pow(2.0, i)));
    }
  }
  StudyResult& failed = results[static_cast<std::size_t>(3 * runs_each)];
  failed = {};
  failed.status = RunStatus::failed;
  failed.why = "at 0.5 s of scene time: became infinite or not a number";
  return results;
}

Study some_study(int runs_each) { return study_of({"euler", "verlet", "suzuki4", "stiff"}, runs_each); }

Chart some_chart(int runs_each = 8) {
  return work_precision_chart(some_study(runs_each), some_results(runs_each), WorkAxis::cpu).value();
}

Image picture_of(const Chart& chart, int width, int height) {
  const auto context = make_context({});
  Canvas canvas(*context, width, height);
  draw(canvas, laid_out(chart, canvas, width, height));
  Image image;
  canvas.finish(image);
  return image;
}

Drawing drawing_of(const Chart& chart) {
  const auto context = make_context({});
  Canvas ruler(*context, 8, 8);
  return laid_out(chart, ruler, 2400, 1500);
}

template <typename Mark>
std::vector<Mark> marks_of(const Drawing& drawing) {
  std::vector<Mark> marks;
  for (const DrawnMark& mark : drawing.marks) {
    if (const auto* found = std::get_if<Mark>(&mark)) marks.push_back(*found);
  }
  return marks;
}

TEST_CASE("The work-precision diagram looks as it was found good", "[study_chart]") {
  const Image image = picture_of(some_chart(), 1600, 1000);
  const Image golden = read_png("tests/lab/work_precision.png");
  const std::string now = (std::filesystem::temp_directory_path() / "proofreel_work_precision.png").string();
  const bool same = image.rgba == golden.rgba;  // millions of bytes are no use in a message
  if (!same) {
    const std::vector<std::uint8_t> png = encode_png(image);
    write_text(now, std::string(png.begin(), png.end()));
  }
  INFO("Changed on purpose? Look at " + now + ", and put it in place of tests/lab/work_precision.png.");
  REQUIRE(same);
}

TEST_CASE("The diagram has a band for the front, pale symbols for the dominated, a cross for the failed",
          "[study_chart]") {
  const Chart chart = some_chart();
  REQUIRE(chart.front.size() > 3);
  int grey = 0;
  for (const ChartCurve& curve : chart.curves) {
    for (const ChartPoint& point : curve.points) grey += point.grey;
  }
  REQUIRE(grey == 4 * 8 - 1 - static_cast<int>(chart.front.size()));
  REQUIRE(chart.curves[3].failures.size() == 1);
  REQUIRE_THAT(chart.curves[3].failures[0].words, Contains("failed (at 0.5 s of scene time"));
  REQUIRE(chart.curves[2].floor.has_value());
  REQUIRE(chart.curves[1].note == "order 2.00");
  std::vector<std::string> labels;
  for (const SlopeTriangle& triangle : chart.triangles) labels.push_back(triangle.label);
  REQUIRE(labels == std::vector<std::string>{"1", "2", "4"});
}

TEST_CASE("Every mark of a chart lies within the picture", "[study_chart]") {
  const Drawing drawing = drawing_of(some_chart());
  const auto inside = [&](Vec2d p) {
    return p.x >= 0 && p.y >= 0 && p.x <= drawing.width_px && p.y <= drawing.height_px;
  };
  for (const SymbolMark& mark : marks_of<SymbolMark>(drawing)) REQUIRE(inside(mark.center));
  for (const LineMark& mark : marks_of<LineMark>(drawing)) {
    for (const Vec2d& p : mark.points) REQUIRE(inside(p));
  }
  const auto context = make_context({});
  Canvas ruler(*context, 8, 8);
  for (const TextMark& mark : marks_of<TextMark>(drawing)) {
    const double width = ruler.text_width(mark.text, mark.size_px);
    const double left = mark.baseline.x - (mark.align == Align::left     ? 0
                                           : mark.align == Align::center ? width / 2
                                                                         : width);
    INFO(mark.text);
    REQUIRE(left >= 0);
    REQUIRE(left + width <= drawing.width_px);
    REQUIRE(mark.baseline.y <= drawing.height_px);
  }
}

TEST_CASE("Points lie where the axes say", "[study_chart]") {
  Chart chart;
  chart.x = {"x", true};
  chart.y = {"y", true};
  chart.curves = {
      {"a", "", {{{1, 1}, "one", false}, {{10, 100}, "two", false}, {{100, 10000}, "three", false}}, true, {}, {}}};
  std::vector<Vec2d> places;
  for (const SymbolMark& mark : marks_of<SymbolMark>(drawing_of(chart))) {
    if (!mark.words.empty()) places.push_back(mark.center);
  }
  REQUIRE(places.size() == 3);
  REQUIRE(places[1].x - places[0].x == Approx(places[2].x - places[1].x));
  REQUIRE(places[0].y - places[1].y == Approx(places[1].y - places[2].y));
  REQUIRE(places[0].y > places[1].y);
}

TEST_CASE("A chart of nothing, of one point, and of what no logarithm takes is drawn all the same", "[study_chart]") {
  Chart chart;
  chart.title = "Nothing";
  chart.x = {"x", true};
  chart.y = {"y", true};
  REQUIRE_FALSE(marks_of<TextMark>(drawing_of(chart)).empty());
  chart.curves = {
      {"a", "", {{{3, 4}, "only", false}, {{0, 1}, "zero", false}, {{1, NAN}, "no number", false}}, true, {}, {}}};
  int words = 0;
  for (const SymbolMark& mark : marks_of<SymbolMark>(drawing_of(chart))) words += !mark.words.empty();
  REQUIRE(words == 1);
}

TEST_CASE("No two of the first 48 curves look alike", "[study_chart]") {
  std::set<std::pair<std::uint32_t, int>> looks;
  for (std::size_t i = 0; i < 48; ++i) {
    const CurveLook look = look_of_curve(i);
    const auto color = static_cast<std::uint32_t>(look.color.r << 16U | look.color.g << 8U | look.color.b);
    looks.insert({color, static_cast<int>(look.symbol)});
    REQUIRE(look.symbol != Symbol::cross);
  }
  REQUIRE(looks.size() == 48);
}

TEST_CASE("The SVG has the same texts and points as the picture, escaped", "[study_chart]") {
  const Drawing drawing = drawing_of(some_chart());
  const std::string svg = svg_of(drawing, "A <title>");
  REQUIRE_THAT(svg, Contains("viewBox=\"0 0 2400 1500\"") && Contains("A &lt;swing&gt; &amp; more") &&
                        Contains("aria-label=\"A &lt;title&gt;\"") && !Contains("<swing>"));
  std::size_t words = 0;
  for (const SymbolMark& mark : marks_of<SymbolMark>(drawing)) words += !mark.words.empty();
  std::size_t points = 0;
  for (std::size_t at = svg.find("class=\"point\""); at != std::string::npos; at = svg.find("class=\"point\"", at + 1))
    ++points;
  REQUIRE(points == words);
  REQUIRE(points == 32);
}

std::string some_page() {
  const StudyOutcome outcome{some_results(8), 4.905};
  Study study = some_study(8);
  study.left_out = {"rk4: cannot step <joints>."};
  return page_of(study, outcome, {{svg_of(drawing_of(some_chart()), "Errors"), "Error against CPU time."}},
                 {"proofreel study swing -o 'a<b'", "0.1.0", "Z80", {"work_precision.png"}, "study.csv"});
}

TEST_CASE("The study's page begins with the verdict, tells its rules and who was left out, and loads nothing",
          "[study_chart]") {
  const std::string html = some_page();
  REQUIRE_THAT(html, Contains("class=\"verdict\">For an error of 1e-") && Contains("4.905 J") &&
                         Contains("cannot step &lt;joints&gt;") && Contains("-o 'a&lt;b'") &&
                         Contains("60 times a second"));
  for (const char* word : {"https:", "src=", "<link", "@import", "url("}) REQUIRE_THAT(html, !Contains(word));
}

TEST_CASE("In a browser the table of runs is sorted, and a point tells its figures", "[study_chart]") {
  const std::string script =
      "const column = i => [...document.querySelectorAll('#runs tbody tr')].map(r => r.cells[i].dataset.sort);"
      "const heads = [...document.querySelectorAll('#runs thead button')];"
      "const error = heads.findIndex(h => h.textContent === 'error of angle');"
      "heads[error].click();"
      "const sorted = column(error);"
      "const known = sorted.filter(v => v !== '').map(Number);"
      "const notes = [known.every((v, i) => i === 0 || known[i - 1] <= v), sorted.length, sorted.at(-1) === ''];"
      "const point = document.querySelectorAll('.point')[3];"
      "point.dispatchEvent(new MouseEvent('mouseenter'));"
      "notes.push(document.getElementById('tip').textContent, document.getElementById('tip').hidden);"
      "point.dispatchEvent(new MouseEvent('mouseleave'));"
      "notes.push(document.getElementById('tip').hidden);"
      "document.title = notes.join('|');";
  REQUIRE_THAT(in_browser(some_page(), script),
               Contains("<title>true|32|true|euler, rate 480: error 0.025; energy error 0.0125; 0.16 ms per simulated "
                        "second|false|true</title>"));
}

}  // namespace
}  // namespace proofreel
