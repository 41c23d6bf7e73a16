#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <set>

#include "engine/simulation.h"
#include "render/draw_layers.h"
#include "render/owners.h"
#include "render/theme.h"
#include "tests/render/painted.h"

using namespace proofreel;
using namespace proofreel::painted;

namespace {

constexpr int width = 480, height = 270;
constexpr int side_px = 27;  ///< of a metre: the view is 10 m high

/// What the engine makes of `count` boxes of a metre, 1 kg each, stacked at x = 0 on ground at y = 0, after a second;
/// one more lies apart at x = 4.
Frame stack_of(int count, const std::vector<Layer>& layers) {
  Scene scene;
  const auto add = [&scene](BodyType type, Vec2d at, double half_x, double half_y) {
    BodyDef body;
    body.name = "box";
    body.type = type;
    body.position = at;
    ShapeDef shape;
    shape.points = {{-half_x, -half_y}, {half_x, -half_y}, {half_x, half_y}, {-half_x, half_y}};
    body.shapes.push_back(shape);
    scene.bodies.push_back(body);
  };
  add(BodyType::fixed, {0, -1}, 20, 1);
  for (int i = 0; i < count; ++i) add(BodyType::dynamic, {0, 0.5 + i}, 0.5, 0.5);
  add(BodyType::dynamic, {4, 0.5}, 0.5, 0.5);
  const auto simulation = make_simulation(scene);
  simulation->keep_islands();
  for (int i = 0; i < scene.rate; ++i) simulation->step();
  Frame frame;
  frame.view = {{0, 4}, 10};
  frame.layers = layers;
  frame.force_scale = 0.05;
  simulation->observe(frame.snapshot);
  frame.energy.initial_total = frame.energy.highest = frame.snapshot.energy.total();
  return frame;
}

OwnerPicture owners(const Frame& frame) {
  Canvas canvas(context(), width, height);
  return draw_owners(canvas, frame, {Theme::light});
}

Image drawn(const Frame& frame, Theme theme = Theme::light) {
  Canvas canvas(context(), width, height);
  Image image;
  draw_frame(canvas, frame, {theme}, image);
  return image;
}

/// How high in pixels what belongs to `owner` reaches.
int extent(const OwnerPicture& picture, const Owner& owner) {
  int top = height, bottom = -1;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (!(picture.at(x, y) == owner)) continue;
      top = std::min(top, y);
      bottom = std::max(bottom, y);
    }
  }
  return bottom - top + 1;
}

int pixels(const OwnerPicture& picture, OwnerKind kind) {
  int count = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) count += picture.at(x, y).kind == kind ? 1 : 0;
  return count;
}

Color pixel(const Image& image, int x, int y) {
  const std::uint8_t* p = image.row(y) + 4 * x;
  return {p[0], p[1], p[2], p[3]};
}

/// The colour in the middle of the metre that has its centre at this place of the world.
Color color_at(const Image& image, Vec2d at) {
  return pixel(image, width / 2 + static_cast<int>(at.x * side_px),
               height / 2 - static_cast<int>((at.y - 4) * side_px));
}

BodyId id(int number) { return static_cast<BodyId>(number); }
Owner force(int a, int b) {
  return {OwnerKind::force, static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), {}};
}

}  // namespace

TEST_CASE("The arrows of forces are as long as what lies above their contact weighs") {
  const OwnerPicture picture = owners(stack_of(3, {Layer::forces}));
  // Half of n m g at each of two corners, 0.05 m of the picture per newton. Bodies 2, 3 and 4 are the boxes, upwards.
  for (const auto& [a, b, carried] : {std::tuple{1, 2, 3}, {2, 3, 2}, {3, 4, 1}}) {
    INFO(a << " - " << b);
    const int found = std::max(extent(picture, force(a, b)), extent(picture, force(b, a)));
    CHECK(found == Approx(0.5 * carried * 9.81 * 0.05 * side_px).margin(4));
  }
}

