#pragma once

/// What a check found, in words, figures and names of files: what the page, JUnit and CI are told. Knows nothing of
/// scenarios, so that other programs can report their pictures, too.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "render/image.h"

namespace proofreel {

/// One thing that was looked at: a picture, a final state, an expectation.
struct ReportItem {
  std::string label;    ///< "frame 120"
  std::string verdict;  ///< the name of a Verdict (golden/judge.h), or "held", "expectation" (not held) or "error"
  bool passed = true;
  std::string message;               ///< a sentence; empty when there is nothing to say
  std::int64_t different = 0;        ///< pixels
  std::int64_t total = 0;            ///< pixels compared
  int max_channel = 0;               ///< the largest difference of one channel, 0..255
  std::optional<PixelRect> place{};  ///< where the pictures differ most densely
  std::string expected{};            ///< picture files, named from the report's folder; empty where there is none
  std::string actual{};
  std::string heat{};
};

/// What belongs together: a scenario, or a picture of another program.
struct ReportEntry {
  std::string name;       ///< unique in a report
  std::string file;       ///< the source an annotation points at
  std::string reproduce;  ///< a command
  std::string bless;      ///< a command; empty when blessing is no way out
  std::vector<ReportItem> items;
  bool passed() const;
};

/// One of several runs that share the work: `number` 1 to `count`.
struct Shard {
  int number = 1;
  int count = 1;
  friend bool operator==(Shard, Shard) = default;
};
/// Whether what has this name is checked by the shard: every name by exactly one of them.
bool is_in(Shard shard, std::string_view name);

struct Report {
  std::string program;  ///< who has checked: "proofreel 0.1.0"
  Shard shard{};
  std::vector<ReportEntry> entries;
  std::int64_t failed() const;
  /// As an exit status: 0 all passed, 1 something did not, 2 something could not be checked.
  int status() const;
};

/// The items that did not pass.
std::vector<const ReportItem*> failures_in(const ReportEntry& entry);

/// report.json: format, kind ("proofreel report"), program, shard {number, count}, passed, total, failed, entries
/// [{name, passed, file, reproduce, bless, items [{label, verdict, passed, message, different, total, max_channel,
/// place {x, y, width, height} or null, expected, actual, heat}]}].
std::string to_json_text(const Report& report);

/// Throws UsageError; `name` is what it calls the file.
Report report_from_json(const std::string& text, const std::string& name);

/// All parts as one. Throws UsageError when two hold the same name, or when a shard is missing or there twice.
Report merged(const std::vector<Report>& parts);

}  // namespace proofreel
