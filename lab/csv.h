#pragma once

/// Tables as RFC 4180 has them, and numbers that read back as they were, in every locale.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace proofreel {

/// The fields of one line of a table.
using CsvRecord = std::vector<std::string>;

/// The shortest text that reads back as the same number.
std::string exact(double value);
/// The same, or nothing.
std::string text_of(std::optional<double> value);
/// The number that is the whole text.
std::optional<double> number_in(std::string_view text);

/// In quotes, those inside doubled.
std::string csv_quoted(std::string_view text);
/// One line with its end; quoted are the fields that need it.
std::string csv_line(const CsvRecord& record);
/// All whole records. What follows the last line end was cut off while it was written, and is left out.
std::vector<CsvRecord> csv_records(std::string_view text);

}  // namespace proofreel