TEST_CASE("A force too long for the picture ends in it, with two heads") {
  Frame frame = stack_of(1, {Layer::forces});
  frame.force_scale = 100;
  const int found = std::max(extent(owners(frame), force(1, 2)), extent(owners(frame), force(2, 1)));
  CHECK(found > 0.3 * height);
  CHECK(found < 0.4 * height);
}

TEST_CASE("Before the first tick nobody knows forces, and none are drawn") {
  Frame frame = stack_of(2, {Layer::forces});
  frame.snapshot.tick = 0;
  frame.snapshot.time = 0;
  CHECK(pixels(owners(frame), OwnerKind::force) == 0);
}

TEST_CASE("The reaction of a joint is drawn where it acts, on what it can move") {
  Frame frame = stack_of(1, {Layer::forces});
  frame.snapshot.contacts.clear();
  JointView& joint = frame.snapshot.joints.emplace_back();
  joint.kind = JointKind::revolute;
  joint.a = id(2);
  joint.b = BodyId::world;
  joint.anchor_a = joint.anchor_b = {0, 4};
  joint.reaction = {0, -40};  // on the world, so 40 N upwards on the box: 2 m
  const OwnerPicture picture = owners(frame);
  const Owner owner{OwnerKind::force, 2, 0, {}};
  CHECK(extent(picture, owner) == Approx(2 * side_px).margin(4));
  CHECK(picture.at(width / 2, height / 2 - side_px) == owner);
}

TEST_CASE("Bodies of one island have one tint, and keep it when islands before them vanish") {
  for (const Theme theme : {Theme::light, Theme::dark, Theme::print}) {
    const Frame frame = stack_of(2, {Layer::islands});
    const Image image = drawn(frame, theme);
    CHECK(color_at(image, {0.2, 0.7}) == color_at(image, {0.2, 1.7}));
    CHECK_FALSE(color_at(image, {0.2, 0.7}) == color_at(image, {4.2, 0.7}));
    Frame later = frame;
    later.snapshot.bodies[1].island = later.snapshot.bodies[2].island = 0;  // the stack: not told any more
    later.snapshot.bodies[3].island = 1;                                    // was 2
    CHECK(color_at(drawn(later, theme), {4.2, 0.7}) == color_at(image, {4.2, 0.7}));
  }
}

TEST_CASE("What sleeps is a paler tint of its island's colour") {
  Frame frame = stack_of(1, {Layer::islands});
  const Color awake = color_at(drawn(frame), {0.2, 0.7});
  frame.snapshot.bodies[1].asleep = true;
  const Color sleeping = color_at(drawn(frame), {0.2, 0.7});
  CHECK(sleeping.r + sleeping.g + sleeping.b > awake.r + awake.g + awake.b + 60);
}

TEST_CASE("Where no engine tells of islands the layer says so") {
  Frame frame = stack_of(1, {Layer::islands});
  CHECK(pixels(owners(frame), OwnerKind::note) == 0);
  for (BodyView& body : frame.snapshot.bodies) body.island = 0;
  const OwnerPicture picture = owners(frame);
  const auto note = std::find_if(picture.owners.begin(), picture.owners.end(),
                                 [](const Owner& owner) { return owner.kind == OwnerKind::note; });
  REQUIRE(note != picture.owners.end());
  CHECK(note->text.find("does not tell") != std::string::npos);
}

TEST_CASE("Every body has its number, and numbers cover neither each other nor other bodies") {
  const Frame frame = stack_of(3, {Layer::bodies, Layer::ids});
  const OwnerPicture picture = owners(frame);
  std::set<std::uint32_t> numbered;
  for (const Owner& owner : picture.owners)
    if (owner.kind == OwnerKind::id) numbered.insert(owner.a);
  CHECK(numbered == std::set<std::uint32_t>{2, 3, 4, 5});  // the ground's centre is below the picture
  for (int number = 2; number <= 4; ++number) {
    const int left = extent(picture, {OwnerKind::id, static_cast<std::uint32_t>(number), 0, {}});
    CHECK(left <= side_px);
  }
}

