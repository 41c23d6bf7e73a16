#include "scenarios/lua_script.h"

#include <cmath>

#include "scenarios/formatted.h"
#include "scenarios/lua_values.h"
#include "scenarios/suggest.h"
#include "scenarios/timeline.h"

namespace proofreel {
namespace {

bool matches(const std::optional<BodyId>& wanted, BodyId body) { return !wanted || *wanted == body; }

/// Into the table on top.
void push_bodies(lua_State* state, BodyId a, BodyId b) {
  push_body(state, a);
  lua_setfield(state, -2, "a");
  push_body(state, b);
  lua_setfield(state, -2, "b");
}

void push_event(lua_State* state, const ContactEvent& event) {
  lua_createtable(state, 0, 6);
  push_bodies(state, event.a, event.b);
  push_vector(state, event.point);
  lua_setfield(state, -2, "point");
  push_vector(state, event.normal);
  lua_setfield(state, -2, "normal");
  lua_pushnumber(state, event.impulse);
  lua_setfield(state, -2, "impulse");
  lua_pushnumber(state, event.speed);
  lua_setfield(state, -2, "speed");
}

void push_event(lua_State* state, const BreakEvent& event) {
  lua_createtable(state, 0, 3);
  push_joint(state, event.joint);
  lua_setfield(state, -2, "joint");
  push_vector(state, event.point);
  lua_setfield(state, -2, "point");
  push_vector(state, event.reaction);
  lua_setfield(state, -2, "reaction");
}

ContactEvent turned_round(const ContactEvent& event) {
  ContactEvent turned = event;
  turned.a = event.b;
  turned.b = event.a;
  turned.normal = -event.normal;
  return turned;
}

/// Where a function is written, as Lua marks its own messages.
std::string place_of(lua_State* state, int function) {
  lua_Debug record{};
  push_function(state, function);
  if (lua_getinfo(state, ">S", &record) == 0) return {};
  return std::string(record.short_src) + ":" + std::to_string(record.linedefined) + ": ";
}

[[noreturn]] void refuse_result(lua_State* state, int function, const std::string& wanted) {
  throw Problem(place_of(state, function) + "must return " + wanted + ", got " + described(state, -1));
}

/// Differences of larger ones are no numbers any more, and no axis can be drawn for them.
constexpr double largest_number = 1e300;

/// " (in measure "x", at 0.5 s)"
std::string context(const std::string& what, double seconds) {
  return " (in " + what + formatted(", at %.6g s)", seconds);
}

}  // namespace

void LuaScript::turn(Phase phase, const std::function<std::string()>& what,
                     const std::function<void(lua_State*)>& body) {
  model_.phase = phase;
  try {
    sandbox_.turn(body);
  } catch (const ScenarioError& error) {
    const std::string& pane = model_.scenario.pane_title;
    throw ScenarioError(error.what() +
                        context(pane.empty() ? what() : what() + " of pane " + quote(pane), model_.time()));
  }
}

void LuaScript::bind(Simulation* simulation) {
  model_.bind(simulation);
  if (simulation == nullptr) return;
  // Ids are positions in the scene, so what the file made and removed again is still in it.
  for (std::size_t i = 0; i < model_.joints.size(); ++i) {
    const auto id = static_cast<JointId>(i);
    if (model_.joints[i].removed && simulation->exists(id)) simulation->apply(RemoveJoint{id});
  }
  for (std::size_t i = 0; i < model_.bodies.size(); ++i) {
    const auto id = static_cast<BodyId>(i + 1);
    if (model_.bodies[i].removed && simulation->exists(id)) simulation->apply(RemoveBody{id});
  }
}

void LuaScript::before_step() {
  const auto due = [&] { return !model_.timers.empty() && model_.timers.begin()->first.first <= model_.tick(); };
  if (!due()) return;
  turn(
      Phase::acting, [] { return "a callback of at or every"; },
      [&](lua_State* state) {
        while (due()) fire_due(state);
      });
}

/// Runs the first timer. An `every` goes back into the queue under its old number: callbacks of one tick run in order
/// of creation.
void LuaScript::fire_due(lua_State* state) {
  constexpr std::uint64_t cost = 100;
  sandbox_.charge(cost);
  auto node = model_.timers.extract(model_.timers.begin());
  Timer& timer = node.mapped();
  const int function = timer.function;
  const bool again = timer.period > 0;
  if (again) {
    ++timer.fired;
    const double seconds = static_cast<double>(timer.fired) * timer.period;
    node.key().first = timer.start + tick_at(seconds, model_.scenario.scene.rate);
    model_.timers.insert(std::move(node));
  }
  push_function(state, function);
  if (!again) luaL_unref(state, LUA_REGISTRYINDEX, function);
  lua_call(state, 0, 0);
}

void LuaScript::after_step() {
  tell_of_contacts();
  tell_of_separations();
  tell_of_breaks();
  tell_of_sleep();
}

void LuaScript::tell_of_breaks() {
  if (model_.break_handlers.empty() || model_.simulation->break_events().empty()) return;
  const std::vector<BreakEvent> events = model_.simulation->break_events();  // handlers change the simulation
  turn(
      Phase::acting, [] { return "a callback of on_break"; },
      [&](lua_State* state) {
        for (const BreakEvent& event : events) {
          const std::size_t count = model_.break_handlers.size();
          for (std::size_t i = 0; i < count; ++i) {
            if (model_.break_handlers[i].joint != event.joint) continue;
            push_function(state, model_.break_handlers[i].function);
            push_event(state, event);
            lua_call(state, 1, 0);
          }
        }
      });
}

void LuaScript::tell_of_sleep() {
  if (model_.sleep_handlers.empty() || model_.simulation->sleep_events().empty()) return;
  const std::vector<SleepEvent> events = model_.simulation->sleep_events();  // handlers change the simulation
  turn(
      Phase::acting, [] { return "a callback of on_sleep"; },
      [&](lua_State* state) {
        for (const SleepEvent& event : events) {
          const std::size_t count = model_.sleep_handlers.size();
          for (std::size_t i = 0; event.asleep && i < count; ++i) {
            if (model_.sleep_handlers[i].body != event.body || !model_.exists(event.body)) continue;
            push_function(state, model_.sleep_handlers[i].function);
            lua_createtable(state, 0, 1);
            push_body(state, event.body);
            lua_setfield(state, -2, "body");
            lua_call(state, 1, 0);
          }
        }
      });
}

void LuaScript::tell_of_contacts() {
  if (model_.contact_handlers.empty() || model_.simulation->contact_events().empty()) return;
  const std::vector<ContactEvent> events = model_.simulation->contact_events();  // handlers change the simulation
  turn(
      Phase::acting, [] { return "a callback of on_contact"; },
      [&](lua_State* state) {
        for (const ContactEvent& event : events) {
          // By index, because handlers may make handlers; those hear of the next tick's contacts.
          const std::size_t count = model_.contact_handlers.size();
          for (std::size_t i = 0; i < count; ++i) tell(state, model_.contact_handlers[i], event);
        }
      });
}

void LuaScript::tell_of_separations() {
  if (model_.separation_handlers.empty() || model_.simulation->separation_events().empty()) return;
  const std::vector<SeparationEvent> events = model_.simulation->separation_events();  // handlers change the simulation
  turn(
      Phase::acting, [] { return "a callback of on_separate"; },
      [&](lua_State* state) {
        for (const SeparationEvent& event : events) {
          const std::size_t count = model_.separation_handlers.size();
          for (std::size_t i = 0; i < count; ++i) tell(state, model_.separation_handlers[i], event);
        }
      });
}

/// Also of bodies that are gone, for that is one way to part: their handles still compare.
void LuaScript::tell(lua_State* state, const ContactHandler& handler, const SeparationEvent& event) {
  const bool straight = matches(handler.a, event.a) && matches(handler.b, event.b);
  const bool swapped = matches(handler.a, event.b) && matches(handler.b, event.a);
  if (!straight && !swapped) return;
  push_function(state, handler.function);
  lua_createtable(state, 0, 2);
  push_bodies(state, straight ? event.a : event.b, straight ? event.b : event.a);
  lua_call(state, 1, 0);
}

/// Calls the handler if the event is one of its; bodies come in the order the handler names them.
void LuaScript::tell(lua_State* state, const ContactHandler& handler, const ContactEvent& event) {
  const bool straight = matches(handler.a, event.a) && matches(handler.b, event.b);
  const bool swapped = matches(handler.a, event.b) && matches(handler.b, event.a);
  if (!straight && !swapped) return;
  if (!model_.exists(event.a) || !model_.exists(event.b)) return;  // an earlier handler removed it
  push_function(state, handler.function);
  push_event(state, straight ? event : turned_round(event));
  lua_call(state, 1, 0);
}

double LuaScript::number_from(int function, const std::function<std::string()>& what, std::optional<double> argument) {
  double number = 0;
  turn(Phase::looking, what, [&](lua_State* state) {
    push_function(state, function);
    if (argument) lua_pushnumber(state, *argument);
    lua_call(state, argument ? 1 : 0, 1);
    if (lua_type(state, -1) != LUA_TNUMBER) refuse_result(state, function, "a number");
    number = lua_tonumber(state, -1);
    if (!std::isfinite(number)) refuse_result(state, function, "a finite number");
    if (std::abs(number) > largest_number) refuse_result(state, function, "a number between -1e300 and 1e300");
  });
  return number;
}

ForceField LuaScript::force_field(int function) {
  return [this, function](Vec2d at, Vec2d velocity, double time) { return force_from(function, at, velocity, time); };
}

Vec2d LuaScript::force_from(int function, Vec2d at, Vec2d velocity, double time) {
  Vec2d force;
  const auto what = [] { return std::string("a force field"); };
  turn(Phase::looking, what, [&](lua_State* state) {
    push_function(state, function);
    for (const double number : {at.x, at.y, velocity.x, velocity.y, time}) lua_pushnumber(state, number);
    lua_call(state, 5, 2);
    for (const int index : {-1, -2}) {
      const bool is_number = lua_type(state, index) == LUA_TNUMBER;
      if (is_number && std::isfinite(lua_tonumber(state, index))) continue;
      throw Problem(place_of(state, function) + "a field must return two finite numbers, fx and fy, got " +
                    described(state, -2) + " and " + described(state, -1));
    }
    force = {lua_tonumber(state, -2), lua_tonumber(state, -1)};
  });
  return force;
}

double LuaScript::measure(int index) {
  const auto i = static_cast<std::size_t>(index);
  return number_from(
      model_.measures[i], [&] { return "measure " + quote(model_.scenario.measures[i].name); }, std::nullopt);
}

std::optional<double> LuaScript::reference(int index, std::int64_t tick) {
  const int found = reference_of_[static_cast<std::size_t>(index)];
  if (found < 0) return std::nullopt;
  const Reference& reference = model_.references[static_cast<std::size_t>(found)];
  const int rate = model_.scenario.scene.rate;
  if (reference.function) {
    if (!is_sample_tick(model_.scenario, tick)) return std::nullopt;
    const double seconds = static_cast<double>(tick) / rate;
    return number_from(
        *reference.function, [&] { return "reference " + quote(reference.measure); }, seconds);
  }
  for (const auto& [seconds, value] : reference.points) {
    if (tick_at(seconds, rate) == tick) return value;
  }
  return std::nullopt;
}

bool LuaScript::expectation(int index) {
  const auto i = static_cast<std::size_t>(index);
  const auto what = [&] { return "expect " + quote(model_.scenario.expectations[i].text); };
  bool held = false;
  turn(Phase::looking, what, [&](lua_State* state) {
    push_function(state, model_.expectations[i]);
    lua_call(state, 0, 1);
    if (lua_type(state, -1) != LUA_TBOOLEAN) refuse_result(state, model_.expectations[i], "true or false");
    held = lua_toboolean(state, -1) != 0;
  });
  return held;
}

/// A measure's function and that of its reference, an expectation's, or those of all fields.
std::vector<int> LuaScript::functions_behind(ScriptFunction what, int index) const {
  const auto i = static_cast<std::size_t>(index);
  if (what == ScriptFunction::field) return model_.fields;
  if (what == ScriptFunction::expectation) return {model_.expectations[i]};
  std::vector<int> functions{model_.measures[i]};
  const int reference = reference_of_[i];
  if (reference < 0) return functions;
  const auto& function = model_.references[static_cast<std::size_t>(reference)].function;
  if (function) functions.push_back(*function);
  return functions;
}

std::optional<SeenVariables> LuaScript::variables_of(int function) {
  std::optional<SeenVariables> seen;
  sandbox_.turn([&](lua_State* state) { seen = variables_seen_by(state, function); });
  return seen;
}

void LuaScript::remember_variables() {
  for (const int function : model_.fields) remembered_[function] = variables_of(function);
  for (const int function : model_.measures) remembered_[function] = variables_of(function);
  for (const int function : model_.expectations) remembered_[function] = variables_of(function);
  for (const Reference& reference : model_.references) {
    if (reference.function) remembered_[*reference.function] = variables_of(*reference.function);
  }
}

std::optional<std::string> LuaScript::changed_variable(ScriptFunction what, int index) {
  for (const int function : functions_behind(what, index)) {
    if (auto name = difference(remembered_[function], variables_of(function))) return name;
  }
  return std::nullopt;
}

double LuaScript::plot_value(int plot, int curve) {
  const auto p = static_cast<std::size_t>(plot);
  const auto c = static_cast<std::size_t>(curve);
  const auto name = [&] {
    const PlotMark& mark = model_.scenario.picture.plots[p];
    return "plot curve " + quote(c < mark.curves.size() ? mark.curves[c] : mark.x_name);
  };
  return number_from(model_.plots[p][c], name, std::nullopt);
}

}  // namespace proofreel
