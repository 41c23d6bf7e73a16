#include "lab/study_charts.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "lab/score_text.h"
#include "scenarios/formatted.h"

namespace proofreel {
namespace {

constexpr std::array<const char*, work_axis_count> work_labels{
    "CPU time per simulated second (ms)", "updates of constraint rows and body forces per simulated second",
    "instructions per simulated second"};

std::string reference_words(const StudiedMeasure& measure) {
  if (measure.has_reference) return "Reference: the scenario\u2019s own, for \u201C" + measure.name + "\u201D.";
  return "No reference is known for \u201C" + measure.name + "\u201D: each method is compared with itself at a step " +
         std::to_string(finer_steps) + " times smaller than its smallest here, which shows consistency and not truth.";
}

std::string fairness_note(const Study& study) {
  std::string note = "Error: max |q \u2212 reference| over " + std::to_string(study.samples_per_s) +
                     " samples a second and the end, over the largest |reference|. ";
  return note + reference_words(study.measures.front());
}

/// The results of one method's runs, as lists.
struct MethodData {
  std::vector<double> steps_s;
  std::vector<std::optional<double>> errors;
  std::vector<std::optional<double>> work;
  std::size_t first = 0;
};

MethodData data_of(const Study& study, const std::vector<StudyResult>& results, WorkAxis axis, std::size_t method) {
  MethodData data;
  const auto [first, last] = runs_of(study, method);
  data.first = first;
  for (std::size_t i = first; i < last; ++i) {
    data.steps_s.push_back(study.runs[i].step_s);
    data.errors.push_back(results[i].errors.empty() ? std::nullopt : results[i].errors[0]);
    data.work.push_back(work_of(results[i], axis));
  }
  return data;
}

std::string note_of(const MethodData& data, const std::optional<double>& floor) {
  std::string note;
  if (const auto fitted = fitted_order(data.steps_s, data.errors)) note = "order " + formatted("%.2f", fitted->order);
  if (floor) note.append(note.empty() ? "" : ", ").append("not below ").append(formatted("%.1e", *floor));
  return note.empty() && data.steps_s.size() > 2 ? "no clear order" : note;
}

ChartCurve curve_of(const Study& study, const std::vector<StudyResult>& results, const MethodData& data,
                    const std::string& name, const std::vector<bool>& front) {
  ChartCurve curve;
  curve.name = name;
  curve.floor = error_floor(data.errors);
  curve.note = note_of(data, curve.floor);
  for (std::size_t k = 0; k < data.errors.size(); ++k) {
    const std::size_t i = data.first + k;
    const std::string words = words_of(study, study.runs[i], results[i]);
    constexpr double exact_run = 1e-17;  // what differs in no bit has a place on a logarithmic axis, too
    const Vec2d at{data.work[k].value_or(0), std::max(exact_run, data.errors[k].value_or(0))};
    const bool has_ended = results[i].status == RunStatus::ended && data.errors[k] && std::isfinite(*data.errors[k]);
    if (!has_ended) curve.failures.push_back({at, words});
    if (has_ended && data.work[k]) curve.points.push_back({at, words, !front[i]});
  }
  return curve;
}

/// One triangle for every order that is met with, at the first method that has it.
void add_triangle(Chart& chart, const MethodData& data) {
  const auto fitted = fitted_order(data.steps_s, data.errors);
  if (!fitted || !data.work[fitted->first] || !data.work[fitted->last]) return;
  const std::string label = formatted("%.0f", fitted->order);
  const auto has_label = [&](const SlopeTriangle& triangle) { return triangle.label == label; };
  if (label == "0" || std::any_of(chart.triangles.begin(), chart.triangles.end(), has_label)) return;
  SlopeTriangle triangle{{}, -std::round(fitted->order), label};
  const auto middle = [](std::optional<double> a, std::optional<double> b) { return a && b ? std::sqrt(*a * *b) : 0; };
  for (std::size_t i = fitted->last; i-- > 0;) {
    triangle.places.push_back({middle(data.work[i], data.work[i + 1]), middle(data.errors[i], data.errors[i + 1])});
  }
  chart.triangles.push_back(std::move(triangle));
}

/// A curve over time per run; `values` of a run's trace.
template <typename Values>
void add_curves(Chart& chart, const Study& study, const std::vector<std::size_t>& runs,
                const std::vector<Trace>& traces, const Values& values) {
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const StudyRun& run = study.runs[runs[i]];
    ChartCurve curve;
    curve.name = study.methods[run.method].name;
    curve.note = step_name(study, run);
    curve.marked = false;
    for (const Vec2d& p : values(traces[i])) curve.points.push_back({p, ""});
    chart.curves.push_back(std::move(curve));
  }
}

std::vector<Vec2d> zipped(const std::vector<double>& xs, const std::vector<double>& ys) {
  std::vector<Vec2d> points;
  for (std::size_t i = 0; i < std::min(xs.size(), ys.size()); ++i) points.push_back({xs[i], ys[i]});
  return points;
}

constexpr const char* equal_cost_note =
    "Of each method the run whose CPU time is nearest to what all of them can spend.";

}  // namespace

std::string reference_words(const Study& study) {
  std::string words;
  for (const StudiedMeasure& measure : study.measures) {
    words.append(words.empty() ? "" : " ").append(reference_words(measure));
  }
  return words;
}

