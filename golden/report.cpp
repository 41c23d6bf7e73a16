#include "golden/report.h"

#include <algorithm>
#include <set>

#include "engine/state_hash.h"
#include "golden/json.h"
#include "render/usage_error.h"

namespace proofreel {
namespace {

constexpr int format_version = 1;
constexpr const char* kind_of_file = "proofreel report";

Json json_of(const std::optional<PixelRect>& place) {
  if (!place) return nullptr;
  return {{"x", place->x_px}, {"y", place->y_px}, {"width", place->width_px}, {"height", place->height_px}};
}

Json json_of(const ReportItem& item) {
  return {{"label", item.label},
          {"verdict", item.verdict},
          {"passed", item.passed},
          {"message", item.message},
          {"different", item.different},
          {"total", item.total},
          {"max_channel", item.max_channel},
          {"place", json_of(item.place)},
          {"expected", item.expected},
          {"actual", item.actual},
          {"heat", item.heat}};
}

Json json_of(const ReportEntry& entry) {
  Json items = Json::array();
  for (const ReportItem& item : entry.items) items.push_back(json_of(item));
  return {{"name", entry.name},   {"passed", entry.passed()},     {"file", entry.file},
          {"bless", entry.bless}, {"reproduce", entry.reproduce}, {"items", items}};
}

ReportItem item_from(const Json& json) {
  ReportItem item{json.at("label"),     json.at("verdict"), json.at("passed"),      json.at("message"),
                  json.at("different"), json.at("total"),   json.at("max_channel"), std::nullopt,
                  json.at("expected"),  json.at("actual"),  json.at("heat")};
  const Json& place = json.at("place");
  if (!place.is_null()) item.place = {place.at("x"), place.at("y"), place.at("width"), place.at("height")};
  return item;
}

ReportEntry entry_from(const Json& json) {
  ReportEntry entry{json.at("name"), json.at("file"), json.at("reproduce"), json.at("bless"), {}};
  for (const Json& item : json.at("items")) entry.items.push_back(item_from(item));
  return entry;
}

Report report_from(const Json& json) {
  const Json& shard = json.at("shard");
  Report report{json.at("program"), {shard.at("number"), shard.at("count")}, {}};
  for (const Json& entry : json.at("entries")) report.entries.push_back(entry_from(entry));
  return report;
}

void refuse_other_kinds(const Json& json, const std::string& name) {
  if (!json.is_object() || json.value("kind", "") != kind_of_file) {
    throw UsageError(name + " is not the report of a check.");
  }
  if (json.at("format") != format_version) {
    throw UsageError(name + " is of format " + json.at("format").dump() + ", this program reads format " +
                     std::to_string(format_version) + ".");
  }
  if (!json.contains("entries")) throw UsageError(name + " is unfinished: that check did not come to its end.");
}

/// A part that is missing would turn a failure into a pass.
void refuse_gaps(const std::vector<Report>& parts) {
  std::set<int> seen;
  const int count = parts.front().shard.count;
  for (const Report& part : parts) {
    const std::string name = std::to_string(part.shard.number) + "/" + std::to_string(part.shard.count);
    if (part.shard.count != count) {
      throw UsageError("Shard " + name + " does not belong to the others, which are of " + std::to_string(count) + ".");
    }
    if (!seen.insert(part.shard.number).second && count > 1) throw UsageError("Shard " + name + " is there twice.");
  }
  for (int number = 1; number <= count; ++number) {
    if (seen.contains(number)) continue;
    throw UsageError("Shard " + std::to_string(number) + "/" + std::to_string(count) +
                     " is missing: without it nobody knows whether all passed.");
  }
}

}  // namespace

bool ReportEntry::passed() const {
  return std::all_of(items.begin(), items.end(), [](const ReportItem& item) { return item.passed; });
}

bool is_in(Shard shard, std::string_view name) {
  const auto count = static_cast<std::uint64_t>(shard.count);
  return hash_of(name.data(), name.size()) % count == static_cast<std::uint64_t>(shard.number - 1);
}

std::int64_t Report::failed() const {
  return std::count_if(entries.begin(), entries.end(), [](const ReportEntry& entry) { return !entry.passed(); });
}

int Report::status() const {
  const auto is_error = [](const ReportItem& item) { return item.verdict == "error"; };
  const auto has_error = [&](const ReportEntry& e) { return std::any_of(e.items.begin(), e.items.end(), is_error); };
  if (std::any_of(entries.begin(), entries.end(), has_error)) return 2;
  return failed() > 0 ? 1 : 0;
}

std::vector<const ReportItem*> failures_in(const ReportEntry& entry) {
  std::vector<const ReportItem*> failures;
  for (const ReportItem& item : entry.items) {
    if (!item.passed) failures.push_back(&item);
  }
  return failures;
}

std::string to_json_text(const Report& report) {
  Json entries = Json::array();
  for (const ReportEntry& entry : report.entries) entries.push_back(json_of(entry));
  const Json json{
      {"format", format_version},       {"kind", kind_of_file},
      {"program", report.program},      {"shard", {{"number", report.shard.number}, {"count", report.shard.count}}},
      {"passed", report.status() == 0}, {"total", report.entries.size()},
      {"failed", report.failed()},      {"entries", entries}};
  return json_text(json, 1) + "\n";
}

Report report_from_json(const std::string& text, const std::string& name) {
  try {
    const Json json = Json::parse(text);
    refuse_other_kinds(json, name);
    return report_from(json);
  } catch (const Json::exception& error) {
    throw UsageError(name + " is damaged: " + problem_in_json(error, text) + "; let check write that report again.");
  }
}

Report merged(const std::vector<Report>& parts) {
  if (parts.empty()) return {};
  refuse_gaps(parts);
  Report whole{parts.front().program, {}, {}};
  std::set<std::string> names;
  for (const Report& part : parts) {
    for (const ReportEntry& entry : part.entries) {
      if (!names.insert(entry.name).second) {
        throw UsageError("\"" + entry.name + "\" is in two of the reports: each must be checked by one of them only.");
      }
      whole.entries.push_back(entry);
    }
  }
  std::sort(whole.entries.begin(), whole.entries.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  return whole;
}

}  // namespace proofreel
