#include "render/video.h"

#include <array>
#include <catch2/catch.hpp>
#include <cstdlib>

#include "scenarios/environment_error.h"
#include "tests/render/decoded_film.h"
#include "tests/render/scratch_folder.h"
#include "tests/render/test_image.h"

namespace proofreel {
namespace {

namespace fs = std::filesystem;
using Catch::Matchers::Contains;

FilmSettings small(Quality quality = Quality::draft) {
  FilmSettings settings;
  settings.size = {64, 48};
  settings.fps = 60;
  settings.quality = quality;
  return settings;
}

/// Frame i is one flat gray that tells its number.
std::uint8_t gray_of(int frame) { return static_cast<std::uint8_t>(20 + frame * 3 % 220); }

void film_grays(const std::string& path, const FilmSettings& settings, int frames) {
  const std::unique_ptr<Sink> sink = make_video_sink(path, settings);
  for (int i = 0; i < frames; ++i) {
    const std::uint8_t gray = gray_of(i);
    sink->frame(filled_image(settings.size.width_px, settings.size.height_px, gray, gray, gray));
  }
  sink->finish();
}

int red_at_center(const Image& image) { return image.rgba[image.rgba.size() / 2]; }

TEST_CASE("Every frame given to an MP4 can be decoded again, the last one too, each at its time", "[video]") {
  const ScratchFolder folder;
  for (const int count : {1, 2, 5, 61, 130}) {
    CAPTURE(count);
    film_grays(folder / "a.mp4", small(), count);
    const DecodedFilm film = decode_film(folder / "a.mp4");
    REQUIRE(film.frames.size() == static_cast<std::size_t>(count));
    REQUIRE(film.duration_s == Approx(count / 60.0).margin(0.002));
    REQUIRE(film.start_s == Approx(0).margin(1e-6));
    REQUIRE(film.fps == Approx(60));
    for (int i = 0; i < count; ++i) {
      REQUIRE(film.times_s[static_cast<std::size_t>(i)] == Approx(i / 60.0).margin(1e-4));
      REQUIRE(std::abs(red_at_center(film.frames[static_cast<std::size_t>(i)]) - gray_of(i)) <= 4);
    }
    REQUIRE(folder.file_count() == 1);
  }
}

/// A gray square that wanders over noise. Between its pictures some are left out, some come twice.
std::vector<Image> wanderings(bool knows_editions) {
  std::vector<Image> pictures;
  const Image noise = noise_image(64, 48, 3, true);
  PixelRect last;
  for (int i = 0; i < 40; ++i) {
    const PixelRect square{2 * (i % 24), 2 * (i * 7 % 16), 16, 16};
    Image image = noise;
    for (int y = square.y_px; y < square.y_px + 16; ++y) std::fill_n(image.row(y) + 4 * square.x_px, 64, gray_of(i));
    if (knows_editions) image.rgba.become({i < 30 ? 100U : 101U, static_cast<std::uint64_t>(i + 1), {last, square}});
    last = square;
    if (i % 7 == 5) continue;
    pictures.push_back(image);
    if (i % 5 == 2) pictures.push_back(image);
  }
  return pictures;
}

TEST_CASE("Pictures that know where they differ make the same film as those that do not", "[video]") {
  const ScratchFolder folder;
  for (const char* name : {"a.mp4", "a.mkv", "a.webm", "a.apng"}) {
    CAPTURE(name);
    std::array<DecodedFilm, 2> films;
    for (const bool knows : {false, true}) {
      FilmSettings settings = small(Quality::lossless);
      settings.threads = 1;
      const std::unique_ptr<Sink> sink = make_video_sink(folder / name, settings);
      for (const Image& picture : wanderings(knows)) sink->frame(picture);
      sink->finish();
      films[knows ? 1 : 0] = decode_film(folder / name);
    }
    REQUIRE(films[0].frames.size() == films[1].frames.size());
    int different = 0;
    for (std::size_t i = 0; i < films[0].frames.size(); ++i)
      different += films[0].frames[i].rgba == films[1].frames[i].rgba ? 0 : 1;
    CHECK(different == 0);
    CHECK_FALSE(films[0].frames.front().rgba == films[0].frames.back().rgba);
  }
}

TEST_CASE("An MP4 says it is BT.709 in limited range, 4:2:0, and puts its index first", "[video]") {
  const ScratchFolder folder;
  film_grays(folder / "a.mp4", small(Quality::final), 10);
  const DecodedFilm film = decode_film(folder / "a.mp4");
  REQUIRE(film.codec == "h264");
  REQUIRE(film.pixel_format == "yuv420p");
  REQUIRE(film.range == "tv");
  REQUIRE(film.matrix == "bt709");
  REQUIRE(film.primaries == "bt709");
  REQUIRE(film.transfer == "bt709");
  REQUIRE(film.index_first);
}

TEST_CASE("#008800 plays as #008800", "[video]") {
  const ScratchFolder folder;
  const std::unique_ptr<Sink> sink = make_video_sink(folder / "green.mp4", small(Quality::final));
  for (int i = 0; i < 5; ++i) sink->frame(filled_image(64, 48, 0, 0x88, 0));
  sink->finish();
  const Image back = decode_film(folder / "green.mp4").frames.back();
  const std::size_t center = (24 * 64 + 32) * 4;
  REQUIRE(back.rgba[center] <= 2);
  REQUIRE(std::abs(back.rgba[center + 1] - 0x88) <= 2);
  REQUIRE(back.rgba[center + 2] <= 2);
}

TEST_CASE("A film can be jumped into at every second", "[video]") {
  const ScratchFolder folder;
  film_grays(folder / "a.mp4", small(Quality::final), 190);
  const std::vector<int> keys = decode_film(folder / "a.mp4").key_frames;
  REQUIRE(keys.front() == 0);
  for (std::size_t i = 1; i < keys.size(); ++i) REQUIRE(keys[i] - keys[i - 1] <= 60);
  REQUIRE(190 - keys.back() <= 60);
}

TEST_CASE("Matroska holds H.264, and when lossless every pixel as drawn", "[video]") {
  const ScratchFolder folder;
  film_grays(folder / "a.mkv", small(), 7);
  REQUIRE(decode_film(folder / "a.mkv").codec == "h264");
  REQUIRE(decode_film(folder / "a.mkv").frames.size() == 7);

  FilmSettings settings = small(Quality::lossless);
  settings.size = {37, 23};
  std::vector<Image> images;
  const std::unique_ptr<Sink> sink = make_video_sink(folder / "b.mkv", settings);
  for (unsigned i = 0; i < 4; ++i) {
    images.push_back(noise_image(37, 23, i, true));
    sink->frame(images.back());
  }
  sink->finish();
  const DecodedFilm film = decode_film(folder / "b.mkv");
  REQUIRE(film.codec == "ffv1");
  REQUIRE(film.frames.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) REQUIRE(film.frames[i].rgba == images[i].rgba);
}

TEST_CASE("What a killed run leaves still plays up to the last whole second", "[video]") {
  const ScratchFolder folder;
  const std::unique_ptr<Sink> sink = make_video_sink(folder / "a.mp4", small());
  for (int i = 0; i < 300; ++i) sink->frame(noise_image(64, 48, static_cast<unsigned>(i), true));
  REQUIRE_FALSE(fs::exists(folder / "a.mp4"));
  for (const auto& entry : fs::directory_iterator(folder.path())) {
    fs::copy_file(entry.path(), folder / "left.mp4");
    break;
  }
  REQUIRE(decode_film(folder / "left.mp4").frames.size() >= 60);
}

TEST_CASE("A film given up leaves nothing", "[video]") {
  const ScratchFolder folder;
  {
    const std::unique_ptr<Sink> sink = make_video_sink(folder / "a.mp4", small());
    sink->frame(filled_image(64, 48, 1, 2, 3));
  }
  REQUIRE(folder.file_count() == 0);
}

TEST_CASE("Odd sizes are refused for film before anything is written, with one that works", "[video]") {
  const ScratchFolder folder;
  FilmSettings settings = small();
  settings.size = {1921, 1081};
  REQUIRE_THROWS_AS(make_video_sink(folder / "a.mp4", settings), UsageError);
  REQUIRE_THROWS_WITH(make_video_sink(folder / "a.mp4", settings), Contains("1921x1081") && Contains("1922x1082"));
  REQUIRE(folder.file_count() == 0);
}

TEST_CASE("Presets and rate factors x264 does not have are refused by name", "[video]") {
  const ScratchFolder folder;
  FilmSettings settings = small();
  settings.preset = "quick";
  REQUIRE_THROWS_WITH(make_video_sink(folder / "a.mp4", settings), Contains("quick") && Contains("veryfast"));
  settings.preset = "ultrafast";
  settings.crf = 52;
  REQUIRE_THROWS_WITH(make_video_sink(folder / "a.mp4", settings), Contains("52") && Contains("0"));
  settings.crf = -1;
  REQUIRE_THROWS_AS(make_video_sink(folder / "a.mp4", settings), UsageError);
  settings.crf = 51;
  REQUIRE_NOTHROW(make_video_sink(folder / "a.mp4", settings));
  settings.quality = Quality::lossless;
  REQUIRE_THROWS_WITH(make_video_sink(folder / "a.mkv", settings), Contains("--preset") && Contains("a.mkv is not"));
}

TEST_CASE("A higher rate factor makes a smaller film", "[video]") {
  const ScratchFolder folder;
  std::uintmax_t sizes[2] = {};
  for (int k = 0; k < 2; ++k) {
    FilmSettings settings = small();
    settings.crf = k == 0 ? 10 : 40;
    const std::unique_ptr<Sink> sink = make_video_sink(folder / "a.mp4", settings);
    for (unsigned i = 0; i < 20; ++i) sink->frame(noise_image(64, 48, i, true));
    sink->finish();
    sizes[k] = fs::file_size(folder / "a.mp4");
  }
  REQUIRE(sizes[1] * 2 < sizes[0]);
}

TEST_CASE("A missing encoder is an error of the environment that names it and what to install", "[video]") {
  REQUIRE_THROWS_AS(require_encoder("libnothing"), EnvironmentError);
  REQUIRE_THROWS_WITH(require_encoder("libnothing"), Contains("libnothing") && Contains("install"));
  REQUIRE_NOTHROW(require_encoder("libx264"));
}

TEST_CASE("A full disk under a film is an error of the environment", "[video]") {
  const ScratchFolder folder;
  fs::create_symlink("/dev/full", folder / "a.mp4");
  const auto film = [&] { film_grays(folder / "a.mp4", small(), 30); };
  REQUIRE_THROWS_AS(film(), EnvironmentError);
  REQUIRE_THROWS_WITH(film(), Contains("a.mp4") && Contains("No space left"));
}

}  // namespace
}  // namespace proofreel
