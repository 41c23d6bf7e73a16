#include "render/output_file.h"

#include <catch2/catch.hpp>

#include "scenarios/environment_error.h"
#include "tests/render/scratch_folder.h"

namespace proofreel {
namespace {

namespace fs = std::filesystem;
using Catch::Matchers::Contains;

TEST_CASE("A file has its name only once it is published", "[output]") {
  const ScratchFolder folder;
  const std::string path = folder / "film.mp4";
  OutputFile file(path);
  write_text(file.temporary_path(), "whole");
  REQUIRE_FALSE(fs::exists(path));
  REQUIRE(fs::path(file.temporary_path()).extension() == ".mp4");
  file.publish();
  REQUIRE(read_text(path) == "whole");
  REQUIRE(folder.file_count() == 1);
}

TEST_CASE("A file that is given up leaves nothing and keeps what had the name before", "[output]") {
  const ScratchFolder folder;
  write_text(folder / "film.mp4", "old");
  { const OutputFile file(folder / "film.mp4"); }
  REQUIRE(read_text(folder / "film.mp4") == "old");
  REQUIRE(folder.file_count() == 1);
}

TEST_CASE("Two files in the making for one name do not meet", "[output]") {
  const ScratchFolder folder;
  const OutputFile a(folder / "x.png"), b(folder / "x.png");
  REQUIRE(a.temporary_path() != b.temporary_path());
}

TEST_CASE("A folder that does not exist is named", "[output]") {
  const ScratchFolder folder;
  REQUIRE_THROWS_AS(OutputFile(folder / "none/film.mp4"), EnvironmentError);
  REQUIRE_THROWS_WITH(OutputFile(folder / "none/film.mp4"), Contains("none") && Contains("does not exist"));
}

TEST_CASE("A folder cannot be overwritten by a file", "[output]") {
  const ScratchFolder folder;
  fs::create_directories(folder / "film.mp4");
  REQUIRE_THROWS_WITH(OutputFile(folder / "film.mp4"), Contains("is a folder"));
}

TEST_CASE("A full disk is an error of the environment, in one sentence", "[output]") {
  REQUIRE_THROWS_AS(write_file("/dev/full", "text"), EnvironmentError);
  REQUIRE_THROWS_WITH(write_file("/dev/full", "text"), Contains("/dev/full") && Contains("No space left"));
  REQUIRE(fs::is_character_file("/dev/full"));
}

TEST_CASE("Writing through a link replaces the file it leads to, not the link", "[output]") {
  const ScratchFolder folder;
  write_text(folder / "real.txt", "old");
  fs::create_symlink(folder / "real.txt", folder / "link.txt");
  write_file(folder / "link.txt", "new");
  REQUIRE(fs::is_symlink(folder / "link.txt"));
  REQUIRE(read_text(folder / "real.txt") == "new");
}

}  // namespace
}  // namespace proofreel
