#pragma once

#include <filesystem>
#include <string>

#include "golden/report.h"
#include "render/image.h"

namespace proofreel {

/// The folder of a report in the making: index.html, report.json, and the pictures in pictures/. The page comes last:
/// whoever finds it finds all of it.
class ReportFolder {
 public:
  /// Makes the folder, or takes away the report that was there. Throws UsageError when the folder holds anything else,
  /// and EnvironmentError.
  explicit ReportFolder(std::filesystem::path path);

  /// Keeps the pictures of the item: a copy of the reference `expected` (nothing when empty), `actual` (nothing when it
  /// has no pixels), and what differs between them, whose figures the item takes over. Throws EnvironmentError.
  void add_pictures(ReportItem& item, const std::string& entry_name, const std::filesystem::path& expected,
                    const Image& actual) const;

  /// Copies the pictures of another report's folder. Throws EnvironmentError.
  void add_pictures_of(const Report& other, const std::filesystem::path& folder) const;

  /// Writes report.json and the page. Throws EnvironmentError.
  void finish(const Report& report) const;

  /// The page; not there before `finish`.
  std::filesystem::path page() const { return path_ / "index.html"; }

 private:
  std::filesystem::path path_;
};

/// The report in a folder. Throws UsageError when there is none.
Report read_report(const std::filesystem::path& folder);

}  // namespace proofreel
