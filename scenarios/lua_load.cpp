// Loading: from the file's text to a scenario that can run.

#include <algorithm>

#include "scenarios/effects.h"
#include "scenarios/film.h"
#include "scenarios/formatted.h"
#include "scenarios/lua_bodies.h"
#include "scenarios/lua_script.h"
#include "scenarios/lua_shapes.h"
#include "scenarios/lua_values.h"
#include "scenarios/lua_words.h"
#include "scenarios/source.h"
#include "scenarios/suggest.h"
#include "scenarios/timeline.h"

namespace proofreel {
namespace {

std::vector<std::string> global_names(lua_State* state) {
  std::vector<std::string> names;
  lua_pushglobaltable(state);
  for (lua_pushnil(state); lua_next(state, -2) != 0; lua_pop(state, 1)) names.emplace_back(lua_tostring(state, -2));
  lua_pop(state, 1);
  std::sort(names.begin(), names.end());
  return names;
}

std::string shown(double seconds) { return formatted("%.6g", seconds); }

bool is_overridden(const Model& model, const std::string& path) {
  return std::any_of(model.overrides.begin(), model.overrides.end(), [&](const auto& o) { return o.path == path; });
}

}  // namespace

LuaScript::LuaScript(Scenario& scenario, std::vector<ParsedOverride> overrides, std::size_t pane)
    : model_(scenario), sandbox_(scenario.path, &model_) {
  model_.overrides = std::move(overrides);
  model_.pane = pane;
}

void LuaScript::open(lua_State* state) {
  open_base(state);
  open_values(state);
  open_math(state);
  open_strings(state);
  open_tables(state);
  open_pairs(state);
  open_scenario(state);
  open_shapes(state);
  open_bodies(state);
  open_body_methods(state);
  open_joints(state);
  open_forces(state);
  open_time(state);
  open_picture(state);
  open_panes(state);
  open_film(state);
  open_demonstrate(state);
  open_measures(state);
  sandbox_.set_known_names(global_names(state));
}

void LuaScript::load(const std::string& text) {
  sandbox_.turn([&](lua_State* state) { open(state); });
  sandbox_.turn([&](lua_State* state) {
    sandbox_.compile(model_.scenario.path, text);
    lua_call(state, 0, 0);
    finish_loading();
  });
}

void LuaScript::finish_loading() {
  Scenario& scenario = model_.scenario;
  if (!model_.described) throw Problem("the file never calls scenario{...}; it must, once");
  time_stories();
  link_references();
  check_expectations();
  check_times();
  scenario.scene = model_.scene_so_far();
  for (const int function : model_.fields) scenario.scene.fields.push_back(force_field(function));
  model_.check_method();
  if (scenario.title.empty()) scenario.title = scenario.id;
  if (scenario.picture.force_scale == 0) scenario.picture.force_scale = usual_force_scale(scenario);
  if (!scenario.scene.effects) return;
  for (std::string& warning : omission_warnings(called_for_by(scenario.scene), *scenario.scene.effects)) {
    scenario.warnings.push_back(std::move(warning));
  }
}

/// A lecture film lasts as long as its steps, unless the scenario says otherwise.
void LuaScript::time_stories() {
  Scenario& scenario = model_.scenario;
  if (scenario.stories.empty()) return;
  if (!model_.panes.empty())
    throw Problem("demonstrate{...} divides the picture itself: such a scenario has no pane{...}");
  if (!model_.bodies.empty())
    throw Problem("demonstrate{...} films an algorithm: a scenario that has one has no bodies");
  if (model_.timed) return;
  scenario.duration = duration_of(scenario.stories);
  if (scenario.duration * scenario.scene.rate > most_ticks)
    throw Problem("demonstrate: the film would be longer than 100 million ticks: choose a smaller pace");
}

void LuaScript::link_references() {
  auto& measures = model_.scenario.measures;
  reference_of_.assign(measures.size(), -1);
  for (std::size_t r = 0; r < model_.references.size(); ++r) {
    const std::string& name = model_.references[r].measure;
    const auto found = std::find_if(measures.begin(), measures.end(), [&](const Measure& m) { return m.name == name; });
    if (found == measures.end()) {
      std::vector<std::string> names;
      for (const Measure& measure : measures) names.push_back(measure.name);
      throw Problem("reference " + quote(name) + ": there is no such measure, " + did_you_mean(name, names));
    }
    found->has_reference = true;
    for (const auto& [seconds, value] : model_.references[r].points) found->reference_times.push_back(seconds);
    reference_of_[static_cast<std::size_t>(found - measures.begin())] = static_cast<int>(r);
  }
}

/// An expectation after the end would hold unseen. A duration set from the command line may cut some off.
void LuaScript::check_expectations() {
  Scenario& scenario = model_.scenario;
  for (const Expectation& expectation : scenario.expectations) {
    if (expectation.when != Expectation::When::at) continue;
    if (tick_at(expectation.at, scenario.scene.rate) <= scenario.ticks()) continue;
    const std::string late = "expect " + quote(expectation.text) + " comes after the end of the scenario";
    if (!is_overridden(model_, "duration")) throw Problem(late);
    scenario.warnings.push_back(late + ": it is not looked at");
  }
}

/// What the file itself puts after its end would be dropped without a word. A duration set from the command line may
/// cut off what it likes, and callbacks may look ahead of it.
void LuaScript::check_times() const {
  const Scenario& scenario = model_.scenario;
  if (is_overridden(model_, "duration")) return;
  const auto check = [&](const std::string& what, double seconds) {
    if (tick_at(seconds, scenario.scene.rate) < scenario.ticks()) return;
    throw Problem(what + shown(seconds) + " never comes: the scenario ends at " + shown(scenario.duration) + " s");
  };
  for (const auto& [key, timer] : model_.timers) {
    const char* const word = timer.period > 0 ? "every: dt = " : "at: t = ";
    check(word, static_cast<double>(key.first) / scenario.scene.rate);
  }
  for (const CameraMove& move : scenario.picture.camera) check("camera: at = ", move.at);
  for (const Caption& caption : scenario.picture.captions)
    check("caption " + quote(caption.text) + ": from = ", caption.from);
  for (const Highlight& highlight : scenario.picture.highlights) check("highlight: from = ", highlight.from);
  for (const SlowMotion& slow : scenario.picture.slow) check("slow: from = ", slow.from);
  for (const Freeze& freeze : scenario.picture.freezes) check("freeze: at = ", freeze.at);
  for (const LayerChange& change : scenario.picture.layer_changes) check("layers: at = ", change.at);
  for (const Section& section : scenario.picture.sections)
    check("section " + quote(section.name) + ": at = ", section.at);
}

namespace {

/// What a scenario, or every pane of one, is made of.
struct Source {
  std::string path;
  std::string text;
  std::vector<ParsedOverride> overrides;
  std::map<std::string, std::string> settings;
};

struct Loaded {
  std::unique_ptr<Scenario> scenario;
  std::vector<PaneRecord> panes;
};

/// Runs the file; `own` replaces what is different in the pane that is made.
Loaded loaded(const Source& source, std::size_t pane, const std::vector<ParsedOverride>& own) {
  auto scenario = std::make_unique<Scenario>();
  scenario->path = source.path;
  scenario->id = id_of(source.path);
  scenario->settings = source.settings;
  std::vector<ParsedOverride> overrides = source.overrides;
  overrides.insert(overrides.end(), own.begin(), own.end());
  auto script = std::make_unique<LuaScript>(*scenario, std::move(overrides), pane);
  script->load(source.text);
  scenario->source_hash = script->source_hash();
  std::vector<PaneRecord> panes = script->panes();
  if (!panes.empty()) scenario->pane_title = panes[std::min(pane, panes.size() - 1)].title;
  scenario->script = std::move(script);
  return {std::move(scenario), std::move(panes)};
}

bool same_titles(const std::vector<PaneRecord>& a, const std::vector<PaneRecord>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const PaneRecord& p, const PaneRecord& q) { return p.title == q.title; });
}

