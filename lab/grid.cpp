#include "lab/grid.h"

#include <algorithm>
#include <array>
#include <map>

#include "engine/state_hash.h"
#include "golden/hex.h"
#include "lab/sources_hash.h"

namespace proofreel {
namespace {

struct StandingNames {
  const char* name;
  const char* sign;
};
constexpr std::array<StandingNames, standing_count> standing_names{{{"stands", "\u2713"},
                                                                    {"degrades", "\u2248"},
                                                                    {"fails", "\u2717"},
                                                                    {"too slow", "\u2026"},
                                                                    {"not offered", "\u2013"}}};

constexpr std::array method_keys{"rate", "substeps", "contact_solver", "joint_solver", "precision"};
constexpr std::array integrator_names{"symplectic_euler",  "verlet",         "suzuki4", "rk4",
                                      "implicit_midpoint", "gauss_legendre6"};
constexpr std::array contact_solver_names{"auto", "soft_step", "sequential_impulses", "ngs", "exact", "event"};

/// What decides how a run comes out, beside the texts it is made from.
using Settings = std::map<std::string, std::string>;

std::string short_key(const std::string& key) {
  constexpr std::string_view method = "method.";
  return key.starts_with(method) ? key.substr(method.size()) : key;
}

Settings settings_of(const Scenario& scenario, std::optional<Peer> peer, const std::vector<Override>& set) {
  Settings settings;
  for (const char* key : method_keys) settings[key] = *own_setting(scenario, key);
  for (const Override& override : set) settings[short_key(override.key)] = override.value;
  if (!peer) return settings;
  for (const char* key : {"substeps", "contact_solver", "joint_solver"}) settings[key].clear();
  settings["precision"] = *peer == Peer::box2d ? "single" : "double";
  return settings;
}

std::string key_of(const RunRequest& run, const Scenario& scenario, const Settings& settings) {
  std::string text =
      std::string(sources_hash()) + "\n" + run.scenario + "\n" + hex(scenario.source_hash) + "\n" + engine_of(run);
  for (const auto& [key, value] : settings) text.append("\n").append(key).append("=").append(value);
  return hex(hash_of(text.data(), text.size()));
}

}  // namespace

const char* name_of(Standing standing) { return standing_names[static_cast<std::size_t>(standing)].name; }
const char* sign_of(Standing standing) { return standing_names[static_cast<std::size_t>(standing)].sign; }

std::optional<Standing> standing_named(std::string_view name) {
  for (int i = 0; i < standing_count; ++i) {
    const auto standing = static_cast<Standing>(i);
    if (name == name_of(standing)) return standing;
  }
  return std::nullopt;
}

std::optional<double> RunResult::cost_ms() const {
  if (standing == Standing::too_slow || standing == Standing::not_offered || simulated_s <= 0) return std::nullopt;
  return 1e3 * cpu_s / simulated_s;
}

std::string engine_of(const RunRequest& run) { return run.peer ? name_of(*run.peer) : "proofreel"; }

std::optional<std::string> own_setting(const Scenario& scenario, const std::string& key) {
  const Method& method = scenario.scene.method;
  if (key == "rate") return std::to_string(scenario.scene.rate);
  if (key == "substeps") return std::to_string(method.substeps);
  if (key == "contact_solver") return contact_solver_names[static_cast<std::size_t>(method.contact_solver)];
  if (key == "integrator") return integrator_names[static_cast<std::size_t>(method.integrator)];
  if (key == "joint_solver") return method.joint_solver == JointMethod::direct ? "direct" : "iterative";
  if (key == "precision") return method.precision == Precision::float64 ? "double" : "single";
  return std::nullopt;
}

RunRequest request(const Scenario& scenario, std::optional<Peer> peer, const std::vector<Override>& set,
                   const std::vector<std::string>& keys) {
  if (scenario.expectations.empty()) {
    throw ScenarioError(scenario.path + ": has no expectation that could say whether it stands: add an expect(...)");
  }
  RunRequest run{scenario.path, scenario.id, peer, set, {}, false, {}};
  Settings settings = settings_of(scenario, peer, set);
  run.key = key_of(run, scenario, settings);
  for (const std::string& key : keys) run.values.push_back(settings[short_key(key)]);
  return run;
}

std::vector<Override> overlaid(const std::vector<Override>& set, const std::vector<Override>& above) {
  std::vector<Override> all;
  for (const Override& under : set) {
    const auto is_over = [&](const Override& over) { return short_key(over.key) == short_key(under.key); };
    if (std::none_of(above.begin(), above.end(), is_over)) all.push_back(under);
  }
  all.insert(all.end(), above.begin(), above.end());
  return all;
}

std::vector<bool> cheapest(const Grid& grid, const std::vector<RunResult>& results) {
  std::vector<bool> chosen(results.size(), false);
  const std::size_t group = grid.one_scenario ? results.size() : grid.columns.size();
  for (std::size_t first = 0; first < results.size(); first += group) {
    std::optional<std::size_t> best;
    for (std::size_t i = first; i < first + group; ++i) {
      if (results[i].standing != Standing::stands || !results[i].cost_ms()) continue;
      if (!best || *results[i].cost_ms() < *results[*best].cost_ms()) best = i;
    }
    if (best) chosen[*best] = true;
  }
  return chosen;
}

}  // namespace proofreel
