#pragma once

#include "golden/report_folder.h"
#include "render/png.h"
#include "tests/render/scratch_folder.h"

namespace proofreel::test {

inline Image plain_picture(int width_px, int height_px, std::uint8_t gray) {
  Image image(width_px, height_px);
  std::fill(image.rgba.begin(), image.rgba.end(), gray);
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) image.rgba[i] = 255;
  return image;
}

/// Light gray with a black square of 8 pixels a side at x, y.
inline Image square_at(int x, int y) {
  Image image = plain_picture(64, 40, 230);
  for (int v = y; v < y + 8; ++v) {
    for (int u = x; u < x + 8; ++u) std::fill_n(image.row(v) + 4 * u, 3, std::uint8_t{0});
  }
  return image;
}

/// "ball", of which frame 0 is as expected and frames 15 and 29 are not; "<b>gone</b>", which has no reference; and two
/// that passed.
inline Report example_report() {
  Report report{"proofreel 0.1.0", {}, {}};
  report.entries.push_back({"ball",
                            "scenarios/ball.lua",
                            "proofreel check ball",
                            "proofreel bless ball",
                            {{"frame 0", "exact", true, ""},
                             {"frame 15", "drawing", false, "128 of 2560 pixels differ."},
                             {"frame 29", "physics", false, "the state differs since tick 70; \"ball\" is 0.2 m away."},
                             {"final state", "physics", false, "the state differs at the end."}}});
  report.entries.push_back({"<b>gone</b>",
                            "",
                            "proofreel check gone",
                            "",
                            {{"frame 0", "missing", false, "there is no reference </script><i>here</i>."}}});
  report.entries.push_back({"calm", "", "proofreel check calm", "", {{"frame 0", "exact", true, ""}}});
  report.entries.push_back({"near", "", "", "", {{"frame 0", "tolerated", true, "1 pixel differs; 4 may."}}});
  return report;
}

/// The report's folder with its pictures, written.
inline void write_example(const std::string& folder, const std::string& references) {
  Report report = example_report();
  const ReportFolder out(folder);
  std::filesystem::create_directories(references);
  write_png(references + "/then.png", square_at(10, 10));
  std::vector<ReportItem>& items = report.entries[0].items;
  out.add_pictures(items[0], "ball", references + "/then.png", {});
  out.add_pictures(items[1], "ball", references + "/then.png", square_at(12, 10));
  out.add_pictures(items[2], "ball", references + "/then.png", square_at(40, 24));
  out.add_pictures(report.entries[1].items[0], report.entries[1].name, {}, square_at(0, 0));
  out.finish(report);
}

}  // namespace proofreel::test
