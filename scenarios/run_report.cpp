#include "scenarios/run_report.h"

#include <algorithm>

namespace proofreel {

std::string name_in_pane(const Scenario& pane, const std::string& name) {
  return pane.pane_title.empty() ? name : pane.pane_title + ": " + name;
}

std::vector<std::string> measure_names(const Scenario& scenario) {
  std::vector<std::string> names;
  for (const Measure& measure : scenario.measures) names.push_back(name_in_pane(scenario, measure.name));
  for (const auto& pane : scenario.other_panes) {
    for (const Measure& measure : pane->measures) names.push_back(name_in_pane(*pane, measure.name));
  }
  return names;
}

bool RunReport::all_held() const {
  return !failure && std::none_of(expectations.begin(), expectations.end(), [](const auto& e) { return e.failed(); });
}

}  // namespace proofreel
