#include "render/changed_tiles.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

using namespace proofreel;

namespace {

int count_of(const std::vector<unsigned char>& marked) {
  return static_cast<int>(std::count(marked.begin(), marked.end(), 1));
}

/// How often each tile is covered.
std::vector<int> times_covered(const TileGrid& grid, const std::vector<TileSpan>& parts) {
  std::vector<int> times(grid.size());
  for (const TileSpan& part : parts) {
    for (int row = part.top; row < part.bottom; ++row) {
      for (int column = part.left; column < part.right; ++column) ++times.at(grid.number(column, row));
    }
  }
  return times;
}

/// Some blobs of marked tiles, as things that move leave them.
std::vector<unsigned char> blobs(const TileGrid& grid, int count, std::mt19937& random) {
  std::vector<unsigned char> marked(grid.size());
  const TileSpan whole = grid.whole();
  for (int i = 0; i < count; ++i) {
    const auto across = static_cast<int>(random() % static_cast<unsigned>(whole.right));
    const auto down = static_cast<int>(random() % static_cast<unsigned>(whole.bottom));
    const int side = 1 + static_cast<int>(random() % 9);
    for (int row = down; row < std::min(down + side, whole.bottom); ++row) {
      for (int column = across; column < std::min(across + side, whole.right); ++column)
        marked[grid.number(column, row)] = 1;
    }
  }
  return marked;
}

std::vector<std::uint64_t> some_hashes(const TileGrid& grid) {
  std::vector<std::uint64_t> hashes(grid.size());
  for (std::size_t i = 0; i < hashes.size(); ++i) hashes[i] = 1000 + i;
  return hashes;
}

/// Begins and settles a picture.
std::vector<TileSpan> drawn(ChangedTiles& tiles, const std::vector<std::uint64_t>& hashes) {
  std::vector<TileSpan> parts = tiles.begin(hashes);
  tiles.settle();
  return parts;
}

}  // namespace

TEST_CASE("Parts hold every marked tile once, no tile twice, and each has at most 64 tiles that are not marked") {
  std::mt19937 random(5);
  for (int round = 0; round < 300; ++round) {
    const TileGrid grid(1 + static_cast<int>(random() % 2000), 1 + static_cast<int>(random() % 1200));
    const std::vector<unsigned char> marked = blobs(grid, round % 40, random);
    const std::vector<TileSpan> parts = parts_that_hold(grid, marked);
    const std::vector<int> times = times_covered(grid, parts);
    int wrong = 0;
    for (std::size_t i = 0; i < marked.size(); ++i) wrong += times[i] > 1 || times[i] < marked[i] ? 1 : 0;
    CAPTURE(round);
    CHECK(wrong == 0);
    int covered = 0;
    for (const TileSpan& part : parts) covered += tiles_in(part);
    CHECK(covered <= count_of(marked) + 64 * static_cast<int>(parts.size()));
    CHECK(static_cast<int>(parts.size()) <= count_of(marked));
  }
}

TEST_CASE("Where nothing is marked there are no parts, where everything is there is one") {
  const TileGrid grid(1920, 1080);
  CHECK(parts_that_hold(grid, std::vector<unsigned char>(grid.size(), 0)).empty());
  CHECK(parts_that_hold(grid, std::vector<unsigned char>(grid.size(), 1)) == std::vector<TileSpan>{grid.whole()});
}

TEST_CASE("Two things far apart are two parts, two near each other one") {
  const TileGrid grid(1920, 1080);
  std::vector<unsigned char> marked(grid.size());
  marked[grid.number(10, 10)] = 1;
  marked[grid.number(13, 12)] = 1;
  CHECK(parts_that_hold(grid, marked) == std::vector<TileSpan>{{10, 14, 10, 13}});
  marked[grid.number(100, 60)] = 1;
  CHECK(parts_that_hold(grid, marked) == std::vector<TileSpan>{{10, 14, 10, 13}, {100, 101, 60, 61}});
}

TEST_CASE("The last tiles of a picture end with it") {
  const TileGrid grid(33, 17);
  CHECK(grid.whole() == TileSpan{0, 3, 0, 2});
  CHECK(grid.pixels_of({2, 3, 1, 2}) == PixelRect{32, 16, 1, 1});
  CHECK(grid.span_of({{-50, -50}, {500, 3}}) == TileSpan{0, 3, 0, 1});
}

