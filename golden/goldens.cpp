#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <optional>
#include <set>
#include <system_error>

#include "golden/compare.h"
#include "golden/report_folder.h"
#include "golden/shell.h"
#include "proofreel/golden.h"
#include "render/mapped_file.h"
#include "render/output_file.h"
#include "render/png.h"
#include "render/usage_error.h"

namespace proofreel {
namespace {

namespace fs = std::filesystem;

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string() : std::string(value);
}

bool wants_to_bless() {
  const std::string wanted = variable("PROOFREEL_BLESS");
  if (wanted.empty() || wanted == "0") return false;
  if (variable("CI") != "true") return true;
  throw UsageError(
      "PROOFREEL_BLESS does not work with CI=true: references are accepted by somebody who has looked at them.");
}

/// A path that stays below the folder, the same on every system.
void refuse_bad_name(const std::string& name) {
  const auto fits = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
           c == '/';
  };
  const bool plain = std::all_of(name.begin(), name.end(), fits) && !name.empty() && name.front() != '/' &&
                     name.back() != '/' && name.find("//") == std::string::npos;
  if (plain) return;
  throw UsageError("\"" + name + "\" cannot be the name of a golden: use letters, digits, - and _, and / for folders.");
}

void refuse_bad_tolerance(const PictureTolerance& tolerance) {
  if (tolerance.max_channel < 0 || tolerance.max_channel > 255 || tolerance.pixels < 0) {
    throw UsageError("A tolerance takes max_channel 0..255 and pixels >= 0.");
  }
  const bool is_none = tolerance.max_channel == 0 && tolerance.pixels == 0;
  if (!is_none && tolerance.reason.empty()) throw UsageError("A tolerance must give its reason.");
}

Image image_of(const Pixels& pixels) {
  const bool sane = pixels.rgba != nullptr && std::min(pixels.width_px, pixels.height_px) > 0 &&
                    std::max(pixels.width_px, pixels.height_px) <= max_image_side_px;
  if (!sane) {
    throw UsageError("A picture needs pixels, and 1 to " + std::to_string(max_image_side_px) + " of them a side.");
  }
  Image image = Image::uncleared(pixels.width_px, pixels.height_px);
  const std::size_t stride = pixels.row_bytes == 0 ? image.row_bytes() : pixels.row_bytes;
  if (stride < image.row_bytes()) throw UsageError("row_bytes is less than a row of the picture takes.");
  for (int y = 0; y < image.height_px; ++y) {
    std::memcpy(image.row(y), pixels.rgba + static_cast<std::size_t>(y) * stride, image.row_bytes());
  }
  return image;
}

std::string size_text(const Image& image) {
  return std::to_string(image.width_px) + "x" + std::to_string(image.height_px);
}

std::string figures(const Comparison& c) {
  return std::to_string(c.different) + " of " + std::to_string(c.total) + " pixels differ, by up to " +
         std::to_string(c.max_channel) + " of 255 (at " + std::to_string(c.worst_x_px) + "," +
         std::to_string(c.worst_y_px) + ")";
}

std::string headroom(const Comparison& c, const PictureTolerance& tolerance) {
  return "; tolerated are " + std::to_string(tolerance.max_channel) + " per channel and " +
         std::to_string(tolerance.pixels) + " pixels beyond, of which " + std::to_string(c.beyond) + " are used";
}

/// What is said of a picture that has a reference.
PictureCheck compared(const std::string& name, const Image& then, const Image& now, const PictureTolerance& tolerance) {
  const Comparison c = compare(then, now, tolerance.max_channel);
  if (!c.same_size) {
    return {name, PictureVerdict::size, "the picture is " + size_text(now) + ", golden is " + size_text(then) + "."};
  }
  if (c.different == 0) return {name, PictureVerdict::exact, ""};
  std::string text = figures(c);
  if (!tolerance.reason.empty()) text += headroom(c, tolerance);
  const bool within = c.beyond <= tolerance.pixels;
  return {name, within ? PictureVerdict::tolerated : PictureVerdict::drawing, text + "."};
}

