/// What check says of scenarios that are broken on purpose: the right verdict, the right body, the right tick.

#include "tests/golden/defects.h"

#include <catch2/catch.hpp>

#include "render/pixel_hash.h"
#include "scenarios/runner.h"

namespace proofreel {
namespace {

using namespace defects;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
using Verdicts = std::vector<Verdict>;

constexpr Verdict exact = Verdict::exact, physics = Verdict::physics, drawing = Verdict::drawing;

/// Pictures that are drawn well and then spoilt.
PictureTools spoilt(const Blessed& blessed, const std::function<void(Image&)>& spoil) {
  PictureTools tools = pictures().tools(blessed.store());
  tools.make = [make = tools.make, spoil](const Scenario& scenario, const Frame& frame) {
    DrawnPicture picture = make(scenario, frame);
    spoil(picture.image);
    picture.hash = pixel_hash(picture.image);
    return picture;
  };
  return tools;
}

void move_right(Image& image) {
  for (int y = 0; y < image.height_px; ++y) {
    std::copy_backward(image.row(y), image.row(y) + image.row_bytes() - 4, image.row(y) + image.row_bytes());
  }
}

void darken(Image& image) {
  for (std::size_t i = 0; i < image.rgba.size(); ++i) {
    if (i % 4 != 3) image.rgba[i] = static_cast<std::uint8_t>(std::max(0, image.rgba[i] - 8));
  }
}

const Cause* cause_named(const Finding& finding, const std::string& name) {
  for (const Cause& cause : finding.causes) {
    if (cause.name == name) return &cause;
  }
  return nullptr;
}

/// The tick of a scenario after which two bodies first touch.
std::int64_t first_touch(const Blessed& blessed) {
  const std::unique_ptr<Scenario> scenario = load_scenario(blessed.file(), {});
  Runner runner(*scenario);
  while (runner.simulation().contact_events().empty()) runner.step();
  return runner.tick();
}

TEST_CASE("Scenes that nobody touched pass, with nothing to explain", "[defects]") {
  for (const std::string& scene : all_scenes()) {
    const Blessed blessed(scene);
    CHECK(verdicts(blessed.check()) == Verdicts(4, exact));
    CHECK(verdicts(blessed.check(PictureTools{})) == Verdicts(4, exact));
  }
}

TEST_CASE("A picture moved by one pixel is drawing, and said to be moved", "[defects]") {
  for (const std::string& scene : all_scenes()) {
    const Blessed blessed(scene);
    const CheckResult result = blessed.check(spoilt(blessed, move_right));
    REQUIRE(verdicts(result) == Verdicts{drawing, drawing, drawing, exact});
    CHECK_THAT(result.findings[1].message, Contains("It is the reference moved 1 px right."));
    CHECK_FALSE(result.findings[1].since_tick);
  }
}

TEST_CASE("A tint of -8 is drawing, and said to be one", "[defects]") {
  for (const std::string& scene : all_scenes()) {
    const Blessed blessed(scene);
    const CheckResult result = blessed.check(spoilt(blessed, darken));
    REQUIRE(verdicts(result) == Verdicts{drawing, drawing, drawing, exact});
    CHECK_THAT(result.findings[1].message, Contains("tinted: red -8, green -8, blue -8 of 255"));
  }
}

TEST_CASE("A colour that is 1 off is drawing, and found in its body", "[defects]") {
  const Blessed blessed(pile());
  const CheckResult result = blessed.check(replaced(pile(), "0x4080c0", "0x4081c0"));
  REQUIRE(verdicts(result) == Verdicts{drawing, drawing, drawing, exact});
  for (std::size_t i = 0; i < 3; ++i) {
    REQUIRE(result.findings[i].causes.front().name == "top");
    CHECK(result.findings[i].causes.front().pixels > 100);
    CHECK_THAT(result.findings[i].message, Contains("by up to 1 of 255") && Contains("none visibly"));
  }
  CHECK_THAT(result.findings[0].message, Contains("All of them differ by the same: red 0, green +1, blue 0 of 255."));
}

TEST_CASE("A body that was removed is physics from the start, and explains the hole it leaves", "[defects]") {
  const Blessed blessed(pile());
  const std::string lua = pile();
  const CheckResult result = blessed.check(lua.substr(0, lua.find("body { name = 'top'")));
  REQUIRE(verdicts(result) == Verdicts(4, physics));
  for (const Finding& finding : result.findings) {
    CHECK(finding.since_tick == 0);
    CHECK_THAT(finding.message, StartsWith("since tick 0 (first top)."));
  }
  CHECK_THAT(result.findings[1].message, Contains("top is gone") && Contains("contact middle - top gone"));
  const Cause* top = cause_named(result.findings[1], "top");
  REQUIRE(top != nullptr);
  CHECK(top->change == "gone");
  CHECK(top->explains);
  CHECK_THAT(result.findings[1].message, Contains("Explains all of") || Contains("Explains 9"));
}

TEST_CASE("A mass that is 1 % off shows at the tick of the first collision, in the two that meet", "[defects]") {
  const Blessed blessed(billiard());
  const std::int64_t touch = first_touch(blessed);
  REQUIRE(touch > 60);  // after golden frame 15
  const CheckResult result = blessed.check(replaced(billiard(), "{0.5, 0}, mass = 1", "{0.5, 0}, mass = 1.01"));
  REQUIRE(verdicts(result) == Verdicts{exact, exact, physics, physics});
  for (const std::size_t i : {2U, 3U}) {
    CHECK(result.findings[i].since_tick == touch);
    CHECK_THAT(result.findings[i].message, Contains("(first cue and target)"));
  }
  CHECK(cause_named(result.findings[2], "bystander") == nullptr);
}

TEST_CASE("Friction of one body that changed shows from the first tick, in that body", "[defects]") {
  const Blessed blessed(slide());
  const CheckResult result = blessed.check(replaced(slide(), "friction = 0.4", "friction = 0.38"));
  REQUIRE(verdicts(result) == Verdicts{exact, physics, physics, physics});
  for (const std::size_t i : {1U, 2U}) {
    const Finding& finding = result.findings[i];
    CHECK(finding.since_tick == 1);
    CHECK_THAT(finding.message, StartsWith("since tick 1 (first left). left moved") && Contains("Explains all of"));
    REQUIRE_FALSE(finding.causes.empty());
    CHECK(finding.causes.front().name == "left");
  }
}

TEST_CASE("A push in the middle of the run is found at its tick", "[defects]") {
  const Blessed blessed(bridge());
  std::string pushed = replaced(bridge(), "body { name = 'load'", "local load = body { name = 'load'");
  pushed += "at(0.3, function() load:impulse({0.001, 0}) end)\n";
  const CheckResult later = blessed.check(pushed);
  REQUIRE(verdicts(later) == Verdicts{exact, exact, physics, physics});
  CHECK(later.findings[2].since_tick == 73);  // 0.3 s are tick 72; the step from there on differs
}

TEST_CASE("Two golden frames that changed places are physics, and known again", "[defects]") {
  const Blessed blessed(pendulum());
  Golden golden = blessed.golden();
  std::swap(golden.frames[1], golden.frames[2]);
  std::swap(golden.frames[1].frame, golden.frames[2].frame);
  blessed.keep(golden);
  const CheckResult result = blessed.check();
  REQUIRE(verdicts(result) == Verdicts{exact, physics, physics, exact});
  CHECK_THAT(result.findings[1].message, Contains("its state is that of golden frame 29"));
  CHECK_THAT(result.findings[2].message, Contains("its state is that of golden frame 15"));
}

TEST_CASE("Two pictures that changed places are drawing, and known again", "[defects]") {
  const Blessed blessed(billiard());
  Golden golden = blessed.golden();
  std::swap(golden.frames[1].pixel_hash, golden.frames[2].pixel_hash);
  std::swap(golden.frames[1].file, golden.frames[2].file);
  std::swap(golden.frames[1].file_hash, golden.frames[2].file_hash);
  std::swap(golden.frames[1].owners, golden.frames[2].owners);
  blessed.keep(golden);
  const CheckResult result = blessed.check();
  REQUIRE(verdicts(result) == Verdicts{exact, drawing, drawing, exact});
  CHECK_THAT(result.findings[1].message, Contains("It is the picture of golden frame 29."));
}

TEST_CASE("A layer that is missing is drawing, and named as a whole", "[defects]") {
  const Blessed blessed(pile());
  const CheckResult result = blessed.check(replaced(pile(), "'bodies', 'contacts'", "'bodies'"));
  REQUIRE(verdicts(result) == Verdicts{exact, drawing, drawing, exact});  // nothing touches before the first tick
  const Finding& finding = result.findings[1];
  CHECK_THAT(finding.message, Contains("all contact marks (not drawn any more: "));
  REQUIRE(finding.causes.size() == 1);
  CHECK(finding.causes[0].pixels == finding.comparison.different);
}

TEST_CASE("A text that changed is drawing, and quoted", "[defects]") {
  const Blessed blessed(pendulum());
  const CheckResult caption = blessed.check(replaced(pendulum(), "It swings", "It swims"));
  REQUIRE(verdicts(caption) == Verdicts{drawing, drawing, drawing, exact});
  CHECK_THAT(caption.findings[1].message, Contains("caption \"It swims\"") || Contains("caption \"It swings\""));
  const CheckResult label = blessed.check(replaced(pendulum(), "text = 'v'", "text = 'w'"));
  REQUIRE(verdicts(label) == Verdicts{drawing, drawing, drawing, exact});
  CHECK_THAT(label.findings[1].message, Contains("label \"w\" (drawn only now: "));
}

TEST_CASE("A picture that is cut is missing, whatever else is well", "[defects]") {
  const Blessed blessed(slide());
  const std::filesystem::path file = blessed.store().folder("scene") / "frame_00015.png";
  const std::string bytes = read_text(file);
  write_text(file, bytes.substr(0, bytes.size() - 20));
  const CheckResult result = blessed.check();
  REQUIRE(verdicts(result) == Verdicts{exact, Verdict::missing, exact, exact});
  CHECK_THAT(result.findings[1].message, Contains("frame_00015.png is damaged"));
}

TEST_CASE("A state that is another every time is nondeterministic, not physics", "[defects]") {
  const Blessed blessed(slide());
  PictureTools tools = pictures().tools(blessed.store());
  int run = 0;
  tools.make = [&, make = tools.make](const Scenario& scenario, const Frame& frame) {
    if (frame.index == 0)
      blessed.write(replaced(slide(), "velocity = {3, 0}", "velocity = {3.0" + std::to_string(++run) + ", 0}"));
    return make(scenario, frame);
  };
  blessed.write(replaced(slide(), "velocity = {3, 0}", "velocity = {2.9, 0}"));
  const CheckResult unsteady = blessed.check(tools);
  CHECK(verdicts(unsteady) == Verdicts(4, Verdict::nondeterministic));
  CHECK_THAT(unsteady.findings[1].message, Contains("two runs just now differ in their state"));
}

TEST_CASE("Pixels that are others every time are nondeterministic, not drawing", "[defects]") {
  const Blessed blessed(slide());
  int picture = 0;
  const auto spoil = [&picture](Image& image) { image.rgba[0] = static_cast<std::uint8_t>(++picture); };
  const CheckResult result = blessed.check(spoilt(blessed, spoil));
  CHECK(verdicts(result) == Verdicts(3, Verdict::nondeterministic));
  CHECK_THAT(result.findings[1].message, Contains("two runs just now differ in their pixels"));
}

TEST_CASE("Another drawing and another motion are both, and the message says where each shows", "[defects]") {
  const Blessed blessed(slide());
  const std::string lua = replaced(slide(), "friction = 0.4", "friction = 0.38");
  const CheckResult result = blessed.check(replaced(lua, "height = 4 }", "height = 4 }, theme = 'dark'"));
  REQUIRE(verdicts(result) == Verdicts{drawing, Verdict::both, Verdict::both, physics});
  CHECK_THAT(result.findings[1].message,
             StartsWith("since tick 1 (first left)") && Contains("The drawing changed as well: frame 0 shows it"));
}

TEST_CASE("Without the files that only explain, verdicts stay and the golden frame before says since when",
          "[defects]") {
  const Blessed blessed(slide());
  const auto folder = blessed.store().folder("scene");
  std::filesystem::remove(blessed.store().ticks_path("scene"));
  write_text(folder / "frame_00015.owners.png", "no picture");
  const CheckResult result = blessed.check(replaced(slide(), "friction = 0.4", "friction = 0.38"));
  REQUIRE(verdicts(result) == Verdicts{exact, physics, physics, physics});
  CHECK_FALSE(result.findings[1].since_tick);
  CHECK_THAT(result.findings[1].message, StartsWith("since after frame 0. left moved") && Contains("Explains"));
}

}  // namespace
}  // namespace proofreel
