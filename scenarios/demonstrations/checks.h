#pragma once

/// What the algorithms do not take of shapes and points that are all right by themselves: the end of a sentence that
/// begins with the algorithm's name, or nothing. How many there may be is checked before.

#include <optional>
#include <string>

#include "scenarios/demonstration.h"

namespace proofreel {

std::optional<std::string> check_points(const Demonstration& d);
std::optional<std::string> check_outline(const Demonstration& d);
std::optional<std::string> check_polygons(const Demonstration& d);
std::optional<std::string> check_axes(const Demonstration& d);
std::optional<std::string> check_boxes(const Demonstration& d);
std::optional<std::string> check_circle(const Demonstration& d);
std::optional<std::string> check_body(const Demonstration& d);
std::optional<std::string> check_vectors(const Demonstration& d);
std::optional<std::string> check_transform(const Demonstration& d);
std::optional<std::string> check_intervals(const Demonstration& d);
std::optional<std::string> check_masses(const Demonstration& d);
std::optional<std::string> check_block(const Demonstration& d);
std::optional<std::string> check_stack(const Demonstration& d);

}  // namespace proofreel