/// What the panes have to say that the first has not said already.
void add_warnings_of(const Scenario& pane, Scenario& whole) {
  for (const std::string& warning : pane.warnings) {
    if (std::find(whole.warnings.begin(), whole.warnings.end(), warning) == whole.warnings.end())
      whole.warnings.push_back("pane " + quote(pane.pane_title) + ": " + warning);
  }
}

/// Runs the file for one pane of several; what is wrong in it only is told as such.
Loaded loaded_pane(const Source& source, std::size_t index, const PaneRecord& pane) {
  try {
    return loaded(source, index, pane.overrides);
  } catch (const ScenarioError& error) {
    const std::string text = error.what();
    const std::string name = "pane " + quote(pane.title);
    throw ScenarioError(text.find(name) == std::string::npos ? text + " (in " + name + ")" : text);
  }
}

/// What holds for the whole film, and the file can say in each pane anew.
void must_be_one_film(const Scenario& first, const Scenario& pane) {
  const auto check = [&](const char* key, bool same) {
    if (same) return;
    throw ScenarioError(in_file(pane) + key + " must be that of the first pane, " + quote(first.pane_title) +
                        ", because all panes are one film");
  };
  const Picture &film = first.picture, &other = pane.picture;
  check("duration", first.duration == pane.duration);
  check("fps", film.fps == other.fps);
  check("size", film.size == other.size);
  check("theme", film.theme == other.theme);
  check("slow", film.slow == other.slow);
  check("freeze", film.freezes == other.freezes);
  check("section", film.sections == other.sections);
}

std::unique_ptr<Scenario> with_panes(const Source& source, const std::vector<PaneRecord>& panes) {
  if (panes.size() == 1) throw ScenarioError(source.path + ": one pane{...} is no split screen: make two or more");
  std::unique_ptr<Scenario> whole;
  for (std::size_t i = 0; i < panes.size(); ++i) {
    Loaded pane = loaded_pane(source, i, panes[i]);
    if (!same_titles(pane.panes, panes)) {
      throw ScenarioError(source.path +
                          ": the file is run once for every pane, and must then call pane{...} for the same panes");
    }
    if (whole) {
      must_be_one_film(*whole, *pane.scenario);
      add_warnings_of(*pane.scenario, *whole);
      whole->other_panes.push_back(std::move(pane.scenario));
    } else {
      whole = std::move(pane.scenario);
    }
  }
  return whole;
}

}  // namespace

std::unique_ptr<Scenario> load_scenario(const std::string& path, const std::vector<Override>& overrides) {
  Source source{path, {}, {}, {}};
  for (const Override& override : overrides) {
    source.overrides.push_back(parse_override(override));
    source.settings[source.overrides.back().path] = override.value;
  }
  source.text = read_source(path);
  Loaded whole = loaded(source, 0, {});
  return whole.panes.empty() ? std::move(whole.scenario) : with_panes(source, whole.panes);
}

}  // namespace proofreel
