#include "lab/target.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "lab/csv.h"
#include "lab/grid.h"
#include "lab/study_run.h"

namespace proofreel {
namespace {

/// The study with nothing in it but one run.
Study single(const Study& study, std::size_t method, int rate) {
  Study one = study;
  one.methods = {study.methods[method]};
  StudyRun run = study.runs[runs_of(study, method).first];
  run.method = 0;
  run.set = overlaid(run.set, {{"rate", std::to_string(rate)}});
  one.runs = {run};
  one.refined = "rate";
  one.samples_per_s = samples_for({rate, study.fps}, study.duration_s);
  return one;
}

/// A number bare, words in quotes, a list as it is.
std::string lua_value(const std::string& value) {
  const bool bare = number_in(value) || value == "true" || value == "false" || value.starts_with("{");
  return bare ? value : "\"" + value + "\"";
}

/// What scenario{} has to say for the same steps: the whole method as the run has it, since a pasted `method` replaces
/// the scenario's own. Empty for peers.
std::string line_of(const Study& study, const StudiedMethod& method, int rate) {
  if (method.peer) return {};
  constexpr std::string_view in_method = "method.";
  std::map<std::string, std::string> inside;
  const std::unique_ptr<Scenario> scenario = load_scenario(study.file, overlaid(study.set, method.set));
  Scenario plain;
  for (const char* key : {"substeps", "contact_solver", "joint_solver", "precision"}) {
    const std::string own = *own_setting(*scenario, key);
    if (own != *own_setting(plain, key)) inside[key] = own;
  }
  inside["integrator"] = *own_setting(*scenario, "integrator");
  for (const Override& each : overlaid(study.set, method.set)) {
    const std::string key = full_key({each.key, {each.value}});
    if (key.starts_with(in_method)) inside[key.substr(in_method.size())] = each.value;
  }
  std::string list;
  for (const auto& [key, value] : inside) list += (list.empty() ? "" : ", ") + key + " = " + lua_value(value);
  return "method = { " + list + " }, rate = " + std::to_string(rate);
}

/// What the search of one method finds, through a pipe: rate, error, error below; or nothing.
std::string found(const Study& study, std::size_t method, double target, double limit_s) {
  const auto error_at = [&](int grains) { return error_at_rate(study, method, grains * rate_grain, limit_s); };
  const auto meets = [&](std::optional<double> error) { return error && *error <= target; };
  int high = 1;
  std::optional<double> high_error = error_at(high);
  int low = 0;
  std::optional<double> low_error;
  while (!meets(high_error)) {
    low = high;
    low_error = high_error;
    high *= 2;
    if (high * rate_grain > highest_rate) return {};
    high_error = error_at(high);
  }
  while (high - low > 1) {
    const int middle = (low + high) / 2;
    const std::optional<double> error = error_at(middle);
    (meets(error) ? high : low) = middle;
    (meets(error) ? high_error : low_error) = error;
  }
  return csv_line({std::to_string(high * rate_grain), exact(*high_error), low_error ? exact(*low_error) : ""});
}

PlannedMethod planned(const Study& study, const StudiedMethod& method, const ChildEnd& end) {
  PlannedMethod plan;
  plan.name = method.name;
  if (!end.died_of.empty() || end.out_of_time) {
    plan.why_not = end.out_of_time ? "the search was stopped at its limit" : "the engine crashed: " + end.died_of;
    return plan;
  }
  if (end.answer.empty()) {
    plan.why_not =
        "at none of the rates up to " + std::to_string(highest_rate) + " does it come to its end in time and reach it";
    return plan;
  }
  const CsvRecord record = csv_records(end.answer).at(0);
  plan.rate = static_cast<int>(number_in(record[0]).value());
  plan.error = number_in(record[1]).value();
  plan.error_below = number_in(record[2]);
  plan.line = line_of(study, method, *plan.rate);
  return plan;
}

/// A search takes a few dozen runs.
constexpr double runs_of_search = 40;

}  // namespace

std::optional<double> error_at_rate(const Study& study, std::size_t method, int rate, double limit_s) {
  const Study one = single(study, method, rate);
  const StudiedMeasure& measure = one.measures.front();
  Trace trace = trace_of(one, one.runs[0], limit_s);
  if (trace.status != RunStatus::ended) return std::nullopt;
  if (!measure.has_reference) {
    const Trace finer = trace_of(one, finer_run(one, 0), finer_steps * limit_s);
    if (finer.status != RunStatus::ended) return std::nullopt;
    trace.expected[0].assign(finer.values[0].begin(), finer.values[0].end());
  }
  return error_of(trace.values[0], trace.expected[0]);
}

std::vector<Axis> axes_of_search(std::vector<Axis> given) {
  const auto is_rate = [](const Axis& axis) { return axis.key == "rate"; };
  if (!given.empty() && std::none_of(given.begin(), given.end(), is_rate)) {
    given.push_back({"rate", {std::to_string(rate_grain)}});
  }
  return given;
}

std::vector<PlannedMethod> plan_for(const Study& study, double target, const StudyWork& work,
                                    const WorkProgress& progress) {
  std::vector<PlannedMethod> plans(study.methods.size());
  const auto search = [&](std::size_t i) {
    return ChildWork{[&, i] { return found(study, i, target, work.limit_s); }, runs_of_search * work.limit_s};
  };
  const auto keep = [&](std::size_t i, const ChildEnd& end) { plans[i] = planned(study, study.methods[i], end); };
  work_off_children(plans.size(), work.at_once, search, keep, progress);
  for (std::size_t i = 0; i < plans.size(); ++i) {
    if (!plans[i].rate) continue;
    const Study one = single(study, i, *plans[i].rate);
    const ChildEnd end =
        Child([&] { return exact(cpu_time_of(one, one.runs[0], work.limit_s)); }, runs_of_search * work.limit_s).end();
    if (const auto cpu_s = number_in(end.answer)) plans[i].cost_ms = 1e3 * *cpu_s / study.duration_s;
  }
  std::stable_sort(plans.begin(), plans.end(), [](const PlannedMethod& a, const PlannedMethod& b) {
    return a.cost_ms.value_or(INFINITY) < b.cost_ms.value_or(INFINITY);
  });
  return plans;
}

}  // namespace proofreel
