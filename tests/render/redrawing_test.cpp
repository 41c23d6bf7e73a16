// A canvas draws only what has changed since its last picture; nobody may see that it does.

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <random>
#include <string>
#include <vector>

#include "render/gl.h"
#include "tests/render/painted.h"

using namespace proofreel;
using namespace proofreel::painted;

namespace {

/// What was asked of OpenGL.
struct Calls {
  int draws = 0;
  int clears = 0;
  std::int64_t cleared_px = 0;
  std::int64_t read_px = 0;
};

/// The shared context, through which calls are counted and can be made to fail.
class WatchedContext final : public GlContext {
 public:
  static inline Calls calls;
  static inline bool out_of_memory = false;  ///< GL is, and says so
  bool lost = false;                         ///< cannot be made current any more

  void make_current() override {
    if (lost) throw EnvironmentError("lost");
    context().make_current();
  }
  void release() override { context().release(); }
  GlBackend backend() const override { return context().backend(); }
  void* proc(const char* name) const override {
    const std::string asked = name;
    if (asked == "glDrawArraysInstanced") return watched(name, draw, draw_behind);
    if (asked == "glScissor") return watched(name, scissor, scissor_behind);
    if (asked == "glClear") return watched(name, clear, clear_behind);
    if (asked == "glReadPixels") return watched(name, read, read_behind);
    if (asked == "glTexImage2D") return watched(name, fill_texture, fill_texture_behind);
    if (asked == "glGetError") return watched(name, error, error_behind);
    return context().proc(name);
  }

 private:
  template <typename Function>
  static void* watched(const char* name, Function ours, Function& behind) {
    behind = reinterpret_cast<Function>(context().proc(name));
    return reinterpret_cast<void*>(ours);
  }
  static void APIENTRY draw(GLenum mode, GLint first, GLsizei count, GLsizei instances) {
    ++calls.draws;
    draw_behind(mode, first, count, instances);
  }
  static void APIENTRY scissor(GLint x, GLint y, GLsizei width, GLsizei height) {
    scissored_px = std::int64_t{width} * height;
    scissor_behind(x, y, width, height);
  }
  static void APIENTRY clear(GLbitfield mask) {
    ++calls.clears;
    calls.cleared_px += scissored_px;
    clear_behind(mask);
  }
  static void APIENTRY read(GLint x, GLint y, GLsizei width, GLsizei height, GLenum format, GLenum type, void* to) {
    calls.read_px += std::int64_t{width} * height;
    read_behind(x, y, width, height, format, type, to);
  }
  static void APIENTRY fill_texture(GLenum target, GLint level, GLint kept_as, GLsizei width, GLsizei height,
                                    GLint border, GLenum format, GLenum type, const void* from) {
    if (!out_of_memory) fill_texture_behind(target, level, kept_as, width, height, border, format, type, from);
  }
  static GLenum APIENTRY error() {
    const GLenum found = error_behind();
    return out_of_memory ? GLenum{GL_OUT_OF_MEMORY} : found;
  }

  static inline std::int64_t scissored_px = 0;
  static inline PFNGLDRAWARRAYSINSTANCEDPROC draw_behind = nullptr;
  static inline PFNGLSCISSORPROC scissor_behind = nullptr;
  static inline PFNGLCLEARPROC clear_behind = nullptr;
  static inline PFNGLREADPIXELSPROC read_behind = nullptr;
  static inline PFNGLTEXIMAGE2DPROC fill_texture_behind = nullptr;
  static inline PFNGLGETERRORPROC error_behind = nullptr;
};

constexpr int scene_width = 320, scene_height = 200;

class Dice {
 public:
  explicit Dice(unsigned seed) : random_(seed) {}
  int below(int bound) { return static_cast<int>(random_() % static_cast<unsigned>(bound)); }
  double between(double low, double high) { return low + (high - low) * below(100000) / 100000; }
  Color color() { return {byte(), byte(), byte(), below(3) == 0 ? byte() : std::uint8_t{255}}; }

