#pragma once

/// What the words that draw have in common.

#include <functional>
#include <string>
#include <vector>

#include "scenarios/lua_model.h"

namespace proofreel {

/// The model, for a word that adds to the picture; throws Problem where scripts may only look.
Model& drawing_model(lua_State* state, const char* word);

/// Throws a Problem about a list; what is wrong comes without its name: "must be a list of names".
using RefuseList = std::function<void(const std::string&)>;

/// The strings of the list on top of the stack.
std::vector<std::string> read_names(lua_State* state, const RefuseList& refuse);

/// The layers that the list on top of the stack names, and those that whoever marks a body wants to see anyway.
std::vector<Layer> read_layers(lua_State* state, const RefuseList& refuse);

}  // namespace proofreel
