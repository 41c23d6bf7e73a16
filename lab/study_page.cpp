#include "lab/study_page.h"

#include <algorithm>

#include "lab/csv.h"
#include "lab/html.h"
#include "lab/score_text.h"
#include "lab/study_analysis.h"
#include "lab/study_charts.h"
#include "scenarios/formatted.h"

namespace proofreel {
namespace {

/// A cell that sorts by a number and shows it; both empty without one.
std::string number_cell(std::optional<double> value, const char* format) {
  return tag("td", value ? formatted(format, *value) : "", attribute("data-sort", value ? exact(*value) : ""));
}

std::string figures_of(const std::vector<PageFigure>& figures) {
  std::string text;
  for (const PageFigure& figure : figures) {
    text += tag("figure", figure.svg + tag("figcaption", html_escaped(figure.caption))) + "\n";
  }
  return text;
}

/// Who reaches which error at what price: the cheapest of each row is framed.
std::string price_row(const Study& study, const std::vector<StudyResult>& results, double target) {
  const auto winners = cheapest_by_method(study, results, WorkAxis::cpu, target);
  std::optional<double> best;
  for (const auto& winner : winners) {
    if (winner && (!best || winner->work < *best)) best = winner->work;
  }
  std::string cells = tag("th", power_text(target), "scope=\"row\"");
  for (const auto& winner : winners) {
    if (!winner) {
      cells += tag("td", "\u2013", "data-sort=\"\"");
      continue;
    }
    const std::string step = step_name(study, study.runs[winner->run]);
    const bool is_best = winner->work == *best;
    cells +=
        tag("td",
            cost_text(winner->work) + tag("small", std::string("&nbsp;").append(html_escaped(step)), "class=\"quiet\""),
            attribute("data-sort", exact(winner->work)) + (is_best ? " class=\"best\"" : ""));
  }
  return tag("tr", cells) + "\n";
}

std::string prices(const Study& study, const std::vector<StudyResult>& results) {
  std::string head = heading("error of at most", 0);
  for (std::size_t i = 0; i < study.methods.size(); ++i) head += heading(html_escaped(study.methods[i].name), i + 1);
  std::string body;
  for (const double target : worthwhile_targets(results)) body += price_row(study, results, target);
  if (body.empty()) return {};
  return tag("h2", "The price of an error") + "\n" +
         tag("p",
             "CPU milliseconds per simulated second of each method\u2019s cheapest run that is at least as good; "
             "framed: the cheapest of all.",
             "class=\"quiet\"") +
         "\n" +
         scrolling(tag("table", tag("thead", tag("tr", head)) + tag("tbody", body), "class=\"plain\" id=\"prices\""),
                   "The price of an error");
}

std::string run_row(const Study& study, const StudyRun& run, const StudyResult& r, bool on_front) {
  std::string cells = tag("th", html_escaped(study.methods[run.method].name), "scope=\"row\"");
  cells += tag("td", study.refined.empty() || run.values.empty() ? "" : html_escaped(run.values.back()));
  cells += tag("td", name_of(r.status), attribute("title", r.why));
  for (std::size_t i = 0; i < study.measures.size(); ++i)
    cells += number_cell(i < r.errors.size() ? r.errors[i] : std::nullopt, "%.3g");
  cells += number_cell(r.energy_error, "%.3g");
  cells += number_cell(work_of(r, WorkAxis::cpu), "%.3g");
  cells += number_cell(r.collision_share ? std::optional(100 * *r.collision_share) : std::nullopt, "%.0f %%");
  cells += number_cell(work_of(r, WorkAxis::updates), "%.0f");
  cells += number_cell(work_of(r, WorkAxis::instructions), "%.4g");
  return tag("tr", cells, on_front ? "class=\"front\"" : "") + "\n";
}

std::string run_table(const Study& study, const std::vector<StudyResult>& results) {
  std::vector<std::optional<double>> work;
  for (const StudyResult& result : results) work.push_back(work_of(result, WorkAxis::cpu));
  const std::vector<bool> front = pareto_front(work, first_errors(results));
  std::vector<std::string> labels{"method", study.refined.empty() ? "step" : study.refined, "status"};
  for (const StudiedMeasure& measure : study.measures) labels.push_back("error of " + measure.name);
  for (const char* label : {"energy error", "CPU ms/s", "of it collision", "updates/s", "instructions/s"})
    labels.emplace_back(label);
  std::string head;
  for (std::size_t i = 0; i < labels.size(); ++i) head += heading(html_escaped(labels[i]), i);
  std::string body;
  for (std::size_t i = 0; i < results.size(); ++i) body += run_row(study, study.runs[i], results[i], front[i]);
  return tag("h2", "All runs") + "\n" +
         scrolling(tag("table", tag("thead", tag("tr", head)) + tag("tbody", body), "class=\"plain\" id=\"runs\""),
                   "All runs");
}

std::string list_of(const std::vector<std::string>& sentences) {
  std::string items;
  for (const std::string& sentence : sentences) items += tag("li", html_escaped(sentence)) + "\n";
  return tag("ul", items) + "\n";
}

bool has_peers(const Study& study) {
  return std::any_of(study.methods.begin(), study.methods.end(), [](const auto& m) { return m.peer.has_value(); });
}

std::string rules(const Study& study, double energy_scale_j) {
  std::vector<std::string> sentences{
      "One error function for all: the largest |q \u2212 reference| over the samples, divided by the largest "
      "|reference| (at least 0.001). Samples are taken " +
          std::to_string(study.samples_per_s) + " times a second and at the end, at the same times in every run.",
      reference_words(study),
      energy_scale_j > 0
          ? "The energy error is the largest deviation from the initial energy and the work done on the "
            "scene, divided by " +
                formatted("%.4g", energy_scale_j) + " J, the largest kinetic energy in the scene as its file steps it."
          : std::string("Nothing moves in the scene: there is no scale for errors of the energy."),
      "One scene for all; nothing in it is tuned for a method.",
      "CPU time is that of the steps alone, the least of two to five runs (of one, where that is long) in processes of "
      "their own, while nothing "
      "else "
      "of this study runs. Nothing is drawn meanwhile. The share of finding contacts is told apart from solving them.",
      "Updates count every solve of a constraint row and every evaluation of the forces on a body; they are exact and "
      "the same on every machine. Peers do not count theirs.",
      "All runs are shown: those that failed or were stopped are crosses at the upper edge. The order of a method is "
      "fitted over its finest three runs in a row between which it is constant."};
  if (has_peers(study)) {
    sentences.emplace_back(
        "Box2D 2.4 (single precision) runs at its defaults, 8 velocity and 3 position iterations, and at one preset we "
        "call accurate: 64 and 24. Chipmunk 7 (double precision) runs at 10 iterations, accurate: 100. A step of "
        "theirs "
        "is one over the rate.");
    sentences.emplace_back(
        "Box2D 2.4: polygons of no more than 8 corners, with a skin; no capsules; no body moves more than 2 m per "
        "step; "
        "nothing slower than 1 m/s bounces. Chipmunk 7: no continuous collision.");
  }
  return tag("h2", "What makes this fair") + "\n" + list_of(sentences);
}

std::string origin(const PageFacts& facts) {
  std::string files;
  for (const std::string& map : facts.maps)
    files.append(" ").append(tag("a", html_escaped(map), attribute("href", map)));
  return tag("h2", "Where this comes from") + "\n" + tag("pre", html_escaped(facts.command)) + "\n" +
         tag("p", "proofreel " + html_escaped(facts.version) + " on " + html_escaped(facts.machine) +
                      ". All figures: " + tag("a", html_escaped(facts.table), attribute("href", facts.table)) +
                      ". For print:" + files + ".") +
         "\n";
}

}  // namespace

std::string page_of(const Study& study, const StudyOutcome& outcome, const std::vector<PageFigure>& figures,
                    const PageFacts& facts) {
  std::string body;
  const std::string verdict = verdict_of(study, outcome.results);
  body +=
      tag("p",
          html_escaped(verdict.empty()
                           ? "No run has an error to compare: none differs from its reference, or none came to its end."
                           : verdict),
          "class=\"verdict\"") +
      "\n";
  body += figures_of(figures) + prices(study, outcome.results) + run_table(study, outcome.results);
  if (!study.left_out.empty()) body += tag("h2", "Left out") + "\n" + list_of(study.left_out);
  body += rules(study, outcome.energy_scale_j) + origin(facts);
  return html_page(study.title + ": what accuracy costs", body);
}

}  // namespace proofreel
