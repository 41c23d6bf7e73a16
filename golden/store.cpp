#include "golden/store.h"

#include <algorithm>
#include <fstream>
#include <iterator>

#include "golden/json.h"

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

GoldenFrame frame_from(const Json& json) {
  GoldenFrame frame{json.at("frame"), json.at("trajectory_hash"), json.at("pixel_hash"),
                    json.at("file"),  json.at("file_hash"),       {}};
  for (const Json& body : json.at("bodies")) frame.bodies.push_back(pose_from(body));
  return frame;
}

/// `"key": value,` on a line of its own.
std::string line(const char* indent, const char* key, const Json& value) {
  std::string text(indent);
  return text.append("\"").append(key).append("\": ").append(json_text(value)).append(",\n");
}

std::string frame_text(const GoldenFrame& frame) {
  std::string text = "    {\n";
  text += line("      ", "frame", frame.frame);
  text += line("      ", "trajectory_hash", frame.trajectory_hash);
  text += line("      ", "pixel_hash", frame.pixel_hash);
  text += line("      ", "file", frame.file);
  text += line("      ", "file_hash", frame.file_hash);
  text += "      \"bodies\": [";
  const char* separator = "\n        ";
  for (const BodyPose& body : frame.bodies) {
    text.append(separator).append(json_text(to_json(body)));
    separator = ",\n        ";
  }
  return text.append("\n      ]\n    }");
}

Golden golden_from(const Json& json) {
  Golden golden;
  golden.scenario = json.at("scenario");
  golden.size = {json.at("width_px"), json.at("height_px")};
  golden.renderer = json.at("renderer");
  golden.version = json.at("gl_version");
  const Json& tolerance = json.at("tolerance");
  golden.tolerance = {tolerance.at("max_channel"), tolerance.at("pixels"), tolerance.at("reason")};
  golden.ticks = json.at("ticks");
  golden.final_trajectory_hash = json.at("final_trajectory_hash");
  for (const Json& frame : json.at("frames")) golden.frames.push_back(frame_from(frame));
  return golden;
}

void check_tolerance(const Tolerance& tolerance, const std::string& name) {
  if (tolerance.max_channel < 0 || tolerance.max_channel > 255 || tolerance.pixels < 0) {
    throw GoldenError(name + ": a tolerance takes max_channel 0..255 and pixels >= 0.");
  }
  if (tolerance.reason.empty() && (tolerance.max_channel > 0 || tolerance.pixels > 0)) {
    throw GoldenError(name + ": a tolerance must give its reason.");
  }
}

bool is_frame_file(const fs::path& path) { return path.extension() == ".png"; }

}  // namespace

std::string to_json_text(const Golden& golden) {
  const Json tolerance{{"max_channel", golden.tolerance.max_channel},
                       {"pixels", golden.tolerance.pixels},
                       {"reason", golden.tolerance.reason}};
  std::string text = "{\n";
  text += line("  ", "format", format_version);
  text += line("  ", "scenario", golden.scenario);
  text += line("  ", "width_px", golden.size.width_px);
  text += line("  ", "height_px", golden.size.height_px);
  text += line("  ", "renderer", golden.renderer);
  text += line("  ", "gl_version", golden.version);
  text += line("  ", "tolerance", tolerance);
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
    golden = golden_from(json);
  } catch (const Json::exception& error) {
    throw GoldenError(name + " is damaged: " + error.what() + ".");
  }
  check_tolerance(golden.tolerance, name);
  return golden;
}

std::optional<Golden> GoldenStore::load(const std::string& id) const {
  const fs::path path = json_path(id);
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  return golden_from_json(text, path.string());
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
    const auto lists_it = [&name](const GoldenFrame& frame) { return frame.file == name; };
    if (!is_frame_file(entry.path())) continue;
    if (std::none_of(golden.frames.begin(), golden.frames.end(), lists_it)) orphans.push_back(entry.path());
  }
  std::sort(orphans.begin(), orphans.end());
  return orphans;
}

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
