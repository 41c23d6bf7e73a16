#pragma once

/// How values cross between C++ and scripts: vectors, handles, and words for values in messages.

#include <lua.hpp>
#include <optional>
#include <string>

#include "engine/scene.h"

namespace proofreel {

/// Makes the metatables of vectors and handles; call once per state before pushing any.
void open_values(lua_State* state);

/// A value in words for messages: `3`, `"text"`, `a table`. Never an address.
std::string described(lua_State* state, int index);
/// What `tostring` gives: the same on every machine; tables and functions are numbered as they are first shown.
std::string shown(lua_State* state, int index);

/// A table {x, y} that also answers to .x and .y.
void push_vector(lua_State* state, Vec2d v);
/// {x, y} or {x=, y=}; nothing when the value is neither. The numbers may be NaN or infinite.
std::optional<Vec2d> to_vector(lua_State* state, int index);
/// An argument that must be a finite vector. `what` names it in the Problem thrown.
Vec2d vector_argument(lua_State* state, int index, const std::string& what);

/// The one handle of that body: equal bodies are equal values.
void push_body(lua_State* state, BodyId body);
void push_joint(lua_State* state, JointId joint);
std::optional<BodyId> to_body(lua_State* state, int index);
std::optional<JointId> to_joint(lua_State* state, int index);

/// The tables their methods are looked up in are filled by the files that know them.
inline constexpr const char* body_methods = "proofreel.body_methods";
inline constexpr const char* joint_methods = "proofreel.joint_methods";

/// The text at `index`, which must be one to show: at most 10000 bytes of UTF-8 without control characters. `what`
/// names it in the Problem thrown.
std::string text_to_show(lua_State* state, int index, const std::string& what);

/// Keeps the function at `index` for later; `what` names it in the Problem thrown when it is none.
int keep_function(lua_State* state, int index, const std::string& what);
void push_function(lua_State* state, int reference);

}  // namespace proofreel
