#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "scenarios/lua_bodies.h"
#include "scenarios/lua_values.h"
#include "scenarios/lua_words.h"

namespace proofreel {
namespace {

constexpr std::uint64_t cost_per_key = 50;  // its SortKey lies outside Lua's memory

/// In the order of traversal.
enum class KeyKind : std::uint8_t { number, text, boolean, body, joint, other };

/// A key as something to sort by. Text points into Lua's memory, which the traversed table keeps.
struct SortKey {
  KeyKind kind = KeyKind::other;
  bool is_integer = false;
  lua_Integer integer = 0;
  lua_Number number = 0;
  std::string_view text;
  lua_Integer slot = 0;  ///< where the key stands in the list of keys
};

/// Exact, unlike comparing both as doubles. Lua holds no key that is a float with an integer's value.
bool integer_below(lua_Integer i, lua_Number x) {
  constexpr lua_Number beyond = 0x1p63;
  if (x >= beyond) return true;
  if (x < -beyond) return false;
  return i <= static_cast<lua_Integer>(std::floor(x));
}

bool number_below(const SortKey& a, const SortKey& b) {
  if (a.is_integer && b.is_integer) return a.integer < b.integer;
  if (a.is_integer) return integer_below(a.integer, b.number);
  if (b.is_integer) return !integer_below(b.integer, a.number);
  return a.number < b.number;
}

/// A strict total order: no two keys of a table are alike.
bool below(const SortKey& a, const SortKey& b) {
  if (a.kind != b.kind) return a.kind < b.kind;
  if (a.kind == KeyKind::number) return number_below(a, b);
  if (a.kind == KeyKind::text) return a.text < b.text;
  return a.integer < b.integer;
}

SortKey sort_key(lua_State* state, int index) {
  SortKey key;
  if (const auto body = to_body(state, index)) {
    key.kind = KeyKind::body;
    key.integer = static_cast<lua_Integer>(*body);
  } else if (const auto joint = to_joint(state, index)) {
    key.kind = KeyKind::joint;
    key.integer = static_cast<lua_Integer>(*joint);
  } else if (lua_type(state, index) == LUA_TNUMBER) {
    key.kind = KeyKind::number;
    key.is_integer = lua_isinteger(state, index) != 0;
    key.integer = lua_tointeger(state, index);
    key.number = lua_tonumber(state, index);
  } else if (lua_type(state, index) == LUA_TSTRING) {
    key.kind = KeyKind::text;
    std::size_t size = 0;
    const char* text = lua_tolstring(state, index, &size);
    key.text = {text, size};
  } else if (lua_type(state, index) == LUA_TBOOLEAN) {
    key.kind = KeyKind::boolean;
    key.integer = lua_toboolean(state, index);
  }
  return key;
}

/// Pushes a list of the keys of the table at index 1 as Lua happens to hold them, and returns them to sort.
std::vector<SortKey> collect_keys(lua_State* state) {
  std::vector<SortKey> keys;
  lua_newtable(state);
  const int list = lua_gettop(state);
  for (lua_pushnil(state); lua_next(state, 1) != 0; lua_pop(state, 1)) {
    SortKey key = sort_key(state, -2);
    key.slot = static_cast<lua_Integer>(keys.size()) + 1;
    keys.push_back(key);
    sandbox_of(state).charge(cost_per_key);
    lua_pushvalue(state, -2);
    lua_rawseti(state, list, key.slot);
  }
  return keys;
}

/// Upvalues: the table, its keys in order, how many were visited. Keys whose value is gone by now are passed over.
int next_pair(lua_State* state) {
  lua_Integer visited = lua_tointeger(state, lua_upvalueindex(3));
  while (lua_rawgeti(state, lua_upvalueindex(2), ++visited) != LUA_TNIL) {
    lua_pushvalue(state, -1);
    if (lua_rawget(state, lua_upvalueindex(1)) != LUA_TNIL) {
      lua_pushinteger(state, visited);
      lua_replace(state, lua_upvalueindex(3));
      return 2;
    }
    lua_pop(state, 2);
  }
  lua_pushnil(state);
  return 1;
}

int pairs(lua_State* state) {
  if (lua_type(state, 1) != LUA_TTABLE) throw Problem("pairs needs a table, got " + described(state, 1));
  lua_settop(state, 1);
  std::vector<SortKey> keys = collect_keys(state);
  const auto others = std::count_if(keys.begin(), keys.end(), [](const auto& k) { return k.kind == KeyKind::other; });
  if (others > 1) {
    throw Problem(
        "pairs: the order of keys that are tables or functions is not the same everywhere; "
        "use numbers, strings, bodies or joints as keys");
  }
  std::sort(keys.begin(), keys.end(), below);
  lua_pushvalue(state, 1);
  lua_createtable(state, static_cast<int>(keys.size()), 0);
  lua_Integer place = 0;
  for (const SortKey& key : keys) {
    lua_rawgeti(state, 2, key.slot);
    lua_rawseti(state, -2, ++place);
  }
  lua_pushinteger(state, 0);
  lua_pushcclosure(state, guarded<next_pair>, 3);
  return 1;
}

}  // namespace

void open_pairs(lua_State* state) {
  lua_pushglobaltable(state);
  set_word<pairs>(state, "pairs");
  lua_pop(state, 1);
}

}  // namespace proofreel
