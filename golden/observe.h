#pragma once

#include <functional>
#include <string>
#include <vector>

#include "golden/store.h"
#include "render/image.h"
#include "scenarios/frame.h"
#include "scenarios/runner.h"

namespace proofreel {

/// A picture and the hash by which it is known again.
struct DrawnPicture {
  Image image;
  std::string hash;
};

/// One golden frame as it comes out now.
struct ObservedFrame {
  std::int64_t frame = 0;
  std::string trajectory_hash;
  Image image;  ///< empty when nothing is drawn; without its bytes once nobody needs them
  std::vector<BodyPose> bodies;
  std::string pixel_hash = {};
  std::vector<Touch> touching = {};  ///< ascending
};

struct Observation {
  std::string final_trajectory_hash;
  std::vector<ObservedFrame> frames;  ///< ascending
  RunReport report;
};

/// Draws a frame of the scenario.
using MakePicture = std::function<DrawnPicture(const Scenario&, const Frame&)>;

/// Who looks on while a scenario runs, and at what. Whatever is left empty is not done.
struct Watch {
  MakePicture make_picture;  ///< without one, frames are stepped and hashed only
  std::function<void(const Scenario&, const Frame&, ObservedFrame&)> at_frame;  ///< at every golden frame
  TickRecorder* ticks = nullptr;
};

/// Runs the scenario to its end and keeps what its golden frames show. Throws ScenarioError, also when a golden frame
/// lies beyond the end of the film.
Observation observe(Scenario& scenario, const Watch& watch);

}  // namespace proofreel
