#pragma once

/// Films read back, picture by picture, through FFmpeg's libraries.

#include <memory>
#include <string>

#include "render/image.h"

namespace proofreel {

/// True for the endings of what VideoReader reads: .mp4, .mkv, .webm, .mov, .gif, .apng and .avi.
bool is_film_name(const std::string& path);

class VideoReader {
 public:
  /// Throws ImageError: no such file, not a film, damaged.
  explicit VideoReader(const std::string& path);
  ~VideoReader();
  VideoReader(VideoReader&&) noexcept;
  VideoReader& operator=(VideoReader&&) noexcept;

  /// The next picture, in the colours its tags say (untagged YUV is BT.601, as players take it); false at the end.
  /// Throws ImageError when it does not decode, or is too large (max_image_pixels).
  bool next(Image& image);

  /// Frames per second, 0 when the film does not say.
  double fps() const;

  /// How many pictures there will be, as far as the file says; 0 when it does not.
  std::int64_t stated_frames() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace proofreel
