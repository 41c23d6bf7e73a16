#include <catch2/catch.hpp>
#include <cstdlib>

#include "render/palette.h"
#include "render/video.h"
#include "tests/render/decoded_film.h"
#include "tests/render/scratch_folder.h"
#include "tests/render/test_image.h"

namespace proofreel {
namespace {

using Catch::Matchers::Contains;

FilmSettings settings_of(int fps, Quality quality = Quality::final) {
  FilmSettings settings;
  settings.size = {64, 48};
  settings.fps = fps;
  settings.quality = quality;
  return settings;
}

void film(const std::string& path, const FilmSettings& settings, const std::vector<Image>& images) {
  const std::unique_ptr<Sink> sink = make_sink(path, settings);
  for (const Image& image : images) sink->frame(image);
  sink->finish();
}

std::vector<Image> grays(int count) {
  std::vector<Image> images;
  for (int i = 0; i < count; ++i) {
    const auto gray = static_cast<std::uint8_t>(20 + 5 * i);
    images.push_back(filled_image(64, 48, gray, gray, gray));
  }
  return images;
}

/// Left half nothing, right half a colour of which a part is covered.
Image half_covered(std::uint8_t alpha) {
  Image image = filled_image(64, 48, 200, 80, 40, alpha);
  for (int y = 0; y < 48; ++y) std::fill(image.row(y), image.row(y) + std::ptrdiff_t{4} * 32, std::uint8_t{0});
  return image;
}

const std::uint8_t* pixel(const Image& image, int x, int y) { return image.row(y) + std::ptrdiff_t{4} * x; }

/// The delays of all frames of a GIF, in hundredths of a second: they stand in its graphic control extensions.
std::vector<int> gif_delays(const std::string& bytes) {
  std::vector<int> delays;
  const std::string start("\x21\xF9\x04", 3);
  for (std::size_t at = bytes.find(start); at != std::string::npos; at = bytes.find(start, at + 1)) {
    if (bytes[at + 7] != 0) continue;  // pixels that look like one
    delays.push_back(static_cast<unsigned char>(bytes[at + 4]) + 256 * static_cast<unsigned char>(bytes[at + 5]));
  }
  return delays;
}

TEST_CASE("Every kind of film gives back the frames it was given, each at its time", "[video]") {
  const ScratchFolder folder;
  const std::vector<Image> images = grays(17);
  for (const char* ending : {".webm", ".mov", ".apng", ".mkv", ".gif"}) {
    for (const Quality quality : {Quality::draft, Quality::final, Quality::lossless}) {
      CAPTURE(ending, static_cast<int>(quality));
      const std::string path = folder / std::string("a").append(ending);
      film(path, settings_of(30, quality), images);
      const DecodedFilm back = decode_film(path);
      REQUIRE(back.frames.size() == images.size());
      for (std::size_t i = 0; i < images.size(); ++i) {
        CAPTURE(i);
        REQUIRE(back.times_s[i] == Approx(static_cast<double>(i) / 30).margin(0.0051));
        REQUIRE(std::abs(pixel(back.frames[i], 32, 24)[0] - pixel(images[i], 32, 24)[0]) <= 3);
      }
    }
  }
}

TEST_CASE("Each kind of film is what its name says", "[video]") {
  const ScratchFolder folder;
  const auto codec = [&](const char* name, Quality quality, bool transparent = false) {
    FilmSettings settings = settings_of(25, quality);
    settings.transparent = transparent;
    film(folder / name, settings, grays(2));
    const DecodedFilm back = decode_film(folder / name);
    return back.codec + " " + back.pixel_format;
  };
  REQUIRE(codec("a.webm", Quality::final) == "vp9 yuv420p");
  REQUIRE(codec("a.mov", Quality::final) == "prores yuv444p10le");
  REQUIRE(codec("a.mov", Quality::final, true) == "prores yuva444p10le");
  REQUIRE(codec("a.mov", Quality::lossless) == "qtrle rgb24");
  REQUIRE(codec("a.apng", Quality::final) == "apng rgb24");
  REQUIRE(codec("a.gif", Quality::final) == "gif bgra");
  for (const char* name : {"a.webm", "b.mov"}) {
    CAPTURE(name);
    film(folder / name, settings_of(25), grays(2));
    REQUIRE(decode_film(folder / name).matrix == "bt709");
    REQUIRE(decode_film(folder / name).range == "tv");
  }
}

TEST_CASE("Lossless films have every pixel as drawn, whatever their size", "[video]") {
  const ScratchFolder folder;
  for (const bool transparent : {false, true}) {
    for (const char* ending : {".mov", ".apng", ".mkv"}) {
      CAPTURE(ending, transparent);
      FilmSettings settings = settings_of(25, Quality::lossless);
      settings.size = {37, 23};
      settings.transparent = transparent;
      std::vector<Image> images;
      for (unsigned i = 0; i < 4; ++i) images.push_back(noise_image(37, 23, i, !transparent));
      const std::string path = folder / std::string("a").append(ending);
      film(path, settings, images);
      const DecodedFilm back = decode_film(path);
      REQUIRE(back.frames.size() == images.size());
      for (std::size_t i = 0; i < images.size(); ++i) {
        const bool equal = back.frames[i].rgba == images[i].rgba;
        REQUIRE(equal);
      }
    }
  }
}

TEST_CASE("Alpha survives in films that may be transparent", "[video]") {
  const ScratchFolder folder;
  FilmSettings settings = settings_of(25);
  settings.transparent = true;
  for (const char* ending : {".webm", ".mov", ".apng"}) {
    CAPTURE(ending);
    const std::string path = folder / std::string("a").append(ending);
    film(path, settings, {half_covered(120), half_covered(255)});
    const DecodedFilm back = decode_film(path);
    REQUIRE(back.frames.size() == 2);
    REQUIRE(pixel(back.frames[0], 8, 24)[3] <= 2);
    REQUIRE(std::abs(pixel(back.frames[0], 56, 24)[3] - 120) <= 3);
    REQUIRE(pixel(back.frames[1], 56, 24)[3] >= 253);
    REQUIRE(std::abs(pixel(back.frames[1], 56, 24)[0] - 200) <= 4);
  }
  film(folder / "a.gif", settings, {half_covered(255)});
  const Image gif = decode_film(folder / "a.gif").frames.front();
  REQUIRE(pixel(gif, 8, 24)[3] == 0);
  REQUIRE(pixel(gif, 56, 24)[3] == 255);
}

TEST_CASE("The delays of a GIF add up to its duration, at rates that hundredths do not divide, too", "[video]") {
  const ScratchFolder folder;
  for (const int fps : {10, 24, 30, 48, 50}) {
    CAPTURE(fps);
    std::vector<Image> images = grays(25);
    film(folder / "a.gif", settings_of(fps), images);
    const std::vector<int> delays = gif_delays(read_text(folder / "a.gif"));
    REQUIRE(delays.size() == images.size());
    int sum = 0;
    for (const int delay : delays) sum += delay;
    REQUIRE(std::abs(sum - 2500.0 / fps) <= 1);
    for (const int delay : delays) REQUIRE(delay >= 2);
  }
}

TEST_CASE("Up to 255 colours a GIF shows every pixel as drawn; of more, fills stay and shades are right on average",
          "[video]") {
  const ScratchFolder folder;
  Image few(16, 15);
  for (std::size_t i = 0; i < few.rgba.size(); ++i)
    few.rgba[i] = i % 4 == 3 ? std::uint8_t{255} : static_cast<std::uint8_t>((i / 4 * 37 + i % 4 * 91) % 256);
  FilmSettings settings = settings_of(25);
  settings.size = {16, 15};
  film(folder / "few.gif", settings, {few});
  const bool equal = decode_film(folder / "few.gif").frames.front().rgba == few.rgba;
  REQUIRE(equal);

  Image many = filled_image(64, 48, 250, 247, 240);  // the lower half is a fill, the upper one shades of everything
  for (int y = 0; y < 24; ++y) {
    for (int x = 0; x < 64; ++x) {
      std::uint8_t* p = many.row(y) + std::ptrdiff_t{4} * x;
      p[0] = static_cast<std::uint8_t>(4 * x);
      p[1] = static_cast<std::uint8_t>(10 * y);
      p[2] = static_cast<std::uint8_t>(255 - 2 * x - 5 * y);
    }
  }
  film(folder / "many.gif", settings_of(25), {many});
  const Image shown = decode_film(folder / "many.gif").frames.front();
  REQUIRE(pixel(shown, 30, 40)[0] == 250);
  REQUIRE(pixel(shown, 30, 40)[2] == 240);
  for (std::size_t c = 0; c < 3; ++c) {
    double off = 0;
    for (int y = 0; y < 24; ++y) {
      for (int x = 0; x < 64; ++x) off += pixel(shown, x, y)[c] - pixel(many, x, y)[c];
    }
    REQUIRE(std::abs(off / (64 * 24)) < 4);
  }
}

TEST_CASE("A picture of nothing has a palette, too", "[video]") {
  ColorCounts counts;
  counts.add(Image(4, 4));
  Palette palette(counts);
  REQUIRE(palette.colors().size() == 256);
  REQUIRE(palette.colors().back() == 0);
  for (const std::uint8_t index : palette.dithered(Image(4, 4))) REQUIRE(index == 255);
}

TEST_CASE("What a kind of film cannot have is refused by name, before anything is written", "[video]") {
  const ScratchFolder folder;
  const auto refusal = [&](const char* name, FilmSettings settings) {
    try {
      make_sink(folder / name, settings);
    } catch (const UsageError& error) {
      return std::string(error.what());
    }
    return std::string("nothing was refused");
  };
  FilmSettings clear = settings_of(30);
  clear.transparent = true;
  REQUIRE_THAT(refusal("a.mp4", clear), Contains("H.264 knows no transparency") && Contains(".webm"));
  REQUIRE_THAT(refusal("a.mkv", clear), Contains("lossless"));
  FilmSettings odd = settings_of(30);
  odd.size = {33, 21};
  REQUIRE_THAT(refusal("a.webm", odd), Contains(".webm stores colour at half") && Contains("34x22"));
  REQUIRE_THAT(refusal("a.gif", settings_of(60)), Contains("more than 50 frames per second"));
  FilmSettings coarse = settings_of(30);
  coarse.crf = 64;
  REQUIRE_THAT(refusal("a.webm", coarse), Contains("63") && Contains("64"));
  REQUIRE_THAT(refusal("a.gif", coarse), Contains("--crf is for"));
  FilmSettings preset = settings_of(30);
  preset.preset = "fast";
  REQUIRE_THAT(refusal("a.webm", preset), Contains("--preset is for films in H.264"));
  REQUIRE_THAT(refusal("a.mov", preset), Contains("--preset"));
  REQUIRE(folder.file_count() == 0);
}

}  // namespace
}  // namespace proofreel
