#include "engine/block_matrix.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/engine/random.h"
#include "tests/engine/scenes.h"

using namespace proofreel;
using namespace proofreel::test;

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

constexpr double no_limit = 1e9;

/// A random system of blocks, and the same in full.
struct System {
  BlockMatrix matrix;
  std::vector<int> most_rows;
  std::vector<std::vector<int>> below;

  explicit System(Random& random) : System(random, 1 + random.below(20), 0, 4) {}
  /// Of so many blocks, each with so many rows (0: any number), one in so many of which is not 0.
  System(Random& random, std::uint32_t blocks, int rows, std::uint32_t rarity) : below(blocks) {
    const int count = static_cast<int>(below.size());
    for (int c = 0; c < count; ++c) {
      most_rows.push_back(rows > 0 ? rows : 1 + static_cast<int>(random.below(5)));
      for (int r = c + 1; r < count; ++r) {
        if (random.below(rarity) == 0) below[at(c)].push_back(r);
      }
    }
    REQUIRE(matrix.plan(below, most_rows, no_limit));
  }

  std::vector<std::vector<real>> fill(Random& random) {
    std::vector<std::vector<real>> dense(at(matrix.size()), std::vector<real>(at(matrix.size()), 0));
    for (int c = 0; c < static_cast<int>(below.size()); ++c) {
      fill_block(random, c, c, dense);
      for (const int r : below[at(c)]) fill_block(random, r, c, dense);
    }
    return dense;
  }

  void fill_block(Random& random, int row, int column, std::vector<std::vector<real>>& dense) {
    const BlockMatrix::Block block = matrix.block(matrix.place_of(row, column));
    for (int i = matrix.first(row); i < matrix.first(row + 1); ++i) {
      for (int k = matrix.first(column); k <= std::min(i, matrix.first(column + 1) - 1); ++k) {
        const auto x = static_cast<real>(i == k ? 80 + random.between(0, 5) : random.between(-1, 1));
        block(i - matrix.first(row), k - matrix.first(column)) = x;
        dense[at(i)][at(k)] = dense[at(k)][at(i)] = x;
      }
    }
  }
};

void require_solved(BlockMatrix& matrix, const std::vector<std::vector<real>>& dense, Random& random) {
  std::vector<real> truth;
  for (int r = 0; r < matrix.size(); ++r) truth.push_back(static_cast<real>(random.between(-3, 3)));
  std::vector<real> x(truth.size(), 0);
  for (std::size_t r = 0; r < x.size(); ++r) {
    for (std::size_t c = 0; c < x.size(); ++c) x[r] += dense[r][c] * truth[c];
  }
  matrix.factor();
  matrix.solve(x);
  for (std::size_t r = 0; r < x.size(); ++r) REQUIRE(x[r] == Approx(truth[r]).margin(pick(1e-13, 1e-5)));
}

}  // namespace

TEST_CASE("A factored system solves to the vector it was made from", "[block_matrix]") {
  Random random(3);
  for (int round = 0; round < 50; ++round) {
    System system(random);
    require_solved(system.matrix, system.fill(random), random);
  }
}

// Small systems are solved by other loops than large ones, and those whose blocks are alike by others again.
TEST_CASE("So does a large one: of pins with two equations each, of bodies with three, or of all kinds",
          "[block_matrix]") {
  const int rows = GENERATE(0, 2, 3);
  Random random(4);
  for (int round = 0; round < 30; ++round) {
    System system(random, 1 + random.below(90), rows, 2 + random.below(20));
    CAPTURE(round, system.matrix.size());
    require_solved(system.matrix, system.fill(random), random);
  }
}

TEST_CASE("Blocks that shrink and grow again leave nothing behind in the system", "[block_matrix]") {
  Random random(5);
  System system(random);
  for (int round = 0; round < 50; ++round) {
    std::vector<int> rows;
    for (const int most : system.most_rows)
      rows.push_back(static_cast<int>(random.below(static_cast<std::uint32_t>(most) + 1)));
    system.matrix.resize(rows);
    require_solved(system.matrix, system.fill(random), random);
  }
}

TEST_CASE("A tree numbered from its leaves costs in proportion to its size, a star of rows does not",
          "[block_matrix]") {
  const auto fits = [](int count, double work_per_block, auto parent_of) {
    std::vector<std::vector<int>> below(at(count));
    for (int i = 0; i + 1 < count; ++i) below[at(i)].push_back(parent_of(i));
    return BlockMatrix().plan(below, std::vector<int>(at(count), 1), work_per_block * count);
  };
  const int count = 4001;
  const auto chain = [](int i) { return i + 1; };
  const auto binary_tree = [](int i) { return count - 1 - (count - 2 - i) / 2; };
  CHECK(fits(count, 2, chain));
  CHECK(fits(count, 2, binary_tree));
  std::vector<std::vector<int>> hub(at(count));  // numbered from its middle: all the others meet
  for (int i = 1; i < count; ++i) hub[0].push_back(i);
  CHECK_FALSE(BlockMatrix().plan(hub, std::vector<int>(at(count), 1), 1e3 * count));
}

TEST_CASE("A row that repeats another one is dropped, not divided by", "[block_matrix]") {
  for (const std::vector<int>& blocks : {std::vector<int>{2}, std::vector<int>{1, 1}}) {
    BlockMatrix matrix;
    const bool together = blocks.size() == 1;
    matrix.plan(together ? std::vector<std::vector<int>>{{}} : std::vector<std::vector<int>>{{1}, {}}, blocks,
                no_limit);
    matrix.block(0)(0, 0) = 2;
    (together ? matrix.block(0)(1, 0) : matrix.block(1)(0, 0)) = 2;
    (together ? matrix.block(0)(1, 1) : matrix.block(2)(0, 0)) = 2;
    CHECK(matrix.factor() == 0);
    std::vector<real> x{4, 4};
    matrix.solve(x);
    CHECK(x[0] == Approx(2));
    CHECK(x[1] == 0);
  }
}

TEST_CASE("A system without rows has nothing to solve", "[block_matrix]") {
  BlockMatrix matrix;
  REQUIRE(matrix.plan({{1}, {}}, {2, 3}, no_limit));
  matrix.resize({0, 0});
  CHECK(matrix.factor() == 1);
  std::vector<real> x;
  matrix.solve(x);
  CHECK(x.empty());
}
