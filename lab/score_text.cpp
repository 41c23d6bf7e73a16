#include "lab/score_text.h"

#include "scenarios/formatted.h"

namespace proofreel {
namespace {

void add(std::string& text, const char* format, std::optional<double> value) {
  if (value) text += formatted(format, *value);
}

}  // namespace

std::string cost_text(std::optional<double> cost_ms) {
  if (!cost_ms) return {};
  return formatted(*cost_ms < 0.0995  ? "%.3f"
                   : *cost_ms < 0.995 ? "%.2f"
                   : *cost_ms < 9.95  ? "%.1f"
                                      : "%.0f",
                   *cost_ms);
}

std::string name_of(const Heading& heading) {
  std::string name = heading.group;
  for (const std::string& part : {heading.name, heading.detail}) {
    if (!part.empty()) name.append(name.empty() ? "" : ", ").append(part);
  }
  return name;
}

std::string label_of(const Grid& grid, const Heading& heading) {
  return grid.one_scenario ? heading.group + " = " + heading.name : name_of({heading.group, heading.name, ""});
}

std::string details_of(const RunRequest& request, const RunResult& r) {
  std::string text = request.scenario + " by " + engine_of(request) + ": " + name_of(r.standing);
  if (!r.why.empty()) text.append(" (").append(r.why).append(")");
  add(text, "; %.3g ms of CPU time per simulated second", r.cost_ms());
  add(text, "; largest energy drift %.3g J", r.energy_drift_j);
  add(text, ", booked work %.3g J", r.booked_work_j);
  if (r.overlap_share) text += formatted("; at the end overlap %.2g %% of the thinner body", 100 * *r.overlap_share);
  if (r.joint_gap_m) text += formatted(", joint gap %.2g mm", 1e3 * *r.joint_gap_m);
  if (r.same_twice) text += *r.same_twice ? "; the same bits when run again" : "; OTHER bits when run again";
  return text;
}

}  // namespace proofreel
