#include "golden/frame_source.h"

#include <catch2/catch.hpp>

#include "golden/diff_folders.h"
#include "render/png.h"
#include "tests/render/scratch_folder.h"
#include "tests/render/test_image.h"

namespace proofreel {
namespace {

using Catch::Matchers::Contains;
using Names = std::vector<std::string>;

TEST_CASE("Numbers in names count by value, and no two names are alike", "[frames]") {
  const Names sorted{
      "a", "a1", "a01", "a2", "a10", "a10b2", "a10b10", "b", "b99999999999999999998", "b99999999999999999999"};
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    for (std::size_t j = 0; j < sorted.size(); ++j) {
      CAPTURE(sorted[i], sorted[j]);
      const bool numbers_only = (i == 1 && j == 2) || (i == 2 && j == 1);
      if (!numbers_only) REQUIRE(comes_before(sorted[i], sorted[j]) == (i < j));
    }
  }
  REQUIRE(comes_before("a1", "a01") != comes_before("a01", "a1"));
}

TEST_CASE("A folder of pictures is read in the order of its numbers", "[frames]") {
  const ScratchFolder folder;
  for (const int number : {9, 10, 1}) {
    write_png(folder / ("frame_" + std::to_string(number) + ".png"),
              filled_image(4, 4, static_cast<std::uint8_t>(number), 0, 0));
  }
  write_text(folder / "notes.txt", "no picture");
  FrameSource frames(folder.path().string());
  REQUIRE(frames.stated_frames() == 3);
  Image image;
  for (const int number : {1, 9, 10}) {
    REQUIRE(frames.next(image));
    REQUIRE(image.rgba[0] == number);
  }
  REQUIRE_FALSE(frames.next(image));
}

TEST_CASE("A folder without pictures, a missing one and a film that is none are refused by name", "[frames]") {
  const ScratchFolder folder;
  REQUIRE_THROWS_WITH(FrameSource(folder.path().string()), Contains("no .png files"));
  REQUIRE_THROWS_WITH(FrameSource(folder / "none"), Contains("none"));
  write_text(folder / "a.mp4", "this is not a film");
  REQUIRE_THROWS_WITH(FrameSource(folder / "a.mp4"), Contains("a.mp4"));
  REQUIRE_THROWS_WITH(FrameSource(folder / "b.webm"), Contains("b.webm"));
}

TEST_CASE("A playlist that calls itself a film opens no other file", "[frames]") {
  const ScratchFolder folder;
  write_text(folder / "list.mp4", "#EXTM3U\n#EXTINF:1,\n/etc/passwd\n#EXT-X-ENDLIST\n");
  REQUIRE_THROWS_AS(FrameSource(folder / "list.mp4"), ImageError);
  write_text(folder / "concat.mkv", "ffconcat version 1.0\nfile /etc/passwd\n");
  REQUIRE_THROWS_AS(FrameSource(folder / "concat.mkv"), ImageError);
}

TEST_CASE("Two pictures are read together, and the one that is damaged is named", "[frames]") {
  const ScratchFolder folder;
  write_png(folder / "a.png", filled_image(3, 2, 1, 1, 1));
  write_png(folder / "b.png", filled_image(2, 3, 2, 2, 2));
  const ImagePair pair = read_pair(folder / "a.png", folder / "b.png");
  REQUIRE((pair.expected.width_px == 3 && pair.actual.width_px == 2));
  write_text(folder / "c.png", "no");
  REQUIRE_THROWS_WITH(read_pair(folder / "a.png", folder / "c.png"), Contains("c.png"));
  REQUIRE_THROWS_WITH(read_pair(folder / "c.png", folder / "a.png"), Contains("c.png"));
}

TEST_CASE("Folders are matched by the paths of their pictures", "[frames]") {
  const ScratchFolder folder;
  for (const char* name : {"then/a.png", "then/sub/b.png", "then/gone.png", "then/x.txt", "now/a.png", "now/sub/b.png",
                           "now/b.png", "now/film.mp4"}) {
    write_text(folder / name, "");
  }
  const FolderMatch match = match_folders(folder / "then", folder / "now");
  REQUIRE(match.both == Names{"a.png", "sub/b.png"});
  REQUIRE(match.removed == Names{"gone.png"});
  REQUIRE(match.added == Names{"b.png", "film.mp4"});
  REQUIRE(match_folders(folder / "then/", folder / "now/").both == match.both);
}

TEST_CASE("Two folders without any picture are refused", "[frames]") {
  const ScratchFolder folder;
  write_text(folder / "a/x.txt", "");
  write_text(folder / "b/x.txt", "");
  REQUIRE_THROWS_AS(match_folders(folder / "a", folder / "b"), ImageError);
}

}  // namespace
}  // namespace proofreel
