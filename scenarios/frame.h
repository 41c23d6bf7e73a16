#pragma once

/// One film frame as data: everything drawing needs, nothing it could change. Made by the runner, so that drawing may
/// happen later and elsewhere while the simulation goes on.

#include <algorithm>
#include <cstdint>
#include <limits>
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

/// What is emphasised: a circle at `at`, or where that is empty a whole body.
struct HighlightView {
  BodyId body{};            ///< it belongs to; the world where it belongs to none
  std::optional<Vec2d> at;  ///< world
  double radius = 0;        ///< m
  double strength = 1;      ///< 0 to 1: it comes and goes softly
  std::string text;
};

struct CaptionView {
  std::string text;
  Corner at = Corner::bottom;
  std::string place = {};  ///< where the script makes it, as sentences begin
};

/// The least and the greatest of some numbers; of none, the low is above the high.
struct Reach {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

/// Samples of one plot up to now: curve i at time times[k] is values[i][k].
struct PlotView {
  std::string title;
  std::vector<std::string> curves;
  double seconds = 10;  ///< width of the time axis
  Corner at = Corner::top_right;
  std::vector<double> times;  ///< s of scene time
  std::vector<std::vector<double>> values;
  std::string unit = {};  ///< of the values
  std::string x_name =
      {};  ///< of what a phase portrait has in the place of time, and then xs[k] goes with values[i][k]
  std::string x_unit = {};
  std::vector<double> xs = {};
  Reach x_reach = {};  ///< of all samples of a phase portrait, the forgotten ones too
  Reach y_reach = {};
  bool is_portrait() const { return !x_name.empty(); }
};

/// What the bars of the layer energy are measured by, J. Of all samples so far.
struct EnergyExtent {
  double initial_total = 0;
  double lowest = 0;   ///< of kinetic, potential and total
  double highest = 0;  ///< of kinetic, potential and total
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
  double force_scale = 0;  ///< m of the picture per N, the same in all frames of a film; 0: forces are not drawn
  EnergyExtent energy;
  std::vector<TrailView> trails;
  std::vector<GhostView> ghosts;
  std::vector<ArrowView> arrows;
  std::vector<LabelView> labels;
  std::vector<HighlightView> highlights;
  std::vector<CaptionView> captions;
  std::vector<PlotView> plots;
  std::optional<DemonstrationView> demonstration;  ///< takes the place of the bodies
  std::string pane_title;                          ///< of a split screen, whose first pane this is
  std::vector<Frame> other_panes;
  Bands bands;
};

}  // namespace proofreel