TEST_CASE("The first picture is drawn whole, the same again nowhere, and another one where it differs") {
  const TileGrid grid(1920, 1080);
  ChangedTiles tiles(grid);
  std::vector<std::uint64_t> hashes = some_hashes(grid);
  CHECK(drawn(tiles, hashes) == std::vector<TileSpan>{grid.whole()});
  const Edition first = tiles.edition();
  CHECK(drawn(tiles, hashes).empty());
  CHECK(tiles.edition().same_as(first));
  hashes[grid.number(7, 8)] = 1;
  CHECK(drawn(tiles, hashes) == std::vector<TileSpan>{{7, 8, 8, 9}});
  CHECK(tiles.edition().follows(first));
  CHECK(tiles.edition().changes.size() == 1);
}

TEST_CASE("When more than half of a picture has changed it is drawn in one, but only what changed counts as changed") {
  const TileGrid grid(1920, 1080);
  ChangedTiles tiles(grid);
  std::vector<std::uint64_t> hashes = some_hashes(grid);
  drawn(tiles, hashes);
  const Edition first = tiles.edition();
  for (int row = 0; row < 45; ++row) {
    for (int column = 0; column < 120; ++column) ++hashes[grid.number(column, row)];
  }
  CHECK(drawn(tiles, hashes) == std::vector<TileSpan>{grid.whole()});
  CHECK(tiles.parts_since(first) == std::vector<TileSpan>{{0, 120, 0, 45}});
}

TEST_CASE("An older edition lacks what has changed in all pictures since, one of another series everything") {
  const TileGrid grid(1920, 1080);
  ChangedTiles tiles(grid), others(grid);
  std::vector<std::uint64_t> hashes = some_hashes(grid);
  drawn(tiles, hashes);
  drawn(others, hashes);
  const Edition first = tiles.edition();
  for (const auto& [column, row] : {std::pair{3, 2}, {60, 30}, {110, 60}}) {
    ++hashes[grid.number(column, row)];
    drawn(tiles, hashes);
  }
  CHECK(tiles.parts_since(first) == std::vector<TileSpan>{{3, 4, 2, 3}, {60, 61, 30, 31}, {110, 111, 60, 61}});
  CHECK(tiles.parts_since(tiles.edition()).empty());
  CHECK(tiles.parts_since({}) == std::vector<TileSpan>{grid.whole()});
  CHECK(tiles.parts_since(others.edition()) == std::vector<TileSpan>{grid.whole()});
}

TEST_CASE("After a picture that was begun and not settled the next is drawn whole, in a series of its own") {
  const TileGrid grid(640, 480);
  ChangedTiles tiles(grid);
  const std::vector<std::uint64_t> hashes = some_hashes(grid);
  drawn(tiles, hashes);
  const Edition before = tiles.edition();
  tiles.begin(hashes);
  CHECK(drawn(tiles, hashes) == std::vector<TileSpan>{grid.whole()});
  CHECK(tiles.edition().series != before.series);
  CHECK_FALSE(tiles.edition().follows(before));
  CHECK(tiles.parts_since(before) == std::vector<TileSpan>{grid.whole()});
}

TEST_CASE("Bytes know their edition until somebody may write to them, and take it along") {
  Image image = Image::uncleared(4, 4);
  CHECK(image.rgba.edition().number == 0);
  image.rgba.become({7, 3, {}});
  const Image& looked_at = image;
  CHECK(looked_at.row(1) != nullptr);
  CHECK(looked_at.rgba.edition().number == 3);
  Image copy = image;
  CHECK(copy.rgba.edition().same_as(image.rgba.edition()));
  const Image moved = std::move(copy);
  CHECK(moved.rgba.edition().series == 7);
  CHECK(copy.rgba.edition().number == 0);
  image.rgba[0] = 1;
  CHECK(image.rgba.edition().number == 0);
  CHECK(moved.rgba.edition().number == 3);
  Image larger = moved;
  larger.rgba.resize(100);
  CHECK(larger.rgba.edition().number == 0);
}

TEST_CASE("Editions that are not known are neither the same nor follow each other") {
  CHECK_FALSE(Edition{}.same_as(Edition{}));
  CHECK_FALSE(Edition{0, 1, {}}.follows(Edition{}));
  CHECK_FALSE(Edition{1, 2, {}}.follows(Edition{2, 1, {}}));
  CHECK_FALSE(Edition{1, 3, {}}.follows(Edition{1, 1, {}}));
  CHECK(Edition{1, 3, {}}.follows(Edition{1, 2, {}}));
}
