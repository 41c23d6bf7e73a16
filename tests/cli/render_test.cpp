#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <thread>

#include "render/png.h"
#include "tests/cli/collection.h"
#include "tests/render/decoded_film.h"

namespace proofreel {
namespace {

namespace fs = std::filesystem;
using Catch::Matchers::Contains;

/// A collection with one scenario, "ball": 30 frames of 96x64.
class BallCollection : public Collection {
 public:
  BallCollection() { write("ball", falling_ball()); }
  Outcome render(const std::vector<std::string>& options) const {
    std::vector<std::string> arguments{"render", "ball"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run(arguments);
  }
};

TEST_CASE("render makes an MP4 with every frame of the film, and says nothing off a terminal", "[cli]") {
  const BallCollection c;
  const Outcome o = c.render({"-o", "ball.mp4", "--quality", "draft"});
  REQUIRE(o.status == 0);
  REQUIRE(o.out.empty());
  REQUIRE(o.err.empty());
  const DecodedFilm film = decode_film(c / "ball.mp4");
  REQUIRE(film.frames.size() == 30);
  REQUIRE(film.duration_s == Approx(0.5).margin(0.002));
  REQUIRE(film.fps == Approx(60));
  REQUIRE(film.matrix == "bt709");
  REQUIRE(film.range == "tv");
  REQUIRE(film.index_first);
  REQUIRE(film.frames.back().width_px == 96);
}

TEST_CASE("A film shows what the pictures show: the last frame of a lossless one is the last PNG", "[cli]") {
  const BallCollection c;
  REQUIRE(c.render({"-o", "ball.mkv", "--quality", "lossless"}).status == 0);
  REQUIRE(c.render({"-o", "last.png"}).status == 0);
  const DecodedFilm film = decode_film(c / "ball.mkv");
  REQUIRE(film.frames.size() == 30);
  REQUIRE(film.frames.back().rgba == read_png(c / "last.png").rgba);
  REQUIRE(film.frames.front().rgba != film.frames.back().rgba);
}

TEST_CASE("--size, --fps and --frames say what is made", "[cli]") {
  const BallCollection c;
  REQUIRE(c.render({"-o", "a.mp4", "--size", "128x72", "--fps", "30", "--frames", "3:9"}).status == 0);
  const DecodedFilm film = decode_film(c / "a.mp4");
  REQUIRE(film.frames.size() == 7);
  REQUIRE(film.fps == Approx(30));
  REQUIRE(film.frames.front().width_px == 128);
  REQUIRE(c.render({"-o", "odd.png", "--size", "33x21"}).status == 0);
  REQUIRE(read_png(c / "odd.png").width_px == 33);
}

TEST_CASE("A GIF takes the most frames per second that GIFs can show and the rate is divided by", "[cli]") {
  const BallCollection c;
  REQUIRE(c.render({"-o", "a.gif"}).status == 0);
  const DecodedFilm film = decode_film(c / "a.gif");
  REQUIRE(film.times_s[1] <= 0.05);
  REQUIRE(film.times_s.back() < 0.5);
  REQUIRE(film.times_s.back() + film.times_s[1] >= 0.49);
}

TEST_CASE("Sections are chapters of a film, and a still each", "[cli]") {
  const BallCollection c;
  c.write("parts", falling_ball("section{at=0, name='first'} section{at=0.25, name='second; half'}\n"));
  for (const char* out : {"a.mp4", "a.mkv", "a.webm", "a.mov"}) {
    CAPTURE(out);
    REQUIRE(c.run({"render", "parts", "-o", out, "--quality", "draft"}).status == 0);
    const std::vector<FilmChapter> chapters = chapters_in(c / out);
    REQUIRE(chapters.size() == 2);
    REQUIRE(chapters[0].name == "first");
    REQUIRE(chapters[1].name == "second; half");
    REQUIRE(chapters[1].start_s == Approx(0.25).margin(0.002));
    REQUIRE(chapters[1].end_s == Approx(0.5).margin(0.002));
  }
  REQUIRE(c.run({"render", "parts", "-o", "cut.mkv", "--frames", "12:20"}).status == 0);
  const std::vector<FilmChapter> cut = chapters_in(c / "cut.mkv");
  REQUIRE(cut.size() == 2);
  REQUIRE(cut[1].start_s == Approx(3 / 60.0).margin(0.002));
  REQUIRE(cut[1].end_s == Approx(9 / 60.0).margin(0.002));
  REQUIRE(c.run({"render", "parts", "-o", "s%02d.png", "--stills"}).status == 0);
  REQUIRE(c.run({"render", "parts", "-o", "f.png", "--frames", "14"}).status == 0);
  REQUIRE(read_text(c / "s01.png") == read_text(c / "f.png"));
  REQUIRE(fs::exists(c / "s02.png"));
  REQUIRE_FALSE(fs::exists(c / "s03.png"));
  REQUIRE_THAT(c.run({"render", "parts", "-o", "s.png", "--stills"}).err, Contains("%02d"));
  const Outcome none = c.render({"-o", "t%02d.png", "--stills"});
  REQUIRE(none.status == 2);
  REQUIRE_THAT(none.err, Contains("has no section{at=, name=}"));
}

TEST_CASE("Behind what is drawn there may be nothing", "[cli]") {
  const BallCollection c;
  REQUIRE(c.render({"-o", "a.png", "--transparent", "--layers", "bodies"}).status == 0);
  const Image image = read_png(c / "a.png");
  REQUIRE(image.rgba[3] == 0);
  std::size_t covered = 0;
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) covered += image.rgba[i] == 255 ? 1 : 0;
  REQUIRE(covered > 30);
  REQUIRE(c.render({"-o", "b.png", "--layers", "bodies"}).status == 0);
  const Image opaque = read_png(c / "b.png");
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    if (image.rgba[i + 3] != 255) continue;
    REQUIRE(std::equal(image.rgba.data() + i, image.rgba.data() + i + 4, opaque.rgba.data() + i));
  }
}

TEST_CASE("A sequence has one PNG per frame, the same pictures as asked for singly", "[cli]") {
  const BallCollection c;
  fs::create_directories(c / "out");
  REQUIRE(c.render({"-o", "out/f_%04d.png", "--frames", "10:12"}).status == 0);
  REQUIRE(c.render({"-o", "single.png", "--frames", "11"}).status == 0);
  REQUIRE(read_png(c / "out/f_0011.png").rgba == read_png(c / "single.png").rgba);
  REQUIRE(fs::exists(c / "out/f_0010.png"));
  REQUIRE(fs::exists(c / "out/f_0012.png"));
  REQUIRE_FALSE(fs::exists(c / "out/f_0013.png"));
}

TEST_CASE("Raw pictures on standard output are the bytes of the frames and nothing else", "[cli]") {
  const BallCollection c;
  const Outcome o = c.render({"-o", "-", "--frames", "0:2"});
  REQUIRE(o.status == 0);
  REQUIRE(o.out.size() == 3 * 96 * 64 * 4);
  REQUIRE(c.render({"-o", "first.png", "--frames", "0"}).status == 0);
  const Image first = read_png(c / "first.png");
  REQUIRE(o.out.compare(0, first.rgba.size(), reinterpret_cast<const char*>(first.rgba.data()), first.rgba.size()) ==
          0);
}

TEST_CASE("The same frames have the same hashes whatever draws them and on how many threads", "[cli]") {
  const BallCollection c;
  REQUIRE(c.render({"-o", "a.hash", "--gl", "osmesa"}).status == 0);
  REQUIRE(c.render({"-o", "b.hash", "--gl", "egl", "--threads", "8"}).status == 0);
  REQUIRE(c.render({"-o", "c.hash", "--theme", "dark"}).status == 0);
  REQUIRE(read_text(c / "a.hash") == read_text(c / "b.hash"));
  REQUIRE(read_text(c / "a.hash") != read_text(c / "c.hash"));
}

TEST_CASE("--layers holds for the whole film, also where the scenario changes its layers", "[cli]") {
  const BallCollection c;
  c.write("changing", falling_ball("layers { at = 0.2, 'grid' }\n"));
  const auto last = [&c](const std::string& scenario, const std::string& layers) {
    const std::string out = scenario + layers + ".png";
    std::vector<std::string> arguments{"render", scenario, "-o", out, "--frames", "20"};
    if (!layers.empty()) arguments.insert(arguments.end(), {"--layers", layers});
    REQUIRE(c.run(arguments).status == 0);
    return read_png(c / out).rgba;
  };
  const bool unchanged = last("changing", "") == last("ball", "");
  CHECK_FALSE(unchanged);
  const bool same_list = last("changing", "bodies") == last("ball", "bodies");
  CHECK(same_list);
  const bool added = last("changing", "+bodies") == last("ball", "bodies,grid");
  CHECK(added);
}

TEST_CASE("--layers replaces the layers or changes them", "[cli]") {
  const BallCollection c;
  for (const char* layers : {"bodies", "grid", "+grid,-bodies", "bodies,grid", "+grid"}) {
    REQUIRE(c.render({"-o", std::string(layers) + ".hash", "--frames", "0", "--layers", layers}).status == 0);
  }
  REQUIRE(read_text(c / "grid.hash") == read_text(c / "+grid,-bodies.hash"));
  REQUIRE(read_text(c / "bodies,grid.hash") == read_text(c / "+grid.hash"));
  REQUIRE(read_text(c / "bodies.hash") != read_text(c / "grid.hash"));
  REQUIRE(read_text(c / "bodies.hash") != read_text(c / "+grid.hash"));
}

TEST_CASE("Values that make no sense exit with 2 and leave no file", "[cli]") {
  const BallCollection c;
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong{
      {{"-o", "a.mp4", "--size", "0x0"}, "0x0"},
      {{"-o", "a.mp4", "--size", "1921x1081"}, "1922x1082"},
      {{"-o", "a.png", "--size", "100000x100000"}, "100000x100000"},
      {{"-o", "a.png", "--size", "99999999999999999999x2"}, "--size"},
      {{"-o", "a.png", "--size", "12"}, "12"},
      {{"-o", "a.png", "--size", "12x-3"}, "12x-3"},
      {{"-o", "a.png", "--size", "axb"}, "axb"},
      {{"-o", "a.mp4", "--frames", "9:3"}, "9:3"},
      {{"-o", "a.mp4", "--frames", "0:30"}, "0 to 29"},
      {{"-o", "a.mp4", "--frames", "x"}, "x"},
      {{"-o", "a.mp4", "--frames", "-1:3"}, ""},
      {{"-o", "a.mp4", "--frames", ":"}, "FIRST:LAST"},
      {{"-o", "a.mp4", "--layers", "bodies,bones"}, "bvh"},
      {{"-o", "a.mp4", "--layers", "+grid,bodies"}, "+grid,bodies"},
      {{"-o", "a.mp4", "--theme", "pink"}, "dark"},
      {{"-o", "a.mp4", "--quality", "best"}, "lossless"},
      {{"-o", "a.mp4", "--fps", "0"}, "fps"},
      {{"-o", "a.mp4", "--fps", "7"}, "7"},
      {{"-o", "a.mp4", "--preset", "quick"}, "veryfast"},
      {{"-o", "a.mp4", "--fps", "nan"}, "fps"},
      {{"-o", "a.mp4", "--size", "nanxinf"}, "nanxinf"},
      {{"-o", "a.mp4", "--frames", "nan:3"}, "nan:3"},
      {{"-o", "a.mp4", "--crf", "99"}, "51"},
      {{"-o", "a.mp4", "--crf", "nan"}, "crf"},
      {{"-o", "a.png", "--crf", "20"}, "--preset and --crf are for films, which a.png is not."},
      {{"-o", "a_%04d.png", "--crf", "20"}, "for films"},
      {{"-o", "a.hash", "--preset", "veryfast"}, "for films"},
      {{"-o", "-", "--crf", "0"}, "which raw RGBA is not"},
      {{"-o", "a.avi"}, "a.avi"},
      {{"-o", "a.gif", "--fps", "60"}, "50"},
      {{"-o", "a.gif", "--fps", "25"}, "225 or 250"},
      {{"-o", "a.mp4", "--transparent"}, "H.264 knows no transparency"},
      {{"-o", "%s.png"}, "%04d"},
      {{}, "--output"},
  };
  for (const auto& [options, expected] : wrong) {
    CAPTURE(options);
    const Outcome o = c.render(options);
    REQUIRE(o.status == 2);
    REQUIRE_THAT(o.err, Contains(expected));
    REQUIRE(o.out.empty());
  }
  for (const auto& entry : fs::directory_iterator(c.path())) REQUIRE(fs::is_directory(entry));
}

TEST_CASE("A film of a single tick has one frame", "[cli]") {
  const Collection c;
  c.write("blink", "scenario { duration = 0.005, size = {16, 16} }\n");
  REQUIRE(c.run({"render", "blink", "-o", "a.mp4"}).status == 0);
  REQUIRE(decode_film(c / "a.mp4").frames.size() == 1);
}

TEST_CASE("An unwritable place and a full disk are errors of the environment", "[cli]") {
  const BallCollection c;
  REQUIRE(c.render({"-o", "none/a.mp4"}).status == 3);
  fs::create_symlink("/dev/full", c / "full.png");
  fs::create_symlink("/dev/full", c / "full.mp4");
  for (const char* out : {"full.png", "full.mp4"}) {
    const Outcome o = c.render({"-o", out});
    REQUIRE(o.status == 3);
    REQUIRE_THAT(o.err, Contains(out) && Contains("No space left"));
  }
}

TEST_CASE("A script that fails in the middle leaves no film", "[cli]") {
  const Collection c;
  c.write("ball", falling_ball("at(0.3, function() error(\"out of luck\") end)\n"));
  const Outcome o = c.run({"render", "ball", "-o", "a.mp4"});
  REQUIRE(o.status == 2);
  REQUIRE_THAT(o.err, Contains("out of luck"));
  for (const auto& entry : fs::directory_iterator(c.path())) REQUIRE(fs::is_directory(entry));
}

TEST_CASE("A film that is interrupted leaves nothing and dies of the signal", "[cli]") {
  const Collection c;
  c.write("long", "scenario { duration = 1000, size = {320, 240} }\nbody { shape = circle { radius = 1 } }\n");
  for (const int signal : {SIGINT, SIGTERM}) {
    Program program({"render", "long", "-o", "a.mp4"}, c.path());
    const auto started = [&] {
      for (const auto& entry : fs::directory_iterator(c.path())) {
        if (!fs::is_directory(entry) && fs::file_size(entry) > 0) return true;
      }
      return false;
    };
    for (int i = 0; i < 500 && !started(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    REQUIRE(started());
    program.send(signal);
    const Outcome o = program.wait();
    REQUIRE(o.signal == signal);
    for (const auto& entry : fs::directory_iterator(c.path())) REQUIRE(fs::is_directory(entry));
  }
}

TEST_CASE("doctor tells of both backends and the encoders", "[cli]") {
  const Outcome o = proofreel_program({"doctor"});
  REQUIRE(o.status == 0);
  REQUIRE_THAT(o.out, Contains("osmesa") && Contains("egl") && Contains("libx264") && Contains("16384"));
}

TEST_CASE("The picture commands explain themselves with an example", "[cli]") {
  for (const char* name : {"render", "bless", "doctor"}) {
    const Outcome o = proofreel_program({name, "--help"});
    REQUIRE(o.status == 0);
    REQUIRE_THAT(o.out, Contains("Example: proofreel " + std::string(name)));
  }
}

}  // namespace
}  // namespace proofreel
