#include <string_view>

#include "scenarios/lua_sandbox.h"
#include "scenarios/lua_strings.h"
#include "scenarios/lua_values.h"

namespace proofreel {
namespace {

/// Replaces the argument of a %s by its text where Lua would print an address.
void show_argument(lua_State* state, int argument) {
  const int type = lua_type(state, argument);
  const bool by_address = type == LUA_TTABLE || type == LUA_TFUNCTION || type == LUA_TUSERDATA;
  if (!by_address) return;
  const std::string text = shown(state, argument);
  lua_pushlstring(state, text.data(), text.size());
  lua_replace(state, argument);
}

int format(lua_State* state) {
  std::size_t size = 0;
  const char* text = luaL_checklstring(state, 1, &size);
  const std::string_view format{text, size};
  int argument = 1;
  for (std::size_t i = format.find('%'); i < format.size(); i = format.find('%', i + 1)) {
    i = format.find_first_not_of("-+ #0123456789.", i + 1);
    if (i == std::string_view::npos) break;
    if (format[i] == '%') continue;
    ++argument;
    if (format[i] == 'p') throw Problem("string.format: %p is not offered, addresses differ from run to run");
    if (format[i] == 's' && argument <= lua_gettop(state)) show_argument(state, argument);
  }
  return call_original(state);
}

/// The library's loop for nothing, repeated without end, is not counted by anyone.
int rep(lua_State* state) {
  std::size_t size = 0;
  std::size_t separator = 0;
  luaL_checklstring(state, 1, &size);
  luaL_optlstring(state, 3, "", &separator);
  if (size + separator > 0) return call_original(state);
  lua_pushliteral(state, "");
  return 1;
}

}  // namespace

void open_formats(lua_State* state) {
  wrap_word<format>(state, "format");
  wrap_word<rep>(state, "rep");
}

}  // namespace proofreel
