// Refuses bodies that cannot be simulated, before they are.

#include <algorithm>
#include <cmath>

#include "engine/mass.h"
#include "engine/outline.h"
#include "engine/polygon.h"
#include "engine/simulation.h"

namespace proofreel {
namespace {

bool usable(double x) { return std::isfinite(x) && std::abs(x) <= max_coordinate; }
bool usable(Vec2d v) { return usable(v.x) && usable(v.y); }

std::optional<std::string> problem_with_coefficients(const ShapeDef& shape) {
  if (!(shape.density > 0) || !usable(shape.density))
    return "its density must be a number above 0 and up to 1e9 kg/m^2";
  for (const double mu : {shape.friction.at_rest, shape.friction.sliding}) {
    if (!(mu >= 0) || !usable(mu)) return "its friction must be a number not below 0";
  }
  if (shape.friction.at_rest < shape.friction.sliding)
    return "its static friction must not be below its kinetic friction";
  if (!(shape.restitution >= 0 && shape.restitution <= 1)) return "its restitution must lie between 0 and 1";
  if (!(shape.rolling_resistance >= 0) || !usable(shape.rolling_resistance)) {
    return "its rolling_resistance must be a number from 0 to 1e9 m";
  }
  if (!usable(shape.surface_speed)) return "its surface_speed must be a number below 1e9 m/s";
  return std::nullopt;
}

/// A polygon must be listed as the collision stages want it.
std::optional<std::string> problem_with_polygon(const std::vector<Vec2d>& corners) {
  if (corners.size() > max_polygon_vertices) {
    return "its polygon has " + std::to_string(corners.size()) + " corners, a convex one may have at most " +
           std::to_string(max_polygon_vertices) + "; leave some out, or cut it with convex_parts";
  }
  const auto cleaned = clean_polygon(corners, "its polygon");
  if (const auto* problem = std::get_if<std::string>(&cleaned)) return *problem;
  const auto& outline = std::get<std::vector<Vec2d>>(cleaned);
  if (!is_convex(outline)) return "its polygon is concave; cut it with convex_parts and make every part a shape";
  const bool repeats = std::adjacent_find(corners.begin(), corners.end()) != corners.end();
  if (repeats || corners.front() == corners.back() || !is_convex(corners)) {
    return "its polygon must be listed counter-clockwise, every corner once; use the corners that clean_polygon "
           "returns";
  }
  return std::nullopt;
}

std::optional<std::string> problem_with_outline(const ShapeDef& shape) {
  for (const Vec2d p : shape.points) {
    if (!usable(p)) return "its shape has a coordinate that is not a number below 1e9 m; give finite coordinates";
  }
  if (!(shape.radius >= 0) || !usable(shape.radius)) return "its radius must be a number from 0 to 1e9 m";
  if (shape.points.empty()) return "its shape has no points";
  if (shape.points.size() == 1 && shape.radius <= 0) return "its circle needs a radius above 0 (m)";
  if (shape.points.size() == 2 && shape.points[0] == shape.points[1]) {
    return "the two ends of its capsule or segment are the same point; move one, or use a circle";
  }
  if (shape.points.size() < 3) return std::nullopt;
  return problem_with_polygon(shape.points);
}

std::optional<std::string> problem_with_motion(const BodyDef& body) {
  if (!usable(body.position)) return "its position must be two numbers below 1e9 m";
  if (!usable(body.angle)) return "its angle must be a number below 1e9 rad";
  if (!usable(body.velocity)) return "its velocity must be two numbers below 1e9 m/s";
  if (!usable(body.spin)) return "its spin must be a number below 1e9 rad/s";
  if (!usable(body.gravity_scale)) return "its gravity_scale must be a number";
  return std::nullopt;
}

std::optional<std::string> problem_with_mass(const BodyDef& body) {
  if (body.mass && (!(*body.mass > 0) || !usable(*body.mass)))
    return "its mass must be a number above 0 and up to 1e9 kg";
  if (body.inertia && (!(*body.inertia > 0) || !usable(*body.inertia))) {
    return "its inertia must be a number above 0 and up to 1e9 kg m^2";
  }
  if (body.type != BodyType::dynamic) return std::nullopt;
  const MassProperties mass = mass_of(body);
  if (mass.mass > 0 && mass.inertia > 0) return std::nullopt;
  if (body.shapes.empty()) return "it is dynamic but has no shape; give it one, or give mass= and inertia=";
  return "it is dynamic but its shapes have no area; give mass=, or use shapes with an area";
}

}  // namespace

std::optional<std::string> problem_with(const BodyDef& body) {
  if (auto problem = problem_with_motion(body)) return problem;
  for (const ShapeDef& shape : body.shapes) {
    if (auto problem = problem_with_outline(shape)) return problem;
    if (auto problem = problem_with_coefficients(shape)) return problem;
  }
  return problem_with_mass(body);
}

}  // namespace proofreel
