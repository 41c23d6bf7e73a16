#pragma once

/// What a script has made so far, and the simulation it lives in. The words of the language read and change this; no
/// Lua values in here but references to functions.

#include <cstdint>
#include <lua.hpp>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/simulation.h"
#include "scenarios/overrides.h"
#include "scenarios/random.h"
#include "scenarios/scenario.h"

namespace proofreel {

/// What the script may do: everything; everything but what belongs at the top of the file; look only.
enum class Phase : std::uint8_t { loading, acting, looking };

/// What shapes without coefficients of their own take from their body.
struct Material {
  double density = 1;
  FrictionDef friction;
  double restitution = 0;
  double rolling_resistance = 0;
  double surface_speed = 0;
};

struct BodyRecord {
  BodyDef def;
  Material material;
  bool removed = false;  ///< while loading; later the simulation knows
};

struct JointRecord {
  JointDef def;
  bool removed = false;  ///< while loading; later the simulation knows
};

/// An `at` (period 0) or an `every`.
struct Timer {
  std::int64_t start = 0;  ///< tick it was made at
  double period = 0;       ///< s
  std::int64_t fired = 0;  ///< how often
  int function = 0;
};

struct ContactHandler {
  std::optional<BodyId> a;
  std::optional<BodyId> b;
  int function = 0;
};

struct BreakHandler {
  JointId joint{};
  int function = 0;
};

struct SleepHandler {
  BodyId body{};
  int function = 0;
};

/// What a measure should be: a function of time, or a table of times and values.
struct Reference {
  std::string measure;
  std::optional<int> function;
  std::vector<std::pair<double, double>> points;
};

/// One `pane{}`: a part of a split screen, and what of `scenario{}` is different in it.
struct PaneRecord {
  std::string title;
  std::vector<ParsedOverride> overrides;
};

struct Model {
  explicit Model(Scenario& owner) : scenario(owner) {}

  Scenario& scenario;
  const Simulation* simulation = nullptr;  ///< changed by `apply` only
  std::vector<Command>* log = nullptr;     ///< takes down what is applied
  Phase phase = Phase::loading;
  bool described = false;  ///< scenario{} was called
  bool timed = false;      ///< it said how long the scenario lasts
  int includes_open = 0;   ///< files being included right now
  std::vector<ParsedOverride> overrides;
  std::size_t pane = 0;  ///< the one being made of the file, where it has panes
  std::vector<PaneRecord> panes;
  Random random{1};
  std::vector<BodyRecord> bodies;  ///< body i + 1 is bodies[i]
  std::vector<JointRecord> joints;
  /// By tick, then in order of creation.
  std::map<std::pair<std::int64_t, std::size_t>, Timer> timers;
  std::size_t timers_made = 0;
  std::vector<ContactHandler> contact_handlers;
  std::vector<ContactHandler> separation_handlers;
  std::vector<int> fields;  ///< functions of Scene::fields
  std::vector<BreakHandler> break_handlers;
  std::vector<SleepHandler> sleep_handlers;
  std::vector<int> measures;      ///< functions of Scenario::measures
  std::vector<int> expectations;  ///< functions of Scenario::expectations
  std::vector<Reference> references;
  std::vector<std::vector<int>> plots;  ///< functions of the curves of Picture::plots

  void bind(Simulation* to);
  /// Acts on the simulation, which must be bound.
  void apply(const Command& command);
  /// Notes what a command has made, which somebody else applied.
  void adopt(const Command& command);
  bool has_callbacks() const {
    return !timers.empty() || !contact_handlers.empty() || !separation_handlers.empty() || !break_handlers.empty() ||
           !sleep_handlers.empty();
  }

  std::int64_t tick() const { return simulation != nullptr ? simulation->tick() : 0; }
  double time() const { return static_cast<double>(tick()) / scenario.scene.rate; }

  BodyRecord& record(BodyId body) { return bodies[static_cast<std::size_t>(body) - 1]; }
  std::string name(BodyId body) const;
  bool exists(BodyId body) const;
  bool exists(JointId joint) const;
  BodyState state(BodyId body) const;
  BodyType type(BodyId body) const;
  /// A simulation made of the scene as it is so far, and whether it must be made first.
  const Simulation& preview();
  bool needs_preview() const { return simulation == nullptr && preview_ == nullptr; }
  /// The scene as it is so far.
  Scene scene_so_far() const;
  /// Throws Problem where the script may only look; `what` is what it tried.
  void must_act(const std::string& what) const;
  /// Throws Problem unless the file is still being loaded.
  void must_load(const std::string& what) const;
  /// Adds to the warnings when the list of effects omits what was just made.
  void warn_of_omissions(EffectSet wanted);
  /// Throws Problem where the method cannot step what the scene holds by now.
  void check_method() const;
  /// The scene has changed while loading.
  void touch() { preview_.reset(); }

 private:
  Simulation* bound_ = nullptr;
  std::unique_ptr<Simulation> preview_;
};

Model& model_of(lua_State* state);

/// Counts the work of a word that makes something, so that a script cannot fill the memory outside Lua's.
void charge_for_making(lua_State* state);

/// The bound simulation, or while loading one made of the scene as it is so far, which counts as work.
const Simulation& observed(lua_State* state);

/// An argument or field that must be a body that exists (the world counts); throws Problem.
BodyId existing_body(lua_State* state, int index, const std::string& what);
/// The same, the world refused.
BodyId own_body(lua_State* state, int index, const std::string& what);
JointId existing_joint(lua_State* state, int index);

}  // namespace proofreel