TEST_CASE("A crowd of bodies has no numbers, which would be dust") {
  Frame frame = stack_of(2, {Layer::bodies, Layer::ids, Layer::mass});
  const BodyView box = frame.snapshot.bodies[1];
  for (int i = 0; i < 400; ++i) frame.snapshot.bodies.push_back(box);
  CHECK(pixels(owners(frame), OwnerKind::id) == 0);
  CHECK(pixels(owners(frame), OwnerKind::mass) > 0);  // the marks of the centres remain
}

TEST_CASE("The mark of a mass lies on its centre, and only what can be moved has one") {
  const OwnerPicture picture = owners(stack_of(1, {Layer::bodies, Layer::mass}));
  CHECK(picture.at(width / 2, height / 2 - static_cast<int>((0.5 - 4) * side_px)) == Owner{OwnerKind::mass, 2, 0, {}});
  const auto of_ground = [](const Owner& owner) { return owner.kind == OwnerKind::mass && owner.a == 1; };
  CHECK(std::none_of(picture.owners.begin(), picture.owners.end(), of_ground));
}

TEST_CASE("The bars of energy are as long as the energies, against what was reached so far") {
  Frame frame = stack_of(1, {Layer::energy});
  frame.energy = {100, 0, 100};
  const auto bar_pixels = [&frame](double kinetic, double potential, std::size_t curve) {
    frame.snapshot.energy = {kinetic, potential, 0};
    const Image image = drawn(frame);
    const Color wanted = palette_of(Theme::light).curves[curve];
    int count = 0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) count += pixel(image, x, y) == wanted ? 1 : 0;
    return count;
  };
  const int full = bar_pixels(100, 0, 0);
  CHECK(full > 100);
  CHECK(bar_pixels(50, 50, 0) == Approx(0.5 * full).margin(0.03 * full));
  CHECK(bar_pixels(25, 75, 1) == Approx(0.75 * full).margin(0.03 * full));
  CHECK(bar_pixels(0, 100, 0) == 0);
}

TEST_CASE("A highlighted body has a halo as wide as it is strong, and one of a point is a circle") {
  Frame frame = stack_of(1, {Layer::bodies});
  const auto halo = [&frame](double strength) {
    frame.highlights = {{id(2), {}, 0, strength, ""}};
    return pixels(owners(frame), OwnerKind::highlight);
  };
  CHECK(halo(0.5) > 4 * side_px);
  CHECK(halo(1) > 1.5 * halo(0.5));
  CHECK(owners(frame).at(width / 2 + 4, height / 2 + 3 * side_px).kind == OwnerKind::body);
  frame.highlights = {{BodyId::world, Vec2d{-3, 6}, 0.5, 1, ""}};
  CHECK(owners(frame).at(width / 2 - 3 * side_px, height / 2 - 2 * side_px).kind == OwnerKind::highlight);
}

TEST_CASE("A phase portrait shows where it is now by a dot, and its past fading") {
  Frame frame;
  PlotView plot{"portrait", {"v"}, 4, Corner::top_right, {}, {{}}, "m/s", "x", "m"};
  for (int i = 0; i <= 100; ++i) {
    plot.times.push_back(0.01 * i);
    plot.xs.push_back(0.01 * i);
    plot.values[0].push_back(0.5);
    plot.x_reach.add(0.01 * i);
    plot.y_reach.add(i % 2);
  }
  frame.plots = {plot};
  const Image image = drawn(frame);
  const Color curve = palette_of(Theme::light).curves[0];
  std::array<int, width> heights{};  // of what has the curve's colour, unmixed
  int last = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (!(pixel(image, x, y) == curve)) continue;
      ++heights[static_cast<std::size_t>(x)];
      last = std::max(last, x);
    }
  }
  REQUIRE(last > 40);
  const auto highest_near = [&heights](int x) {
    return *std::max_element(heights.begin() + x - 4, heights.begin() + x + 1);
  };
  CHECK(highest_near(last) >= 2);       // the dot, where x is greatest
  CHECK(highest_near(last - 40) == 0);  // the past: paler
}
