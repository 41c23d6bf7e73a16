#include "render/draw.h"

#include <algorithm>

#include "render/draw_layers.h"
#include "render/framing.h"

namespace proofreel {
namespace {

/// What is drawn on nothing comes out multiplied by its alpha, and files want it as it is.
void make_straight(Image& image) {
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    const int alpha = image.rgba[i + 3];
    if (alpha == 0 || alpha == 255) continue;
    for (std::size_t c = i; c < i + 3; ++c)
      image.rgba[c] = static_cast<std::uint8_t>(std::min(255, (image.rgba[c] * 255 + alpha / 2) / alpha));
  }
}

Stage stage_of(Canvas& canvas, const Frame& frame, const Style& style, std::vector<Owner>* marks) {
  const Sizes sizes = sizes_of(canvas.width_px(), canvas.height_px());
  const Framing framing = framing_of(canvas, frame, sizes);
  return {canvas, frame, palette_of(style.theme), framing.camera, sizes, framing.plots, marks};
}

void draw_world_layers(const Stage& stage) {
  if (stage.frame.demonstration) return draw_demonstration(stage);
  if (!stage.frame.other_panes.empty()) return draw_split_scenes(stage);
  draw_scene(stage);
}

void draw_written_layers(const Stage& stage) {
  if (!stage.frame.other_panes.empty()) return draw_split_notes(stage);
  Cards cards(stage.safe_area());
  if (stage.frame.demonstration) return draw_captions(stage, cards);
  for (const Aabbd& place : stage.plot_places) cards.take(place);
  if (stage.frame.shows(Layer::clock)) draw_clock(stage, cards);
  draw_captions(stage, cards);
  draw_notes(stage, cards);
}

}  // namespace

void draw_frame(Canvas& canvas, const Frame& frame, const Style& style, Image& image) {
  canvas.clear(style.transparent ? Color{0, 0, 0, 0} : palette_of(style.theme).background);
  draw_layers(canvas, frame, style, nullptr);
  canvas.finish(image);
  if (style.transparent) make_straight(image);
}

std::string svg_of(const Frame& frame, const Style& style, Size size) {
  Canvas canvas(size.width_px, size.height_px);
  canvas.clear(style.transparent ? Color{0, 0, 0, 0} : palette_of(style.theme).background);
  draw_layers(canvas, frame, style, nullptr);
  return canvas.svg();
}

void draw_layers(Canvas& canvas, const Frame& frame, const Style& style, std::vector<Owner>* marks) {
  const Stage stage = stage_of(canvas, frame, style, marks);
  draw_world_layers(stage);
  draw_written_layers(stage);
}

void draw_world(Canvas& canvas, const Frame& frame, const Style& style, Image& image) {
  canvas.clear(palette_of(style.theme).background);
  draw_world_layers(stage_of(canvas, frame, style, nullptr));
  canvas.finish(image);
}

void draw_written(Canvas& canvas, const Frame& frame, const Style& style, const Image& world, Image& image) {
  canvas.clear(world);
  draw_written_layers(stage_of(canvas, frame, style, nullptr));
  canvas.finish(image);
}

void draw_scene(const Stage& stage) {
  const auto shows = [&stage](Layer layer) { return stage.frame.shows(layer); };
  const bool bodies = shows(Layer::bodies) || shows(Layer::islands);
  if (shows(Layer::grid)) draw_grid(stage);
  draw_water(stage);
  if (bodies) draw_bodies(stage, true);
  if (shows(Layer::trails)) draw_ghosts(stage);
  if (shows(Layer::trails)) draw_trails(stage);
  if (bodies) draw_bodies(stage, false);
  draw_highlights(stage);
  draw_water_line(stage);
  if (shows(Layer::parts)) draw_parts(stage);
  if (shows(Layer::bvh)) draw_tree(stage);
  if (shows(Layer::aabbs)) draw_boxes(stage);
  if (shows(Layer::joints)) draw_joints(stage);
  if (shows(Layer::contacts)) draw_contacts(stage);
  if (shows(Layer::forces)) draw_forces(stage);
  if (shows(Layer::vectors)) draw_vectors(stage);
  if (shows(Layer::mass)) draw_mass_centers(stage);
}

void draw_notes(const Stage& stage, Cards& cards) {
  const auto shows = [&stage](Layer layer) { return stage.frame.shows(layer); };
  draw_plots(stage, cards);
  if (shows(Layer::energy)) draw_energy(stage, cards);
  if (shows(Layer::forces)) draw_force_key(stage, cards);
  if (shows(Layer::islands)) draw_island_note(stage, cards);
  if (shows(Layer::grid)) draw_grid_numbers(stage, cards);
  draw_labels(stage, cards);
  if (shows(Layer::mass)) draw_masses(stage, cards);
  if (shows(Layer::ids)) draw_ids(stage, cards);
}

}  // namespace proofreel
