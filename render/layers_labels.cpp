#include <algorithm>
#include <array>
#include <optional>

#include "render/draw_layers.h"
#include "render/draw_text.h"

namespace proofreel {
namespace {

/// Where a label may stand, best first: a direction from the body in picture coordinates, y down.
constexpr std::array<Vec2d, 8> sides{Vec2d{0, -1}, {1, 0}, {-1, 0}, {0, 1}, {1, -1}, {-1, -1}, {1, 1}, {-1, 1}};

/// What a label belongs to, in pixels.
struct Labelled {
  Aabbd box;
  const BodyView* body = nullptr;
};

/// A label names the body whose centre it is anchored to.
Labelled labelled(const Stage& stage, const LabelView& label) {
  for (const BodyView& body : stage.frame.snapshot.bodies) {
    if (body.state.center == label.anchor && body.shape_count > 0) return {box_px(stage, body), &body};
  }
  const Vec2d anchor = stage.camera.to_px(label.anchor);
  return {expanded(Aabbd{anchor, anchor}, stage.camera.px(label.clearance)), nullptr};
}

Aabbd beside(const Aabbd& box, double gap, Vec2d size, Vec2d side) {
  const Vec2d reach = 0.5 * (box.upper - box.lower + size) + Vec2d{gap, gap};
  const Vec2d middle = center(box) + Vec2d{side.x * reach.x, side.y * reach.y};
  return {middle - 0.5 * size, middle + 0.5 * size};
}

/// From the body to a label that stands apart from it, unless a card hides the body.
void draw_leader(const Stage& stage, const Cards& cards, const Aabbd& box, const Aabbd& place) {
  const Vec2d from{std::clamp(center(place).x, box.lower.x, box.upper.x),
                   std::clamp(center(place).y, box.lower.y, box.upper.y)};
  const Vec2d to{std::clamp(from.x, place.lower.x, place.upper.x), std::clamp(from.y, place.lower.y, place.upper.y)};
  if (distance(from, to) < stage.sizes.small || !cards.free({from, from})) return;
  stage.canvas.line(from, to, stage.sizes.thin, stage.palette.quiet_ink);
}

Color faded(Color color, double strength) {
  color.a = static_cast<std::uint8_t>(color.a * strength);
  return color;
}

/// Beside what it belongs to, with a line to it where it stands apart.
void write_beside(const Stage& stage, Cards& cards, const Labelled& target, const std::string& text, double strength) {
  const Vec2d middle_of_target = center(target.box);
  const Vec2d anchor = target.body != nullptr ? stage.camera.to_px(target.body->state.center) : middle_of_target;
  if (text.empty() || !contains(stage.picture(), Aabbd{anchor, anchor})) return;
  const int size_px = stage.sizes.small;
  const Vec2d size{stage.canvas.text_width(text, size_px) + 0.7 * size_px, 1.35 * size_px};
  const auto place = place_beside(cards, other_bodies(stage, target.body), target.box, size, false);
  if (!place) return;
  draw_leader(stage, cards, target.box, *place);
  cards.take(*place);
  Color plate = stage.palette.background;
  plate.a = 205;
  plate = faded(plate, strength);
  stage.canvas.rectangle(place->lower, place->upper, 0.3 * size_px, {plate, plate, 0});
  const Vec2d middle = center(*place);
  stage.canvas.text(text, {middle.x, middle.y + 0.5 * cap_height * size_px}, size_px, Align::center,
                    faded(stage.palette.ink, strength));
}

Labelled highlighted(const Stage& stage, const HighlightView& highlight) {
  if (highlight.at) {
    const Vec2d at = stage.camera.to_px(*highlight.at);
    return {expanded(Aabbd{at, at}, stage.camera.px(highlight.radius) + ring_px(stage)), nullptr};
  }
  const BodyView* body = find_body(stage.frame.snapshot, highlight.body);
  return {expanded(box_px(stage, *body), halo_px(stage)), body};
}

}  // namespace

std::optional<Aabbd> place_beside(const Cards& cards, const std::vector<Aabbd>& others, const Aabbd& box, Vec2d size,
                                  bool apart) {
  const int rings = apart ? 1 : 4;
  std::optional<Aabbd> second_best;
  for (int ring = 0; ring < rings; ++ring) {
    for (const Vec2d side : sides) {
      const Aabbd place = beside(box, (0.15 + 0.8 * ring) * size.y, size, side);
      if (!cards.free(place)) continue;
      const auto covers = [&place](const Aabbd& body) { return overlaps(body, place); };
      if (std::none_of(others.begin(), others.end(), covers)) return place;
      if (!second_best && !apart) second_best = place;
    }
  }
  return second_best;
}

std::vector<Aabbd> other_bodies(const Stage& stage, const BodyView* body) {
  std::vector<Aabbd> boxes;
  for (const BodyView& other : stage.frame.snapshot.bodies) {
    if (&other != body && other.type != BodyType::fixed) boxes.push_back(box_px(stage, other));
  }
  return boxes;
}

void draw_labels(const Stage& stage, Cards& cards) {
  for (const HighlightView& highlight : stage.frame.highlights) {
    stage.own(OwnerKind::highlight, highlight.body);
    write_beside(stage, cards, highlighted(stage, highlight), highlight.text, highlight.strength);
  }
  if (!stage.frame.shows(Layer::labels)) return;
  for (const LabelView& label : stage.frame.labels) {
    stage.own(OwnerKind::label, label.text, label.body);
    write_beside(stage, cards, labelled(stage, label), label.text, 1);
  }
}

}  // namespace proofreel
