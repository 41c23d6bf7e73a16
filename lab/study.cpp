#include "lab/study.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "engine/state_hash.h"
#include "golden/hex.h"
#include "lab/csv.h"
#include "lab/grid.h"
#include "lab/sources_hash.h"
#include "render/usage_error.h"
#include "scenarios/runner.h"
#include "scenarios/scenario.h"
#include "scenarios/suggest.h"

namespace proofreel {
namespace {

constexpr std::array<const char*, 4> status_names{"ended", "failed", "too slow", "not offered"};

const std::vector<Axis>& default_axes() {
  static const std::vector<Axis> axes{
      {"integrator", {"symplectic_euler", "verlet", "suzuki4", "rk4", "implicit_midpoint", "gauss_legendre6"}},
      {"rate", {"60", "120", "240", "480", "960", "1920", "3840"}}};
  return axes;
}

/// Samples of a run are at most about this many.
constexpr double most_samples = 1000;

bool is_key(const Axis& axis, const char* name) { return full_key(axis) == full_key({name, {"1"}}); }

std::vector<StudiedMeasure> all_measures(const Scenario& scenario) {
  std::vector<StudiedMeasure> measures;
  for (std::size_t i = 0; i < scenario.measures.size(); ++i) {
    measures.push_back({scenario.measures[i].name, static_cast<int>(i), scenario.measures[i].has_reference});
  }
  return measures;
}

std::vector<StudiedMeasure> chosen_measures(const Scenario& scenario, const std::vector<std::string>& names) {
  const std::vector<StudiedMeasure> all = all_measures(scenario);
  if (all.empty())
    throw UsageError(scenario.path +
                     " measures nothing: add measure(\"name\", function), and a reference if there is one.");
  std::vector<std::string> known;
  std::vector<StudiedMeasure> chosen;
  for (const StudiedMeasure& measure : all) {
    known.push_back(measure.name);
    if (measure.has_reference) chosen.push_back(measure);
  }
  if (names.empty()) return chosen.empty() ? all : chosen;
  chosen.clear();
  for (const std::string& name : names) {
    const auto found = std::find(known.begin(), known.end(), name);
    if (found == known.end())
      throw UsageError("--measure " + name + ": " + scenario.path + " has no such measure; " +
                       did_you_mean(name, known) + ".");
    const StudiedMeasure& measure = all[static_cast<std::size_t>(found - known.begin())];
    const auto is_same = [&](const StudiedMeasure& other) { return other.index == measure.index; };
    if (std::none_of(chosen.begin(), chosen.end(), is_same)) chosen.push_back(measure);
  }
  return chosen;
}

/// One value of every axis.
using Choice = std::vector<std::string>;

/// All choices, the last axis running fastest.
std::vector<Choice> choices_of(const std::vector<Axis>& axes) {
  std::vector<Choice> choices(1);
  for (const Axis& axis : axes) {
    std::vector<Choice> longer;
    for (const Choice& choice : choices) {
      for (const std::string& value : axis.values) {
        longer.push_back(choice);
        longer.back().push_back(value);
      }
    }
    choices = std::move(longer);
  }
  return choices;
}

/// `integrator=verlet,rk4` names its methods by the values alone; of numbers the key is told too.
std::string part_of_name(const Axis& axis, const std::string& value) {
  const bool is_number = number_in(value).has_value();
  return is_number ? axis.key + " " + value : value;
}

/// Another scene is another problem, whose error says nothing beside this one's.
void refuse_scene_key(const Axis& axis) {
  const std::string key = full_key(axis);
  if (key == "rate" || key.starts_with("method.")) return;
  throw UsageError("--vary " + axis.key +
                   ": a study compares methods on one scene, so that only the rate and the keys of " +
                   "method may vary; set others with --set (maps take any key: --map).");
}

class Planner {
 public:
  explicit Planner(const StudyRequest& request)
      : request_(request), axes_(request.axes.empty() ? default_axes() : request.axes) {
    scenario_ = load_scenario(request.file, request.set);
    must_be_one_scene(*scenario_);
    for (const Axis& axis : axes_) {
      refuse_scene_key(axis);
      check_axis(request.file, axis, request.set);
    }
    refine_last();
  }

  Study plan() {
    study_.file = scenario_->path;
    study_.scenario = scenario_->id;
    study_.title = scenario_->title;
    study_.duration_s = scenario_->duration;
    study_.set = request_.set;
    study_.measures = chosen_measures(*scenario_, request_.measures);
    for (const Axis& axis : axes_) study_.keys.push_back(axis.key);
    add_own_methods();
    for (const Peer peer : request_.peers) add_peer(peer);
    study_.fps = scenario_->picture.fps;
    rates_.insert(study_.fps);
    study_.samples_per_s = samples_for(rates_, study_.duration_s);
    for (StudyRun& run : study_.runs) run.key = key_of(run);
    if (study_.methods.empty()) throw UsageError("Nothing is left to be run: " + study_.left_out.front());
    return std::move(study_);
  }

 private:
  /// The axis along a curve is the last one, and its values go from coarse to fine.
  void refine_last() {
    for (const char* key : {"rate", "substeps"}) {
      const auto found = std::find_if(axes_.begin(), axes_.end(), [&](const Axis& axis) { return is_key(axis, key); });
      if (found == axes_.end()) continue;
      std::rotate(found, found + 1, axes_.end());
      study_.refined = key;
      std::vector<std::string>& values = axes_.back().values;
      std::sort(values.begin(), values.end(), [](const std::string& a, const std::string& b) {
        return number_in(a).value_or(0) < number_in(b).value_or(0);
      });
      return;
    }
  }

  bool is_refined() const { return !study_.refined.empty(); }

