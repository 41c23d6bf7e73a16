#include "scenarios/lua_values.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include "scenarios/lua_model.h"
#include "scenarios/lua_sandbox.h"
#include "scenarios/suggest.h"
#include "scenarios/utf8.h"

namespace proofreel {
namespace {

constexpr const char* vector_type = "proofreel.vector";
constexpr const char* body_type = "proofreel.body";
constexpr const char* joint_type = "proofreel.joint";
constexpr const char* number_of_value = "proofreel.numbers";
constexpr const char* body_handles = "proofreel.bodies";
constexpr const char* joint_handles = "proofreel.joints";

/// 1 for "x", 2 for "y", else 0.
int component(lua_State* state, int index) {
  if (lua_type(state, index) != LUA_TSTRING) return 0;
  const std::string_view name = lua_tostring(state, index);
  return name == "x" ? 1 : name == "y" ? 2 : 0;
}

int vector_index(lua_State* state) {
  const int slot = component(state, 2);
  if (slot == 0) return 0;
  lua_rawgeti(state, 1, slot);
  return 1;
}

int vector_newindex(lua_State* state) {
  const int slot = component(state, 2);
  if (slot != 0) {
    lua_rawseti(state, 1, slot);
  } else {
    lua_rawset(state, 1);
  }
  return 0;
}

/// Methods stand in a table of the registry; asking for one that is not there is a mistake.
int find_method(lua_State* state, const char* methods, const char* what) {
  luaL_getsubtable(state, LUA_REGISTRYINDEX, methods);
  lua_pushvalue(state, 2);
  if (lua_rawget(state, -2) != LUA_TNIL) return 1;
  std::vector<std::string> names;
  for (lua_pushnil(state); lua_next(state, 3) != 0; lua_pop(state, 1)) names.emplace_back(lua_tostring(state, -2));
  std::sort(names.begin(), names.end());
  const std::string asked = lua_type(state, 2) == LUA_TSTRING ? lua_tostring(state, 2) : described(state, 2);
  throw Problem(std::string(what) + " has no " + quote(asked) + ", " + did_you_mean(asked, names));
}

int body_index(lua_State* state) { return find_method(state, body_methods, "a body"); }
int joint_index(lua_State* state) { return find_method(state, joint_methods, "a joint"); }

int refuse_assignment(lua_State* state) {
  throw Problem("handles have no fields to assign to (" + described(state, 2) + "); use b:set{...}");
}

int body_text(lua_State* state) {
  const std::string text = shown(state, 1);
  lua_pushlstring(state, text.data(), text.size());
  return 1;
}

void make_handle_type(lua_State* state, const char* type, lua_CFunction index) {
  luaL_newmetatable(state, type);
  lua_pushcfunction(state, index);
  lua_setfield(state, -2, "__index");
  set_word<refuse_assignment>(state, "__newindex");
  set_word<body_text>(state, "__tostring");
  lua_pop(state, 1);
}

template <typename Id>
void push_handle(lua_State* state, const char* handles, const char* type, Id id) {
  luaL_getsubtable(state, LUA_REGISTRYINDEX, handles);
  if (lua_rawgeti(state, -1, static_cast<lua_Integer>(id)) == LUA_TNIL) {
    lua_pop(state, 1);
    *static_cast<Id*>(lua_newuserdatauv(state, sizeof(Id), 0)) = id;
    luaL_setmetatable(state, type);
    lua_pushvalue(state, -1);
    lua_rawseti(state, -3, static_cast<lua_Integer>(id));
  }
  lua_remove(state, -2);
}

template <typename Id>
std::optional<Id> to_handle(lua_State* state, int index, const char* type) {
  const void* handle = luaL_testudata(state, index, type);
  if (handle == nullptr) return std::nullopt;
  return *static_cast<const Id*>(handle);
}

/// `table: 3`, the third value whose number anybody asked for.
std::string numbered(lua_State* state, int index) {
  index = lua_absindex(state, index);
  luaL_getsubtable(state, LUA_REGISTRYINDEX, number_of_value);
  lua_pushvalue(state, index);
  if (lua_rawget(state, -2) == LUA_TNIL) {
    lua_pop(state, 1);
    lua_rawgeti(state, -1, 0);
    lua_pushinteger(state, lua_tointeger(state, -1) + 1);
    lua_remove(state, -2);
    lua_pushvalue(state, -1);
    lua_rawseti(state, -3, 0);
    lua_pushvalue(state, index);
    lua_pushvalue(state, -2);
    lua_rawset(state, -4);
  }
  const std::string number = std::to_string(lua_tointeger(state, -1));
  lua_pop(state, 2);
  return std::string(luaL_typename(state, index)) + ": " + number;
}

std::string number_text(lua_State* state, int index) {
  const lua_Number number = lua_tonumber(state, index);
  if (number != number) return "nan";  // the C library shows its sign, which differs between processors
  lua_pushvalue(state, index);         // converting in place would turn a table's key into a string
  const std::string text = lua_tostring(state, -1);
  lua_pop(state, 1);
  return text;
}

bool has_metatable(lua_State* state, int index, const char* type) {
  if (lua_getmetatable(state, index) == 0) return false;
  luaL_getmetatable(state, type);
  const bool same = lua_rawequal(state, -1, -2) != 0;
  lua_pop(state, 2);
  return same;
}

/// The number at [slot], or under `name`.
std::optional<double> vector_component(lua_State* state, int index, int slot, const char* name) {
  if (lua_rawgeti(state, index, slot) == LUA_TNIL) {
    lua_pop(state, 1);
    lua_pushstring(state, name);
    lua_rawget(state, index);
  }
  std::optional<double> number;
  if (lua_type(state, -1) == LUA_TNUMBER) number = lua_tonumber(state, -1);
  lua_pop(state, 1);
  return number;
}

bool has_two_entries(lua_State* state, int index) {
  int count = 0;
  lua_pushnil(state);
  while (lua_next(state, index) != 0) {
    lua_pop(state, 1);
    if (++count <= 2) continue;
    lua_pop(state, 1);
    return false;
  }
  return count == 2;
}

}  // namespace

void open_values(lua_State* state) {
  luaL_newmetatable(state, vector_type);
  set_word<vector_index>(state, "__index");
  set_word<vector_newindex>(state, "__newindex");
  lua_pop(state, 1);
  make_handle_type(state, body_type, guarded<body_index>);
  make_handle_type(state, joint_type, guarded<joint_index>);
  luaL_getsubtable(state, LUA_REGISTRYINDEX, number_of_value);
  lua_newtable(state);
  lua_pushstring(state, "k");  // values nobody else holds may go
  lua_setfield(state, -2, "__mode");
  lua_setmetatable(state, -2);
  lua_pop(state, 1);
}

std::string described(lua_State* state, int index) {
  switch (lua_type(state, index)) {
    case LUA_TNONE:
    case LUA_TNIL:
      return "nothing";
    case LUA_TSTRING:
      return quote(lua_tostring(state, index));
    case LUA_TNUMBER:
      return number_text(state, index);
    case LUA_TBOOLEAN:
      return lua_toboolean(state, index) != 0 ? "true" : "false";
    case LUA_TUSERDATA:
      if (to_body(state, index)) return "a body";
      if (to_joint(state, index)) return "a joint";
      return "a shape";
    default:
      return std::string("a ") + luaL_typename(state, index);
  }
}

std::string shown(lua_State* state, int index) {
  index = lua_absindex(state, index);
  if (const auto body = to_body(state, index)) return "body " + quote(model_of(state).name(*body));
  if (const auto joint = to_joint(state, index)) return "joint " + std::to_string(static_cast<unsigned>(*joint));
  switch (lua_type(state, index)) {
    case LUA_TNIL:
      return "nil";
    case LUA_TBOOLEAN:
      return lua_toboolean(state, index) != 0 ? "true" : "false";
    case LUA_TNUMBER:
      return number_text(state, index);
    case LUA_TSTRING: {
      std::size_t size = 0;
      const char* text = lua_tolstring(state, index, &size);
      return {text, size};
    }
    case LUA_TUSERDATA:
      return "shape";
    default:
      break;
  }
  if (has_metatable(state, index, vector_type)) {
    const Vec2d v = to_vector(state, index).value_or(Vec2d{});
    lua_pushfstring(state, "{%f, %f}", v.x, v.y);
    const std::string text = lua_tostring(state, -1);
    lua_pop(state, 1);
    return text;
  }
  return numbered(state, index);
}

void push_vector(lua_State* state, Vec2d v) {
  lua_createtable(state, 2, 0);
  lua_pushnumber(state, v.x);
  lua_rawseti(state, -2, 1);
  lua_pushnumber(state, v.y);
  lua_rawseti(state, -2, 2);
  luaL_setmetatable(state, vector_type);
}

std::optional<Vec2d> to_vector(lua_State* state, int index) {
  if (lua_type(state, index) != LUA_TTABLE) return std::nullopt;
  index = lua_absindex(state, index);
  const auto x = vector_component(state, index, 1, "x");
  const auto y = vector_component(state, index, 2, "y");
  if (!x || !y || !has_two_entries(state, index)) return std::nullopt;
  return Vec2d{*x, *y};
}

Vec2d vector_argument(lua_State* state, int index, const std::string& what) {
  const auto v = to_vector(state, index);
  if (!v) throw Problem(what + " must be a vector {x, y}, got " + described(state, index));
  if (!is_finite(*v)) throw Problem(what + " must be finite");
  return *v;
}

void push_body(lua_State* state, BodyId body) { push_handle(state, body_handles, body_type, body); }
void push_joint(lua_State* state, JointId joint) { push_handle(state, joint_handles, joint_type, joint); }

std::optional<BodyId> to_body(lua_State* state, int index) { return to_handle<BodyId>(state, index, body_type); }
std::optional<JointId> to_joint(lua_State* state, int index) { return to_handle<JointId>(state, index, joint_type); }

std::string text_to_show(lua_State* state, int index, const std::string& what) {
  constexpr std::size_t longest = 10000;
  if (lua_type(state, index) != LUA_TSTRING) {
    throw Problem(what + " must be a text in quotes, got " + described(state, index));
  }
  std::size_t size = 0;
  const char* text = lua_tolstring(state, index, &size);
  if (size > longest) throw Problem(what + " is longer than 10000 bytes");
  if (!is_plain_text({text, size})) throw Problem(what + " must be UTF-8 without control characters");
  return {text, size};
}

int keep_function(lua_State* state, int index, const std::string& what) {
  if (lua_type(state, index) != LUA_TFUNCTION) {
    throw Problem(what + " must be a function, got " + described(state, index));
  }
  lua_pushvalue(state, index);
  return luaL_ref(state, LUA_REGISTRYINDEX);
}

void push_function(lua_State* state, int reference) { lua_rawgeti(state, LUA_REGISTRYINDEX, reference); }

}  // namespace proofreel
