#include "scenarios/demonstrations/checks.h"

#include <algorithm>
#include <cmath>

#include "engine/outline.h"
#include "engine/polygon.h"
#include "scenarios/demonstrations/stack.h"
#include "scenarios/demonstrations/storyboard.h"
#include "scenarios/demonstrations/weighed.h"

namespace proofreel {
namespace {

constexpr std::size_t most_corners = 8;
constexpr std::size_t most_contacts = 8;

bool is_polygon(const DemonstrationShape& shape) {
  return shape.parts.size() == 1 && shape.parts[0].size() >= 3 && shape.radius == 0;
}

bool is_circle(const DemonstrationShape& shape) { return shape.parts.size() == 1 && shape.parts[0].size() == 1; }

bool is_convex_polygon(const DemonstrationShape& shape) {
  return is_polygon(shape) && shape.parts[0].size() <= most_corners;
}

}  // namespace

std::optional<std::string> check_points(const Demonstration& d) {
  if (convex_hull(d.points).size() >= 3) return std::nullopt;
  return "takes points that are not all on one line: move one off the line";
}

std::optional<std::string> check_outline(const Demonstration& d) {
  const auto cleaned = clean_polygon(d.points);
  if (const auto* problem = std::get_if<std::string>(&cleaned)) return "takes an outline, but " + *problem;
  if (std::get<0>(cleaned).size() == d.points.size()) return std::nullopt;
  return std::string(
      "takes the corners of an outline, none of them twice and none within a straight edge: leave it out");
}

std::optional<std::string> check_polygons(const Demonstration& d) {
  if (std::all_of(d.shapes.begin(), d.shapes.end(), is_convex_polygon)) return std::nullopt;
  return "takes two convex polygons without rounding, of at most " + std::to_string(most_corners) + " corners each";
}

/// Every axis has a bar of its own.
std::optional<std::string> check_axes(const Demonstration& d) {
  constexpr std::size_t most_axes = 10;
  if (const auto problem = check_polygons(d)) return problem;
  if (d.shapes[0].parts[0].size() + d.shapes[1].parts[0].size() <= most_axes) return std::nullopt;
  return "takes two convex polygons of at most " + std::to_string(most_axes) + " corners together";
}

std::optional<std::string> check_boxes(const Demonstration& d) {
  const auto box_of = [](const DemonstrationShape& shape) {
    Aabbd box;
    for (const auto& part : shape.parts) box = merged(box, expanded(bounds_of(part), shape.radius));
    return box;
  };
  for (std::size_t i = 0; i < d.shapes.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Aabbd a = box_of(d.shapes[i]), b = box_of(d.shapes[j]);
      if (a.lower == b.lower && a.upper == b.upper)
        return "takes shapes whose boxes differ, but shape " + std::to_string(j + 1) + " and shape " +
               std::to_string(i + 1) + " have the same one: move one of them";
    }
  }
  return std::nullopt;
}

std::optional<std::string> check_circle(const Demonstration& d) {
  const bool other = is_circle(d.shapes[1]) || is_convex_polygon(d.shapes[1]);
  if (is_circle(d.shapes[0]) && other) return std::nullopt;
  return "takes a circle, and then a circle or a convex polygon without rounding of at most " +
         std::to_string(most_corners) + " corners";
}

std::optional<std::string> check_body(const Demonstration& d) {
  const DemonstrationShape& shape = d.shapes[0];
  const auto thin = [](const auto& part) { return part.size() < 3; };
  if (shape.radius == 0 && std::none_of(shape.parts.begin(), shape.parts.end(), thin)) return std::nullopt;
  return std::string("takes a polygon, convex or concave, without rounding");
}

/// Vectors from the origin: two that span something, and points looked at from there.
std::optional<std::string> check_vectors(const Demonstration& d) {
  for (std::size_t i = 0; i < d.points.size(); ++i) {
    if (length(d.points[i]) > 0) continue;
    return "takes the vectors a and b and then points to look at, none of them {0, 0}: change point " +
           std::to_string(i + 1);
  }
  return std::nullopt;
}