 private:
  std::uint8_t byte() { return static_cast<std::uint8_t>(below(256)); }
  std::mt19937 random_;
};

/// One mark of any kind, which may reach out of the picture.
struct Mark {
  int kind = 0;
  Vec2d at;
  Vec2d to;
  double size = 0;
  Color fill;
  Color outline;
  std::string text;
};

Mark some_mark(Dice& dice) {
  const Vec2d at{dice.between(-20, scene_width + 20), dice.between(-20, scene_height + 20)};
  const Vec2d to = at + Vec2d{dice.between(-90, 90), dice.between(-90, 90)};
  const auto letter = static_cast<char>('A' + dice.below(58));
  return {dice.below(8), at, to, dice.between(0.3, 24), dice.color(), dice.color(), std::string(3, letter)};
}

void draw(Canvas& canvas, const Mark& mark) {
  const Paint paint{mark.fill, mark.outline, mark.size > 12 ? 2.5 : 0.0};
  const Vec2d side = 0.4 * mark.size * perp(normalized(mark.to - mark.at));
  const std::array<Vec2d, 5> corners{mark.at + side, mark.at - side, mark.to - side,
                                     mark.to + 0.3 * (mark.to - mark.at), mark.to + side};
  switch (mark.kind) {
    case 0:
      return canvas.disc(mark.at, mark.size, paint);
    case 1:
      return canvas.polygon(corners, 0, paint);
    case 2:
      return canvas.polygon(corners, 3, paint);
    case 3:
      return canvas.capsule(mark.at, mark.to, 0.3 * mark.size, paint);
    case 4:
      return canvas.stroke(std::array<Vec2d, 3>{mark.at, mark.to, mark.to + 2 * side}, mark.size, mark.fill,
                           mark.outline);
    case 5:
      return canvas.arrow(mark.at, mark.to, 3, mark.fill);
    case 6:
      return canvas.rectangle(mark.at, mark.at + Vec2d{40, 25}, 4, {nothing, mark.outline, 2});
    default:
      return canvas.text(mark.text, mark.at, 8 + static_cast<int>(mark.size), Align::center, mark.fill);
  }
}

/// What a picture is to show; the next has a little of it changed.
struct Scene {
  std::vector<Mark> marks;
  Color ground = white;
  bool owners = false;
  bool split = false;  ///< the second half of the marks lies within a part of the picture
  Image behind;        ///< in place of the ground, unless it is empty
};

void paint(Canvas& canvas, const Scene& scene) {
  if (scene.owners) {
    canvas.clear_for_owners();
  } else if (!scene.behind.rgba.empty()) {
    canvas.clear(scene.behind);
  } else {
    canvas.clear(scene.ground);
  }
  for (std::size_t i = 0; i < scene.marks.size(); ++i) {
    if (scene.split && 2 * i == scene.marks.size()) canvas.enter({61, 33, 150, 90});
    canvas.own(static_cast<std::uint32_t>(i + 1));
    draw(canvas, scene.marks[i]);
  }
}

Image drawn_alone(const Scene& scene) {
  Canvas canvas(context(), scene_width, scene_height);
  Image image;
  paint(canvas, scene);
  canvas.finish(image);
  return image;
}

void change(Scene& scene, Dice& dice) {
  std::vector<Mark>& marks = scene.marks;
  const auto any = [&dice, &marks]() -> Mark& {
    return marks[static_cast<std::size_t>(dice.below(int(marks.size())))];
  };
  for (int moves = dice.below(4); moves > 0 && !marks.empty(); --moves) any().at += Vec2d{dice.between(-9, 9), 1};
  if (dice.below(4) == 0) marks.push_back(some_mark(dice));
  if (dice.below(6) == 0 && !marks.empty()) marks.erase(marks.begin() + dice.below(int(marks.size())));
  if (dice.below(5) == 0 && !marks.empty()) any().fill = dice.color();
  if (dice.below(5) == 0 && !marks.empty()) std::swap(any(), any());
  if (dice.below(20) == 0) scene.ground = dice.color();
  if (dice.below(12) == 0) scene.owners = !scene.owners;
  if (dice.below(15) == 0) scene.split = !scene.split;
  scene.behind = dice.below(12) == 0 ? drawn_alone({{some_mark(dice)}, dice.color(), false, false, {}}) : Image{};
}

/// Now and then an image in which to draw is not what it was.
void disturb(Image& image, Dice& dice) {
  if (dice.below(10) == 0)
    image = Image(dice.below(2) == 0 ? scene_width : scene_height, dice.below(2) == 0 ? scene_height : scene_width);
  if (dice.below(10) == 0 && !image.rgba.empty()) std::fill_n(image.row(0), 400, std::uint8_t{77});
}

bool same(const Image& a, const Image& b) {
  return a.width_px == b.width_px && a.height_px == b.height_px && a.rgba == b.rgba;
}

/// A disc on a ground with a text; `x` is where the disc is.
void paint_disc(Canvas& canvas, double x, const std::string& text = "still") {
  canvas.clear(white);
  canvas.rectangle({0, 400}, {640, 480}, 0, solid);
  canvas.disc({x, 240}, 20, solid);
  canvas.text(text, {320, 80}, 24, Align::center, black);
}

/// That picture with the disc at 100, whole; its fingerprint comes back.
std::uint64_t begin_with_disc(Canvas& canvas, Image& image) {
  paint_disc(canvas, 100);
  canvas.finish(image);
  return fingerprint(image);
}

Calls calls_of(Canvas& canvas, Image& image) {
  WatchedContext::calls = {};
  canvas.finish(image);
  return WatchedContext::calls;
}

constexpr std::int64_t whole_px = 640 * 480;

}  // namespace

