#include "cli/diff_output.h"

#include <algorithm>
#include <cmath>

#include "scenarios/formatted.h"

namespace proofreel {
namespace {

/// -0.0 would puzzle.
std::string bias_text(double value) { return formatted("%+.2f", std::abs(value) < 0.005 ? 0 : value); }

std::string verdict_of(const DifferenceCounts& counts, const std::string& broken) {
  if (!counts.same_size) return "size";
  return broken.empty() ? "equal" : "different";
}

std::string share_text(const DifferenceCounts& counts) {
  std::string text = std::to_string(counts.different) + " of " + std::to_string(counts.total) + " pixels differ";
  if (counts.different > 0) {
    text += " (" +
            formatted("%.3g", 100.0 * static_cast<double>(counts.different) / static_cast<double>(counts.total)) +
            " %)";
  }
  if (counts.antialiased > 0) text += ", " + std::to_string(counts.antialiased) + " only by anti-aliasing";
  if (counts.shifted > 0) text += ", " + std::to_string(counts.shifted) + " are only shifted";
  return text;
}

std::string size_text(const PictureSize& size) {
  return std::to_string(size.width_px) + "x" + std::to_string(size.height_px);
}

/// What one number cannot say; nothing when no byte differs.
std::string details(const DifferenceCounts& c) {
  if (c.unequal == 0) return {};
  std::string text = "  " + std::to_string(c.unequal) +
                     " pixels are not the same to the last bit; one channel by up to " + std::to_string(c.max_channel) +
                     " of 255\n";
  text += "  mean bias of red, green, blue: " + bias_text(c.mean_bias[0]) + " " + bias_text(c.mean_bias[1]) + " " +
          bias_text(c.mean_bias[2]) + " of 255\n";
  const PixelRect& window = c.densest.rect;
  if (c.densest.different > 0) {
    text += "  densest window of " + std::to_string(window.width_px) + "x" + std::to_string(window.height_px) + ": " +
            std::to_string(c.densest.different) + " pixels, at " + std::to_string(window.x_px) + "," +
            std::to_string(window.y_px) + "\n";
  }
  return text;
}

Json json_of(const DifferenceCounts& counts, const std::string& broken) {
  const PixelRect& window = counts.densest.rect;
  return {{"verdict", verdict_of(counts, broken)},
          {"different", counts.different},
          {"antialiased", counts.antialiased},
          {"shifted", counts.shifted},
          {"unequal", counts.unequal},
          {"total", counts.total},
          {"max_channel", counts.max_channel},
          {"mean_bias", counts.mean_bias},
          {"densest",
           {{"x", window.x_px},
            {"y", window.y_px},
            {"width", window.width_px},
            {"height", window.height_px},
            {"different", counts.densest.different}}},
          {"reason", broken}};
}

Json json_of(const FrameDifference& frame) {
  return {{"frame", frame.frame},
          {"verdict", verdict_of(frame.counts, frame.broken)},
          {"different", frame.counts.different},
          {"antialiased", frame.counts.antialiased},
          {"max_channel", frame.counts.max_channel},
          {"mean_bias", frame.counts.mean_bias}};
}

std::string lengths(const ClipDifference& found) {
  return "the first has " + std::to_string(found.expected_frames) + " frames, the second " +
         std::to_string(found.actual_frames);
}

/// Why a clip does not pass: of its first frame that does not, or its length.
std::string reason_of(const ClipDifference& found) {
  const std::optional<std::int64_t> first = found.first_different();
  if (!first) return {};
  if (*first == static_cast<std::int64_t>(found.frames.size())) return lengths(found);
  const FrameDifference& frame = found.frames[static_cast<std::size_t>(*first)];
  return std::string("frame ").append(std::to_string(*first)).append(": ").append(frame.broken);
}

/// Error over time, on one line: the share of differing pixels in up to sixty parts of the clip, each by its worst
/// frame, in the digits 0 (none) to 9 (all) of its fourth root.
std::string timeline(const ClipDifference& found) {
  constexpr std::size_t most = 60;
  const std::size_t count = found.frames.size(), parts = std::min(most, count);
  std::string digits(parts, '0');
  for (std::size_t i = 0; i < count; ++i) {
    const DifferenceCounts& c = found.frames[i].counts;
    const double share = !c.same_size   ? 1
                         : c.total == 0 ? 0
                                        : static_cast<double>(c.different) / static_cast<double>(c.total);
    const char digit =
        static_cast<char>('0' + std::min(9, static_cast<int>(std::ceil(std::sqrt(std::sqrt(share)) * 9))));
    char& place = digits[i * parts / count];
    place = std::max(place, digit);
  }
  return "  over time: " + digits + "  (0: nothing, 9: all pixels differ)\n";
}

}  // namespace

std::string text_of(const PictureVerdict& found) {
  if (!found.counts.same_size) {
    return "size: " + size_text(found.expected) + " is expected, " + size_text(found.actual) + " is there\n";
  }
  std::string text = verdict_of(found.counts, found.broken) + ": " + share_text(found.counts) + "\n";
  if (!found.broken.empty()) text += "  beyond the limit: " + found.broken + "\n";
  return text + details(found.counts);
}

std::string text_of(const ClipDifference& found) {
  const std::optional<std::int64_t> first = found.first_different();
  const std::int64_t failing = std::count_if(found.frames.begin(), found.frames.end(),
                                             [](const FrameDifference& f) { return !f.broken.empty(); });
  if (!first) {
    const std::string frames = std::to_string(found.frames.size()) + " frames";
    return "equal: " + frames + ", " + share_text(sum_of(found.frames)) + "\n";
  }
  std::string text = "different from frame " + std::to_string(*first) + " on: " + reason_of(found) + "\n";
  if (!found.same_length()) text += "  " + lengths(found) + "\n";
  text += "  " + std::to_string(failing) + " of " + std::to_string(found.frames.size()) + " frames differ; in all " +
          share_text(sum_of(found.frames)) + "\n";
  if (found.frames.empty()) return text;
  return text + timeline(found) + details(sum_of(found.frames));
}

Json json_of(const PictureVerdict& found) {
  Json json = json_of(found.counts, found.broken);
  json["expected_size"] = {found.expected.width_px, found.expected.height_px};
  json["actual_size"] = {found.actual.width_px, found.actual.height_px};
  return json;
}

Json json_of(const ClipDifference& found) {
  Json json = json_of(sum_of(found.frames), reason_of(found));
  json["expected_frames"] = found.expected_frames;
  json["actual_frames"] = found.actual_frames;
  json["first_different"] = nullptr;
  if (found.first_different()) json["first_different"] = *found.first_different();
  json["frames"] = Json::array();
  for (const FrameDifference& frame : found.frames) json["frames"].push_back(json_of(frame));
  return json;
}

int FolderVerdict::status() const {
  if (!errors.empty()) return 2;
  const bool all_pass = std::all_of(entries.begin(), entries.end(), [](const FolderEntry& e) { return e.passed; });
  return all_pass && match.added.empty() && match.removed.empty() ? 0 : 1;
}

std::string text_of(const FolderVerdict& found) {
  std::string text;
  std::size_t changed = 0;
  for (const FolderEntry& entry : found.entries) {
    if (entry.passed) continue;
    ++changed;
    text += "changed  " + entry.name + ": " + entry.text;
  }
  for (const std::string& name : found.match.removed) text += "removed  " + name + "\n";
  for (const std::string& name : found.match.added) text += "added    " + name + "\n";
  return text + std::to_string(found.entries.size() - changed) + " equal, " + std::to_string(changed) + " changed, " +
         std::to_string(found.match.removed.size()) + " removed, " + std::to_string(found.match.added.size()) +
         " added" + (found.errors.empty() ? "" : ", " + std::to_string(found.errors.size()) + " unreadable") + "\n";
}

Json json_of(const FolderVerdict& found) {
  std::vector<FrameDifference> parts;
  Json changed = Json::array();
  for (const FolderEntry& entry : found.entries) {
    parts.push_back({0, entry.counts, {}});
    if (entry.passed) continue;
    Json json{{"name", entry.name}};
    json.update(entry.json);
    changed.push_back(json);
  }
  const bool equal = found.status() == 0;
  DifferenceCounts sum = sum_of(parts);
  sum.same_size = true;  // sizes are told of each file
  Json json = json_of(sum, equal ? "" : "files differ");
  json["equal"] = found.entries.size() - changed.size();
  json["changed"] = changed;
  json["added"] = found.match.added;
  json["removed"] = found.match.removed;
  json["errors"] = found.errors;
  return json;
}

}  // namespace proofreel