  void add_own_methods() {
    std::vector<Axis> apart = axes_;
    if (is_refined()) apart.pop_back();
    for (const Choice& choice : choices_of(apart)) {
      StudiedMethod method{"", {}, PeerPreset::standard, {}};
      for (std::size_t i = 0; i < choice.size(); ++i) {
        method.set.push_back({apart[i].key, choice[i]});
        method.name.append(i == 0 ? "" : ", ").append(part_of_name(apart[i], choice[i]));
      }
      if (method.name.empty()) method.name = "proofreel";
      if (!is_offered(method)) continue;
      study_.methods.push_back(method);
      add_runs(choice, is_refined() ? axes_.back().values : std::vector<std::string>{""});
    }
  }

  bool is_offered(const StudiedMethod& method) {
    try {
      load_scenario(request_.file, overlaid(request_.set, method.set));
      return true;
    } catch (const ScenarioError& error) {
      const std::string path = scenario_->path + ": ";
      const std::string what = error.what();
      study_.left_out.push_back(method.name + ": " + (what.starts_with(path) ? what.substr(path.size()) : what) + ".");
      return false;
    }
  }

  void add_peer(Peer peer) {
    if (const auto problem = problem_for_peer(peer, scenario_->scene)) {
      study_.left_out.push_back(*problem + ".");
      return;
    }
    for (const PeerPreset preset : {PeerPreset::standard, PeerPreset::accurate}) {
      const std::string name = name_of(peer) + std::string(preset == PeerPreset::accurate ? ", accurate" : "");
      study_.methods.push_back({name, peer, preset, {}});
      add_runs(Choice(axes_.size() - (is_refined() ? 1 : 0)), peer_steps());
    }
  }

  /// Peers have no substeps: where these vary, they take as many steps.
  std::vector<std::string> peer_steps() const {
    if (study_.refined == "rate") return axes_.back().values;
    if (study_.refined.empty()) return {""};
    std::vector<std::string> rates;
    for (const std::string& substeps : axes_.back().values) {
      rates.push_back(std::to_string(static_cast<int>(number_in(substeps).value_or(1)) * scenario_->scene.rate));
    }
    return rates;
  }

  void add_runs(const Choice& choice, const std::vector<std::string>& steps) {
    const StudiedMethod& method = study_.methods.back();
    for (const std::string& step : steps) {
      StudyRun run{study_.methods.size() - 1, overlaid(request_.set, method.set), choice, 0, {}};
      const std::string refined = method.peer && is_refined() ? "rate" : study_.refined;
      if (!step.empty()) run.set = overlaid(run.set, {{refined, step}});
      if (is_refined()) run.values.push_back(step);
      run.step_s = step_of(run, method);
      study_.runs.push_back(std::move(run));
    }
  }

  /// What the run's own rate and substeps make; those it does not replace are the scenario's.
  double step_of(const StudyRun& run, const StudiedMethod& method) {
    int rate = scenario_->scene.rate;
    int substeps = scenario_->scene.method.substeps;
    for (const Override& each : run.set) {
      const double value = number_in(each.value).value_or(0);
      if (is_key({each.key, {each.value}}, "rate")) rate = static_cast<int>(value);
      if (is_key({each.key, {each.value}}, "substeps")) substeps = static_cast<int>(value);
    }
    rates_.insert(rate);
    return 1.0 / (static_cast<double>(rate) * (method.peer ? 1 : substeps));
  }

  std::string key_of(const StudyRun& run) const {
    const StudiedMethod& method = study_.methods[run.method];
    std::string text = std::string(sources_hash()) + "\n" + study_.scenario + "\n" + hex(scenario_->source_hash);
    text += method.peer ? std::string("\n") + name_of(*method.peer) : std::string("\nproofreel");
    text += method.preset == PeerPreset::accurate ? " accurate" : "";
    for (const Override& each : run.set) text.append("\n").append(each.key).append("=").append(each.value);
    text += "\nsamples=" + std::to_string(study_.samples_per_s);
    const auto [first, last] = runs_of(study_, run.method);
    for (const StudiedMeasure& measure : study_.measures) {
      text.append("\n").append(measure.name);
      if (!measure.has_reference) text += " against " + exact(study_.runs[last - 1].step_s / finer_steps);
    }
    return hex(hash_of(text.data(), text.size()));
  }

  const StudyRequest& request_;
  std::vector<Axis> axes_;
  std::unique_ptr<Scenario> scenario_;
  std::set<int> rates_;
  Study study_;
};

}  // namespace

const char* name_of(RunStatus status) { return status_names[static_cast<std::size_t>(status)]; }

std::optional<RunStatus> run_status_named(std::string_view name) {
  for (std::size_t i = 0; i < status_names.size(); ++i) {
    if (name == status_names[i]) return static_cast<RunStatus>(i);
  }
  return std::nullopt;
}

int samples_for(const std::set<int>& rates, double duration_s) {
  int common = 0;
  for (const int rate : rates) common = std::gcd(common, rate);
  int best = 1;
  for (int divisor = 1; divisor <= common; ++divisor) {
    if (common % divisor == 0 && divisor * duration_s <= most_samples) best = divisor;
  }
  return best;
}

Study plan_study(const StudyRequest& request) { return Planner(request).plan(); }

std::pair<std::size_t, std::size_t> runs_of(const Study& study, std::size_t method) {
  const auto is_of = [method](const StudyRun& run) { return run.method == method; };
  const auto first = std::find_if(study.runs.begin(), study.runs.end(), is_of);
  const auto last = std::find_if_not(first, study.runs.end(), is_of);
  return {static_cast<std::size_t>(first - study.runs.begin()), static_cast<std::size_t>(last - study.runs.begin())};
}

}  // namespace proofreel
