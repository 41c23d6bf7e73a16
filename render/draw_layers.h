#pragma once

/// The layers of a picture, each drawn by one function from the same things.

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "engine/aabb.h"
#include "render/camera.h"
#include "render/canvas.h"
#include "render/draw.h"
#include "render/owner.h"
#include "render/theme.h"
#include "scenarios/frame.h"

namespace proofreel {

/// What every layer draws with.
struct Stage {
  Canvas& canvas;
  const Frame& frame;
  const Palette& palette;
  Camera camera;
  Sizes sizes;
  std::vector<Aabbd> plot_places;       ///< px; empty where plots lie in their corners
  std::vector<Owner>* marks = nullptr;  ///< by number; null when nobody asks whose pixels are
  std::uint32_t first_body = 0;         ///< added to the ids of owners: tells the panes of a split screen apart

  Aabbd picture() const {
    return {{0, 0}, {static_cast<double>(canvas.width_px()), static_cast<double>(canvas.height_px())}};
  }
  Aabbd safe_area() const { return expanded(picture(), -sizes.margin); }

  /// What is drawn from now on belongs to this owner.
  void own(OwnerKind kind, BodyId a = {}, BodyId b = {}) const {
    if (marks != nullptr) add_mark({kind, number(a), number(b), {}});
  }
  void own(OwnerKind kind, const std::string& text, BodyId a = {}) const {
    if (marks != nullptr) add_mark({kind, number(a), 0, text});
  }

 private:
  std::uint32_t number(BodyId body) const { return first_body + static_cast<std::uint32_t>(body); }
  void add_mark(Owner owner) const {
    canvas.own(static_cast<std::uint32_t>(marks->size()));
    marks->push_back(std::move(owner));
  }
};

/// All layers, in their order, without the background.
void draw_layers(Canvas& canvas, const Frame& frame, const Style& style, std::vector<Owner>* marks);

/// Where things written on the picture lie, in pixels, so that none covers another.
class Cards {
 public:
  explicit Cards(const Aabbd& safe_area) : safe_(safe_area) {}

  /// The place for a card of this size in its corner: beside the edge, or stacked onto what lies there already.
  Aabbd place(Vec2d size, Corner at);
  bool free(const Aabbd& card) const;
  void take(const Aabbd& card) { taken_.push_back(card); }
  const Aabbd& safe_area() const { return safe_; }

 private:
  Aabbd safe_;
  std::vector<Aabbd> taken_;
};

/// The bodies and what belongs to them.
void draw_scene(const Stage& stage);
/// What is written on them: plots, numbers of the grid, labels.
void draw_notes(const Stage& stage, Cards& cards);
/// A split screen: titled panes, each with its scene; and what is written, the captions of all panes on bands of
/// their own.
void draw_split_scenes(const Stage& stage);
void draw_split_notes(const Stage& stage);

void draw_grid(const Stage& stage);
/// Only where nothing else is written.
void draw_grid_numbers(const Stage& stage, Cards& cards);
/// Everything below the surface, where bodies float: quiet, behind all that moves.
void draw_water(const Stage& stage);
/// The surface again, over the bodies: how deep they lie is what one looks for.
void draw_water_line(const Stage& stage);
void draw_bodies(const Stage& stage, bool fixed_ones);
/// Pale copies of bodies where they stood at even times.
void draw_ghosts(const Stage& stage);
/// Where the bodies of several shapes are put together: concave outlines show the convex parts they were cut into.
void draw_parts(const Stage& stage);
void draw_tree(const Stage& stage);
void draw_contacts(const Stage& stage);
void draw_joints(const Stage& stage);
void draw_boxes(const Stage& stage);
/// Forces on bodies as arrows: those of contacts, along the normal and by friction, and the reactions of joints.
void draw_forces(const Stage& stage);
/// How long which force is drawn, and what the colours mean.
void draw_force_key(const Stage& stage, Cards& cards);
/// Says so where nobody tells which body belongs to which island.
void draw_island_note(const Stage& stage, Cards& cards);
/// A quartered disc on every centre of mass.
void draw_mass_centers(const Stage& stage);
/// What bodies weigh, beside their centres, where there is room.
void draw_masses(const Stage& stage, Cards& cards);
/// A body's number, within it or beside it, where there is room.
void draw_ids(const Stage& stage, Cards& cards);
/// Kinetic, potential and total energy as bars; a line marks what the total was at the start.
void draw_energy(const Stage& stage, Cards& cards);
/// How far the halo of a highlighted body reaches, and how wide the circle round a highlighted point is drawn.
inline double halo_px(const Stage& stage) { return std::max(4.0, 8 * stage.sizes.unit); }
inline double ring_px(const Stage& stage) { return std::max(2.5, 5 * stage.sizes.unit); }
/// Halos of bodies and circles round points, over the bodies.
void draw_highlights(const Stage& stage);
void draw_trails(const Stage& stage);
void draw_vectors(const Stage& stage);
void draw_clock(const Stage& stage, Cards& cards);
/// Throws ScenarioError, with the place of the caption in its file, when one is too long for the picture, or for the
/// bands of a split screen.
void draw_captions(const Stage& stage, Cards& cards);
/// Throws the same, before anything is drawn, when one is too long for any picture of this size.
void require_room(Canvas& canvas, const std::vector<CaptionView>& captions);
void draw_plots(const Stage& stage, Cards& cards);
/// How high the card of a plot has to be that is so wide; px.
double least_plot_height(Canvas& canvas, const Sizes& sizes, const PlotView& plot, double width);
void draw_labels(const Stage& stage, Cards& cards);
/// A lecture film's step: heading and counters, panes, caption. It fills the picture.
void draw_demonstration(const Stage& stage);

/// Where what is written about a body may stand: the first side of its box that no card and, where there is a choice,
/// no other body takes; with `apart` never on another body. Directions and sizes in pixels.
std::optional<Aabbd> place_beside(const Cards& cards, const std::vector<Aabbd>& others, const Aabbd& box, Vec2d size,
                                  bool apart);
/// The boxes of all bodies but one; the fixed ones may be written on.
std::vector<Aabbd> other_bodies(const Stage& stage, const BodyView* body);

/// The box around a body's shapes, in pixels; empty without shapes.
Aabbd box_px(const Stage& stage, const BodyView& body);

/// A shape of a body in pixels.
struct ShapePx {
  std::vector<Vec2d> points;
  double radius = 0;
};
ShapePx shape_px(const Stage& stage, const BodyView& body, const ShapeView& shape);

void paint_shape(Canvas& canvas, const ShapePx& shape, const Paint& paint);

/// Several shapes of one body, outlined together as if they were one.
void paint_compound(Canvas& canvas, const std::vector<ShapePx>& shapes, const Paint& paint);

/// The edges along which the shapes of one body meet or reach into each other.
void paint_seams(Canvas& canvas, const std::vector<ShapePx>& shapes, double width_px, Color color);

}  // namespace proofreel
