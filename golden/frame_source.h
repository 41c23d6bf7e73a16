#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "render/image.h"
#include "render/video_reader.h"

namespace proofreel {

/// Two pictures that belong together.
struct ImagePair {
  Image expected;
  Image actual;
};

/// Reads two PNG files at the same time. Throws ImageError.
ImagePair read_pair(const std::string& expected, const std::string& actual);

/// Whether `a` comes before `b` where numbers in names count by value: frame_9 before frame_10.
bool comes_before(const std::string& a, const std::string& b);

/// The pictures of a film file, or of a folder of PNG files in the order of their names, one after the other.
class FrameSource {
 public:
  /// Throws ImageError when there is nothing to read.
  explicit FrameSource(const std::string& path);
  /// False at the end. Throws ImageError.
  bool next(Image& image);
  /// Frames per second; 0 when it is not known.
  double fps() const { return film_ ? film_->fps() : 0; }
  /// How many there will be, as far as that is known; 0 when it is not.
  std::int64_t stated_frames() const {
    return film_ ? film_->stated_frames() : static_cast<std::int64_t>(files_.size());
  }

 private:
  std::optional<VideoReader> film_;
  std::vector<std::string> files_;
  std::size_t next_file_ = 0;
};

}  // namespace proofreel
