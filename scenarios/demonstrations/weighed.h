#pragma once

/// Shapes with their masses as the engine weighs them (engine/mass.h), for the films on what they weigh together.

#include "engine/mass.h"
#include "scenarios/demonstrations/storyboard.h"

namespace proofreel {

/// A shape of one part.
inline MassProperties weighed(const DemonstrationShape& shape) {
  ShapeDef def;
  def.points = shape.parts[0];
  def.radius = shape.radius;
  def.density = shape.density;
  return mass_of(def);
}

/// All shapes of a demonstration.
inline std::vector<MassProperties> weighed(const Demonstration& demonstration) {
  std::vector<MassProperties> masses;
  for (const DemonstrationShape& shape : demonstration.shapes) masses.push_back(weighed(shape));
  return masses;
}

/// "m_{2}"
inline std::string numbered(const std::string& symbol, std::size_t index) {
  return filled("%_{%}", {symbol, figure(index + 1)});
}

}  // namespace proofreel
