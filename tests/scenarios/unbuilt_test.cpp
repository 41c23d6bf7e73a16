#include <catch2/catch.hpp>

#include "scene_text.h"

using namespace proofreel;
using Catch::Contains;
using Catch::StartsWith;

namespace {

void check_unbuilt(const std::string& line, const std::string& name) {
  const std::string text = "scenario{}\nlocal b = body{shape=circle{radius=1}}\n" + line;
  INFO(line);
  CHECK_THAT(error_of(text), StartsWith("scene.lua: line 3: ") &&
                                 Contains("\"" + name + "\" is part of the language but not built yet"));
}

}  // namespace

TEST_CASE("Words that are not built are refused by name") {
  const std::string word = GENERATE("ghost", "freeze", "section");
  check_unbuilt(word + "{b}", word);
}
