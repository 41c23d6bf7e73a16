#pragma once

/// Shapes as values of the language.

#include <lua.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/scene.h"
#include "scenarios/lua_fields.h"
#include "scenarios/lua_model.h"

namespace proofreel {

/// Geometry and the coefficients the shape has of its own. What is wrong with the geometry is said when a body takes
/// the shape, since only then there is a name to say it of.
struct ShapeValue {
  /// The points of the ShapeDefs it becomes: one list, or one for each convex part of a polygon.
  std::vector<std::vector<Vec2d>> parts;
  double radius = 0;
  std::optional<double> density;
  std::optional<FrictionDef> friction;
  std::optional<double> restitution;
  std::optional<double> rolling_resistance;
  std::optional<double> surface_speed;
  std::string problem;

  /// With the coefficients of its own or else of the body.
  std::vector<ShapeDef> on_body(const Material& material) const;
};

/// The words circle, box, polygon, hull, regular, capsule, segment.
void open_shapes(lua_State* state);

/// The shape at `index`, or nothing.
const ShapeValue* to_shape(lua_State* state, int index);

/// The key `friction`: a number, or {static=, kinetic=}.
std::optional<FrictionDef> read_friction(const Fields& fields);
/// The key `restitution`, between 0 and 1.
std::optional<double> read_restitution(const Fields& fields);

}  // namespace proofreel
