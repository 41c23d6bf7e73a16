#pragma once

/// Two clips held against each other frame by frame: what differs, and a film of it.

#include <functional>
#include <string>

#include "golden/diff_picture.h"
#include "golden/difference.h"

namespace proofreel {

struct FrameDifference {
  std::int64_t frame = 0;
  DifferenceCounts counts;
  std::string broken;  ///< the limit that does not hold; empty when the frame passes
};

struct ClipDifference {
  std::vector<FrameDifference> frames;  ///< those that both have
  std::int64_t expected_frames = 0;
  std::int64_t actual_frames = 0;
  bool same_length() const { return expected_frames == actual_frames; }
  /// The first frame that does not pass; one clip ending before the other counts, too. Nothing when all is equal.
  std::optional<std::int64_t> first_different() const;
};

/// Told after every frame how many are done, of how many; the latter may be a guess.
using FrameProgress = std::function<void(std::int64_t done, std::int64_t total)>;

/// Compares two clips, each a film file or a folder of PNG files, frame by frame. Throws ImageError and UsageError.
ClipDifference compare_clips(const std::string& expected, const std::string& actual, const DifferenceSettings& settings,
                             const DifferenceLimits& limits, const FrameProgress& progress);

/// Draws what `found` is about, frame by frame with a timeline below, into a film (or whatever `out` asks for, see
/// render/sink.h); when `out` is a single picture, only the first frame that differs, or frame 0. Throws ImageError,
/// UsageError and EnvironmentError.
void write_diff_clip(const std::string& expected, const std::string& actual, const DifferenceSettings& settings,
                     const ClipDifference& found, DiffStyle style, const std::string& out,
                     const FrameProgress& progress);

/// What all frames add up to: counts summed, biases averaged over all pixels, the densest of all windows.
DifferenceCounts sum_of(const std::vector<FrameDifference>& frames);

}  // namespace proofreel