TEST_CASE("Pictures drawn one upon another have the bytes that each has when it is drawn alone") {
  const unsigned seed = GENERATE(range(1U, 9U));
  Dice dice(seed);
  Scene scene;
  for (int i = 0; i < 12; ++i) scene.marks.push_back(some_mark(dice));
  Canvas canvas(context(), scene_width, scene_height);
  std::array<Image, 3> images;
  for (int round = 0; round < 40; ++round) {
    change(scene, dice);
    Image& image = images[static_cast<std::size_t>(dice.below(3))];
    disturb(image, dice);
    paint(canvas, scene);
    canvas.finish(image);
    CAPTURE(seed, round);
    REQUIRE(fingerprint(image) == fingerprint(drawn_alone(scene)));
    REQUIRE((image.width_px == scene_width && image.height_px == scene_height));
  }
}

TEST_CASE("Two canvases on one context that draw in turns into the same image do not mix their pictures up") {
  Dice dice(77);
  std::array<Scene, 2> scenes;
  for (Scene& scene : scenes) {
    for (int i = 0; i < 10; ++i) scene.marks.push_back(some_mark(dice));
  }
  Canvas first(context(), scene_width, scene_height), second(context(), scene_width, scene_height);
  Image image;
  for (int round = 0; round < 40; ++round) {
    const auto which = static_cast<std::size_t>(dice.below(2));
    change(scenes[which], dice);
    Canvas& canvas = which == 0 ? first : second;
    paint(canvas, scenes[which]);
    canvas.finish(image);
    CAPTURE(round);
    REQUIRE(fingerprint(image) == fingerprint(drawn_alone(scenes[which])));
  }
}

TEST_CASE("Upon a given picture all is drawn, and what follows is drawn as if there had been none") {
  Dice dice(4);
  const std::vector<Mark> marks{some_mark(dice), some_mark(dice)};
  const Scene on_black{marks, black, false, false, {}};
  const Scene on_gray{marks, black, false, false, drawn_alone({{}, {90, 90, 90, 255}, false, false, {}})};
  const Scene on_picture{marks, black, false, false, drawn_alone({{some_mark(dice)}, white, false, false, {}})};
  Canvas canvas(context(), scene_width, scene_height);
  Image image;
  for (const Scene* scene : {&on_black, &on_gray, &on_picture, &on_black, &on_black, &on_picture, &on_gray}) {
    paint(canvas, *scene);
    canvas.finish(image);
    CHECK(fingerprint(image) == fingerprint(drawn_alone(*scene)));
  }
}

