#include "scenarios/effects.h"
#include "scenarios/lua_bodies.h"
#include "scenarios/lua_values.h"

namespace proofreel {
namespace {

BodyId receiver(lua_State* state) {
  if (!to_body(state, 1)) throw Problem("a method of bodies needs a body: write b:position(), not b.position()");
  return existing_body(state, 1, "body");
}

BodyState state_of_receiver(lua_State* state) {
  const BodyId body = receiver(state);
  return model_of(state).state(body);
}

int position(lua_State* state) { return push_vector(state, state_of_receiver(state).position), 1; }
int center(lua_State* state) { return push_vector(state, state_of_receiver(state).center), 1; }
int velocity(lua_State* state) { return push_vector(state, state_of_receiver(state).velocity), 1; }
int angle(lua_State* state) { return lua_pushnumber(state, state_of_receiver(state).angle), 1; }
int spin(lua_State* state) { return lua_pushnumber(state, state_of_receiver(state).spin), 1; }
int mass(lua_State* state) { return lua_pushnumber(state, state_of_receiver(state).mass), 1; }

/// The receiver of a method that changes it.
BodyId changed(lua_State* state, const char* method) {
  const BodyId body = receiver(state);
  Model& model = model_of(state);
  model.must_act(std::string("b:") + method);
  if (body == BodyId::world) throw Problem(std::string("the world cannot be changed (b:") + method + ")");
  model.touch();
  return body;
}

/// The receiver of a push, which only dynamic bodies feel.
BodyId pushed(lua_State* state, const char* method) {
  const BodyId body = changed(state, method);
  const Model& model = model_of(state);
  if (model.type(body) == BodyType::dynamic) return body;
  throw Problem("b:" + std::string(method) + " has no effect on body " + quote(model.name(body)) +
                ", which is not dynamic");
}

std::optional<Vec2d> point_argument(lua_State* state, int index, const std::string& what) {
  if (lua_isnoneornil(state, index)) return std::nullopt;
  return vector_argument(state, index, what);
}

/// What the keys change of the body, which looks like `def` afterwards.
Command change_command(BodyId body, const BodyKeys& keys, const BodyDef& def) {
  Command command{keys.change};
  auto& change = std::get<ChangeBody>(command);
  change.body = body;
  if (keys.group || keys.category || keys.mask) change.filter = def.filter;
  if (!keys.shapes) return command;
  change.shapes = def.shapes;
  // The new shapes hold these already, their own where they have one.
  change.density.reset();
  change.friction.reset();
  change.restitution.reset();
  change.rolling_resistance.reset();
  change.surface_speed.reset();
  return command;
}

int set(lua_State* state) {
  const BodyId body = changed(state, "set");
  Model& model = model_of(state);
  const BodyKeys keys = read_body_keys(state, 2, "set");
  BodyRecord record = model.record(body);
  apply_keys(record, keys);
  check_body(record.def);
  model.warn_of_omissions(called_for_by(record.def));
  if (model.simulation != nullptr) model.apply(change_command(body, keys, record.def));
  if (keys.name) model.scenario.body_names[static_cast<std::size_t>(body) - 1] = *keys.name;
  model.record(body) = std::move(record);
  return 0;
}

/// Before the first step an impulse is part of the motion the body starts with.
void start_with_impulse(BodyDef& def, Vec2d impulse, std::optional<Vec2d> at) {
  const BodyState start = initial_state(def);
  if (start.mass > 0) def.velocity += (1 / start.mass) * impulse;
  const bool turns = at && start.inertia > 0 && !def.fixed_rotation;
  if (turns) def.spin += cross(*at - start.center, impulse) / start.inertia;
}

int impulse(lua_State* state) {
  const BodyId body = pushed(state, "impulse");
  const Vec2d amount = vector_argument(state, 2, "impulse");
  const auto at = point_argument(state, 3, "the point of the impulse");
  Model& model = model_of(state);
  if (model.simulation != nullptr) {
    model.apply(ApplyImpulse{body, amount, at});
  } else {
    start_with_impulse(model.record(body).def, amount, at);
  }
  return 0;
}

/// A force acts during one tick, so there must be one.
Model& running(Model& model, const char* method) {
  if (model.simulation != nullptr) return model;
  throw Problem(std::string("b:") + method +
                " acts during the next tick and works only in callbacks, such as those of every(dt, fn)");
}

int force(lua_State* state) {
  const BodyId body = pushed(state, "force");
  const Vec2d amount = vector_argument(state, 2, "force");
  const auto at = point_argument(state, 3, "the point of the force");
  running(model_of(state), "force").apply(ApplyForce{body, amount, at});
  return 0;
}

int torque(lua_State* state) {
  const BodyId body = pushed(state, "torque");
  const lua_Number amount = luaL_checknumber(state, 2);
  if (!std::isfinite(amount)) throw Problem("torque must be finite");
  running(model_of(state), "torque").apply(ApplyTorque{body, amount});
  return 0;
}

int remove(lua_State* state) {
  const BodyId body = changed(state, "remove");
  Model& model = model_of(state);
  if (model.simulation != nullptr) {
    model.apply(RemoveBody{body});
    model.record(body).def.shapes = {};  // thousands may come and go
  } else {
    model.record(body).removed = true;
  }
  return 0;
}

/// Nothing sleeps before the first step.
int wake(lua_State* state) {
  const BodyId body = pushed(state, "wake");
  Model& model = model_of(state);
  if (model.simulation != nullptr) model.apply(WakeBody{body});
  return 0;
}

int asleep(lua_State* state) {
  const BodyId body = receiver(state);
  const Model& model = model_of(state);
  lua_pushboolean(state, model.simulation != nullptr && model.simulation->asleep(body) ? 1 : 0);
  return 1;
}

/// Whoever asks when a body falls asleep wants that it may.
void allow_sleep(Model& model) {
  if (model.scenario.scene.sleeping) return;
  model.scenario.scene.sleeping = true;
  model.check_method();
  model.warn_of_omissions({Effect::sleeping});
  if (model.simulation != nullptr) model.apply(AllowSleep{});
}

int on_sleep(lua_State* state) {
  Model& model = model_of(state);
  model.must_act("on_sleep");
  charge_for_making(state);
  if (lua_gettop(state) != 2) throw Problem("on_sleep needs a body and a function");
  const BodyId body = own_body(state, 1, "on_sleep(body, fn): body");
  if (model.type(body) != BodyType::dynamic) {
    throw Problem("on_sleep(body, fn): body " + quote(model.name(body)) + " never sleeps, for it is not dynamic");
  }
  model.sleep_handlers.push_back({body, keep_function(state, 2, "on_sleep(body, fn): fn")});
  allow_sleep(model);
  return 0;
}

}  // namespace

void open_body_methods(lua_State* state) {
  luaL_getsubtable(state, LUA_REGISTRYINDEX, body_methods);
  set_word<position>(state, "position");
  set_word<center>(state, "center");
  set_word<angle>(state, "angle");
  set_word<velocity>(state, "velocity");
  set_word<spin>(state, "spin");
  set_word<mass>(state, "mass");
  set_word<set>(state, "set");
  set_word<impulse>(state, "impulse");
  set_word<force>(state, "force");
  set_word<torque>(state, "torque");
  set_word<remove>(state, "remove");
  set_word<wake>(state, "wake");
  set_word<asleep>(state, "asleep");
  lua_pop(state, 1);
  lua_pushglobaltable(state);
  set_word<on_sleep>(state, "on_sleep");
  lua_pop(state, 1);
}

}  // namespace proofreel
