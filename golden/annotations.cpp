#include "golden/annotations.h"

#include <filesystem>

namespace proofreel {
namespace {

/// Percent signs and line ends would end the message (actions/toolkit, command.ts).
std::string escaped(const std::string& text, bool as_property) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '%':
        out += "%25";
        break;
      case '\r':
        out += "%0D";
        break;
      case '\n':
        out += "%0A";
        break;
      case ':':
        out += as_property ? "%3A" : ":";
        break;
      case ',':
        out += as_property ? "%2C" : ",";
        break;
      default:
        out += c;
    }
  }
  return out;
}

/// As the repository has it; what lies elsewhere stays as it is.
std::string from_root(const std::string& file, const std::string& root) {
  std::error_code error;
  const std::filesystem::path path = std::filesystem::weakly_canonical(file, error);
  const std::filesystem::path relative = path.lexically_relative(std::filesystem::weakly_canonical(root, error));
  const bool below = !relative.empty() && *relative.begin() != "..";
  return below ? relative.generic_string() : file;
}

std::string message_of(const ReportEntry& entry, const std::vector<const ReportItem*>& failures) {
  std::string text = failures.front()->message;
  if (failures.size() > 1) text += "\nand " + std::to_string(failures.size() - 1) + " more.";
  if (!entry.reproduce.empty()) text += "\nTo reproduce: " + entry.reproduce;
  return text;
}

}  // namespace

std::vector<std::string> annotations_of(const Report& report, const std::string& root) {
  std::vector<std::string> lines;
  for (const ReportEntry& entry : report.entries) {
    const std::vector<const ReportItem*> failures = failures_in(entry);
    if (failures.empty()) continue;
    const std::string title = entry.name + " " + failures.front()->label + ": " + failures.front()->verdict;
    std::string line = "::error ";
    if (!entry.file.empty()) line += "file=" + escaped(from_root(entry.file, root), true) + ",";
    line += "title=" + escaped(title, true) + "::" + escaped(message_of(entry, failures), false);
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace proofreel
