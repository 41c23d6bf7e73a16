#pragma once

/// Bodies of the language: the word `body` and its shorthands.

#include <cstdint>
#include <lua.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/simulation.h"
#include "scenarios/lua_fields.h"
#include "scenarios/lua_shapes.h"

namespace proofreel {

/// What the keys of one `body{}` or `set{}` ask for. `change` holds what the simulation can take as it is; the rest
/// needs the rest of the body.
struct BodyKeys {
  ChangeBody change;
  std::optional<std::string> name;
  std::optional<std::vector<ShapeValue>> shapes;
  std::optional<std::int32_t> group;
  std::optional<std::uint64_t> category;
  std::optional<std::uint64_t> mask;
};

/// Reads the table at `index`.
BodyKeys read_body_keys(lua_State* state, int index, const std::string& word);

/// Puts what is given into the record.
void apply_keys(BodyRecord& record, const BodyKeys& keys);

/// Throws a Problem that names the body when its numbers or geometry cannot be used.
void check_body(const BodyDef& def);

/// The words body, ground, wall, world.
void open_bodies(lua_State* state);
/// What handles of bodies can do, and on_sleep.
void open_body_methods(lua_State* state);

}  // namespace proofreel
