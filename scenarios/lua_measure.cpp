#include <algorithm>

#include "scenarios/lua_bodies.h"
#include "scenarios/lua_values.h"
#include "scenarios/lua_words.h"

namespace proofreel {
namespace {

std::string name_argument(lua_State* state, const std::string& what) {
  std::string name = text_to_show(state, 1, what);
  if (name.empty()) throw Problem(what + " must not be empty");
  return name;
}

int measure(lua_State* state) {
  Model& model = model_of(state);
  model.must_load("measure");
  charge_for_making(state);
  const std::string name = name_argument(state, "measure(name, fn): name");
  const auto& measures = model.scenario.measures;
  const bool taken = std::any_of(measures.begin(), measures.end(), [&](const Measure& m) { return m.name == name; });
  if (taken) throw Problem("there is a measure " + quote(name) + " already");
  model.measures.push_back(keep_function(state, 2, "measure(name, fn): fn"));
  model.scenario.measures.push_back({name, false});
  return 0;
}

/// One {t, value} on top of the stack.
std::pair<double, double> read_point(lua_State* state) {
  const auto point = to_vector(state, -1);
  if (!point || !is_finite(*point) || point->x < 0) {
    throw Problem("reference: the table must hold pairs {t, value} of finite numbers, got " + described(state, -1));
  }
  return {point->x, point->y};
}

std::vector<std::pair<double, double>> read_points(lua_State* state) {
  std::vector<std::pair<double, double>> points;
  const lua_Unsigned count = lua_rawlen(state, 2);
  for (lua_Unsigned i = 1; i <= count; ++i) {
    lua_rawgeti(state, 2, static_cast<lua_Integer>(i));
    charge_for_making(state);
    points.push_back(read_point(state));
    lua_pop(state, 1);
  }
  if (points.empty()) throw Problem("reference: the table must hold at least one pair {t, value}");
  return points;
}

int reference(lua_State* state) {
  Model& model = model_of(state);
  model.must_load("reference");
  charge_for_making(state);
  Reference reference{name_argument(state, "reference(name, what): name"), std::nullopt, {}};
  for (const Reference& other : model.references) {
    if (other.measure == reference.measure)
      throw Problem("there is a reference for " + quote(other.measure) + " already");
  }
  if (lua_type(state, 2) == LUA_TTABLE) {
    reference.points = read_points(state);
  } else {
    reference.function = keep_function(state, 2, "reference(name, what): what");
  }
  model.references.push_back(std::move(reference));
  return 0;
}

void read_when(lua_State* state, Expectation& expectation) {
  static constexpr Name keys[] = {{"at"}, {"always"}, {"finally"}};
  const Fields fields(state, 3, "expect", keys);
  const auto at = fields.number("at", Range::not_negative);
  const bool always = fields.boolean("always").value_or(false);
  const bool finally = fields.boolean("finally").value_or(false);
  if ((at ? 1 : 0) + (always ? 1 : 0) + (finally ? 1 : 0) != 1) {
    throw Problem("expect takes one of {at=t}, {always=true}, {finally=true}");
  }
  if (at) {
    expectation.when = Expectation::When::at;
    expectation.at = *at;
  } else if (always) {
    expectation.when = Expectation::When::always;
  }
}

int expect(lua_State* state) {
  Model& model = model_of(state);
  model.must_load("expect");
  charge_for_making(state);
  Expectation expectation;
  expectation.text = name_argument(state, "expect(text, fn): text");
  if (!lua_isnoneornil(state, 3)) read_when(state, expectation);
  model.expectations.push_back(keep_function(state, 2, "expect(text, fn): fn"));
  model.scenario.expectations.push_back(expectation);
  return 0;
}

}  // namespace

void open_measures(lua_State* state) {
  lua_pushglobaltable(state);
  set_word<measure>(state, "measure");
  set_word<reference>(state, "reference");
  set_word<expect>(state, "expect");
  lua_pop(state, 1);
}

}  // namespace proofreel
