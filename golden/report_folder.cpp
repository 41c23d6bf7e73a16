#include "golden/report_folder.h"

#include <algorithm>

#include "golden/compare.h"
#include "golden/diff_paint.h"
#include "golden/file_text.h"
#include "golden/plain_path.h"
#include "golden/report_page.h"
#include "render/output_file.h"
#include "render/png.h"
#include "render/usage_error.h"
#include "scenarios/environment_error.h"

namespace proofreel {
namespace {

namespace fs = std::filesystem;

constexpr const char* json_name = "report.json";
constexpr const char* unfinished = "{\"format\": 1, \"kind\": \"proofreel report\"}\n";

bool is_ours(const fs::path& folder) {
  return file_text(folder / json_name).value_or("").find("proofreel report") < 200;
}

void clear_away(const fs::path& path) {
  std::error_code error;
  fs::remove_all(path, error);
  if (error) throw EnvironmentError("Cannot remove " + path.string() + ": " + error.message() + ".");
}

void keep_copy(const fs::path& from, const fs::path& to) {
  make_folder(to.parent_path());
  std::error_code error;
  fs::copy_file(from, to, fs::copy_options::overwrite_existing, error);
  if (error)
    throw EnvironmentError("Cannot copy " + from.string() + " to " + to.string() + ": " + error.message() + ".");
}

/// "frame 120" as "frame_120": the labels of one entry do not need to be told apart by more.
std::string with_underscores(std::string label) {
  std::replace(label.begin(), label.end(), ' ', '_');
  return label;
}

/// Where the pictures differ most densely; where nothing that catches the eye does, the worst pixel.
std::optional<PixelRect> place_of(const DifferenceCounts& counts, const Comparison& comparison) {
  if (counts.different > 0) return counts.densest.rect;
  if (comparison.different > 0) return PixelRect{comparison.worst_x_px, comparison.worst_y_px, 1, 1};
  return std::nullopt;
}

/// A damaged reference has nothing to show; the item's sentence says so already.
std::optional<Image> readable(const fs::path& path) {
  try {
    return read_png(path.string());
  } catch (const ImageError&) {
    return std::nullopt;
  }
}

/// Nothing when nothing can be shown.
std::optional<Image> heat_of(ReportItem& item, const Image& expected, const Image& actual) {
  const Comparison comparison = compare(expected, actual, 0);
  item.different = comparison.different;
  item.total = comparison.total;
  item.max_channel = comparison.max_channel;
  if (!comparison.same_size || comparison.different == 0) return std::nullopt;
  const Difference difference = difference_between(expected, actual, {});
  item.place = place_of(difference.counts, comparison);
  return heat_picture({expected, actual, difference}, {});
}

/// Pictures named by others must lie where ours do.
void refuse_other_places(const std::string& file, const fs::path& folder) {
  const bool inside = file.starts_with("pictures/") && file.find("..") == std::string::npos;
  if (!inside)
    throw UsageError((folder / json_name).string() + " names a picture outside of its folder: " + file + ".");
}

}  // namespace

ReportFolder::ReportFolder(fs::path path) : path_(std::move(path)) {
  make_folder(path_);
  if (!fs::is_empty(path_) && !is_ours(path_)) {
    throw UsageError("The folder " + path_.string() + " holds other things than a report: name a new or an empty one.");
  }
  clear_away(page());
  write_file((path_ / json_name).string(), std::string(unfinished));
  clear_away(path_ / "pictures");
}

void ReportFolder::add_pictures(ReportItem& item, const std::string& entry_name, const fs::path& expected,
                                const Image& actual) const {
  const std::string stem = "pictures/" + plain_path(entry_name) + "/" + plain_path(with_underscores(item.label));
  const std::optional<Image> reference = expected.empty() ? std::nullopt : readable(expected);
  if (reference) keep_copy(expected, path_ / (item.expected = stem + "-expected.png"));
  if (actual.rgba.empty()) return;
  make_folder((path_ / stem).parent_path());
  write_png((path_ / (item.actual = stem + "-actual.png")).string(), actual);
  const std::optional<Image> heat = reference ? heat_of(item, *reference, actual) : std::nullopt;
  if (heat) write_png((path_ / (item.heat = stem + "-heat.png")).string(), *heat);
}

void ReportFolder::add_pictures_of(const Report& other, const fs::path& folder) const {
  for (const ReportEntry& entry : other.entries) {
    for (const ReportItem& item : entry.items) {
      for (const std::string& file : {item.expected, item.actual, item.heat}) {
        if (file.empty()) continue;
        refuse_other_places(file, folder);
        keep_copy(folder / file, path_ / file);
      }
    }
  }
}

void ReportFolder::finish(const Report& report) const {
  write_file((path_ / json_name).string(), to_json_text(report));
  write_file(page().string(), report_page(report));
}

Report read_report(const fs::path& folder) {
  const fs::path path = folder / json_name;
  const std::optional<std::string> text = file_text(path);
  if (!text) throw UsageError("There is no report in " + folder.string() + ".");
  return report_from_json(*text, path.string());
}

}  // namespace proofreel
