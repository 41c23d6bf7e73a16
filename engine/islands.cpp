#include "engine/islands.h"

#include <algorithm>
#include <numeric>

namespace proofreel {
namespace {

std::uint32_t root_of(std::vector<std::uint32_t>& parents, std::uint32_t i) {
  while (parents[i] != i) i = parents[i] = parents[parents[i]];
  return i;
}

/// The lesser root stays one, so that it is the least member of its set.
void unite(std::vector<std::uint32_t>& parents, std::uint32_t a, std::uint32_t b) {
  const auto [least, other] = std::minmax({root_of(parents, a), root_of(parents, b)});
  parents[other] = least;
}

}  // namespace

std::vector<std::uint32_t> number_islands(std::span<const std::uint8_t> takes_part, std::span<const Link> links) {
  std::vector<std::uint32_t> parents(takes_part.size());
  std::iota(parents.begin(), parents.end(), 0U);
  for (const Link& link : links) {
    if (takes_part[link.a] != 0 && takes_part[link.b] != 0) unite(parents, link.a, link.b);
  }
  std::vector<std::uint32_t> numbers(takes_part.size(), 0);
  std::uint32_t count = 0;
  for (std::uint32_t i = 0; i < numbers.size(); ++i) {
    if (takes_part[i] == 0) continue;
    const std::uint32_t root = root_of(parents, i);
    numbers[i] = root == i ? ++count : numbers[root];
  }
  return numbers;
}

}  // namespace proofreel
