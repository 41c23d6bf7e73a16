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

}  // namespace
}  // namespace proofreel
