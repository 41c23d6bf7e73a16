#pragma once

/// Islands: what hangs together, directly or through others. Bodies of one island can push each other, those of two
/// cannot, so that each island may be solved, or left asleep, by itself.
///
/// Found by disjoint sets: every member points to another one of its set and the last of that chain, the root, stands
/// for all of them. Uniting two sets lets one root point to the other; looking a root up lets every member passed on
/// the way point to its grandparent, so that chains stay short (path halving: Tarjan and van Leeuwen 1984).

#include <cstdint>
#include <span>
#include <vector>

namespace proofreel {

/// Two members that hang together.
struct Link {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
};

/// The number of each one's island: 1, 2, ... in order of the least member, and 0 for those that take no part. A link
/// to one that takes no part connects nothing: what stands on the same ground is not one island. The order of the links
/// does not matter. Time: almost linear.
std::vector<std::uint32_t> number_islands(std::span<const std::uint8_t> takes_part, std::span<const Link> links);

}  // namespace proofreel