std::string words_of(const Study& study, const StudyRun& run, const StudyResult& r) {
  const std::string step = step_name(study, run);
  std::string words = study.methods[run.method].name + (step.empty() ? "" : ", " + step) + ": ";
  if (r.status != RunStatus::ended) return words + name_of(r.status) + (r.why.empty() ? "" : " (" + r.why + ")");
  const std::optional<double> error = r.errors.empty() ? std::nullopt : r.errors[0];
  words += error ? "error " + formatted("%.3g", *error) : std::string("no error known");
  if (r.energy_error) words += "; energy error " + formatted("%.3g", *r.energy_error);
  if (const auto work = work_of(r, WorkAxis::cpu))
    words += "; " + formatted("%.3g", *work) + " ms per simulated second";
  if (r.collision_share) words += ", " + formatted("%.0f", 100 * *r.collision_share) + " % of it collision";
  if (const auto work = work_of(r, WorkAxis::updates))
    words += "; " + formatted("%.0f", *work) + " updates per simulated second";
  if (const auto work = work_of(r, WorkAxis::instructions))
    words += "; " + formatted("%.3g", *work) + " instructions per simulated second";
  return words;
}

std::optional<Chart> work_precision_chart(const Study& study, const std::vector<StudyResult>& results, WorkAxis axis) {
  std::vector<std::optional<double>> work;
  for (const StudyResult& result : results) work.push_back(work_of(result, axis));
  if (std::none_of(work.begin(), work.end(), [](const auto& w) { return w.has_value(); })) return std::nullopt;
  const std::vector<std::optional<double>> errors = first_errors(results);
  const std::vector<bool> front = pareto_front(work, errors);
  Chart chart;
  chart.title = study.title + ": what accuracy costs";
  chart.notes.push_back(fairness_note(study));
  chart.x = {work_labels[static_cast<std::size_t>(axis)], true};
  chart.y = {"error of " + study.measures.front().name, true};
  for (std::size_t m = 0; m < study.methods.size(); ++m) {
    const MethodData data = data_of(study, results, axis, m);
    if (axis != WorkAxis::cpu && std::none_of(data.work.begin(), data.work.end(), [](const auto& w) { return w; }))
      continue;
    chart.curves.push_back(curve_of(study, results, data, study.methods[m].name, front));
    add_triangle(chart, data);
  }
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < front.size(); ++i) {
    if (front[i]) order.push_back(i);
  }
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return *work[a] < *work[b]; });
  for (const std::size_t i : order) chart.front.push_back({*work[i], *errors[i]});
  return chart;
}

std::vector<std::size_t> runs_of_equal_cost(const Study& study, const std::vector<StudyResult>& results) {
  double affordable = INFINITY;  // by the method that can spend least
  std::vector<std::vector<std::size_t>> by_method(study.methods.size());
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (results[i].status == RunStatus::ended && work_of(results[i], WorkAxis::cpu))
      by_method[study.runs[i].method].push_back(i);
  }
  const auto cost = [&](std::size_t i) { return *work_of(results[i], WorkAxis::cpu); };
  for (const std::vector<std::size_t>& runs : by_method) {
    if (runs.size() > 1) affordable = std::min(affordable, std::sqrt(cost(runs.front()) * cost(runs.back())));
  }
  std::vector<std::size_t> chosen;
  for (const std::vector<std::size_t>& runs : by_method) {
    if (runs.empty()) continue;
    chosen.push_back(*std::min_element(runs.begin(), runs.end(), [&](std::size_t a, std::size_t b) {
      return std::abs(std::log(cost(a) / affordable)) < std::abs(std::log(cost(b) / affordable));
    }));
  }
  return chosen;
}

Chart error_chart(const Study& study, const std::vector<std::size_t>& runs, const std::vector<Trace>& traces) {
  Chart chart;
  chart.title = study.title + ": error over time";
  chart.notes = {equal_cost_note, reference_words(study.measures.front())};
  chart.x = {"time (s)", false};
  chart.y = {"error of " + study.measures.front().name, true};
  add_curves(chart, study, runs, traces, [](const Trace& trace) {
    if (trace.values.empty()) return std::vector<Vec2d>();
    std::vector<double> errors;
    for (const auto& error : errors_of(trace.values[0], trace.expected[0])) errors.push_back(error.value_or(NAN));
    return zipped(trace.times_s, errors);
  });
  return chart;
}

Chart energy_chart(const Study& study, const std::vector<std::size_t>& runs, const std::vector<Trace>& traces,
                   double energy_scale_j) {
  Chart chart;
  chart.title = study.title + ": energy drift";
  chart.notes = {equal_cost_note,
                 "Energy beyond what the run began with and the work done on it, over the largest "
                 "kinetic energy of the scene (" +
                     formatted("%.4g", energy_scale_j) + " J)."};
  chart.x = {"time (s)", false};
  chart.y = {"|energy drift|", true};
  add_curves(chart, study, runs, traces, [&](const Trace& trace) {
    std::vector<double> drifts;
    for (const double joules : trace.energy_drift_j)
      drifts.push_back(energy_scale_j > 0 ? std::abs(joules) / energy_scale_j : 0);
    return zipped(trace.times_s, drifts);
  });
  return chart;
}

std::optional<Chart> phase_chart(const Study& study, const std::vector<std::size_t>& runs,
                                 const std::vector<Trace>& traces) {
  if (study.measures.size() < 2) return std::nullopt;
  Chart chart;
  chart.title = study.title + ": phase portrait";
  chart.notes = {equal_cost_note};
  chart.x = {study.measures[0].name, false};
  chart.y = {study.measures[1].name, false};
  add_curves(chart, study, runs, traces, [](const Trace& trace) {
    return trace.values.empty() ? std::vector<Vec2d>() : zipped(trace.values[0], trace.values[1]);
  });
  return chart;
}

}  // namespace proofreel
