#pragma once

#include <lua.hpp>

namespace proofreel {

/// Sets `format` and `rep` of the table on top of the stack, Lua's originals being in the table below it.
void open_formats(lua_State* state);

}  // namespace proofreel
