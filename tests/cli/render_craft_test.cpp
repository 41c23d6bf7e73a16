#include <catch2/catch.hpp>

#include "render/png.h"
#include "tests/cli/collection.h"
#include "tests/render/decoded_film.h"

namespace proofreel {
namespace {

namespace fs = std::filesystem;
using Catch::Matchers::Contains;

const std::string parts =
    "section{at=0, name='first'} section{at=0.25, name='second'}\n"
    "caption{text='half of $g t^2$', from=0.25}\n";

/// "ball", and "parts" with sections and a caption, both of half a second.
class FilmCollection : public Collection {
 public:
  FilmCollection() {
    write("ball", falling_ball());
    write("parts", falling_ball(parts));
  }
};

bool same(const Image& a, const Image& b) { return a.rgba == b.rgba; }

TEST_CASE("A title card opens a film, and chapters count from it", "[cli]") {
  const FilmCollection c;
  REQUIRE(c.run({"render", "parts", "-o", "a.mkv", "--quality", "lossless", "--title-card=1"}).status == 0);
  REQUIRE(c.run({"render", "parts", "-o", "b.mkv", "--quality", "lossless"}).status == 0);
  const DecodedFilm with = decode_film(c / "a.mkv"), without = decode_film(c / "b.mkv");
  REQUIRE(with.frames.size() == 60 + without.frames.size());
  REQUIRE(same(with.frames[60], without.frames[0]));
  REQUIRE(same(with.frames[0], with.frames[10]));
  REQUIRE_FALSE(same(with.frames[0], with.frames[60]));
  const std::vector<FilmChapter> chapters = chapters_in(c / "a.mkv");
  REQUIRE(chapters.size() == 3);
  REQUIRE(chapters[0].name == "Falling ball");
  REQUIRE(chapters[0].start_s == 0);
  REQUIRE(chapters[1].start_s == Approx(1).margin(0.002));
  REQUIRE(chapters[2].start_s == Approx(1.25).margin(0.002));
}

TEST_CASE("A title card lasts three seconds unless told", "[cli]") {
  const FilmCollection c;
  REQUIRE(c.run({"render", "ball", "-o", "a.mp4", "--quality", "draft", "--title-card"}).status == 0);
  REQUIRE(decode_film(c / "a.mp4").frames.size() == 180 + 30);
}

TEST_CASE("Subtitles are written for the film of the same options, and nothing is drawn for them", "[cli]") {
  const FilmCollection c;
  const Outcome o = c.run({"render", "parts", "-o", "a.srt", "--title-card=2", "--size", "1x1", "--theme", "dark"});
  REQUIRE(o.status == 0);
  REQUIRE(o.err.empty());
  REQUIRE(read_text(c / "a.srt") ==
          "1\n00:00:02,000 --> 00:00:02,250\nfirst\n\n"
          "2\n00:00:02,250 --> 00:00:02,500\nsecond\nhalf of g t\u00b2\n\n");
  REQUIRE(c.run({"render", "parts", "-o", "b.srt", "--frames", "20:29"}).status == 0);
  REQUIRE_THAT(read_text(c / "b.srt"), Catch::StartsWith("1\n00:00:00,000 --> 00:00:00,167\nsecond\n"));
  const Outcome empty = c.run({"render", "ball", "-o", "c.srt"});
  REQUIRE(empty.status == 0);
  REQUIRE_THAT(empty.err, Contains("no captions and no sections"));
  REQUIRE(read_text(c / "c.srt").empty());
}

TEST_CASE("A contact sheet has the title, the sections and their times, at the size asked for", "[cli]") {
  const FilmCollection c;
  REQUIRE(c.run({"render", "ball", "-o", "a.png", "--contact-sheet", "--size", "96x64"}).status == 0);
  const Image twelve = read_png(c / "a.png");
  REQUIRE(twelve.width_px > 4 * 96);
  REQUIRE(twelve.width_px < 5 * 96);
  REQUIRE(twelve.height_px > 3 * 64);
  REQUIRE(c.run({"render", "ball", "-o", "b.png", "--contact-sheet=2x1"}).status == 0);
  REQUIRE(read_png(c / "b.png").width_px > 2 * 480);
  REQUIRE(c.run({"render", "parts", "-o", "c.png", "--contact-sheet", "--size", "96x64"}).status == 0);
  REQUIRE(read_png(c / "c.png").width_px < 3 * 96);
}

TEST_CASE("A shutter blurs what moves, and refuses what does not fit with a rate that works", "[cli]") {
  const FilmCollection c;
  const Outcome few = c.run({"render", "ball", "-o", "a.png", "--shutter", "180"});
  REQUIRE(few.status == 2);
  REQUIRE_THAT(few.err, Contains("--set rate=480 works"));
  const std::vector<std::string> options{"--set", "rate=480", "--frames", "20", "--layers", "bodies"};
  const auto picture = [&](const std::string& name, const std::vector<std::string>& more) {
    std::vector<std::string> words{"render", "ball", "-o", name};
    words.insert(words.end(), options.begin(), options.end());
    words.insert(words.end(), more.begin(), more.end());
    REQUIRE(c.run(words).status == 0);
    return read_png(c / name);
  };
  REQUIRE_FALSE(same(picture("b.png", {"--shutter", "180"}), picture("c.png", {})));
  REQUIRE(same(picture("d.png", {"--shutter", "180", "--gl", "egl"}), picture("b.png", {"--shutter", "180"})));
}

TEST_CASE("An upright film shows all of what a wide one does", "[cli]") {
  const FilmCollection c;
  c.write(
      "edges",
      "scenario { duration = 0.1, size = {160, 90}, gravity = {0, 0}, view = { height = 9 }, layers = {'bodies'} }\n"
      "for _, x in ipairs { -7.9, 7.9 } do body { at = {x, 0}, shape = box { width = 0.1, height = 9 } } end\n");
  REQUIRE(c.run({"render", "edges", "-o", "a.png", "--size", "180x320"}).status == 0);
  const Image image = read_png(c / "a.png");
  const auto differs = [&](int x) {
    return !std::equal(image.row(160) + 4 * x, image.row(160) + 4 * x + 3, image.row(2));
  };
  REQUIRE(differs(1));
  REQUIRE(differs(178));
  REQUIRE_FALSE(differs(90));
}

TEST_CASE("What does not go together exits with 2, says why, and leaves no file", "[cli]") {
  const FilmCollection c;
  c.write("wordy", falling_ball("caption { text = ('impulse '):rep(200) }\n"));
  c.write("shown", "scenario{title='t'} demonstrate{algorithm='gift_wrapping', points={{0,0},{1,0},{0,1}}}\n");
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong{
      {{"ball", "-o", "a.png", "--title-card"}, "--title-card opens films"},
      {{"parts", "-o", "a%d.png", "--stills", "--title-card"}, "--title-card opens films"},
      {{"ball", "-o", "a.mp4", "--title-card=0"}, "more than 0 and up to 60"},
      {{"ball", "-o", "a.mp4", "--title-card=nan"}, "more than 0"},
      {{"ball", "-o", "a.mp4", "--title-card=x"}, "not \"x\""},
      {{"ball", "-o", "a.mov", "--title-card", "--transparent"}, "--transparent leaves out"},
      {{"ball", "-o", "a.mp4", "--contact-sheet"}, "-o NAME.png"},
      {{"ball", "-o", "a.png", "--contact-sheet=0x3"}, "from 1x1 to 100x100"},
      {{"ball", "-o", "a.png", "--contact-sheet=4"}, "COLUMNSxROWS"},
      {{"parts", "-o", "a.png", "--contact-sheet=1x1"}, "2 sections: 2x1"},
      {{"ball", "-o", "a.png", "--contact-sheet", "--title-card"}, "--title-card opens films"},
      {{"ball", "-o", "a.png", "--contact-sheet", "--stills"}, "excludes"},
      {{"ball", "-o", "a.png", "--contact-sheet", "--crf", "9"}, "for films"},
      {{"parts", "-o", "a.srt", "--stills"}, "--stills makes pictures"},
      {{"ball", "-o", "a.srt", "--crf", "9"}, "for films"},
      {{"ball", "-o", "a.mp4", "--shutter", "0"}, "from 1 to 360"},
      {{"ball", "-o", "a.mp4", "--shutter", "361"}, "from 1 to 360"},
      {{"ball", "-o", "a.mp4", "--shutter", "nan"}, "1 to 360"},
      {{"ball", "-o", "a.mov", "--shutter", "180", "--transparent"}, "--transparent leaves out"},
      {{"shown", "-o", "a.mp4", "--shutter", "180"}, "demonstrates an algorithm"},
      {{"wordy", "-o", "a.mp4"}, "line 6: the text of this caption does not fit into a picture of 96x64"},
  };
  for (const auto& [options, expected] : wrong) {
    CAPTURE(options);
    std::vector<std::string> words{"render"};
    words.insert(words.end(), options.begin(), options.end());
    const Outcome o = c.run(words);
    REQUIRE(o.status == 2);
    REQUIRE_THAT(o.err, Contains(expected));
  }
  for (const auto& entry : fs::directory_iterator(c.path())) REQUIRE(fs::is_directory(entry));
}

TEST_CASE("A title card that does not fit is refused, and leaves no film behind", "[cli]") {
  const FilmCollection c;
  c.write("long", "scenario { title = '" + std::string(80, 'w') + "', duration = 0.1 }\n");
  c.write("much", "scenario { title = 'T', description = ('many words '):rep(300), duration = 0.1 }\n");
  for (const char* id : {"long", "much"}) {
    const Outcome o = c.run({"render", id, "-o", "film/a.mp4", "--title-card", "--size", "320x180"});
    CHECK(o.status == 3);
    std::filesystem::create_directories(c / "film");
    const Outcome refused = c.run({"render", id, "-o", "film/a.mp4", "--title-card", "--size", "320x180"});
    CHECK(refused.status == 2);
    CHECK_THAT(refused.err, Contains("do not fit into a picture of 320x180"));
    CHECK(fs::is_empty(c / "film"));
    std::filesystem::remove_all(c / "film");
  }
}

TEST_CASE("Only PNG pictures are numbered", "[cli]") {
  const FilmCollection c;
  for (const char* out : {"a%02d.svg", "a%d.srt", "a%d.mp4"}) {
    const Outcome o = c.run({"render", "ball", "-o", out});
    CHECK(o.status == 2);
    CHECK_THAT(o.err, Contains("Only PNG pictures are numbered"));
    CHECK_FALSE(fs::exists(c / out));
  }
}

TEST_CASE("A quality that there is none of is refused for every output", "[cli]") {
  const FilmCollection c;
  for (const char* out : {"a.svg", "a.srt", "a.png", "a.mp4"}) {
    const Outcome o = c.run({"render", "ball", "-o", out, "--quality", "silly"});
    INFO(out);
    CHECK(o.status == 2);
    CHECK_THAT(o.err, Contains("There is no quality \"silly\"; there are draft, final and lossless."));
    CHECK_FALSE(fs::exists(c / out));
  }
}

TEST_CASE("A film option with nothing after its = is refused, also where a default would serve", "[cli]") {
  const FilmCollection c;
  Refusals refusals;
  for (const char* option :
       {"--title-card", "--contact-sheet", "--stills", "--transparent", "--size", "--frames", "--layers", "--theme",
        "--quality", "--preset", "--crf", "--shutter", "--fps", "--gl", "--threads", "--output"}) {
    const std::string name = option;
    refusals.push_back({{name + "="}, "There is nothing after \"" + name + "=\": write there what is meant"});
    refusals.push_back({{name, ""}, "There is an empty word after \"" + name + "\": write there what is meant"});
  }
  require_refused(c, {"render", "ball", "-o", "a.mp4"}, refusals);
  REQUIRE_FALSE(fs::exists(c / "a.mp4"));
}

}  // namespace
}  // namespace proofreel
