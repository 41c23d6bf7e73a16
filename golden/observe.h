#pragma once

#include <functional>
#include <string>
#include <vector>

#include "golden/store.h"
#include "render/image.h"
#include "scenarios/frame.h"
#include "scenarios/runner.h"

namespace proofreel {

/// One golden frame as it comes out now.
struct ObservedFrame {
  std::int64_t frame = 0;
  std::string trajectory_hash;
  Image image;  ///< empty when nothing is drawn
  std::vector<BodyPose> bodies;
};

struct Observation {
  std::string final_trajectory_hash;
  std::vector<ObservedFrame> frames;  ///< ascending
  RunReport report;
};

/// Draws a frame of the scenario. An empty function: step and hash only.
using MakePicture = std::function<Image(const Scenario&, const Frame&)>;

/// Runs the scenario to its end and keeps what its golden frames show. Throws ScenarioError, also when a golden frame
/// lies beyond the end of the film.
Observation observe(Scenario& scenario, const MakePicture& make_picture);

}  // namespace proofreel