TEST_CASE("The first picture is cleared and read whole") {
  WatchedContext watched;
  Canvas canvas(watched, 640, 480);
  Image image;
  paint_disc(canvas, 100);
  const Calls calls = calls_of(canvas, image);
  CHECK(calls.clears == 1);
  CHECK(calls.cleared_px == whole_px);
  CHECK(calls.read_px == whole_px);
  CHECK(calls.draws == 2);  // boxes, glyphs
}

TEST_CASE("When nothing has changed nothing is drawn, and nothing read by whom has the picture") {
  WatchedContext watched;
  Canvas canvas(watched, 640, 480);
  Image image, other;
  begin_with_disc(canvas, image);
  paint_disc(canvas, 100);
  const Calls again = calls_of(canvas, image);
  CHECK((again.clears == 0 && again.draws == 0 && again.read_px == 0));
  paint_disc(canvas, 100);
  const Calls elsewhere = calls_of(canvas, other);
  CHECK((elsewhere.clears == 0 && elsewhere.draws == 0 && elsewhere.read_px == whole_px));
  CHECK(same(image, other));
}

TEST_CASE("When a disc moves, what is cleared and read is the tiles it has left and those it has reached") {
  WatchedContext watched;
  Canvas canvas(watched, 640, 480);
  Image image;
  const std::uint64_t before = begin_with_disc(canvas, image);
  paint_disc(canvas, 104);
  const Calls calls = calls_of(canvas, image);
  constexpr std::int64_t most_px = (4 + 42 + 32) * (42 + 32);  // the disc's way, its soft edge, and tiles at both ends
  CHECK(calls.clears == 1);
  CHECK(calls.draws == 1);
  CHECK((calls.cleared_px > 46 * 42 && calls.cleared_px <= most_px));
  CHECK(calls.read_px == calls.cleared_px);
  CHECK(fingerprint(image) != before);
}

TEST_CASE("A long thin mark that turns changes the tiles along it, not all within its bounds") {
  WatchedContext watched;
  Canvas canvas(watched, 640, 480);
  Image image;
  std::int64_t read_px = 0;
  for (const double end : {400.0, 403.0}) {
    canvas.clear(white);
    canvas.line({40, 40}, {600, end}, 3, black);
    read_px = calls_of(canvas, image).read_px;
  }
  CHECK(read_px > 600 * 3);
  CHECK(read_px < 560 * 363 / 2);
}

TEST_CASE("When the ground has another colour all is drawn, though no mark has changed") {
  WatchedContext watched;
  Canvas canvas(watched, 640, 480);
  Image image;
  for (const Color ground : {white, Color{250, 255, 255, 255}, Color{250, 255, 255, 254}}) {
    canvas.clear(ground);
    canvas.disc({30, 30}, 9, solid);
    CHECK(calls_of(canvas, image).cleared_px == whole_px);
  }
  canvas.clear_for_owners();
  canvas.disc({30, 30}, 9, solid);
  CHECK(calls_of(canvas, image).cleared_px == whole_px);
}

TEST_CASE("After a picture that failed, whatever failed, the next one is drawn whole and right, new letters included") {
  const bool loses_context = GENERATE(true, false);
  WatchedContext watched;
  Canvas canvas(watched, 640, 480);
  Image image, expected;
  begin_with_disc(canvas, image);
  paint_disc(canvas, 300, "other");
  watched.lost = loses_context;
  WatchedContext::out_of_memory = !loses_context;
  CHECK_THROWS_AS(canvas.finish(image), EnvironmentError);
  watched.lost = false;
  WatchedContext::out_of_memory = false;
  paint_disc(canvas, 300, "other");
  const Calls calls = calls_of(canvas, image);
  if (!loses_context) CHECK((calls.cleared_px == whole_px && calls.read_px == whole_px));
  Canvas fresh(context(), 640, 480);
  paint_disc(fresh, 300, "other");
  fresh.finish(expected);
  CHECK(same(image, expected));
}

TEST_CASE("An image that was written to in between is read whole") {
  WatchedContext watched;
  Canvas canvas(watched, 640, 480);
  Image image;
  const std::uint64_t before = begin_with_disc(canvas, image);
  image.rgba[5] = 3;
  paint_disc(canvas, 100);
  CHECK(calls_of(canvas, image).read_px == whole_px);
  CHECK(fingerprint(image) == before);
}
