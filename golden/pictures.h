#pragma once

#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "golden/second_look.h"
#include "render/canvas.h"
#include "render/context.h"
#include "render/owners.h"

namespace proofreel {

/// Draws golden frames, and holds them against their references. Starts GL when the first picture is asked for, and
/// must be used on one thread.
class Pictures {
 public:
  explicit Pictures(std::optional<GlBackend> backend) : backend_(backend) {}

  /// The frame in the size of the scenario's golden pictures. Throws EnvironmentError.
  DrawnPicture draw(const Scenario& scenario, const Frame& frame);

  /// Whose its pixels are.
  OwnerPicture draw_owners(const Scenario& scenario, const Frame& frame);

  /// Exact without decoding the reference when the hashes agree and its file is whole; else compares the pixels.
  Finding judge(const GoldenStore& store, const Golden& golden, const GoldenFrame& then,
                const ObservedFrame& now) const;

  /// Why the picture of `now` differs from its reference, which must be there and of its size.
  PictureWhy explain(const GoldenStore& store, const Golden& golden, const GoldenFrame& then, const Scenario& scenario,
                     const Frame& frame, const ObservedFrame& now);

  /// All of these, as `check_scenario` asks for them. The pictures must outlive what is returned.
  PictureTools tools(const GoldenStore& store);

  /// What has drawn the pictures; empty strings before the first one.
  const GlInfo& info() const { return info_; }

 private:
  Canvas& canvas_of(Size size);

  std::optional<GlBackend> backend_;
  std::unique_ptr<GlContext> context_;
  GlInfo info_;
  std::map<std::pair<int, int>, Canvas> canvases_;  ///< by width and height
};

/// What is wrong with the reference's file: nothing when it is there, whole and the one that was blessed.
std::optional<std::string> problem_with_file(const GoldenStore& store, const Golden& golden, const GoldenFrame& frame);

/// Whose the pixels of a reference are; nothing when that was not kept, or cannot be read.
std::optional<OwnerPicture> load_owners(const GoldenStore& store, const Golden& golden, const GoldenFrame& frame);

}  // namespace proofreel