std::optional<std::string> check_transform(const Demonstration& d) {
  const auto fits = [](double scale) { return std::abs(scale) >= 0.01 && std::abs(scale) <= 100; };
  if (!is_convex_polygon(d.shapes[0]))
    return "takes a convex polygon without rounding of at most " + std::to_string(most_corners) + " corners";
  if (fits(d.placing->scale.x) && fits(d.placing->scale.y)) return std::nullopt;
  return std::string("takes scales between 0.01 and 100, or between -100 and -0.01");
}

std::optional<std::string> check_intervals(const Demonstration& d) {
  const auto fits = [](const DemonstrationShape& shape) {
    const std::vector<Vec2d>& ends = shape.parts[0];
    return ends.size() == 2 && shape.radius == 0 && ends[0].y == 0 && ends[1].y == 0;
  };
  if (std::all_of(d.shapes.begin(), d.shapes.end(), fits)) return std::nullopt;
  return std::string("takes two intervals of the x axis: segment{a={x1, 0}, b={x2, 0}}");
}

std::optional<std::string> check_masses(const Demonstration& d) {
  const auto has_mass = [](const DemonstrationShape& shape) {
    return shape.parts.size() == 1 && (shape.radius > 0 || shape.parts[0].size() >= 3) && shape.density > 0;
  };
  if (std::all_of(d.shapes.begin(), d.shapes.end(), has_mass)) return std::nullopt;
  return std::string("takes convex shapes with an area and a density above 0: build concave ones from parts");
}

/// The force acts in the centre of mass and tilts by two degrees beyond the cone: up to there its line must go through
/// the base, or the block would tip over. With less friction it would slide out of the picture.
std::optional<std::string> check_block(const Demonstration& d) {
  const DemonstrationShape& block = d.shapes[0];
  if (const auto problem = check_masses(d)) return problem;
  if (!is_convex_polygon(block))
    return "takes a convex polygon without rounding of at most " + std::to_string(most_corners) + " corners";
  if (!(block.friction.sliding >= 0.2 && block.friction.sliding < block.friction.at_rest &&
        block.friction.at_rest <= 1))
    return std::string("takes a shape with friction={static=, kinetic=} between 0.2 and 1, the static one larger");
  const Vec2d center = weighed(block).center;
  const double floor = bounds_of(block.parts[0]).lower.y;
  double right = center.x;
  for (const Vec2d corner : block.parts[0]) right = corner.y == floor ? std::max(right, corner.x) : right;
  if (std::count_if(block.parts[0].begin(), block.parts[0].end(), [&](Vec2d p) { return p.y == floor; }) < 2)
    return std::string("takes a block that stands on a level edge");
  constexpr double beyond = 0.0349;  // the tangent of two degrees
  const double tilt = (block.friction.at_rest + beyond) / (1 - block.friction.at_rest * beyond);
  if (tilt * (center.y - floor) < right - center.x) return std::nullopt;
  return std::string("takes a block that slides before it tips over to the right: make it lower or wider");
}

std::optional<std::string> check_stack(const Demonstration& d) {
  if (const auto problem = check_masses(d)) return problem;
  if (!std::all_of(d.shapes.begin(), d.shapes.end(), is_convex_polygon))
    return "takes convex polygons without rounding, of at most " + std::to_string(most_corners) + " corners each";
  const Stack stack(d.shapes);
  std::vector<bool> touches(d.shapes.size() + 1);
  for (const Contact& contact : stack.contacts()) {
    const double size = extent_of(d.shapes[contact.body_b - 1].parts[0]);
    if (deepest(contact.manifold) < -0.01 * size)
      return "takes shapes that only touch, but the contact " + stack.name(contact) + " is an overlap: move them apart";
    touches[contact.body_a] = touches[contact.body_b] = true;
  }
  const auto alone = std::find(touches.begin() + 1, touches.end(), false);
  if (alone != touches.end())
    return "takes shapes that rest on each other and on level ground, but shape " +
           std::to_string(alone - touches.begin()) + " touches nothing";
  if (stack.contacts().size() <= most_contacts) return std::nullopt;
  return "takes shapes with at most " + std::to_string(most_contacts) + " contacts, got " +
         std::to_string(stack.contacts().size());
}

}  // namespace proofreel
