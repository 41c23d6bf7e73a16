#pragma once

/// How `diff` tells what it found: as text and as JSON.

#include <string>
#include <vector>

#include "golden/diff_clips.h"
#include "golden/diff_folders.h"
#include "golden/json.h"

namespace proofreel {

/// Two pictures.
struct PictureVerdict {
  DifferenceCounts counts;
  std::string broken;  ///< the limit that does not hold; empty when they count as equal
  PictureSize expected, actual;
};

/// A file that both folders have.
struct FolderEntry {
  std::string name;
  bool passed = true;
  std::string text;  ///< what is said of it, of several lines for a clip
  Json json;
  DifferenceCounts counts;
};

struct FolderVerdict {
  FolderMatch match;
  std::vector<FolderEntry> entries;  ///< those that could be compared
  std::vector<std::string> errors;   ///< sentences about those that could not
  /// 0 when all is equal, 1 when something differs, 2 when something could not be read.
  int status() const;
};

/// A few lines for people; each ends in a newline.
std::string text_of(const PictureVerdict& found);
std::string text_of(const ClipDifference& found);
std::string text_of(const FolderVerdict& found);

/// One object. All three have verdict ("equal", "different" or "size"), different (pixels), antialiased, shifted,
/// unequal (pixels with any other byte), total, max_channel, mean_bias [r, g, b] (B - A, of 255), densest {x, y, width,
/// height, different} and reason (the limit that does not hold, or ""). Pictures add expected_size and actual_size,
/// [width, height] each. Clips add expected_frames, actual_frames, first_different (a frame or null) and frames
/// [{frame, verdict, different, antialiased, max_channel, mean_bias}]. Folders add equal (a number), changed [{name,
/// ...}], added [], removed [] and errors [].
Json json_of(const PictureVerdict& found);
Json json_of(const ClipDifference& found);
Json json_of(const FolderVerdict& found);

}  // namespace proofreel
