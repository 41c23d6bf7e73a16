#include <array>

#include "engine/elementary.h"
#include "scenarios/lua_bodies.h"
#include "scenarios/lua_words.h"

/// The linker sends Lua's calls of pow, those of the compiler for constants included, here (see CMakeLists.txt).
/// Lua itself multiplies for the exponent 2.
extern "C" double __wrap_pow(double x, double y);
extern "C" double __wrap_pow(double x, double y) { return proofreel::elementary::pow(x, y); }

namespace proofreel {
namespace {

template <double (*function)(double)>
int of_one(lua_State* state) {
  lua_pushnumber(state, function(luaL_checknumber(state, 1)));
  return 1;
}

int atan(lua_State* state) {
  const double y = luaL_checknumber(state, 1);
  lua_pushnumber(state, elementary::atan2(y, luaL_optnumber(state, 2, 1)));
  return 1;
}

int log(lua_State* state) {
  const double x = luaL_checknumber(state, 1);
  if (lua_isnoneornil(state, 2)) {
    lua_pushnumber(state, elementary::log(x));
    return 1;
  }
  const double base = luaL_checknumber(state, 2);
  lua_pushnumber(state, base == 2    ? elementary::log2(x)
                        : base == 10 ? elementary::log10(x)
                                     : elementary::log(x) / elementary::log(base));
  return 1;
}

/// The scene's generator. Looking must not move it on, or the motion would depend on the frame rate.
Random& random_of(lua_State* state) {
  Model& model = model_of(state);
  if (!model.described) throw Problem("math.random needs the scene's seed: call scenario{...} first");
  model.must_act("math.random");
  return model.random;
}

int random(lua_State* state) {
  Random& generator = random_of(state);
  const int arguments = lua_gettop(state);
  if (arguments == 0) {
    lua_pushnumber(state, generator.uniform());
    return 1;
  }
  if (arguments > 2) throw Problem("math.random takes at most two numbers");
  const lua_Integer low = arguments == 1 ? 1 : luaL_checkinteger(state, 1);
  const lua_Integer high = luaL_checkinteger(state, arguments);
  if (arguments == 1 && high == 0) {  // as Lua has it: all bits
    lua_pushinteger(state, static_cast<lua_Integer>(generator.next()));
    return 1;
  }
  if (low > high) throw Problem("math.random: the interval is empty");
  lua_pushinteger(state, generator.between(low, high));
  return 1;
}

int randomseed(lua_State*) { throw Problem("math.randomseed is not offered: set seed= in scenario{...}"); }

/// What is exact in the C library, or made of integers, stays Lua's own.
constexpr std::array kept{"abs",        "ceil", "deg", "floor", "fmod", "huge", "max",       "maxinteger", "min",
                          "mininteger", "modf", "pi",  "rad",   "sqrt", "type", "tointeger", "ult"};

}  // namespace

void open_math(lua_State* state) {
  luaL_requiref(state, LUA_MATHLIBNAME, luaopen_math, 0);
  lua_newtable(state);
  for (const char* name : kept) {
    lua_getfield(state, -2, name);
    lua_setfield(state, -2, name);
  }
  set_word<of_one<elementary::sin>>(state, "sin");
  set_word<of_one<elementary::cos>>(state, "cos");
  set_word<of_one<elementary::tan>>(state, "tan");
  set_word<of_one<elementary::asin>>(state, "asin");
  set_word<of_one<elementary::acos>>(state, "acos");
  set_word<of_one<elementary::exp>>(state, "exp");
  set_word<atan>(state, "atan");
  set_word<log>(state, "log");
  set_word<random>(state, "random");
  set_word<randomseed>(state, "randomseed");
  lua_setglobal(state, LUA_MATHLIBNAME);
  lua_pop(state, 1);
}

}  // namespace proofreel
