#pragma once

/// Every file of words puts them into the globals; call each once per state.

#include <lua.hpp>

namespace proofreel {

/// The globals that scripts see, empty at first, with what the sandbox offers of Lua's own.
void open_base(lua_State* state);
void open_math(lua_State* state);
void open_strings(lua_State* state);
void open_tables(lua_State* state);
/// `pairs` in sorted key order.
void open_pairs(lua_State* state);

void open_scenario(lua_State* state);
/// Forces of the scene as a whole: drag, wind, attractor, nbody, buoyancy, field, rocket.
void open_forces(lua_State* state);
void open_joints(lua_State* state);
void open_time(lua_State* state);
void open_picture(lua_State* state);
/// Split screens: pane.
void open_panes(lua_State* state);
/// The course of the film: slow, freeze, section, layers.
void open_film(lua_State* state);
/// Algorithms as lecture films: demonstrate.
void open_demonstrate(lua_State* state);
void open_measures(lua_State* state);

}  // namespace proofreel
