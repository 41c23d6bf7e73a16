#pragma once

/// A table in a file that grows while long work goes on, and tells what was done when the work is taken up again.

#include <string>
#include <vector>

#include "lab/csv.h"

namespace proofreel {

class CsvFile {
 public:
  /// Reads what is there; a last line that was cut off is forgotten. Throws UsageError when the file holds something
  /// else than a table under this header.
  CsvFile(std::string path, CsvRecord header);

  const std::string& path() const { return path_; }
  /// What was there when the file was opened, the header left out.
  const std::vector<CsvRecord>& found() const { return found_; }
  /// Adds lines, at once and as a whole. Throws EnvironmentError.
  void append(const std::vector<CsvRecord>& records) const;
  /// From now on the file holds these lines. Throws EnvironmentError.
  void rewrite(const std::vector<CsvRecord>& records) const;

 private:
  std::string path_;
  CsvRecord header_;
  std::vector<CsvRecord> found_;
};

}  // namespace proofreel
