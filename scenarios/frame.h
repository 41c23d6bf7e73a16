#pragma once

/// One film frame as data: everything drawing needs, nothing it could change. Made by the runner, so that drawing may
/// happen later and elsewhere while the simulation goes on.

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/snapshot.h"
#include "scenarios/scenario.h"

namespace proofreel {

/// Points from old to new, world coordinates.
struct TrailView {
  BodyId body{};
  std::vector<Vec2d> points;
};

/// Where the body stood at even times, the oldest first.
struct GhostView {
  BodyId body{};
  std::vector<Posed> poses;
};

struct ArrowView {
  VectorOf of = VectorOf::velocity;
  Vec2d from;  ///< world
  Vec2d to;    ///< world
  BodyId body{};
};

struct LabelView {
  Vec2d anchor;          ///< world: the body's centre
  double clearance = 0;  ///< m from the anchor to the body's far edge
  std::string text;
  BodyId body{};
};

struct CaptionView {
  std::string text;
  Corner at = Corner::bottom;
};

/// Samples of one plot up to now: curve i at time times[k] is values[i][k].
struct PlotView {
  std::string title;
  std::vector<std::string> curves;
  double seconds = 10;  ///< width of the time axis
  Corner at = Corner::top_right;
  std::vector<double> times;  ///< s of scene time
  std::vector<std::vector<double>> values;
};

/// Where the film has captions, now or at another time: there a split screen leaves room for them.
struct Bands {
  bool above = false;
  bool below = false;
};

/// Bodies of pane n of a split screen, from 0, are told apart by n times this in pictures of owners and in references.
inline constexpr std::uint32_t pane_stride = 1'000'000;

struct Frame {
  std::int64_t index = 0;  ///< film frame
  Snapshot snapshot;
  View view;                  ///< the camera, resolved
  std::vector<Layer> layers;  ///< what of it is drawn
  bool shows(Layer layer) const { return std::find(layers.begin(), layers.end(), layer) != layers.end(); }
  std::vector<TrailView> trails;
  std::vector<GhostView> ghosts;
  std::vector<ArrowView> arrows;
  std::vector<LabelView> labels;
  std::vector<CaptionView> captions;
  std::vector<PlotView> plots;
  std::optional<DemonstrationView> demonstration;  ///< takes the place of the bodies
  std::string pane_title;                          ///< of a split screen, whose first pane this is
  std::vector<Frame> other_panes;
  Bands bands;
};

}  // namespace proofreel
