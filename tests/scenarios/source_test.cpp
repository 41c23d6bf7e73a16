#include "scenarios/source.h"

#include <catch2/catch.hpp>
#include <filesystem>

#include "scene_text.h"

using namespace proofreel;
using Catch::Contains;

TEST_CASE("A file that cannot be read is named, with the reason") {
  const ScratchFolder folder;
  CHECK_THROWS_WITH(load_scenario(folder.path() + "/none.lua", {}), Contains("none.lua\": there is no such file"));
  CHECK_THROWS_WITH(load_scenario(folder.path(), {}), Contains("it is a folder"));
  CHECK_THROWS_WITH(load_scenario("/dev/zero", {}), Contains("it is not a plain file"));
}

TEST_CASE("The id is the path below the folder scenarios, or the file's name") {
  CHECK(id_of("/a/scenarios/hard/stack.lua") == "hard/stack");
  CHECK(id_of("/a/scenarios/b/scenarios/ball.lua") == "ball");
  CHECK(id_of("/a/examples/ball.lua") == "ball");
}

TEST_CASE("A byte order mark is passed over") {
  const ScratchFolder folder;
  CHECK(read_source(folder.write("a.lua", "\xEF\xBB\xBFscenario{}")) == "scenario{}");
}

TEST_CASE("include runs a file below the scenario and hands on its values") {
  const ScratchFolder folder;
  folder.write("parts/two.lua", "return 2");
  folder.write("one.lua", "return 1 + include 'parts/two.lua', 'more'");
  const auto path =
      folder.write("main.lua", "scenario{}\nlocal n = include 'one.lua'\nmeasure('n', function() return n end)");
  CHECK(load_scenario(path, {})->script->measure(0) == 3);
}

TEST_CASE("Errors in included files name that file and its line") {
  const ScratchFolder folder;
  folder.write("part.lua", "\n\nbody{shap=1}");
  const auto path = folder.write("main.lua", "scenario{}\ninclude 'part.lua'");
  CHECK_THROWS_WITH(load_scenario(path, {}), Contains("part.lua: line 3: body: unknown key \"shap\""));
}

TEST_CASE("include keeps to the scenario's folder") {
  const ScratchFolder folder;
  folder.write("secret.lua", "return 1");
  const std::string name = GENERATE("../secret.lua", "/etc/passwd", "sub/../../secret.lua", "..\\\\secret.lua", "");
  const auto path = folder.write("scene/main.lua", "scenario{}\ninclude '" + name + "'");
  CHECK_THROWS_WITH(load_scenario(path, {}),
                    Contains("line 2") && Contains("only files from the scenario's own folder"));
}

TEST_CASE("include does not follow links out of the folder") {
  const ScratchFolder folder;
  folder.write("secret.lua", "return 1");
  const auto path = folder.write("scene/main.lua", "scenario{}\ninclude 'link.lua'");
  std::filesystem::create_symlink(folder.path() + "/secret.lua", folder.path() + "/scene/link.lua");
  CHECK_THROWS_WITH(load_scenario(path, {}), Contains("a symbolic link leads out"));
}

TEST_CASE("include of nothing, and of itself, is an error") {
  const ScratchFolder folder;
  CHECK_THROWS_WITH(load_scenario(folder.write("a.lua", "scenario{}\ninclude 'b.lua'"), {}), Contains("no such file"));
  CHECK_THROWS_WITH(load_scenario(folder.write("c.lua", "include 'c.lua'"), {}),
                    Contains("include each other without end"));
}
