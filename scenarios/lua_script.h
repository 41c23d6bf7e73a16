#pragma once

/// The script of a scenario in Lua.

#include <functional>
#include <string>
#include <vector>

#include "scenarios/lua_model.h"
#include "scenarios/lua_sandbox.h"
#include "scenarios/lua_watch.h"
#include "scenarios/scenario.h"

namespace proofreel {

class LuaScript : public Script {
 public:
  /// The scenario owns the script and must stay where it is.
  /// `pane` is the one to make, from 0, where the file turns out to have panes.
  LuaScript(Scenario& scenario, std::vector<ParsedOverride> overrides, std::size_t pane);

  /// Runs the file's text and fills the scenario. Throws ScenarioError.
  void load(const std::string& text);

  void bind(Simulation* simulation) override;
  void before_step() override;
  void after_step() override;
  double measure(int index) override;
  std::optional<double> reference(int index, std::int64_t tick) override;
  bool expectation(int index) override;
  double plot_value(int plot, int curve) override;
  void log_commands(std::vector<Command>* log) override { model_.log = log; }
  void adopt(const Command& command) override { model_.adopt(command); }
  bool has_callbacks() const override { return model_.has_callbacks(); }
  void remember_variables() override;
  std::optional<std::string> changed_variable(ScriptFunction what, int index) override;

  const std::vector<PaneRecord>& panes() const { return model_.panes; }
  /// Of the file's text and of all it includes.
  std::uint64_t source_hash() const { return sandbox_.source_hash(); }

 private:
  /// A turn of the script in which it may do what `phase` says; errors tell the time and `what` ran.
  void turn(Phase phase, const std::function<std::string()>& what, const std::function<void(lua_State*)>& body);
  /// What the function returns, which must be a finite number.
  double number_from(int function, const std::function<std::string()>& what, std::optional<double> argument);
  /// The field the function tells; asking it is a turn of the script, which may only look.
  ForceField force_field(int function);
  Vec2d force_from(int function, Vec2d at, Vec2d velocity, double time);
  void open(lua_State* state);
  void finish_loading();
  void time_stories();
  void link_references();
  void check_expectations();
  void check_times() const;
  void fire_due(lua_State* state);
  void tell_of_contacts();
  void tell_of_separations();
  void tell_of_breaks();
  std::vector<int> functions_behind(ScriptFunction what, int index) const;
  std::optional<SeenVariables> variables_of(int function);
  void tell_of_sleep();
  void tell(lua_State* state, const ContactHandler& handler, const ContactEvent& event);
  void tell(lua_State* state, const ContactHandler& handler, const SeparationEvent& event);

  Model model_;
  Sandbox sandbox_;
  std::map<int, std::optional<SeenVariables>> remembered_;  ///< by function
  std::vector<int> reference_of_;                           ///< of measure i: index into Model::references, or -1
};

}  // namespace proofreel
