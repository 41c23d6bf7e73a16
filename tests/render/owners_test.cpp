#include "render/owners.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstring>

#include "render/theme.h"
#include "tests/render/painted.h"
#include "tests/render/sample_frame.h"

using namespace proofreel;
using namespace proofreel::painted;

namespace {

constexpr int width = 480, height = 270;

Image drawn(const Frame& frame) {
  Canvas canvas(context(), width, height);
  Image image;
  draw_frame(canvas, frame, {Theme::light}, image);
  return image;
}

OwnerPicture owners(const Frame& frame) {
  Canvas canvas(context(), width, height);
  return draw_owners(canvas, frame, {Theme::light});
}

std::vector<Layer> without(Layer layer) {
  std::vector<Layer> layers = all_layers();
  layers.erase(std::find(layers.begin(), layers.end(), layer));
  return layers;
}

bool same_pixel(const Image& a, const Image& b, int x, int y) {
  return std::memcmp(a.row(y) + 4 * x, b.row(y) + 4 * x, 4) == 0;
}

}  // namespace

TEST_CASE("A picture of owners names something of every kind that is drawn") {
  const OwnerPicture picture = owners(sample_frame());
  REQUIRE(picture.indices.size() == std::size_t{width} * height);
  CHECK(picture.owners.front() == Owner{});
  for (const OwnerKind kind :
       {OwnerKind::grid, OwnerKind::body, OwnerKind::trail, OwnerKind::bvh, OwnerKind::joint, OwnerKind::contact,
        OwnerKind::vector, OwnerKind::clock, OwnerKind::caption, OwnerKind::plot, OwnerKind::label, OwnerKind::force,
        OwnerKind::mass, OwnerKind::id, OwnerKind::energy, OwnerKind::highlight, OwnerKind::note}) {
    INFO(name_of(kind));
    const auto is_it = [kind](const Owner& owner) { return owner.kind == kind; };
    CHECK(std::any_of(picture.owners.begin(), picture.owners.end(), is_it));
  }
}

TEST_CASE("Where a layer leaves its mark in the picture, it or what lies on top of it is the owner") {
  const Image with = drawn(sample_frame());
  const Image less = drawn(with_layers(sample_frame(), without(Layer::contacts)));
  const OwnerPicture picture = owners(sample_frame());
  int marked = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (same_pixel(with, less, x, y)) continue;
      ++marked;
      const OwnerKind kind = picture.at(x, y).kind;
      // Text finds its place around contacts as well as around bodies, so labels and numbers may stand elsewhere.
      const bool fits = kind == OwnerKind::contact || kind == OwnerKind::vector || kind == OwnerKind::label ||
                        kind == OwnerKind::caption || kind == OwnerKind::plot || kind == OwnerKind::grid ||
                        kind == OwnerKind::force || kind == OwnerKind::mass || kind == OwnerKind::id ||
                        kind == OwnerKind::highlight || kind == OwnerKind::energy || kind == OwnerKind::note;
      CHECK(fits);
    }
  }
  CHECK(marked > 20);
}

TEST_CASE("A pixel of the background is nobody's, and one that is nobody's is background") {
  Frame frame = with_layers(sample_frame(), {Layer::bodies});
  frame.captions.clear();
  frame.plots.clear();
  frame.snapshot.water_level.reset();
  const Image image = drawn(frame);
  const OwnerPicture picture = owners(frame);
  const Color background = palette_of(Theme::light).background;
  int faint = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::uint8_t* p = image.row(y) + 4 * x;
      const bool plain = Color{p[0], p[1], p[2], p[3]} == background,
                 owned = picture.at(x, y).kind != OwnerKind::nothing;
      if (!owned) CHECK(plain);
      if (owned && plain) ++faint;  // covered by less than 1/255
    }
  }
  CHECK(faint < 50);
}

TEST_CASE("Asking for owners changes no picture that is drawn before or after on the same canvas") {
  Canvas canvas(context(), width, height);
  Image before, after;
  draw_frame(canvas, sample_frame(), {Theme::light}, before);
  const OwnerPicture first = draw_owners(canvas, sample_frame(), {Theme::light});
  draw_frame(canvas, sample_frame(), {Theme::light}, after);
  CHECK(before.rgba == after.rgba);
  const OwnerPicture second = draw_owners(canvas, sample_frame(), {Theme::light});
  CHECK(first.indices == second.indices);
  CHECK(first.owners == second.owners);
}

TEST_CASE("A canvas paints owners by their number, the topmost one, without smoothing") {
  Canvas canvas(context(), 40, 40);
  Image image;
  canvas.clear_for_owners();
  canvas.own(0x010203);
  canvas.disc({20, 20}, 12.3, {white, white, 0});
  canvas.own(0xfffefd);
  canvas.disc({20, 20}, 5.4, {{0, 0, 0, 3}, {0, 0, 0, 3}, 0});
  canvas.own(9);
  canvas.disc({20, 20}, 3, {nothing, nothing, 0});  // paints nothing, so it owns nothing
  canvas.finish(image);
  const auto number = [&image](int x, int y) {
    const std::uint8_t* p = image.row(y) + 4 * x;
    return p[0] | p[1] << 8 | p[2] << 16;
  };
  CHECK(number(20, 20) == 0xfffefd);
  CHECK(number(28, 20) == 0x010203);
  CHECK(number(2, 2) == 0);
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 40; ++x) {
      const int n = number(x, y);
      CHECK((n == 0 || n == 0x010203 || n == 0xfffefd));
    }
  }
}

TEST_CASE("A picture of owners comes back from the image it is kept as") {
  const OwnerPicture picture = owners(sample_frame());
  const auto back = owner_picture_from(image_of(picture), picture.owners);
  REQUIRE(back.has_value());
  CHECK(back->indices == picture.indices);
  CHECK_FALSE(owner_picture_from(image_of(picture), {Owner{}}).has_value());
}

TEST_CASE("Kinds of owners are found again by their names") {
  for (const char* name : owner_kind_names) CHECK(name_of(*owner_kind_named(name)) == std::string(name));
  CHECK_FALSE(owner_kind_named("ghost").has_value());
}
