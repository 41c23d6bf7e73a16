#include "render/video_reader.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cstdlib>

#include "render/png.h"
#include "render/sink.h"
#include "tests/render/scratch_folder.h"
#include "tests/render/test_image.h"

namespace proofreel {
namespace {

using Catch::Matchers::Contains;

std::vector<Image> noise_frames(int count) {
  std::vector<Image> frames;
  for (int i = 0; i < count; ++i) frames.push_back(noise_image(64, 48, static_cast<unsigned>(i), true));
  return frames;
}

void write_film(const std::string& path, const std::vector<Image>& frames, Quality quality) {
  FilmSettings settings;
  settings.size = {frames[0].width_px, frames[0].height_px};
  settings.fps = 25;
  settings.quality = quality;
  const std::unique_ptr<Sink> sink = make_sink(path, settings);
  for (const Image& frame : frames) sink->frame(frame);
  sink->finish();
}

TEST_CASE("A lossless film is read back picture by picture, to the last bit", "[video reader]") {
  const ScratchFolder folder;
  const std::vector<Image> frames = noise_frames(7);
  write_film(folder / "a.mkv", frames, Quality::lossless);
  VideoReader film(folder / "a.mkv");
  REQUIRE(film.fps() == 25);
  REQUIRE(film.stated_frames() == 7);
  Image image;
  for (const Image& frame : frames) {
    REQUIRE(film.next(image));
    REQUIRE(image.rgba == frame.rgba);
  }
  REQUIRE_FALSE(film.next(image));
  REQUIRE_FALSE(film.next(image));
}

TEST_CASE("An MP4 comes back in its own colours", "[video reader]") {
  const ScratchFolder folder;
  write_film(folder / "a.mp4", {filled_image(64, 48, 20, 136, 60), filled_image(64, 48, 200, 40, 90)}, Quality::final);
  VideoReader film(folder / "a.mp4");
  Image image;
  for (const auto& [r, g, b] : {std::array<int, 3>{20, 136, 60}, {200, 40, 90}}) {
    REQUIRE(film.next(image));
    const std::uint8_t* middle = image.row(24) + 4 * 32;
    REQUIRE(std::abs(middle[0] - r) <= 3);
    REQUIRE(std::abs(middle[1] - g) <= 3);
    REQUIRE(std::abs(middle[2] - b) <= 3);
    REQUIRE(middle[3] == 255);
  }
  REQUIRE_FALSE(film.next(image));
}

/// A GIF of one pixel that is red, then blue, and is played for ever.
std::string red_then_blue() {
  const auto frame = [](char code) {
    return std::string("!\xf9\x04\x00\x0a\x00\x00\x00", 8) +                   // for a tenth of a second
           std::string(",\x00\x00\x00\x00\x01\x00\x01\x00\x00\x02\x02", 12) +  // everywhere
           code + std::string("\x01\x00", 2);
  };
  return std::string("GIF89a\x01\x00\x01\x00\x80\x00\x00\xff\x00\x00\x00\x00\xff", 19) +
         std::string("!\xff\x0bNETSCAPE2.0\x03\x01\x00\x00\x00", 19) + frame('\x44') + frame('\x4c') + ";";
}

TEST_CASE("A GIF is read once, though it is played for ever", "[video reader]") {
  const ScratchFolder folder;
  write_text(folder / "a.gif", red_then_blue());
  VideoReader film(folder / "a.gif");
  Image image;
  REQUIRE(film.next(image));
  REQUIRE(std::equal(image.rgba.begin(), image.rgba.end(), std::array<std::uint8_t, 4>{255, 0, 0, 255}.begin()));
  REQUIRE(film.next(image));
  REQUIRE(std::equal(image.rgba.begin(), image.rgba.end(), std::array<std::uint8_t, 4>{0, 0, 255, 255}.begin()));
  REQUIRE_FALSE(film.next(image));
}

TEST_CASE("A film that claims a size beyond all pictures is refused", "[video reader]") {
  const ScratchFolder folder;
  std::string bytes = red_then_blue();
  for (const std::size_t place : {6U, 7U, 8U, 9U}) bytes[place] = '\xff';
  write_text(folder / "a.gif", bytes);
  REQUIRE_THROWS_AS(
      [&] {
        VideoReader film(folder / "a.gif");
        for (Image image; film.next(image);) {
        }
      }(),
      ImageError);
}

TEST_CASE("A film that is cut or damaged ends with a sentence or early, never with a crash", "[video reader]") {
  const ScratchFolder folder;
  write_film(folder / "a.mkv", noise_frames(3), Quality::lossless);
  const std::string whole = read_text(folder / "a.mkv");
  std::mt19937 random(3);
  for (int i = 0; i < 60; ++i) {
    std::string bytes = whole;
    if (i % 2 == 0) bytes.resize(whole.size() * static_cast<std::size_t>(i) / 60);
    for (int k = 0; k < 5 && !bytes.empty() && i % 2 == 1; ++k)
      bytes[random() % bytes.size()] = static_cast<char>(random());
    write_text(folder / "b.mkv", bytes);
    int frames = 0;
    try {
      VideoReader film(folder / "b.mkv");
      for (Image image; film.next(image) && frames < 100;) ++frames;
    } catch (const ImageError& error) {
      REQUIRE_THAT(error.what(), Contains("b.mkv"));
    }
    REQUIRE(frames <= 3);
  }
}

TEST_CASE("Films are told by their names", "[video reader]") {
  for (const char* name : {"a.mp4", "b/c.webm", "d.gif", "e.mkv", "f.mov", "g.apng"}) REQUIRE(is_film_name(name));
  for (const char* name : {"a.png", "mp4", "folder.mp4/x", ".mp4x", ""}) REQUIRE_FALSE(is_film_name(name));
}

}  // namespace
}  // namespace proofreel
