#include "lab/score_files.h"

#include <algorithm>
#include <filesystem>
#include <type_traits>

#include "lab/child.h"
#include "lab/html.h"
#include "lab/score_map.h"
#include "render/output_file.h"
#include "render/png.h"
#include "scenarios/environment_error.h"

namespace proofreel {
namespace {

/// Drawing starts threads, and who has threads makes no more children: see Child.
constexpr double drawing_limit_s = 300;

/// As many rows as fill a sheet upright; what is more is dealt out evenly to as many sheets as it takes.
constexpr std::size_t rows_per_sheet = 44;

/// Some rows of a grid as a grid of their own.
struct Sheet {
  Grid grid;
  std::vector<RunResult> results;
};

std::vector<Sheet> sheets_of(const Grid& grid, const std::vector<RunResult>& results) {
  const std::size_t count = std::max<std::size_t>(1, (grid.rows.size() + rows_per_sheet - 1) / rows_per_sheet);
  const auto row_at = [&](std::size_t sheet) { return sheet * grid.rows.size() / count; };
  std::vector<Sheet> sheets;
  for (std::size_t i = 0; i < count; ++i) {
    Sheet sheet{grid, {}};
    if (count > 1) sheet.grid.title += ", " + std::to_string(i + 1) + " of " + std::to_string(count);
    const auto part = [&](const auto& list, std::size_t each) {
      const auto at = [&](std::size_t row) { return list.begin() + static_cast<std::ptrdiff_t>(row * each); };
      return std::remove_cvref_t<decltype(list)>(at(row_at(i)), at(row_at(i + 1)));
    };
    sheet.grid.rows = part(grid.rows, 1);
    sheet.grid.runs = part(grid.runs, grid.columns.size());
    sheet.results = part(results, grid.columns.size());
    sheets.push_back(std::move(sheet));
  }
  return sheets;
}

std::string drawn_map(const Sheet& sheet, const GridWork& work) {
  const auto draw = [&] {
    const std::vector<std::uint8_t> png = encode_png(draw_map(sheet.grid, sheet.results, work.gl));
    return std::string(png.begin(), png.end());
  };
  const ChildEnd end = Child(draw, drawing_limit_s).end();
  if (end.answer.empty()) throw EnvironmentError("The map could not be drawn. " + end.died_of);
  return end.answer;
}

}  // namespace

void write_score_files(const Grid& grid, const std::vector<RunResult>& results, const std::vector<MethodScore>& scores,
                       const GridWork& work, const std::string& command, const std::string& version) {
  const std::filesystem::path folder(work.folder);
  const std::string name = std::filesystem::path(work.table).stem().string();
  PageFacts facts{command, version, machine_name(), {}, work.table};
  const std::vector<Sheet> sheets = sheets_of(grid, results);
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    const std::string number = sheets.size() > 1 ? std::string("-").append(std::to_string(i + 1)) : std::string();
    facts.maps.push_back(name + number + ".png");
    write_file((folder / facts.maps.back()).string(), drawn_map(sheets[i], work));
  }
  write_file((folder / (name + ".html")).string(), page_of(grid, results, scores, facts));
}

}  // namespace proofreel
