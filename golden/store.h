#pragma once

/// What is kept of a scenario so that later runs can be held against it, in STORE/images/ID/: one golden.json, and one
/// PNG per golden frame. What decides is in these. Beside them lies what explains a failure: ticks.bin with
/// fingerprints of all ticks, and per golden frame a PNG that says whose each pixel is.

#include <compare>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "golden/difference.h"
#include "golden/ticks.h"
#include "render/owner.h"
#include "scenarios/scenario.h"

namespace proofreel {

/// Where a body was. Kept so that a failure can name the bodies that moved.
struct BodyPose {
  std::uint32_t id = 0;
  std::string name;  ///< empty for bodies the script made while it ran
  double x = 0;      ///< m
  double y = 0;      ///< m
  double angle = 0;  ///< rad
};

/// Two bodies that touched, the one of the lower id first.
struct Touch {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  friend auto operator<=>(const Touch&, const Touch&) = default;
};

struct GoldenFrame {
  std::int64_t frame = 0;       ///< of the film
  std::string trajectory_hash;  ///< of all ticks up to this frame's, hex
  std::string pixel_hash;       ///< of the picture
  std::string file;             ///< the PNG, in the same folder
  std::string file_hash;        ///< of the PNG's bytes: finds a damaged reference without decoding it
  std::vector<BodyPose> bodies;
  std::optional<std::vector<Touch>> touching = {};  ///< ascending; nothing where it was not kept
  std::vector<Owner> owners = {};                   ///< of its owner picture; empty where none was kept
};

/// The PNG that says whose each pixel of the frame's picture is.
std::string owners_file_of(const GoldenFrame& frame);

/// What may differ as it is seen: see golden/difference.h.
struct SeenTolerance {
  double threshold = 0.1;
  DifferenceLimits limits;
};

/// What may differ without failing: every channel by `max_channel`, and beyond that `pixels` pixels by anything. Or,
/// where `seen` is given, what keeps its limits.
struct Tolerance {
  int max_channel = 0;
  std::int64_t pixels = 0;
  std::string reason;  ///< must be given when anything may differ
  std::optional<SeenTolerance> seen = {};

  bool is_none() const { return max_channel == 0 && pixels == 0 && !seen; }
};

struct Golden {
  std::string scenario;  ///< id
  Size size;             ///< of the pictures
  std::string renderer;  ///< GL_RENDERER and
  std::string version;   ///< GL_VERSION of whoever blessed the pictures
  Tolerance tolerance;
  std::int64_t ticks = 0;
  std::string final_trajectory_hash;
  std::vector<GoldenFrame> frames;  ///< ascending
};

/// A golden file that cannot be used: which, and what is wrong with it.
class GoldenError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The text of golden.json: one line per body and per figure, so that version control shows what changed.
std::string to_json_text(const Golden& golden);
/// Throws GoldenError; `name` is what it calls the file.
Golden golden_from_json(const std::string& text, const std::string& name);

class GoldenStore {
 public:
  explicit GoldenStore(std::filesystem::path root) : root_(std::move(root)) {}
  const std::filesystem::path& root() const { return root_; }
  std::filesystem::path folder(const std::string& id) const { return root_ / "images" / id; }
  std::filesystem::path json_path(const std::string& id) const { return folder(id) / "golden.json"; }
  std::filesystem::path ticks_path(const std::string& id) const { return folder(id) / "ticks.bin"; }
  /// Nothing when there is none. Throws GoldenError when it cannot be used.
  std::optional<Golden> load(const std::string& id) const;
  /// The fingerprints of the run that gave `golden`; nothing when they are not kept, or are of another.
  std::optional<TickTrace> load_ticks(const Golden& golden) const;
  /// The ids of all scenarios kept, sorted.
  std::vector<std::string> ids() const;
  /// The PNGs in the scenario's folder that `golden` does not list, sorted.
  std::vector<std::filesystem::path> orphan_files(const Golden& golden) const;

 private:
  std::filesystem::path root_;
};

/// The nearest folder `golden` beside or above the scenario's file.
std::optional<GoldenStore> nearest_store(const std::filesystem::path& scenario_file);

}  // namespace proofreel
