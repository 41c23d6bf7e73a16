#include "lab/study_files.h"

#include <cmath>
#include <filesystem>

#include "lab/child.h"
#include "lab/html.h"
#include "lab/study_analysis.h"
#include "lab/study_charts.h"
#include "lab/study_page.h"
#include "render/canvas.h"
#include "render/output_file.h"
#include "render/png.h"
#include "scenarios/environment_error.h"

namespace proofreel {
namespace {

/// Drawing starts threads, and who has threads makes no more children: see Child.
constexpr double drawing_limit_s = 300;

/// A page wide at 300 dots per inch.
constexpr int print_width_px = 2400;
constexpr int print_height_px = 1500;

struct Figure {
  std::string name;
  std::string caption;
  Chart chart;
};

std::vector<Figure> work_figures(const Study& study, const StudyOutcome& outcome) {
  constexpr const char* names[] = {"work_precision", "work_precision_updates", "work_precision_instructions"};
  constexpr const char* captions[] = {"Error against CPU time.",
                                      "Error against updates, which are the same on every machine.",
                                      "Error against instructions."};
  std::vector<Figure> figures;
  for (int i = 0; i < work_axis_count; ++i) {
    if (auto chart = work_precision_chart(study, outcome.results, static_cast<WorkAxis>(i))) {
      figures.push_back(
          {names[i], std::string(captions[i]) + " Point at a symbol for its figures.", std::move(*chart)});
    }
  }
  return figures;
}

std::vector<Figure> figures_of(const Study& study, const StudyOutcome& outcome, const StudyWork& work) {
  std::vector<Figure> figures = work_figures(study, outcome);
  const std::vector<std::size_t> runs = runs_of_equal_cost(study, outcome.results);
  if (runs.empty()) return figures;
  const std::vector<Trace> traces = traces_of(study, runs, work, [](std::int64_t, std::int64_t) {});
  figures.push_back({"error_over_time", "Error over time.", error_chart(study, runs, traces)});
  figures.push_back(
      {"energy_drift", "Energy drift over time.", energy_chart(study, runs, traces, outcome.energy_scale_j)});
  if (auto chart = phase_chart(study, runs, traces))
    figures.push_back({"phase_portrait", "Phase portrait.", std::move(*chart)});
  return figures;
}

/// A figure for print, and the same for pages, through one pipe: the PNG's length, the PNG, the SVG.
std::string drawn(const Figure& figure, std::optional<GlBackend> gl) {
  const std::unique_ptr<GlContext> context = make_context(gl);
  Canvas canvas(*context, print_width_px, print_height_px);
  const Drawing drawing = laid_out(figure.chart, canvas, print_width_px, print_height_px);
  draw(canvas, drawing);
  Image image;
  canvas.finish(image);
  const std::vector<std::uint8_t> png = encode_png(image);
  return std::to_string(png.size()) + ":" + std::string(png.begin(), png.end()) + svg_of(drawing, figure.chart.title);
}

struct DrawnFigure {
  std::string png;
  std::string svg;
};

DrawnFigure draw_in_child(const Figure& figure, std::optional<GlBackend> gl) {
  const ChildEnd end = Child([&] { return drawn(figure, gl); }, drawing_limit_s).end();
  const std::size_t colon = end.answer.find(':');
  if (colon == std::string::npos)
    throw EnvironmentError("The figure " + figure.name + " could not be drawn. " + end.died_of);
  const std::size_t size = std::stoul(end.answer.substr(0, colon));
  return {end.answer.substr(colon + 1, size), end.answer.substr(colon + 1 + size)};
}

/// Those of another study in the same folder, which may have had figures that this one has not.
void remove_figures(const std::filesystem::path& folder) {
  for (const char* name : {"work_precision", "work_precision_updates", "work_precision_instructions", "error_over_time",
                           "energy_drift", "phase_portrait"}) {
    std::error_code ignored;
    for (const char* ending : {".png", ".svg"}) std::filesystem::remove(folder / (std::string(name) + ending), ignored);
  }
}

Json number_or_null(std::optional<double> value) {
  return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}
Json count_or_null(std::optional<std::int64_t> value) { return value ? Json(*value) : Json(nullptr); }

Json json_of_method(const Study& study, const std::vector<StudyResult>& results, std::size_t method) {
  std::vector<double> steps;
  std::vector<std::optional<double>> errors;
  const auto [first, last] = runs_of(study, method);
  for (std::size_t i = first; i < last; ++i) {
    steps.push_back(study.runs[i].step_s);
    errors.push_back(results[i].errors.empty() ? std::nullopt : results[i].errors[0]);
  }
  const auto fitted = fitted_order(steps, errors);
  const StudiedMethod& m = study.methods[method];
  return {{"name", m.name},
          {"engine", m.peer ? name_of(*m.peer) : "proofreel"},
          {"order", fitted ? Json(fitted->order) : Json(nullptr)},
          {"floor", number_or_null(error_floor(errors))}};
}

Json json_of_run(const Study& study, const StudyRun& run, const StudyResult& r, bool on_front) {
  Json set = Json::object();
  for (const Override& each : run.set) set[each.key] = each.value;
  Json errors = Json::object();
  for (std::size_t i = 0; i < study.measures.size(); ++i)
    errors[study.measures[i].name] = number_or_null(i < r.errors.size() ? r.errors[i] : std::nullopt);
  return {{"method", study.methods[run.method].name},
          {"set", set},
          {"status", name_of(r.status)},
          {"why", r.why},
          {"errors", errors},
          {"energy_error", number_or_null(r.energy_error)},
          {"cpu_s", number_or_null(r.cpu_s)},
          {"cpu_ms_per_s", number_or_null(work_of(r, WorkAxis::cpu))},
          {"row_updates", count_or_null(r.row_updates)},
          {"evaluations", count_or_null(r.evaluations)},
          {"instructions", count_or_null(r.instructions)},
          {"on_front", on_front}};
}

}  // namespace

Json json_of(const Study& study, const StudyOutcome& outcome) {
  std::vector<std::optional<double>> work;
  for (const StudyResult& result : outcome.results) work.push_back(work_of(result, WorkAxis::cpu));
  const std::vector<bool> front = pareto_front(work, first_errors(outcome.results));
  Json measures = Json::array();
  for (const StudiedMeasure& measure : study.measures)
    measures.push_back({{"name", measure.name}, {"has_reference", measure.has_reference}});
  Json methods = Json::array();
  for (std::size_t i = 0; i < study.methods.size(); ++i) methods.push_back(json_of_method(study, outcome.results, i));
  Json runs = Json::array();
  for (std::size_t i = 0; i < study.runs.size(); ++i)
    runs.push_back(json_of_run(study, study.runs[i], outcome.results[i], front[i]));
  return {{"scenario", study.scenario},
          {"samples_per_s", study.samples_per_s},
          {"measures", measures},
          {"energy_scale_j", outcome.energy_scale_j},
          {"verdict", verdict_of(study, outcome.results)},
          {"methods", methods},
          {"runs", runs},
          {"left_out", study.left_out}};
}

void write_study_files(const Study& study, const StudyOutcome& outcome, const StudyWork& work,
                       std::optional<GlBackend> gl, const std::string& command, const std::string& version) {
  const std::filesystem::path folder(work.folder);
  const std::vector<Figure> figures = figures_of(study, outcome, work);
  remove_figures(folder);
  PageFacts facts{command, version, machine_name(), {}, "study.csv"};
  std::vector<PageFigure> on_page;
  for (const Figure& figure : figures) {
    const DrawnFigure made = draw_in_child(figure, gl);
    write_file((folder / (figure.name + ".png")).string(), made.png);
    write_file((folder / (figure.name + ".svg")).string(), made.svg);
    on_page.push_back({made.svg, figure.caption});
    for (const char* ending : {".png", ".svg"}) facts.maps.push_back(figure.name + ending);
  }
  write_file((folder / "study.json").string(), json_text(json_of(study, outcome), 2) + "\n");
  write_file((folder / "study.html").string(), page_of(study, outcome, on_page, facts));
}

}  // namespace proofreel
