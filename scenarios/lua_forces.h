#pragma once

#include <optional>

#include "engine/scene.h"
#include "scenarios/lua_fields.h"

namespace proofreel {

/// The key `drag` of a body: a number (linear), or {linear=, quadratic=, angular=}.
std::optional<DragDef> read_drag(const Fields& fields);

}  // namespace proofreel
