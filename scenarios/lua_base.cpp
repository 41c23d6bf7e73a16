#include <array>
#include <cstdio>

#include "scenarios/lua_bodies.h"
#include "scenarios/lua_values.h"
#include "scenarios/lua_words.h"
#include "scenarios/source.h"

namespace proofreel {
namespace {

constexpr int deepest_include = 20;

int to_string(lua_State* state) {
  luaL_checkany(state, 1);
  const std::string text = shown(state, 1);
  lua_pushlstring(state, text.data(), text.size());
  return 1;
}

/// To stderr: stdout is for data.
int print(lua_State* state) {
  std::string line;
  for (int i = 1; i <= lua_gettop(state); ++i) {
    if (i > 1) line += '\t';
    const std::string text = shown(state, i);
    sandbox_of(state).charge(text.size());
    line += text;
  }
  line += '\n';
  std::fwrite(line.data(), 1, line.size(), stderr);
  return 0;
}

/// Runs another file of the scenario's folder tree and hands on what it returns.
int include(lua_State* state) {
  Model& model = model_of(state);
  model.must_load("include");
  if (lua_type(state, 1) != LUA_TSTRING) throw Problem("include needs the name of a file, got " + described(state, 1));
  Sandbox& sandbox = sandbox_of(state);
  const std::string path = included_path(sandbox.path(), lua_tostring(state, 1));
  if (model.includes_open >= deepest_include) {
    throw Problem("include " + quote(lua_tostring(state, 1)) + ": files include each other without end");
  }
  const std::string text = read_source(path);
  sandbox.charge(text.size());
  lua_settop(state, 0);
  sandbox.compile(path, text);
  ++model.includes_open;
  lua_call(state, 0, LUA_MULTRET);
  --model.includes_open;
  return lua_gettop(state);
}

constexpr std::array kept{"assert", "error", "ipairs", "select", "tonumber", "type"};

}  // namespace

void open_base(lua_State* state) {
  luaL_requiref(state, LUA_GNAME, luaopen_base, 0);
  lua_newtable(state);
  for (const char* name : kept) {
    lua_getfield(state, -2, name);
    lua_setfield(state, -2, name);
  }
  set_word<to_string>(state, "tostring");
  set_word<print>(state, "print");
  set_word<include>(state, "include");
  lua_rawseti(state, LUA_REGISTRYINDEX, LUA_RIDX_GLOBALS);
  lua_pop(state, 1);
}

}  // namespace proofreel
