#pragma once

/// Helps who mistyped a name.

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace proofreel {

/// How many letters must be inserted, dropped, changed or swapped with their neighbour to get from `a` to `b`.
int edit_distance(std::string_view a, std::string_view b);

/// The candidate nearest to `name`, or nothing when all are too far to be meant.
std::string_view nearest(std::string_view name, std::span<const std::string> candidates);

/// `did you mean "friction"?`, or the candidates when none is near: `known are "a", "b"`.
std::string did_you_mean(std::string_view name, std::span<const std::string> candidates);

/// `"a", "b", "c"`
std::string quoted_list(std::span<const std::string> names);

/// `text` in double quotes, cut when it is long.
std::string quote(std::string_view text);

}  // namespace proofreel
