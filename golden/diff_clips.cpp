#include "golden/diff_clips.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <future>

#include "golden/frame_source.h"
#include "render/png.h"
#include "render/sink.h"

namespace proofreel {
namespace {

/// Two clips read side by side, both at the same time.
class ClipPair {
 public:
  ClipPair(const std::string& expected, const std::string& actual) : expected_(expected), actual_(actual) {}

  /// False when either is at its end.
  bool next() {
    std::future<bool> other = std::async(std::launch::async, [this] { return actual_.next(images_.actual); });
    has_expected_ = expected_.next(images_.expected);
    has_actual_ = other.get();
    return has_expected_ && has_actual_;
  }

  /// How many frames are left of each; to be called once, when `next` was false.
  std::int64_t rest_of_expected() { return rest_of(expected_, has_expected_, images_.expected); }
  std::int64_t rest_of_actual() { return rest_of(actual_, has_actual_, images_.actual); }

  const ImagePair& images() const { return images_; }
  std::int64_t stated_frames() const { return std::min(expected_.stated_frames(), actual_.stated_frames()); }
  double fps() const { return expected_.fps() > 0 ? expected_.fps() : actual_.fps(); }

 private:
  static std::int64_t rest_of(FrameSource& source, bool has_one, Image& image) {
    std::int64_t count = has_one ? 1 : 0;
    while (has_one && source.next(image)) ++count;
    return count;
  }

  FrameSource expected_, actual_;
  ImagePair images_;
  bool has_expected_ = false, has_actual_ = false;
};

/// Draws the frames of a difference.
class ClipPainter {
 public:
  ClipPainter(const std::string& expected, const std::string& actual, const DifferenceSettings& settings,
              const ClipDifference& found, DiffStyle style)
      : names_{name_of(expected), name_of(actual)}, settings_(settings), style_(style) {
    for (const FrameDifference& frame : found.frames) shares_.push_back(share_of(frame.counts));
  }

  Image draw(const ImagePair& images, std::size_t frame) const {
    const Difference difference = difference_between(images.expected, images.actual, settings_);
    const Image picture = diff_picture(style_, {images.expected, images.actual, difference}, settings_.region,
                                       titles(difference.counts, frame));
    return with_timeline(picture, shares_, frame);
  }

 private:
  static std::string name_of(const std::string& path) { return std::filesystem::path(path).filename().string(); }

  static double share_of(const DifferenceCounts& counts) {
    if (!counts.same_size) return 1;
    return counts.total == 0 ? 0 : static_cast<double>(counts.different) / static_cast<double>(counts.total);
  }

  DiffTitles titles(const DifferenceCounts& counts, std::size_t frame) const {
    return {"expected  " + names_.expected, "actual  " + names_.actual,
            "frame " + std::to_string(frame) + ": " + std::to_string(counts.different) + " pixels differ"};
  }

  struct Names {
    std::string expected, actual;
  } names_;
  const DifferenceSettings& settings_;
  DiffStyle style_;
  std::vector<double> shares_;
};

FilmSettings film_settings(const Image& image, double fps) {
  constexpr int unknown_fps = 30;
  FilmSettings settings;
  settings.size = {image.width_px, image.height_px};
  settings.fps = fps >= 1 ? static_cast<int>(std::lround(std::min(fps, 1000.0))) : unknown_fps;
  return settings;
}

void check_size(const Image& image, Size size, std::int64_t frame) {
  if (image.width_px == size.width_px && image.height_px == size.height_px) return;
  throw ImageError("No film can be drawn of this: frame " + std::to_string(frame) +
                   " is not of the size of those before. Ask for a single picture, -o NAME.png.");
}

/// Films have even sizes: a row and a column more, in the colour of the last ones.
Image with_even_size(Image image) {
  const int width = image.width_px + image.width_px % 2, height = image.height_px + image.height_px % 2;
  if (width == image.width_px && height == image.height_px) return image;
  Image even = Image::uncleared(width, height);
  for (int y = 0; y < height; ++y) {
    const std::uint8_t* from = image.row(std::min(y, image.height_px - 1));
    std::copy_n(from, image.row_bytes(), even.row(y));
    if (width > image.width_px) std::copy_n(from + image.row_bytes() - 4, 4, even.row(y) + image.row_bytes());
  }
  return even;
}

}  // namespace

std::optional<std::int64_t> ClipDifference::first_different() const {
  for (const FrameDifference& frame : frames) {
    if (!frame.broken.empty()) return frame.frame;
  }
  if (same_length()) return std::nullopt;
  return std::min(expected_frames, actual_frames);
}

ClipDifference compare_clips(const std::string& expected, const std::string& actual, const DifferenceSettings& settings,
                             const DifferenceLimits& limits, const FrameProgress& progress) {
  ClipPair clips(expected, actual);
  ClipDifference found;
  while (clips.next()) {
    const auto frame = static_cast<std::int64_t>(found.frames.size());
    const DifferenceCounts counts = difference_between(clips.images().expected, clips.images().actual, settings).counts;
    found.frames.push_back({frame, counts, broken_limit(counts, limits)});
    progress(frame + 1, std::max(frame + 1, clips.stated_frames()));
  }
  const auto both = static_cast<std::int64_t>(found.frames.size());
  found.expected_frames = both + clips.rest_of_expected();
  found.actual_frames = both + clips.rest_of_actual();
  return found;
}

void write_diff_clip(const std::string& expected, const std::string& actual, const DifferenceSettings& settings,
                     const ClipDifference& found, DiffStyle style, const std::string& out,
                     const FrameProgress& progress) {
  ClipPair clips(expected, actual);
  const ClipPainter painter(expected, actual, settings, found, style);
  const bool single = is_single_picture(out);
  const auto last = static_cast<std::int64_t>(found.frames.size()) - 1;
  const std::int64_t wanted = std::min(found.first_different().value_or(0), last);
  FilmSettings settings_of_film;
  std::unique_ptr<Sink> sink;
  for (std::int64_t frame = 0; frame <= last && clips.next(); ++frame) {
    progress(frame + 1, single ? wanted + 1 : last + 1);
    if (single && frame != wanted) continue;
    Image image = with_even_size(painter.draw(clips.images(), static_cast<std::size_t>(frame)));
    if (!sink) {
      settings_of_film = film_settings(image, clips.fps());
      sink = make_sink(out, settings_of_film);
    }
    check_size(image, settings_of_film.size, frame);
    sink->frame(image);
    if (single) break;
  }
  if (sink) sink->finish();
}

DifferenceCounts sum_of(const std::vector<FrameDifference>& frames) {
  DifferenceCounts sum;
  for (const FrameDifference& frame : frames) {
    const DifferenceCounts& c = frame.counts;
    sum.same_size = sum.same_size && c.same_size;
    sum.total += c.total, sum.unequal += c.unequal, sum.different += c.different;
    sum.antialiased += c.antialiased, sum.shifted += c.shifted;
    sum.max_channel = std::max(sum.max_channel, c.max_channel);
    if (c.densest.different > sum.densest.different) sum.densest = c.densest;
  }
  for (const FrameDifference& frame : frames) {
    for (std::size_t i = 0; sum.total > 0 && i < 3; ++i) {
      const double weight = static_cast<double>(frame.counts.total) / static_cast<double>(sum.total);
      sum.mean_bias[i] += frame.counts.mean_bias[i] * weight;
      sum.quiet_bias[i] += frame.counts.quiet_bias[i] * weight;
    }
  }
  return sum;
}

}  // namespace proofreel
