#include <cmath>

#include "scenarios/lua_bodies.h"
#include "scenarios/lua_values.h"
#include "scenarios/lua_words.h"
#include "scenarios/timeline.h"

namespace proofreel {
namespace {

/// Scene times are rounded to ticks, so the rate must be known.
void must_be_described(const Model& model, const std::string& what) {
  if (!model.described) throw Problem(what + " needs the scene's rate: call scenario{...} first");
}

double seconds_argument(lua_State* state, const std::string& what) {
  if (lua_type(state, 1) != LUA_TNUMBER)
    throw Problem(what + " must be a number of seconds, got " + described(state, 1));
  const double seconds = lua_tonumber(state, 1);
  if (!std::isfinite(seconds) || seconds < 0) {
    throw Problem(what + " must be a number of seconds that is not negative, got " + described(state, 1));
  }
  return seconds;
}

int at(lua_State* state) {
  Model& model = model_of(state);
  must_be_described(model, "at");
  model.must_act("at");
  charge_for_making(state);
  const double seconds = seconds_argument(state, "at(t, fn): t");
  const std::int64_t tick = tick_at(seconds, model.scenario.scene.rate);
  if (tick < model.tick()) throw Problem("at(" + described(state, 1) + ", fn): that time has passed already");
  const int function = keep_function(state, 2, "at(t, fn): fn");
  model.timers.insert({{tick, model.timers_made++}, {model.tick(), 0, 0, function}});
  return 0;
}

int every(lua_State* state) {
  Model& model = model_of(state);
  must_be_described(model, "every");
  model.must_act("every");
  charge_for_making(state);
  const double period = seconds_argument(state, "every(dt, fn): dt");
  const int rate = model.scenario.scene.rate;
  if (period * rate < 1 - 1e-9) {
    throw Problem("every(" + described(state, 1) + ", fn): shorter than a tick, which takes 1/" + std::to_string(rate) +
                  " s");
  }
  const int function = keep_function(state, 2, "every(dt, fn): fn");
  const std::int64_t first = model.tick() + tick_at(period, rate);
  model.timers.insert({{first, model.timers_made++}, {model.tick(), period, 1, function}});
  return 0;
}

std::optional<BodyId> body_or_any(lua_State* state, int index, const std::string& word) {
  if (lua_isnil(state, index)) return std::nullopt;
  return existing_body(state, index, word + "(a, b, fn): a and b");
}

ContactHandler contact_handler(lua_State* state, const std::string& word) {
  model_of(state).must_act(word);
  charge_for_making(state);
  if (lua_gettop(state) != 3) throw Problem(word + " needs two bodies (or nil for any) and a function");
  ContactHandler handler{body_or_any(state, 1, word), body_or_any(state, 2, word), 0};
  if (handler.a && handler.a == handler.b) throw Problem(word + ": a body never touches itself");
  handler.function = keep_function(state, 3, word + "(a, b, fn): fn");
  return handler;
}

int on_contact(lua_State* state) {
  model_of(state).contact_handlers.push_back(contact_handler(state, "on_contact"));
  return 0;
}

int on_separate(lua_State* state) {
  model_of(state).separation_handlers.push_back(contact_handler(state, "on_separate"));
  return 0;
}

int time(lua_State* state) {
  lua_pushnumber(state, model_of(state).time());
  return 1;
}

int energy(lua_State* state) {
  const Energy energy = observed(state).energy();
  lua_createtable(state, 0, 4);
  lua_pushnumber(state, energy.kinetic);
  lua_setfield(state, -2, "kinetic");
  lua_pushnumber(state, energy.potential);
  lua_setfield(state, -2, "potential");
  lua_pushnumber(state, energy.total());
  lua_setfield(state, -2, "total");
  lua_pushnumber(state, energy.booked_work);
  lua_setfield(state, -2, "work");
  return 1;
}

void push_touch(lua_State* state, const ContactPoint& point, const Vec2d& normal) {
  push_vector(state, point.point);
  lua_setfield(state, -2, "point");
  push_vector(state, normal);
  lua_setfield(state, -2, "normal");
  lua_pushnumber(state, point.normal_impulse);
  lua_setfield(state, -2, "impulse");
  lua_pushnumber(state, point.separation);
  lua_setfield(state, -2, "separation");
}

/// A touching point as seen from `body`: the normal leads away from it.
void push_contact_of(lua_State* state, const ContactView& contact, const ContactPoint& point, BodyId body) {
  const bool is_a = contact.a == body;
  lua_createtable(state, 0, 5);
  push_body(state, is_a ? contact.b : contact.a);
  lua_setfield(state, -2, "other");
  push_touch(state, point, is_a ? contact.normal : -contact.normal);
}

/// A touching point as seen from nobody: the normal leads from a to b.
void push_contact(lua_State* state, const ContactView& contact, const ContactPoint& point) {
  lua_createtable(state, 0, 6);
  push_body(state, contact.a);
  lua_setfield(state, -2, "a");
  push_body(state, contact.b);
  lua_setfield(state, -2, "b");
  push_touch(state, point, contact.normal);
}

int contacts(lua_State* state) {
  const bool all_of_them = lua_gettop(state) == 0;
  const BodyId body = all_of_them ? BodyId::world : existing_body(state, 1, "contacts(b): b");
  lua_settop(state, 1);
  lua_newtable(state);
  lua_Integer count = 0;
  const std::vector<ContactView> all = observed(state).contacts();
  sandbox_of(state).charge(all.size());
  for (const ContactView& contact : all) {
    if (!all_of_them && contact.a != body && contact.b != body) continue;
    for (int i = 0; i < contact.point_count; ++i) {
      if (!contact.points[i].touching()) continue;
      if (all_of_them) {
        push_contact(state, contact, contact.points[i]);
      } else {
        push_contact_of(state, contact, contact.points[i], body);
      }
      lua_rawseti(state, 2, ++count);
    }
  }
  return 1;
}

}  // namespace

void open_time(lua_State* state) {
  lua_pushglobaltable(state);
  set_word<at>(state, "at");
  set_word<every>(state, "every");
  set_word<on_contact>(state, "on_contact");
  set_word<on_separate>(state, "on_separate");
  set_word<time>(state, "time");
  set_word<energy>(state, "energy");
  set_word<contacts>(state, "contacts");
  lua_pop(state, 1);
}

}  // namespace proofreel
