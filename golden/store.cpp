#include "golden/store.h"

#include <algorithm>

#include "golden/file_text.h"
#include "golden/hex.h"
#include "golden/json.h"
#include "render/png.h"

namespace proofreel {
namespace {

namespace fs = std::filesystem;

constexpr int format_version = 1;

Json to_json(const BodyPose& body) {
  return {{"id", body.id}, {"name", body.name}, {"x", body.x}, {"y", body.y}, {"angle", body.angle}};
}

BodyPose pose_from(const Json& json) {
  return {json.at("id"), json.at("name"), json.at("x"), json.at("y"), json.at("angle")};
}

/// Rows of a body and those of higher ids that it touches.
std::vector<Touch> touching_from(const Json& rows) {
  std::vector<Touch> touching;
  for (const Json& row : rows) {
    for (std::size_t i = 1; i < row.size(); ++i) touching.push_back({row.at(0), row.at(i)});
  }
  return touching;
}

std::vector<std::vector<std::uint32_t>> rows_of(const std::vector<Touch>& touching) {
  std::vector<std::vector<std::uint32_t>> rows;
  for (const Touch& touch : touching) {
    if (rows.empty() || rows.back().front() != touch.a) rows.push_back({touch.a});
    rows.back().push_back(touch.b);
  }
  return rows;
}

/// [kind, a, b, text], without what is 0 or empty at the end.
Json to_json(const Owner& owner) {
  Json json{name_of(owner.kind), owner.a, owner.b, owner.text};
  if (!owner.text.empty()) return json;
  json.erase(3);
  if (owner.b == 0) json.erase(2);
  if (owner.b == 0 && owner.a == 0) json.erase(1);
  return json;
}

Owner owner_from(const Json& json) {
  const std::string kind = json.at(0);
  Owner owner{owner_kind_named(kind).value_or(OwnerKind::nothing)};
  if (json.size() > 1) owner.a = json.at(1);
  if (json.size() > 2) owner.b = json.at(2);
  if (json.size() > 3) owner.text = json.at(3);
  return owner;
}

GoldenFrame frame_from(const Json& json) {
  GoldenFrame frame{json.at("frame"), json.at("trajectory_hash"), json.at("pixel_hash"),
                    json.at("file"),  json.at("file_hash"),       {}};
  for (const Json& body : json.at("bodies")) frame.bodies.push_back(pose_from(body));
  if (json.contains("touching")) frame.touching = touching_from(json.at("touching"));
  for (const Json& owner : json.value("owners", Json::array())) frame.owners.push_back(owner_from(owner));
  return frame;
}

/// `"key": value,` on a line of its own.
std::string line(const char* indent, const char* key, const Json& value) {
  std::string text(indent);
  return text.append("\"").append(key).append("\": ").append(json_text(value)).append(",\n");
}

/// `"key": [` and a row per line.
template <typename Rows, typename ToJson>
std::string rows_text(const char* key, const Rows& rows, const ToJson& json_of) {
  std::string text = std::string("      \"").append(key).append("\": [");
  const char* separator = "\n        ";
  for (const auto& row : rows) {
    text.append(separator).append(json_text(json_of(row)));
    separator = ",\n        ";
  }
  return text.append(rows.empty() ? "]" : "\n      ]");
}

std::string frame_text(const GoldenFrame& frame) {
  std::string text = "    {\n";
  text += line("      ", "frame", frame.frame);
  text += line("      ", "trajectory_hash", frame.trajectory_hash);
  text += line("      ", "pixel_hash", frame.pixel_hash);
  text += line("      ", "file", frame.file);
  text += line("      ", "file_hash", frame.file_hash);
  if (!frame.owners.empty()) {
    Json owners = Json::array();
    for (const Owner& owner : frame.owners) owners.push_back(to_json(owner));
    text += line("      ", "owners", owners);
  }
  if (frame.touching) {
    text += rows_text("touching", rows_of(*frame.touching), [](const auto& row) { return Json(row); }) + ",\n";
  }
  text += rows_text("bodies", frame.bodies, [](const BodyPose& body) { return to_json(body); });
  return text.append("\n    }");
}

Json to_json(const Tolerance& tolerance) {
  if (!tolerance.seen) {
    return {{"max_channel", tolerance.max_channel}, {"pixels", tolerance.pixels}, {"reason", tolerance.reason}};
  }
  const DifferenceLimits& limits = tolerance.seen->limits;
  Json json{{"threshold", tolerance.seen->threshold}, {"different", limits.different}};
  if (limits.window) json["window"] = *limits.window;
  json["bias"] = limits.bias;
  json["reason"] = tolerance.reason;
  return json;
}

Tolerance tolerance_from(const Json& json) {
  if (!json.contains("different")) return {json.at("max_channel"), json.at("pixels"), json.at("reason")};
  SeenTolerance seen;
  seen.threshold = json.value("threshold", seen.threshold);
  seen.limits.different = json.at("different");
  if (json.contains("window")) seen.limits.window = json.at("window").get<std::int64_t>();
  seen.limits.bias = json.value("bias", seen.limits.bias);
  return {json.value("max_channel", 0), json.value("pixels", std::int64_t{0}), json.at("reason"), seen};
}

/// JSON has numbers that no `int` holds. What has no pictures has the size 0.
void check_size(const Json& json, const std::string& name) {
  const auto is_side = [](const Json& side) {
    return side.is_number_integer() && side >= 0 && side <= max_image_side_px;
  };
  if (is_side(json.at("width_px")) && is_side(json.at("height_px"))) return;
  throw GoldenError(name + " is damaged: width_px and height_px are whole numbers up to " +
                    std::to_string(max_image_side_px) + ".");
}

Golden golden_from(const Json& json) {
  Golden golden;
  golden.scenario = json.at("scenario");
  golden.size = {json.at("width_px"), json.at("height_px")};
  golden.renderer = json.at("renderer");
  golden.version = json.at("gl_version");
  golden.tolerance = tolerance_from(json.at("tolerance"));
  golden.ticks = json.at("ticks");
  golden.final_trajectory_hash = json.at("final_trajectory_hash");
  for (const Json& frame : json.at("frames")) golden.frames.push_back(frame_from(frame));
  return golden;
}

void check_seen(const Tolerance& tolerance, const std::string& name) {
  const auto& [threshold, limits] = *tolerance.seen;
  if (tolerance.max_channel != 0 || tolerance.pixels != 0) {
    throw GoldenError(name +
                      ": a tolerance takes either max_channel and pixels, or different with threshold, window "
                      "and bias.");
  }
  const bool fits = threshold >= 0 && threshold <= 1 && limits.different >= 0 && limits.window.value_or(0) >= 0 &&
                    limits.bias >= 0 && limits.bias <= 255;
  if (fits) return;
  throw GoldenError(name + ": a tolerance takes threshold 0..1, different >= 0, window >= 0 and bias 0..255.");
}

void check_tolerance(const Tolerance& tolerance, const std::string& name) {
  if (tolerance.seen) check_seen(tolerance, name);
  if (tolerance.max_channel < 0 || tolerance.max_channel > 255 || tolerance.pixels < 0) {
    throw GoldenError(name + ": a tolerance takes max_channel 0..255 and pixels >= 0.");
  }
  if (tolerance.reason.empty() && !tolerance.is_none()) {
    throw GoldenError(name + ": a tolerance must give its reason.");
  }
}

bool is_frame_file(const fs::path& path) { return path.extension() == ".png"; }

}  // namespace

std::string to_json_text(const Golden& golden) {
  std::string text = "{\n";
  text += line("  ", "format", format_version);
  text += line("  ", "scenario", golden.scenario);
  text += line("  ", "width_px", golden.size.width_px);
  text += line("  ", "height_px", golden.size.height_px);
  text += line("  ", "renderer", golden.renderer);
  text += line("  ", "gl_version", golden.version);
  text += line("  ", "tolerance", to_json(golden.tolerance));
  text += line("  ", "ticks", golden.ticks);
  text += line("  ", "final_trajectory_hash", golden.final_trajectory_hash);
  text += "  \"frames\": [";
  const char* separator = "\n";
  for (const GoldenFrame& frame : golden.frames) {
    text.append(separator).append(frame_text(frame));
    separator = ",\n";
  }
  return text.append("\n  ]\n}\n");
}

Golden golden_from_json(const std::string& text, const std::string& name) {
  Golden golden;
  try {
    const Json json = Json::parse(text);
    if (json.at("format") != format_version) {
      throw GoldenError(name + " is of format " + json.at("format").dump() + ", this program reads format " +
                        std::to_string(format_version) + ".");
    }
    check_size(json, name);
    golden = golden_from(json);
  } catch (const Json::exception& error) {
    throw GoldenError(name + " is damaged: " + problem_in_json(error, text) + ".");
  }
  check_tolerance(golden.tolerance, name);
  return golden;
}

std::optional<Golden> GoldenStore::load(const std::string& id) const {
  const fs::path path = json_path(id);
  const std::optional<std::string> text = file_text(path);
  if (!text) return std::nullopt;
  Golden golden = golden_from_json(*text, path.string());
  golden.scenario = id;  // also where a folder was moved together with its scenario
  return golden;
}

std::optional<TickTrace> GoldenStore::load_ticks(const Golden& golden) const {
  const std::string text = file_text(ticks_path(golden.scenario)).value_or("");
  std::optional<TickTrace> trace = tick_trace_from({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  if (!trace || static_cast<std::int64_t>(trace->pieces.size()) != golden.ticks + 1) return std::nullopt;
  return hex(trace->pieces.back()).substr(12) == golden.final_trajectory_hash.substr(12) ? trace : std::nullopt;
}

std::vector<std::string> GoldenStore::ids() const {
  std::vector<std::string> ids;
  std::error_code error;
  const fs::path images = root_ / "images";
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(images, error)) {
    if (entry.path().filename() != "golden.json") continue;
    ids.push_back(entry.path().parent_path().lexically_relative(images).generic_string());
  }
  std::sort(ids.begin(), ids.end());
  return ids;
}

std::vector<fs::path> GoldenStore::orphan_files(const Golden& golden) const {
  std::vector<fs::path> orphans;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder(golden.scenario), error)) {
    const std::string name = entry.path().filename().string();
    const auto lists_it = [&name](const GoldenFrame& frame) {
      return frame.file == name || (!frame.owners.empty() && owners_file_of(frame) == name);
    };
    if (!is_frame_file(entry.path())) continue;
    if (std::none_of(golden.frames.begin(), golden.frames.end(), lists_it)) orphans.push_back(entry.path());
  }
  std::sort(orphans.begin(), orphans.end());
  return orphans;
}

std::string owners_file_of(const GoldenFrame& frame) { return fs::path(frame.file).stem().string() + ".owners.png"; }

std::optional<GoldenStore> nearest_store(const fs::path& scenario_file) {
  std::error_code error;
  fs::path folder = fs::absolute(scenario_file, error).lexically_normal().parent_path();
  while (true) {
    if (fs::is_directory(folder / "golden", error)) return GoldenStore(folder / "golden");
    if (folder == folder.parent_path()) return std::nullopt;
    folder = folder.parent_path();
  }
}

}  // namespace proofreel
