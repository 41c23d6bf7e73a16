#include "engine/elimination.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "tests/engine/random.h"

using namespace proofreel;

namespace {

using Graph = std::vector<std::vector<int>>;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

void connect(Graph& graph, int a, int b) {
  graph[at(a)].push_back(b);
  graph[at(b)].push_back(a);
}

Graph sorted(Graph graph) {
  for (std::vector<int>& list : graph) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return graph;
}

Graph random_graph(Random& random, int count, int links) {
  Graph graph(at(count));
  for (int i = 0; i < links; ++i) {
    const int a = static_cast<int>(random.below(static_cast<std::uint32_t>(count)));
    const int b = static_cast<int>(random.below(static_cast<std::uint32_t>(count)));
    if (a != b) connect(graph, a, b);
  }
  return sorted(graph);
}

Graph random_tree(Random& random, int count) {
  Graph graph(at(count));
  for (int i = 1; i < count; ++i) connect(graph, i, static_cast<int>(random.below(static_cast<std::uint32_t>(i))));
  return sorted(graph);
}

Graph grid(int side) {
  Graph graph(at(side * side));
  for (int i = 0; i < side * side; ++i) {
    if (i % side > 0) connect(graph, i, i - 1);
    if (i >= side) connect(graph, i, i - side);
  }
  return sorted(graph);
}

/// Entries below the diagonal of the factors, by eliminating in that order one after the other.
int entries_of_factors(const Graph& graph, const std::vector<int>& turns) {
  std::vector<int> order(turns.size());
  for (int i = 0; i < static_cast<int>(turns.size()); ++i) order[at(turns[at(i)])] = i;
  std::vector<std::set<int>> left;
  for (const std::vector<int>& list : graph) left.emplace_back(list.begin(), list.end());
  int entries = 0;
  for (const int chosen : order) {
    entries += static_cast<int>(left[at(chosen)].size());
    for (const int i : left[at(chosen)]) {
      left[at(i)].insert(left[at(chosen)].begin(), left[at(chosen)].end());
      left[at(i)].erase(i);
      left[at(i)].erase(chosen);
    }
  }
  return entries;
}

int entries_of(const Graph& graph) {
  int ends = 0;
  for (const std::vector<int>& list : graph) ends += static_cast<int>(list.size());
  return ends / 2;
}

/// Always the first of those with the fewest neighbours, by looking at all of them.
std::vector<int> by_brute_force(const Graph& graph) {
  std::vector<std::set<int>> left;
  for (const std::vector<int>& list : graph) left.emplace_back(list.begin(), list.end());
  std::vector<int> turns(graph.size(), -1);
  for (int turn = 0; turn < static_cast<int>(graph.size()); ++turn) {
    int chosen = -1;
    for (int i = 0; i < static_cast<int>(graph.size()); ++i) {
      if (turns[at(i)] >= 0) continue;
      if (chosen < 0 || left[at(i)].size() < left[at(chosen)].size()) chosen = i;
    }
    turns[at(chosen)] = turn;
    for (const int i : left[at(chosen)]) {
      left[at(i)].insert(left[at(chosen)].begin(), left[at(chosen)].end());
      left[at(i)].erase(i);
      left[at(i)].erase(chosen);
    }
  }
  return turns;
}

}  // namespace

TEST_CASE("Everything has one turn of its own") {
  Random random(1);
  for (int trial = 0; trial < 50; ++trial) {
    const int count = 1 + static_cast<int>(random.below(60));
    std::vector<int> turns = elimination_turns(random_graph(random, count, 2 * count));
    std::sort(turns.begin(), turns.end());
    REQUIRE(turns.size() == at(count));
    for (int i = 0; i < count; ++i) REQUIRE(turns[at(i)] == i);
  }
}

TEST_CASE("The next is the first of those with the fewest neighbours left") {
  Random random(2);
  for (int trial = 0; trial < 50; ++trial) {
    const Graph graph = random_graph(random, 40, 70);
    REQUIRE(elimination_turns(graph) == by_brute_force(graph));
  }
}

TEST_CASE("Trees are eliminated without any fill") {
  Random random(3);
  for (int trial = 0; trial < 20; ++trial) {
    const Graph tree = random_tree(random, 80);
    REQUIRE(entries_of_factors(tree, elimination_turns(tree)) == entries_of(tree));
  }
}

TEST_CASE("A grid fills in less than half of what it does row by row") {
  constexpr int side = 30;
  const Graph graph = grid(side);
  std::vector<int> in_rows;
  for (int i = 0; i < side * side; ++i) in_rows.push_back(i);
  CHECK(2 * entries_of_factors(graph, elimination_turns(graph)) < entries_of_factors(graph, in_rows));
}

TEST_CASE("Nothing to eliminate takes no turns") { CHECK(elimination_turns({}).empty()); }
