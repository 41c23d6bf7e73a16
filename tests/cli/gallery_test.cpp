#include <catch2/catch.hpp>

#include "render/png.h"
#include "tests/cli/collection.h"
#include "tests/render/decoded_film.h"

namespace proofreel {
namespace {

using Catch::Matchers::Contains;

const char* const contents = "[]";  // all in a chapter of the rest

TEST_CASE("gallery films every scenario, takes its chosen moment as a still, and writes the page", "[cli]") {
  Collection c;
  c.write("ball", falling_ball());
  write_text(c / "scenarios/contents.json", contents);
  const Outcome o = c.run({"gallery", "-o", "out", "--quiet"});
  REQUIRE(o.status == 0);
  CHECK(o.err.empty());
  const DecodedFilm film = decode_film(c / "out/films/ball.mp4");
  CHECK(film.frames.size() == 15);  // half a second at 30 frames a second
  const Image still = read_png(c / "out/stills/ball.png");
  CHECK(still.height_px == film.frames.front().height_px);
  CHECK_THAT(read_text(c / "out/index.html"), Contains("films/ball.mp4") && Contains("</html>"));
}

TEST_CASE("gallery films what is set from outside", "[cli]") {
  Collection c;
  c.write("ball", falling_ball());
  write_text(c / "scenarios/contents.json", contents);
  REQUIRE(c.run({"gallery", "-o", "out", "--set", "duration=0.2"}).status == 0);
  CHECK(decode_film(c / "out/films/ball.mp4").frames.size() == 6);
}

TEST_CASE("gallery tells what cannot be filmed, and shows the rest", "[cli]") {
  Collection c;
  c.write("ball", falling_ball());
  c.write("wrong", "scenario{}\nbox{}");
  write_text(c / "scenarios/contents.json", contents);
  const Outcome o = c.run({"gallery", "-o", "out"});
  CHECK(o.status == 2);
  CHECK_THAT(o.err, Contains("wrong.lua: line 2: box needs width="));
  CHECK_THAT(read_text(c / "out/index.html"), Contains("films/ball.mp4") && !Contains("wrong"));
  CHECK(c.run({"gallery", "-o", "out/films/ball.mp4/x"}).status == 3);
}

TEST_CASE("gallery without contents says which file is missing", "[cli]") {
  Collection c;
  c.write("ball", falling_ball());
  const Outcome o = c.run({"gallery", "-o", "out"});
  CHECK(o.status == 2);
  CHECK_THAT(o.err, Contains("contents.json"));
}

TEST_CASE("gallery touches no folder that is not one of its own", "[cli]") {
  Collection c;
  c.write("ball", falling_ball());
  write_text(c / "scenarios/contents.json", contents);
  write_text(c / "mine/index.html", "<title>My page</title>");
  write_text(c / "mine/films/ball.mp4", "my film");
  const Outcome o = c.run({"gallery", "-o", "mine"});
  CHECK(o.status == 2);
  CHECK_THAT(o.err, Contains("mine holds other things than a gallery"));
  CHECK(read_text(c / "mine/index.html") == "<title>My page</title>");
  CHECK(read_text(c / "mine/films/ball.mp4") == "my film");
  REQUIRE(c.run({"gallery", "-o", "out", "--set", "duration=0.1"}).status == 0);
  CHECK(c.run({"gallery", "-o", "out", "--set", "duration=0.1"}).status == 0);
}

TEST_CASE("gallery tells apart what has one name in two folders, and takes every name", "[cli]") {
  Collection c;
  const std::string odd = "50 % <b> #1 'q'";
  for (const std::string& name : {std::string("a/ball"), std::string("b/ball"), odd}) {
    write_text(c / ("mine/" + name + ".lua"), falling_ball());
  }
  write_text(c / "mine/contents.json", R"([{"title": "T", "about": "A", "scenarios": ["b/*", "a/ball"]}])");
  REQUIRE(c.run({"gallery", "mine", "-o", "out", "--set", "duration=0.1"}).status == 0);
  const std::string page = read_text(c / "out/index.html");
  CHECK(page.find("films/b/ball.mp4") < page.find("films/a/ball.mp4"));
  CHECK_THAT(page, Contains("films/a/ball.mp4") && Contains("proofreel render mine/a/ball.lua -o"));
  CHECK_THAT(page, Contains("films/50____b___1__q_-") && !Contains("<b>"));
  CHECK_THAT(page, !Contains("/engine/"));  // no project lies beside this folder
}

TEST_CASE("A contents.json that is broken is named, with the line and a way out in one sentence", "[cli]") {
  Collection c;
  c.write("ball", falling_ball());
  const std::string form = "must be a list of chapters, {\"title\", \"about\", \"scenarios\": [ids]} each\n";
  const auto no_json = [](int line) {
    return "line " + std::to_string(line) +
           " is no JSON: mend it, or put [] into the file, and all scenarios are in one " + "chapter\n";
  };
  const std::vector<std::pair<std::string, std::string>> broken{
      {"", no_json(1)},
      {"[{\"title\": \"a\",\n  \"about\": \"b\"\n  \"scenarios\": []}]", no_json(3)},
      {"[\n{\"title\": \"\xff\"}]", no_json(2)},
      {"{}", form},
      {"[1]", form},
      {"[{\"title\": \"a\", \"about\": \"b\", \"scenarios\": \"ball\"}]", form}};
  for (const auto& [text, sentence] : broken) {
    write_text(c / "scenarios/contents.json", text);
    const Outcome o = c.run({"gallery", "-o", "out"});
    CAPTURE(text);
    CHECK(o.status == 2);
    CHECK_THAT(o.err, Catch::Matchers::EndsWith("scenarios/contents.json: " + sentence));
    CHECK(std::count(o.err.begin(), o.err.end(), '\n') == 1);
    CHECK_FALSE(std::filesystem::exists(c / "out"));
  }
}

TEST_CASE("A folder in the place of contents.json is no contents", "[cli]") {
  Collection c;
  c.write("ball", falling_ball());
  std::filesystem::create_directories(c / "scenarios/contents.json");
  const Outcome o = c.run({"gallery", "-o", "out"});
  CHECK(o.status == 2);
  CHECK_THAT(o.err, Contains("There is no file") && Contains("contents.json"));
}

}  // namespace
}  // namespace proofreel
