#include "lab/csv_file.h"

#include <fcntl.h>
#include <unistd.h>

#include "golden/file_text.h"
#include "render/output_file.h"
#include "render/usage_error.h"
#include "scenarios/environment_error.h"

namespace proofreel {
namespace {

/// What was cut off while its first line was written is a beginning of the header.
bool is_ours(const std::string& text, const std::vector<CsvRecord>& records, const CsvRecord& header) {
  return records.empty() ? csv_line(header).starts_with(text) : records.front() == header;
}

}  // namespace

CsvFile::CsvFile(std::string path, CsvRecord header) : path_(std::move(path)), header_(std::move(header)) {
  const std::string text = file_text(path_).value_or("");
  found_ = csv_records(text);
  if (!is_ours(text, found_, header_))
    throw UsageError(path_ + " holds a table of other columns: name another folder with -o, or remove it.");
  if (!found_.empty()) found_.erase(found_.begin());
}

void CsvFile::append(const std::vector<CsvRecord>& records) const {
  std::string lines;
  for (const CsvRecord& record : records) lines += csv_line(record);
  const int file = ::open(path_.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  const bool written = file >= 0 && ::write(file, lines.data(), lines.size()) == static_cast<ssize_t>(lines.size());
  if (file >= 0) ::close(file);
  if (!written) throw EnvironmentError("Cannot write " + path_ + ": is the disk full?");
}

void CsvFile::rewrite(const std::vector<CsvRecord>& records) const {
  std::string whole = csv_line(header_);
  for (const CsvRecord& record : records) whole += csv_line(record);
  write_file(path_, whole);
}

}  // namespace proofreel
