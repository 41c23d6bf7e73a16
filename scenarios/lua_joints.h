#pragma once

/// Joints of the language: a word per kind, and what their handles can do.

#include <lua.hpp>

#include "scenarios/lua_bodies.h"
#include "scenarios/lua_words.h"

namespace proofreel {

/// What handles of joints can do, and on_break.
void open_joint_methods(lua_State* state);

}  // namespace proofreel
