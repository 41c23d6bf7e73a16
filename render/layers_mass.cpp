#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "render/draw_layers.h"
#include "render/draw_text.h"

namespace proofreel {
namespace {

/// Where more bodies than this are in the picture, numbers on them would be dust.
constexpr std::size_t most_numbers = 300;

bool is_in_picture(const Stage& stage, const BodyView& body) {
  const Vec2d at = stage.camera.to_px(body.state.center);
  return contains(stage.picture(), Aabbd{at, at});
}

/// From the centre of mass to the nearest edge of the shape it lies in, in pixels; the same however the body turns.
double inner_radius(const Stage& stage, const BodyView& body) {
  const Vec2d middle = stage.camera.to_px(body.state.center);
  double least = 0;
  for (std::uint32_t i = 0; i < body.shape_count; ++i) {
    const ShapePx shape = shape_px(stage, body, stage.frame.snapshot.shapes[body.first_shape + i]);
    if (shape.points.size() < 3) {
      if (body.shape_count == 1) least = shape.radius;
      continue;
    }
    double inner = 1e300;
    for (std::size_t k = 0; k < shape.points.size(); ++k) {
      const Vec2d a = shape.points[k];
      const Vec2d along = normalized(shape.points[(k + 1) % shape.points.size()] - a);
      // y is down, so corners that run counter-clockwise in the world run clockwise here.
      inner = std::min(inner, -cross(along, middle - a));
    }
    least = std::max(least, inner + shape.radius);
  }
  return least;
}

double mark_radius(const Stage& stage, const BodyView& body) {
  return std::clamp(0.5 * inner_radius(stage, body), 2.5, std::max(4.0, 8 * stage.sizes.unit));
}

/// A quarter of a disc, the corner in its middle.
std::array<Vec2d, 9> quarter(Vec2d middle, double radius, double sign) {
  // Unit vectors at 0, 90/7, ... 90 degrees.
  constexpr std::array<Vec2d, 8> rim{Vec2d{1, 0},
                                     {0.97492791, 0.22252093},
                                     {0.90096887, 0.43388374},
                                     {0.78183148, 0.62348980},
                                     {0.62348980, 0.78183148},
                                     {0.43388374, 0.90096887},
                                     {0.22252093, 0.97492791},
                                     {0, 1}};
  std::array<Vec2d, 9> corners{middle};
  for (std::size_t i = 0; i < rim.size(); ++i) corners[i + 1] = middle + sign * radius * Vec2d{rim[i].x, -rim[i].y};
  return corners;
}

/// Three digits that matter, without zeros at the end: 0.0125, 1.25, 125, 2.
std::string kilograms(double mass) {
  const double digits = mass > 0 ? std::floor(std::log10(mass)) : 0;
  std::string text = number_text(mass, static_cast<int>(std::clamp(2 - digits, 0.0, 6.0)));
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text + " kg";
}

void write_on_plate(const Stage& stage, const Aabbd& place, const std::string& text, Color ink) {
  const int size = stage.sizes.small;
  Color plate = stage.palette.background;
  plate.a = 205;
  const Vec2d middle = center(place);
  stage.canvas.rectangle(place.lower, place.upper, 0.3 * size, {plate, plate, 0});
  stage.canvas.text(text, {middle.x, middle.y + 0.5 * cap_height * size}, size, Align::center, ink);
}

Vec2d plate_size(const Stage& stage, const std::string& text) {
  const int size = stage.sizes.small;
  return {stage.canvas.text_width(text, size) + 0.5 * size, 1.2 * size};
}

/// The bodies to write numbers on: those in the picture, unless there are too many.
std::vector<const BodyView*> numbered(const Stage& stage) {
  std::vector<const BodyView*> bodies;
  for (const BodyView& body : stage.frame.snapshot.bodies) {
    if (is_in_picture(stage, body)) bodies.push_back(&body);
  }
  if (bodies.size() > most_numbers) bodies.clear();
  return bodies;
}

}  // namespace

void draw_mass_centers(const Stage& stage) {
  for (const BodyView& body : stage.frame.snapshot.bodies) {
    if (body.state.mass <= 0 || !is_in_picture(stage, body)) continue;
    const Vec2d at = stage.camera.to_px(body.state.center);
    const double radius = mark_radius(stage, body);
    const Color dark = stage.palette.gray ? stage.palette.ink : Color{31, 42, 54, 255};
    const Color bright{255, 255, 255, 255};
    stage.own(OwnerKind::mass, body.id);
    stage.canvas.disc(at, radius, {bright, bright, 0});
    for (const double sign : {1.0, -1.0}) stage.canvas.polygon(quarter(at, radius, sign), 0, {dark, dark, 0});
    stage.canvas.disc(at, radius + 0.5, {{255, 255, 255, 0}, dark, std::max(1.0, 1.25 * stage.sizes.unit)});
  }
}

void draw_masses(const Stage& stage, Cards& cards) {
  const std::vector<const BodyView*> bodies = numbered(stage);
  for (const BodyView* body : bodies) {
    const Vec2d at = stage.camera.to_px(body->state.center);
    if (body->state.mass > 0) cards.take(expanded(Aabbd{at, at}, mark_radius(stage, *body) + 1));
  }
  for (const BodyView* body : bodies) {
    if (body->state.mass <= 0) continue;
    const std::string text = kilograms(body->state.mass);
    const Vec2d at = stage.camera.to_px(body->state.center);
    const Aabbd mark = expanded(Aabbd{at, at}, mark_radius(stage, *body) + 1);
    const auto place = place_beside(cards, other_bodies(stage, body), mark, plate_size(stage, text), true);
    if (!place) continue;
    cards.take(*place);
    stage.own(OwnerKind::mass, body->id);
    write_on_plate(stage, *place, text, stage.palette.ink);
  }
}

void draw_ids(const Stage& stage, Cards& cards) {
  for (const BodyView* body : numbered(stage)) {
    const std::string text = std::to_string(static_cast<std::uint32_t>(body->id));
    const Vec2d size = plate_size(stage, text);
    const Vec2d at = stage.camera.to_px(body->state.center);
    const Aabbd within{at - 0.5 * size, at + 0.5 * size};
    const bool fits = inner_radius(stage, *body) >= 0.3 * size.y && cards.free(within);
    const auto place =
        fits ? std::optional(within) : place_beside(cards, other_bodies(stage, body), box_px(stage, *body), size, true);
    if (!place) continue;
    cards.take(*place);
    stage.own(OwnerKind::id, body->id);
    write_on_plate(stage, *place, text, stage.palette.ink);
  }
}

void draw_island_note(const Stage& stage, Cards& cards) {
  const std::vector<BodyView>& bodies = stage.frame.snapshot.bodies;
  const auto is_dynamic = [](const BodyView& body) { return body.type == BodyType::dynamic && !body.sensor; };
  const bool told = std::any_of(bodies.begin(), bodies.end(), [](const BodyView& body) { return body.island != 0; });
  if (told || std::none_of(bodies.begin(), bodies.end(), is_dynamic)) return;
  const std::string text = "islands: this engine does not tell them";
  const int size = stage.sizes.small;
  stage.own(OwnerKind::note, text);
  const Vec2d room{stage.canvas.text_width(text, size) + 1.4 * size, 2.0 * size};
  const Aabbd card = cards.place(room, Corner::bottom_left);
  stage.canvas.rectangle(card.lower, card.upper, 0.3 * size, {stage.palette.plate, stage.palette.plate_edge, 1});
  stage.canvas.text(text, {card.lower.x + 0.7 * size, std::floor(center(card).y + 0.5 * cap_height * size)}, size,
                    Align::left, stage.palette.ink);
}

}  // namespace proofreel