/// The reference, or why there is none.
std::optional<Image> reference_in(const fs::path& file, std::string& problem) {
  std::error_code error;
  if (!fs::exists(file, error)) {
    problem = "there is no reference " + file.string() + ".";
    return std::nullopt;
  }
  try {
    return read_png(file.string());
  } catch (const ImageError& damaged) {
    problem = damaged.what();
    return std::nullopt;
  }
}

fs::path nearest_folder() {
  std::error_code error;
  const fs::path start = fs::current_path(error);
  for (fs::path folder = start; !folder.empty(); folder = folder.parent_path()) {
    if (fs::is_directory(folder / "golden", error)) return folder / "golden";
    if (folder == folder.parent_path()) break;
  }
  return start / "golden";
}

}  // namespace

const char* name_of(PictureVerdict verdict) {
  constexpr const char* names[] = {"exact", "tolerated", "drawing", "missing", "size", "orphan", "blessed"};
  return names[static_cast<std::size_t>(verdict)];
}

struct Goldens::State {
  fs::path folder;
  bool bless = wants_to_bless();
  std::optional<ReportFolder> report_folder;
  Report report{"proofreel::golden", {}, {}};
  std::set<std::string> asked;

  fs::path file_of(const std::string& name) const { return folder / (name + ".png"); }

  /// Writes what did not pass.
  PictureCheck blessed(const PictureCheck& check, const Image& now) const {
    make_folder(file_of(check.name).parent_path().string());
    write_png(file_of(check.name).string(), now);
    return {check.name, PictureVerdict::blessed, "written; before, " + check.message};
  }

  /// Into the report, in place of what was said before of this name.
  void note(const PictureCheck& check, const Image& now) {
    if (!report_folder) return;
    std::erase_if(report.entries, [&](const ReportEntry& entry) { return entry.name == check.name; });
    ReportItem item{"picture", name_of(check.verdict), check.passed(), check.message};
    const bool shown = !check.passed() && check.verdict != PictureVerdict::missing;
    report_folder->add_pictures(item, check.name, shown ? file_of(check.name) : fs::path(),
                                check.passed() ? Image() : now);
    const std::string command = command_line();
    const bool is_orphan = check.verdict == PictureVerdict::orphan;
    report.entries.push_back({check.name, "", command, is_orphan ? "" : "PROOFREEL_BLESS=1 " + command, {item}});
  }
};

Goldens::Goldens(fs::path folder, fs::path report) : state_(std::make_unique<State>()) {
  state_->folder = std::move(folder);
  if (!report.empty()) state_->report_folder.emplace(std::move(report));
}

Goldens::~Goldens() {
  try {
    write_report();
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
  }
}

Goldens& Goldens::of_process() {
  const std::string folder = variable("PROOFREEL_GOLDEN");
  static Goldens goldens(folder.empty() ? nearest_folder() : fs::path(folder), variable("PROOFREEL_REPORT"));
  return goldens;
}

PictureCheck Goldens::check(const std::string& name, const Pixels& pixels, const PictureTolerance& tolerance) {
  refuse_bad_name(name);
  refuse_bad_tolerance(tolerance);
  const Image now = image_of(pixels);
  state_->asked.insert(name);
  std::string problem;
  const std::optional<Image> then = reference_in(state_->file_of(name), problem);
  PictureCheck check{name, PictureVerdict::missing, problem};
  if (then) check = compared(name, *then, now, tolerance);
  if (!check.passed()) {
    if (state_->bless)
      check = state_->blessed(check, now);
    else
      check.message += " If it is right so, run this once more with PROOFREEL_BLESS=1.";
  }
  state_->note(check, now);
  return check;
}

std::vector<PictureCheck> Goldens::check_orphans() {
  std::vector<PictureCheck> orphans;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(state_->folder, error)) {
    if (entry.path().extension() != ".png") continue;
    const std::string name = entry.path().lexically_relative(state_->folder).replace_extension().generic_string();
    if (state_->asked.contains(name)) continue;
    orphans.push_back({name, PictureVerdict::orphan, "nobody asked for " + entry.path().string() + "; remove it."});
  }
  std::sort(orphans.begin(), orphans.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  for (const PictureCheck& orphan : orphans) state_->note(orphan, {});
  return orphans;
}

void Goldens::write_report() {
  if (!state_->report_folder) return;
  state_->report_folder->finish(state_->report);
  state_->report_folder.reset();
}

}  // namespace proofreel
