#include "render/sink.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "render/output_file.h"
#include "render/pixel_hash.h"
#include "render/png.h"
#include "render/video.h"
#include "scenarios/environment_error.h"

namespace proofreel {
namespace {

namespace fs = std::filesystem;

constexpr const char* known_endings =
    "Known are NAME.png, NAME%04d.png (one file per frame), .svg, .mp4, .webm, .gif, .apng, .mov, .mkv, .srt "
    "(subtitles), "
    ".hash (a line per frame) and - (raw RGBA on standard output).";

/// An unwritable folder is to be found before anything is drawn.
void check_writable(const std::string& path) { const OutputFile removed_at_once(path); }

class PngSink final : public Sink {
 public:
  explicit PngSink(const std::string& path) : path_(path) { check_writable(path); }
  void frame(const Image& image) override { last_ = image; }
  void finish() override { write_png(path_, last_); }

 private:
  std::string path_;
  Image last_;
};

/// NAME%04d.png taken apart.
struct NumberedName {
  std::string before;
  int width = 0;  ///< padded with zeros
  std::string after;
};

[[noreturn]] void refuse_pattern(const std::string& out) {
  throw UsageError("In " + out +
                   " the frame number must stand once, as %d or with a width as in %04d, and nothing else "
                   "may follow a %.");
}

/// Reads "%d" or "%0Nd" (N one digit) by hand: the name comes from the user and must never reach printf.
NumberedName parse_pattern(const std::string& out) {
  const std::size_t start = out.find('%', out.find_last_of('/') + 1);
  NumberedName name{out.substr(0, start), 0, ""};
  std::size_t i = start + 1;
  if (i + 1 < out.size() && out[i] == '0' && out[i + 1] >= '1' && out[i + 1] <= '9') {
    name.width = out[i + 1] - '0';
    i += 2;
  }
  if (i >= out.size() || out[i] != 'd') refuse_pattern(out);
  name.after = out.substr(i + 1);
  if (name.after.find('%') != std::string::npos) refuse_pattern(out);
  return name;
}

class PngSequenceSink final : public Sink {
 public:
  PngSequenceSink(const std::string& out, std::int64_t first) : name_(parse_pattern(out)), number_(first) {
    check_writable(path_of(number_));
  }
  void frame(const Image& image) override { write_png(path_of(number_++), image); }
  void finish() override {}

 private:
  std::string path_of(std::int64_t number) const {
    const std::string digits = std::to_string(number);
    const std::size_t width = static_cast<std::size_t>(name_.width);
    std::string path = name_.before;
    if (digits.size() < width) path.append(width - digits.size(), '0');
    return path.append(digits).append(name_.after);
  }

  NumberedName name_;
  std::int64_t number_;
};

class HashSink final : public Sink {
 public:
  HashSink(const std::string& path, std::int64_t first) : path_(path), number_(first) { check_writable(path); }
  void frame(const Image& image) override {
    lines_.append(std::to_string(number_++)).append(" ").append(pixel_hash(image)).append("\n");
  }
  void finish() override { write_file(path_, lines_); }

 private:
  std::string path_;
  std::int64_t number_;
  std::string lines_;
};

class RawSink final : public Sink {
 public:
  void frame(const Image& image) override {
    if (std::fwrite(image.rgba.data(), 1, image.rgba.size(), stdout) != image.rgba.size()) fail();
  }
  void finish() override {
    if (std::fflush(stdout) != 0) fail();
  }

 private:
  [[noreturn]] static void fail() {
    throw EnvironmentError(std::string("Cannot write to standard output: ").append(std::strerror(errno)).append("."));
  }
};

/// Nobody compresses pictures by x264's settings.
void check_no_film_settings(const std::string& out, const FilmSettings& settings) {
  if (!settings.preset && !settings.crf) return;
  throw UsageError("--preset and --crf are for films, which " + (out == "-" ? "raw RGBA" : out) + " is not.");
}

bool has_number(const std::string& out) { return fs::path(out).filename().string().find('%') != std::string::npos; }

[[noreturn]] void refuse_ending(const std::string& out) {
  throw UsageError("Cannot tell from its ending what " + out + " should be. " + known_endings);
}

void check_size(Size size) {
  const auto fits = [](int side) { return side >= 1 && side <= max_image_side_px; };
  if (fits(size.width_px) && fits(size.height_px)) return;
  throw UsageError("A picture's sides go from 1 to " + std::to_string(max_image_side_px) + " pixels, not " +
                   std::to_string(size.width_px) + "x" + std::to_string(size.height_px) + ".");
}

}  // namespace

std::optional<Quality> quality_named(std::string_view name) {
  if (name == "draft") return Quality::draft;
  if (name == "final") return Quality::final;
  if (name == "lossless") return Quality::lossless;
  return std::nullopt;
}

std::string ending_of(const std::string& path) { return fs::path(path).extension().string(); }

void refuse_numbers(const std::string& out) {
  if (has_number(out) && ending_of(out) != ".png")
    throw UsageError("Only PNG pictures are numbered: NAME%04d.png, not " + out + ".");
}

bool is_single_picture(const std::string& out) { return ending_of(out) == ".png" && !has_number(out); }

std::unique_ptr<Sink> make_sink(const std::string& out, const FilmSettings& settings) {
  check_size(settings.size);
  const std::string ending = ending_of(out);
  const bool numbered = has_number(out);
  refuse_numbers(out);
  if (is_film_ending(ending)) return make_video_sink(out, settings);
  if (out != "-" && ending != ".png" && ending != ".hash") refuse_ending(out);
  check_no_film_settings(out, settings);
  if (out == "-") return std::make_unique<RawSink>();
  if (ending == ".hash") return std::make_unique<HashSink>(out, settings.first_frame);
  if (numbered) return std::make_unique<PngSequenceSink>(out, settings.first_frame);
  return std::make_unique<PngSink>(out);
}

}  // namespace proofreel
