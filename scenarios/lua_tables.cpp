#include <algorithm>

#include "scenarios/lua_bodies.h"
#include "scenarios/lua_values.h"
#include "scenarios/lua_words.h"

namespace proofreel {
namespace {

/// insert and remove shift what lies behind, unseen by the count of instructions.
int metered_shift(lua_State* state) {
  const bool at_the_end = lua_gettop(state) < 3 && (lua_gettop(state) < 2 || lua_type(state, 2) != LUA_TNUMBER);
  if (lua_type(state, 1) == LUA_TTABLE && !at_the_end) sandbox_of(state).charge(lua_rawlen(state, 1));
  return call_original(state);
}

/// concat reads every entry between its bounds.
int metered_concat(lua_State* state) {
  if (lua_type(state, 1) == LUA_TTABLE) sandbox_of(state).charge(lua_rawlen(state, 1));
  return call_original(state);
}

/// move(a1, first, last, t, a2) copies that many entries, whether there is anything in them or not.
int metered_move(lua_State* state) {
  const lua_Integer first = luaL_checkinteger(state, 2);
  const lua_Integer last = luaL_checkinteger(state, 3);
  if (last >= first) sandbox_of(state).charge(static_cast<std::uint64_t>(last) - static_cast<std::uint64_t>(first));
  return call_original(state);
}

int metered_unpack(lua_State* state) {
  constexpr std::uint64_t most_results = 1'000'000;  // what Lua's stack can hold
  sandbox_of(state).charge(
      lua_type(state, 1) == LUA_TTABLE ? std::min<std::uint64_t>(lua_rawlen(state, 1), most_results) : 0);
  return call_original(state);
}

constexpr int order = 2;  ///< stack index of the function that compares, or nil

/// Whether the value at `a` comes before that at `b`.
bool comes_before(lua_State* state, int a, int b) {
  if (lua_isnil(state, order)) return lua_compare(state, a, b, LUA_OPLT) != 0;
  lua_pushvalue(state, order);
  lua_pushvalue(state, a);
  lua_pushvalue(state, b);
  lua_call(state, 2, 1);
  const bool before = lua_toboolean(state, -1) != 0;
  lua_pop(state, 1);
  return before;
}

/// Merges the sorted runs [low, middle) and [middle, high) of the list at `from` into the list at `to`.
void merge(lua_State* state, int from, int to, lua_Integer low, lua_Integer middle, lua_Integer high) {
  lua_Integer left = low;
  lua_Integer right = middle;
  for (lua_Integer place = low; place < high; ++place) {
    lua_rawgeti(state, from, left);
    lua_rawgeti(state, from, right);
    const int top = lua_gettop(state);
    const bool take_right = left >= middle || (right < high && comes_before(state, top, top - 1));
    lua_settop(state, take_right ? top : top - 1);
    lua_rawseti(state, to, place);
    lua_settop(state, top - 2);
    ++(take_right ? right : left);
  }
}

/// A stable merge sort: the same order everywhere, also among equals. Lua's own sort picks pivots by the clock.
int sort(lua_State* state) {
  luaL_checktype(state, 1, LUA_TTABLE);
  lua_settop(state, 2);
  if (!lua_isnil(state, order)) luaL_checktype(state, order, LUA_TFUNCTION);
  const auto count = static_cast<lua_Integer>(lua_rawlen(state, 1));
  lua_newtable(state);
  int from = 1;
  int to = 3;
  for (lua_Integer run = 1; run < count; run *= 2) {
    sandbox_of(state).charge(4 * static_cast<std::uint64_t>(count));
    for (lua_Integer low = 1; low <= count; low += 2 * run) {
      merge(state, from, to, low, std::min(low + run, count + 1), std::min(low + 2 * run, count + 1));
    }
    std::swap(from, to);
  }
  if (from == 1) return 0;
  for (lua_Integer place = 1; place <= count; ++place) {
    lua_rawgeti(state, from, place);
    lua_rawseti(state, 1, place);
  }
  return 0;
}

}  // namespace

void open_tables(lua_State* state) {
  luaL_requiref(state, LUA_TABLIBNAME, luaopen_table, 0);
  lua_newtable(state);
  wrap_word<metered_shift>(state, "insert");
  wrap_word<metered_shift>(state, "remove");
  wrap_word<metered_concat>(state, "concat");
  wrap_word<metered_move>(state, "move");
  wrap_word<metered_unpack>(state, "unpack");
  lua_getfield(state, -2, "pack");
  lua_setfield(state, -2, "pack");
  set_word<sort>(state, "sort");
  lua_setglobal(state, LUA_TABLIBNAME);
  lua_pop(state, 1);
}

}  // namespace proofreel
