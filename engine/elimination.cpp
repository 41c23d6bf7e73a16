#include "engine/elimination.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

namespace proofreel {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Those of a and b, but neither `one` nor `other`.
std::vector<int> united(const std::vector<int>& a, const std::vector<int>& b, int one, int other) {
  std::vector<int> both;
  both.reserve(a.size() + b.size());
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  std::erase_if(both, [&](int i) { return i == one || i == other; });
  return both;
}

}  // namespace

std::vector<int> elimination_turns(std::vector<std::vector<int>> neighbours) {
  std::vector<int> turns(neighbours.size(), -1);
  std::set<std::pair<std::size_t, int>> left;  // by how many neighbours each has
  for (int i = 0; i < static_cast<int>(neighbours.size()); ++i) left.insert({neighbours[at(i)].size(), i});
  for (int turn = 0; !left.empty(); ++turn) {
    const int chosen = left.begin()->second;
    left.erase(left.begin());
    turns[at(chosen)] = turn;
    for (const int i : neighbours[at(chosen)]) {
      left.erase({neighbours[at(i)].size(), i});
      neighbours[at(i)] = united(neighbours[at(i)], neighbours[at(chosen)], i, chosen);
      left.insert({neighbours[at(i)].size(), i});
    }
  }
  return turns;
}

}  // namespace proofreel
