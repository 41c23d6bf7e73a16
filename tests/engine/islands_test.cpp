#include "engine/islands.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/engine/random.h"

using namespace proofreel;

namespace {

using Numbers = std::vector<std::uint32_t>;

/// Numbers spread along the links until nothing changes.
Numbers by_brute_force(const std::vector<std::uint8_t>& takes_part, const std::vector<Link>& links) {
  Numbers least(takes_part.size());
  for (std::uint32_t i = 0; i < least.size(); ++i) least[i] = i;
  for (bool changed = true; changed;) {
    changed = false;
    for (const Link& link : links) {
      if (takes_part[link.a] == 0 || takes_part[link.b] == 0 || least[link.a] == least[link.b]) continue;
      least[link.a] = least[link.b] = std::min(least[link.a], least[link.b]);
      changed = true;
    }
  }
  Numbers numbers(least.size(), 0);
  std::uint32_t count = 0;
  for (std::uint32_t i = 0; i < least.size(); ++i) {
    if (takes_part[i] != 0) numbers[i] = least[i] == i ? ++count : numbers[least[i]];
  }
  return numbers;
}

}  // namespace

TEST_CASE("Islands are the connected components, whatever the graph", "[islands]") {
  Random random(GENERATE(range<std::uint64_t>(1, 41)));
  const std::uint32_t members = 1 + random.below(120);
  std::vector<std::uint8_t> takes_part(members);
  for (std::uint8_t& part : takes_part) part = random.below(5) > 0 ? 1 : 0;
  std::vector<Link> links(random.below(2 * members));
  for (Link& link : links) link = {random.below(members), random.below(members)};
  CHECK(number_islands(takes_part, links) == by_brute_force(takes_part, links));
  std::reverse(links.begin(), links.end());
  CHECK(number_islands(takes_part, links) == by_brute_force(takes_part, links));
}

TEST_CASE("A long chain is one island from whichever end it is linked", "[islands]") {
  const std::uint32_t length = 100000;
  const std::vector<std::uint8_t> all(length, 1);
  std::vector<Link> links;
  for (std::uint32_t i = 1; i < length; ++i) links.push_back({length - i, length - i - 1});
  CHECK(number_islands(all, links) == Numbers(length, 1));
}

TEST_CASE("Islands are numbered in order of their least members, and ground joins none", "[islands]") {
  const std::vector<std::uint8_t> all_but_ground{0, 1, 1, 1, 1, 1};
  const std::vector<Link> links{{0, 1}, {2, 0}, {0, 3}, {5, 2}, {4, 3}};
  CHECK(number_islands(all_but_ground, links) == Numbers{0, 1, 2, 3, 3, 2});
}

TEST_CASE("Where nothing takes part there are no islands", "[islands]") {
  CHECK(number_islands({}, {}).empty());
  const std::vector<Link> links{{0, 1}};
  CHECK(number_islands(std::vector<std::uint8_t>{0, 0}, links) == Numbers{0, 0});
}
