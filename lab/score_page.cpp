#include "lab/score_page.h"

#include <array>

#include "lab/csv.h"
#include "lab/html.h"
#include "lab/score_text.h"
#include "scenarios/formatted.h"

namespace proofreel {
namespace {

constexpr std::array<const char*, standing_count> meanings{
    "stands: every expectation holds", "degrades: only expectations about quality do not hold",
    "fails: another expectation does not hold, or the simulation came to no end",
    "too slow: stopped at the limit of CPU time",
    "not offered: the engine or method does not do what the scene asks for"};

std::string class_of(Standing standing) {
  std::string name = name_of(standing);
  for (char& c : name) c = c == ' ' ? '-' : c;
  return name;
}

/// Long names may be broken at their underscores.
std::string breakable(const std::string& name) {
  std::string text;
  for (const char c : html_escaped(name)) text += c == '_' ? std::string("_<wbr>") : std::string(1, c);
  return text;
}

std::string group_headings(const Grid& grid) {
  std::string cells = "<td></td>";
  for (std::size_t c = 0; c < grid.columns.size();) {
    std::size_t end = c;
    while (end < grid.columns.size() && grid.columns[end].group == grid.columns[c].group) ++end;
    cells += tag("th", breakable(grid.columns[c].group),
                 "scope=\"colgroup\" " + attribute("colspan", std::to_string(end - c)));
    c = end;
  }
  return tag("tr", cells) + "\n";
}

std::string column_headings(const Grid& grid) {
  std::string cells = heading(html_escaped(grid.row_axis), 0);
  for (std::size_t c = 0; c < grid.columns.size(); ++c) {
    const Heading& column = grid.columns[c];
    const std::string detail = column.detail.empty() ? "" : tag("small", html_escaped(column.detail));
    const std::string group = tag("span", html_escaped(column.group) + " ", "class=\"vh\"");
    cells += heading(group + html_escaped(column.name) + detail, c + 1);
  }
  return tag("tr", cells) + "\n";
}

std::string cell_of(const RunRequest& request, const RunResult& result, bool best) {
  const std::string content = tag("span", sign_of(result.standing), "class=\"sign\" aria-hidden=\"true\"") +
                              tag("span", name_of(result.standing), "class=\"vh\"") +
                              tag("b", cost_text(result.cost_ms())) +
                              (best ? tag("span", "cheapest", "class=\"vh\"") : "");
  const std::string title = attribute("title", details_of(request, result));
  const std::string inside = result.still.empty() ? tag("span", content, "tabindex=\"0\" " + title)
                                                  : tag("a", content, attribute("href", result.still) + " " + title);
  const std::string sort = result.cost_ms() ? exact(*result.cost_ms()) : "";
  return tag("td", inside,
             attribute("class", class_of(result.standing) + (best ? " best" : "")) + " " +
                 attribute("data-sort", sort)) +
         "\n";
}

std::string run_table(const Grid& grid, const std::vector<RunResult>& results) {
  const std::vector<bool> best = cheapest(grid, results);
  std::string body;
  for (std::size_t row = 0; row < grid.rows.size(); ++row) {
    const Heading& name = grid.rows[row];
    const std::string title =
        name.detail.empty() ? "" : tag("small", html_escaped(name.detail), attribute("title", name.detail));
    std::string cells = tag("th", html_escaped(name.name) + title, "scope=\"row\"");
    for (std::size_t column = 0; column < grid.columns.size(); ++column) {
      const std::size_t i = grid.index(row, column);
      cells += cell_of(grid.runs[i], results[i], best[i]);
    }
    body += tag("tr", cells) + "\n";
  }
  const std::string words =
      tag("p",
          "CPU milliseconds per simulated second. Point at a cell for all its figures; follow it to the picture "
          "of the end. Headings sort.",
          "class=\"quiet\"");
  const std::string head = tag("thead", group_headings(grid) + column_headings(grid));
  return words + scrolling(tag("table", head + tag("tbody", body), "class=\"runs\" id=\"runs\""), "All runs");
}

std::string legend(const Grid& grid) {
  std::string items;
  for (int i = 0; i < standing_count; ++i) {
    const auto standing = static_cast<Standing>(i);
    const std::string sign =
        tag("span", sign_of(standing), attribute("class", "key " + class_of(standing)) + " aria-hidden=\"true\"");
    items += tag("li", sign + tag("span", meanings[static_cast<std::size_t>(i)])) + "\n";
  }
  const std::string framed = std::string("framed: the cheapest that stands") + (grid.one_scenario ? "" : " in its row");
  items += tag("li", tag("span", sign_of(Standing::stands), "class=\"key stands best\" aria-hidden=\"true\"") +
                         tag("span", framed));
  return tag("ul", items, "class=\"legend\"") + "\n";
}

std::string score_row(const MethodScore& score) {
  const std::string engine = score.engine == score.heading.group ? "" : score.engine + ": ";
  std::string cells = tag("th", html_escaped(engine + name_of(score.heading)), "scope=\"row\"");
  cells += tag("td", std::to_string(score.count(Standing::stands)) + " of " + std::to_string(score.scenarios),
               attribute("data-sort", std::to_string(score.count(Standing::stands))));
  for (int i = 1; i < standing_count; ++i) cells += tag("td", std::to_string(score.counts[i]));
  cells += tag("td", cost_text(score.cost_ms) + " (" + std::to_string(score.costed) + ")",
               attribute("data-sort", exact(score.cost_ms)));
  cells += score.to_box2d ? tag("td", formatted("%.2f", *score.to_box2d) + " (" + std::to_string(score.shared) + ")",
                                attribute("data-sort", exact(*score.to_box2d)))
                          : tag("td", "", "data-sort=\"\"");
  return tag("tr", cells) + "\n";
}

std::string score_table(const std::vector<MethodScore>& scores) {
  std::string head = heading("method", 0);
  std::size_t column = 1;
  for (const char* name : {"stands", "degrades", "fails", "too slow", "not offered", "CPU ms/s", "to Box2D"}) {
    head += heading(name, column++);
  }
  std::string body;
  for (const MethodScore& score : scores) body += score_row(score);
  const std::string words =
      tag("p",
          "Runs by outcome. CPU ms/s is the sum over the scenes that came to an end (how many), to "
          "Box2D its ratio to Box2D\u2019s over those both ended (how many).",
          "class=\"quiet\"");
  return words +
         scrolling(tag("table", tag("thead", tag("tr", head)) + tag("tbody", body), "class=\"plain\" id=\"scores\""),
                   "Scores");
}

std::string reasons(const Grid& grid, const std::vector<RunResult>& results, Standing standing) {
  std::string rows;
  int count = 0;
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (results[i].standing != standing) continue;
    const Heading& column = grid.columns[i % grid.columns.size()];
    const std::string method = grid.one_scenario ? label_of(grid, column) : name_of(column);
    const std::string name = label_of(grid, grid.rows[i / grid.columns.size()]);
    rows +=
        tag("tr", tag("th", html_escaped(name), "scope=\"row\"") + tag("td", html_escaped(method), "class=\"words\"") +
                      tag("td", html_escaped(results[i].why), "class=\"words\"")) +
        "\n";
    ++count;
  }
  if (count == 0) return {};
  const std::string head = tag("thead", tag("tr", heading("where", 0) + heading("with", 1) + heading("what", 2)));
  const std::string summary =
      std::string(sign_of(standing)) + " " + name_of(standing) + " (" + std::to_string(count) + ")";
  return tag("details",
             tag("summary", summary) + scrolling(tag("table", head + tag("tbody", rows), "class=\"plain\""), summary),
             standing == Standing::fails || standing == Standing::degrades ? "open" : "") +
         "\n";
}

std::string why_not(const Grid& grid, const std::vector<RunResult>& results) {
  std::string text;
  for (const Standing s : {Standing::fails, Standing::degrades, Standing::too_slow, Standing::not_offered}) {
    text += reasons(grid, results, s);
  }
  return text.empty() ? text : tag("h2", "What does not stand, and why") + "\n" + text;
}

std::string origin(const PageFacts& facts) {
  std::string maps;
  for (const std::string& map : facts.maps)
    maps.append(" ").append(tag("a", html_escaped(map), attribute("href", map)));
  return tag("h2", "Where this comes from") + "\n" + tag("pre", html_escaped(facts.command)) + "\n" +
         tag("p", "proofreel " + html_escaped(facts.version) + " on " + html_escaped(facts.machine) +
                      ". CPU time is that of stepping alone; nothing is drawn meanwhile. All figures: " +
                      tag("a", html_escaped(facts.table), attribute("href", facts.table)) + ". For print:" + maps +
                      ".") +
         "\n" +
         tag("p",
             "Box2D 2.4: polygons of no more than 8 corners, with a skin; no capsules; no body moves more than 2 m per "
             "step; nothing slower than 1 m/s bounces. Chipmunk 7: no continuous collision.",
             "class=\"quiet\"") +
         "\n";
}

}  // namespace

std::string page_of(const Grid& grid, const std::vector<RunResult>& results, const std::vector<MethodScore>& scores,
                    const PageFacts& facts) {
  std::string body = tag("p", html_escaped(grid.about)) + "\n";
  if (!scores.empty()) body += tag("h2", "Scores") + "\n" + score_table(scores);
  body += tag("h2", "All runs") + "\n" + run_table(grid, results) + legend(grid);
  body += why_not(grid, results) + origin(facts);
  return html_page(grid.title, body);
}

}  // namespace proofreel
