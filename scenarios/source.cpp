#include "scenarios/source.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "scenarios/scenario.h"
#include "scenarios/suggest.h"

namespace proofreel {
namespace fs = std::filesystem;
namespace {

constexpr std::uintmax_t largest_source = 16U << 20;

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
  throw ScenarioError("cannot read the scenario file " + quote(path) + ": " + why);
}

/// How a file differs from one that can be read; empty when it does not.
std::string why_unreadable(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) return "there is no such file";
  if (fs::is_directory(status)) return "it is a folder";
  if (!fs::is_regular_file(status)) return "it is not a plain file";
  if (fs::file_size(path, error) > largest_source) return "it is larger than 16 MB";
  return {};
}

bool lies_below(const fs::path& file, const fs::path& folder) {
  const auto split = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
  return split.first == folder.end();
}

[[noreturn]] void refuse_include(std::string_view name, const std::string& why) {
  throw std::runtime_error("include " + quote(name) + ": " + why);
}

}  // namespace

std::string read_source(const std::string& path) {
  const std::string why = why_unreadable(path);
  if (!why.empty()) refuse(path, why);
  std::ifstream file(path, std::ios::binary);
  if (!file) refuse(path, "it cannot be opened");
  std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (file.bad()) refuse(path, "reading it failed");
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
  return text;
}

std::string included_path(const std::string& scenario_path, std::string_view name) {
  const fs::path asked{name};
  const bool climbs = std::find(asked.begin(), asked.end(), "..") != asked.end();
  if (asked.is_absolute() || climbs || name.find('\\') != std::string_view::npos || name.empty()) {
    refuse_include(name, "only files from the scenario's own folder and below it can be included");
  }
  const fs::path folder = fs::path(scenario_path).parent_path();
  const fs::path path = folder / asked;
  const std::string why = why_unreadable(path.string());
  if (!why.empty()) refuse_include(name, why);
  std::error_code error;
  const fs::path root = fs::canonical(folder.empty() ? fs::path(".") : folder, error);
  const fs::path real = fs::canonical(path, error);
  if (error || !lies_below(real, root)) refuse_include(name, "a symbolic link leads out of the scenario's folder");
  return path.string();
}

std::string id_of(const std::string& path) {
  const fs::path normal = fs::absolute(path).lexically_normal();
  fs::path id = normal.filename();
  fs::path below;
  for (const fs::path& part : normal) {
    below /= part;
    if (part == "scenarios") below.clear();
  }
  if (below.is_relative() && !below.empty()) id = below;
  return id.extension() == ".lua" ? id.replace_extension().generic_string() : id.generic_string();
}

}  // namespace proofreel
