#include <algorithm>

#include "render/draw_layers.h"

namespace proofreel {
namespace {

std::vector<ShapePx> shapes_of(const Stage& stage, const BodyView& body) {
  std::vector<ShapePx> shapes;
  for (std::uint32_t i = 0; i < body.shape_count; ++i) {
    shapes.push_back(shape_px(stage, body, stage.frame.snapshot.shapes[body.first_shape + i]));
  }
  return shapes;
}

/// From the centre of a disc to its rim, so that its spin shows.
void draw_radius_line(Canvas& canvas, const BodyView& body, const ShapePx& shape, const Paint& paint) {
  constexpr double least_px = 3;
  if (shape.points.size() != 1 || shape.radius < least_px) return;
  const Vec2d along{body.pose.rotation.c, -body.pose.rotation.s};
  const double reach = shape.radius - paint.outline_px;
  canvas.line(shape.points[0], shape.points[0] + reach * along, paint.outline_px, paint.outline);
}

/// Small bodies have thinner outlines, or there would be nothing else. Measured so that turning does not change it.
double outline_px(const Stage& stage, const std::vector<ShapePx>& shapes) {
  constexpr double largest_part = 0.2;
  double reach = 0;
  for (const ShapePx& shape : shapes) {
    for (const Vec2d point : shape.points) {
      reach = std::max(reach, 0.5 * distance(shape.points[0], point) + shape.radius);
    }
  }
  return std::clamp(largest_part * reach, std::min(1.0, stage.sizes.outline), stage.sizes.outline);
}

void draw_body(const Stage& stage, const BodyView& body, const Tone& tone) {
  const std::vector<ShapePx> shapes = shapes_of(stage, body);
  const Paint paint{tone.fill, tone.outline, outline_px(stage, shapes)};
  if (shapes.size() == 1 || body.sensor) {
    for (const ShapePx& shape : shapes) paint_shape(stage.canvas, shape, paint);
  } else {
    paint_compound(stage.canvas, shapes, paint);
  }
  if (body.type == BodyType::fixed) return;
  for (const ShapePx& shape : shapes) draw_radius_line(stage.canvas, body, shape, paint);
}

/// The least body of every island, by the island's number: islands are counted anew in every snapshot, but the one
/// that holds body 3 is still the one that holds body 3.
std::vector<BodyId> first_bodies(const Snapshot& snapshot) {
  std::vector<BodyId> first;
  for (const BodyView& body : snapshot.bodies) {
    if (body.island >= first.size()) first.resize(body.island + 1, BodyId::world);
    if (first[body.island] == BodyId::world) first[body.island] = body.id;
  }
  return first;
}

Tone island_tone(const Stage& stage, const BodyView& body, const std::vector<BodyId>& first) {
  if (body.island == 0) return tone_of(stage.palette, body);
  const auto number = static_cast<std::size_t>(first[body.island]) - 1;
  const Tone tone = stage.palette.islands[number % stage.palette.islands.size()];
  return body.asleep ? asleep(tone, stage.palette) : tone;
}

Color highlight_color(const Stage& stage, double strength) {
  Color color = stage.palette.highlight;
  color.a = static_cast<std::uint8_t>(255 * strength);
  return color;
}

/// Behind a body that is then drawn once more, over the others, or they would cut its halo.
void draw_halo(const Stage& stage, const BodyView& body, double strength) {
  const Color color = highlight_color(stage, strength);
  for (ShapePx shape : shapes_of(stage, body)) {
    shape.radius += strength * halo_px(stage);
    paint_shape(stage.canvas, shape, {color, color, 0});
  }
}

void draw_ring(const Stage& stage, const HighlightView& highlight) {
  const Color color = highlight_color(stage, highlight.strength);
  const Color inside = highlight_color(stage, 0.2 * highlight.strength);
  stage.canvas.disc(stage.camera.to_px(*highlight.at), stage.camera.px(highlight.radius) + ring_px(stage),
                    {inside, color, ring_px(stage)});
}

}  // namespace

ShapePx shape_px(const Stage& stage, const BodyView& body, const ShapeView& shape) {
  ShapePx result{{}, stage.camera.px(shape.radius)};
  for (std::uint32_t i = 0; i < shape.point_count; ++i) {
    const Vec2d local = stage.frame.snapshot.points[shape.first_point + i];
    result.points.push_back(stage.camera.to_px(to_world(body.pose, local)));
  }
  return result;
}

Aabbd box_px(const Stage& stage, const BodyView& body) {
  Aabbd box;
  for (const ShapePx& shape : shapes_of(stage, body)) {
    for (const Vec2d point : shape.points) {
      box = merged(box, expanded(Aabbd{point, point}, shape.radius));
    }
  }
  return box;
}

void draw_bodies(const Stage& stage, bool fixed_ones) {
  const bool tinted = stage.frame.shows(Layer::islands) && !fixed_ones;
  const std::vector<BodyId> first = tinted ? first_bodies(stage.frame.snapshot) : std::vector<BodyId>{};
  for (const BodyView& body : stage.frame.snapshot.bodies) {
    if ((body.type == BodyType::fixed) != fixed_ones) continue;
    stage.own(OwnerKind::body, body.id);
    draw_body(stage, body, tinted ? island_tone(stage, body, first) : tone_of(stage.palette, body));
  }
}

void draw_ghosts(const Stage& stage) {
  for (const GhostView& ghost : stage.frame.ghosts) {
    const BodyView* body = find_body(stage.frame.snapshot, ghost.body);
    if (body == nullptr) continue;
    Tone tone = tone_of(stage.palette, *body);
    tone.fill = mixed(tone.fill, stage.palette.background, 0.7);
    tone.outline = mixed(tone.outline, stage.palette.background, 0.5);
    stage.own(OwnerKind::trail, ghost.body);
    BodyView then = *body;
    for (const Posed& pose : ghost.poses) {
      then.pose = pose;
      draw_body(stage, then, tone);
    }
  }
}

void draw_highlights(const Stage& stage) {
  const bool tinted = stage.frame.shows(Layer::islands);
  const std::vector<BodyId> first = first_bodies(stage.frame.snapshot);
  for (const HighlightView& highlight : stage.frame.highlights) {
    stage.own(OwnerKind::highlight, highlight.body);
    if (highlight.at) {
      draw_ring(stage, highlight);
      continue;
    }
    const BodyView* body = find_body(stage.frame.snapshot, highlight.body);
    if (body == nullptr || !(tinted || stage.frame.shows(Layer::bodies))) continue;
    draw_halo(stage, *body, highlight.strength);
    stage.own(OwnerKind::body, body->id);
    draw_body(stage, *body, tinted ? island_tone(stage, *body, first) : tone_of(stage.palette, *body));
  }
}

void draw_parts(const Stage& stage) {
  for (const BodyView& body : stage.frame.snapshot.bodies) {
    const Tone tone = tone_of(stage.palette, body);
    stage.own(OwnerKind::body, body.id);
    paint_seams(stage.canvas, shapes_of(stage, body), stage.sizes.thin, mixed(tone.fill, tone.outline, 0.5));
  }
}

}  // namespace proofreel
