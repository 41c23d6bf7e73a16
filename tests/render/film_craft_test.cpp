#include <catch2/catch.hpp>

#include "render/contact_sheet.h"
#include "render/exposure.h"
#include "render/film.h"
#include "render/png.h"
#include "render/subtitles.h"
#include "scenarios/timeline.h"
#include "tests/render/scratch_folder.h"

namespace proofreel {
namespace {

using Catch::Matchers::Contains;

std::unique_ptr<Scenario> loaded(const ScratchFolder& folder, const std::string& keys, const std::string& script) {
  write_text(
      folder / "scene.lua",
      "scenario { duration = 0.5, size = {64, 48}, view = { center = {0, 2}, height = 8 }, " + keys + " }\n" + script);
  return load_scenario(folder / "scene.lua", {});
}

const std::string ball = "local ball = body { at = {0, 5}, shape = circle { radius = 0.5 } }\n";
const std::string resting =
    "ground { y = 0 } body { at = {0, 0.5}, shape = box { width = 1, height = 1 } }\n"
    "caption { text = 'at rest', at = 'top' }\n";

class PictureList final : public Sink {
 public:
  void frame(const Image& image) override { pictures.push_back(image); }
  void finish() override {}
  std::vector<Image> pictures;
};

FilmRequest whole_film(const Scenario& scenario) {
  FilmRequest request;
  request.timeline = film_timeline(scenario);
  request.frames = FrameRange{0, static_cast<std::int64_t>(request.timeline.size()) - 1}.frames();
  return request;
}

std::vector<Image> filmed(Scenario& scenario, const FilmRequest& request) {
  PictureList list;
  render_film(scenario, request, list, {});
  return std::move(list.pictures);
}

std::vector<Image> blurred(Scenario& scenario, double degrees) {
  FilmRequest request = whole_film(scenario);
  request.exposures = exposures(scenario, request.timeline, degrees);
  return filmed(scenario, request);
}

bool same(const Image& a, const Image& b) { return a.rgba == b.rgba; }

Image mean_of(const std::vector<Image>& images, std::size_t first, std::size_t count) {
  Exposure exposure;
  for (std::size_t i = first; i < first + count; ++i) exposure.add(images[i]);
  Image mean = Image::uncleared(images[0].width_px, images[0].height_px);
  exposure.develop(mean);
  return mean;
}

/// Cues as "first-last: line | line".
std::vector<std::string> cues_of(Scenario& scenario, std::int64_t card_pictures = 0) {
  FilmRequest request = whole_film(scenario);
  request.card_pictures = card_pictures;
  std::vector<std::string> texts;
  for (const Cue& cue : subtitles_of(scenario, request, film_sections(scenario, request.timeline), {})) {
    std::string text = std::to_string(cue.first) + "-" + std::to_string(cue.last) + ":";
    for (const std::string& line : cue.lines) text.append(text.back() == ':' ? " " : " | ").append(line);
    texts.push_back(text);
  }
  return texts;
}

}  // namespace

TEST_CASE("A blurred frame is the mean of the pictures of all ticks within the shutter", "[film]") {
  const ScratchFolder folder;
  const auto all = loaded(folder, "rate = 240, fps = 240", ball);
  const std::vector<Image> ticks = filmed(*all, whole_film(*all));
  REQUIRE(ticks.size() == 120);
  const auto scenario = loaded(folder, "rate = 240, fps = 30", ball);
  const std::vector<Image> frames = blurred(*scenario, 180);
  REQUIRE(frames.size() == 15);
  for (std::size_t i = 0; i < frames.size(); ++i) CHECK(same(frames[i], mean_of(ticks, 8 * i, 4)));
  CHECK_FALSE(same(frames[10], ticks[80]));
}

TEST_CASE("Under slow motion the shutter is open for as much less of scene time", "[film]") {
  const ScratchFolder folder;
  const auto all = loaded(folder, "rate = 480, fps = 480", ball);
  const std::vector<Image> ticks = filmed(*all, whole_film(*all));
  const auto slowed = loaded(folder, "rate = 480, fps = 30", ball + "slow { from = 0.25, to = 0.5, factor = 0.5 }\n");
  const std::vector<Image> frames = blurred(*slowed, 180);
  const std::vector<std::int64_t> timeline = film_timeline(*slowed);
  REQUIRE(frames.size() == timeline.size());
  for (const std::size_t i : {3U, 7U}) CHECK(same(frames[i], mean_of(ticks, static_cast<std::size_t>(timeline[i]), 8)));
  for (const std::size_t i : {9U, 15U, 21U})
    CHECK(same(frames[i], mean_of(ticks, static_cast<std::size_t>(timeline[i]), 4)));
}

TEST_CASE("A frozen frame is sharp, and what rests is so in every frame, letters included", "[film]") {
  const ScratchFolder folder;
  const std::string freeze = "freeze { at = 0.25, seconds = 0.1 }\n";
  const auto plain = loaded(folder, "rate = 480", ball + freeze);
  const std::vector<Image> sharp = filmed(*plain, whole_film(*plain));
  const auto frozen = loaded(folder, "rate = 480", ball + freeze);
  const std::vector<Image> frames = blurred(*frozen, 180);
  REQUIRE(frames.size() == sharp.size());
  for (std::size_t i = 15; i < 21; ++i) CHECK(same(frames[i], sharp[i]));
  CHECK_FALSE(same(frames[22], sharp[22]));

  const auto rest = loaded(folder, "rate = 480", resting);
  const std::vector<Image> still = filmed(*rest, whole_film(*rest));
  const auto rest_again = loaded(folder, "rate = 480", resting);
  const std::vector<Image> mean = blurred(*rest_again, 360);
  for (std::size_t i = 0; i < still.size(); ++i) CHECK(same(mean[i], still[i]));
}

TEST_CASE("What is written on a blurred frame is what its first tick says", "[film]") {
  const ScratchFolder folder;
  const std::string clock = "layers = {'clock'}, rate = 480, duration = 2, size = {160, 120}";
  const auto plain = loaded(folder, clock, ball);
  const std::vector<Image> sharp = filmed(*plain, whole_film(*plain));
  const auto again = loaded(folder, clock, ball);
  const std::vector<Image> frames = blurred(*again, 360);
  for (std::size_t i = 0; i < sharp.size(); ++i) REQUIRE(same(frames[i], sharp[i]));
  CHECK_FALSE(same(sharp[0], sharp[20]));
}

TEST_CASE("A run that ends while the shutter is open ends the exposure", "[film]") {
  const ScratchFolder folder;
  const auto scenario = loaded(folder, "duration = 0.505, rate = 960", ball);
  CHECK(blurred(*scenario, 360).size() == 31);
}

TEST_CASE("A title card stands still, gives way to the first frame, and changes nothing after it", "[film]") {
  const ScratchFolder folder;
  const auto plain = loaded(folder, "title = 'A ball'", ball);
  const std::vector<Image> without = filmed(*plain, whole_film(*plain));
  const auto scenario = loaded(folder, "title = 'A ball'", ball);
  FilmRequest request = whole_film(*scenario);
  request.title_card = TitleCard{"A ball", "It falls."};
  request.card_pictures = 90;
  const std::vector<Image> with = filmed(*scenario, request);
  REQUIRE(with.size() == 90 + without.size());
  for (std::size_t i = 0; i < without.size(); ++i) REQUIRE(same(with[90 + i], without[i]));
  for (std::size_t i = 1; i <= 90 - 45; ++i) CHECK(same(with[i - 1], with[0]));
  CHECK_FALSE(same(with[0], without[0]));
  CHECK_FALSE(same(with[89], with[0]));
  request.card_pictures = 1;
  const auto short_one = loaded(folder, "title = 'A ball'", ball);
  CHECK(filmed(*short_one, request).size() == 31);
}

TEST_CASE("A caption without room stops the film before its first picture, with its place in the file", "[film]") {
  const ScratchFolder folder;
  const std::string wordy = "caption {\n  text = ('momentum '):rep(60), from = 0.4 }\n";
  const auto scenario = loaded(folder, "size = {320, 180}", ball + wordy);
  PictureList list;
  CHECK_THROWS_WITH(render_film(*scenario, whole_film(*scenario), list, {}),
                    Contains("scene.lua: line 4: the text of this caption does not fit"));
  CHECK(list.pictures.empty());
  const auto late = loaded(folder, "size = {320, 180}", ball + "at(0.2, function() " + wordy + " end)");
  CHECK_THROWS_WITH(render_film(*late, whole_film(*late), list, {}), Contains("line 4: the text of this caption"));
}

TEST_CASE("Subtitles say what is written, for as long as it is, formulas as plain text", "[film]") {
  const ScratchFolder folder;
  const auto scenario = loaded(folder, "fps = 60",
                               ball +
                                   "caption { text = 'falls by $\\\\frac{g t^2}{2}$', from = 0.1, to = 0.3 }\n"
                                   "at(0.2, function() caption { text = 'now', to = 0.4, at = 'top' } end)\n");
  CHECK(cues_of(*scenario) ==
        std::vector<std::string>{"6-12: falls by (g t\u00b2)/2", "13-17: now | falls by (g t\u00b2)/2", "18-23: now"});
}

TEST_CASE("A section begins a cue with its name, and has one of its own where nothing is written", "[film]") {
  const ScratchFolder folder;
  const std::string script =
      "section { at = 0, name = 'first' } section { at = 0.25, name = 'second' }\n"
      "section { at = 5, name = 'third' } caption { text = 'words', from = 0.125, to = 0.375 }\n";
  const auto scenario = loaded(folder, "fps = 60, duration = 10", ball + script);
  CHECK(cues_of(*scenario) ==
        std::vector<std::string>{"0-7: first", "8-14: words", "15-22: second | words", "300-479: third"});
}

TEST_CASE("Subtitles keep to the film's pictures: slow motion, freezes and title card included", "[film]") {
  const ScratchFolder folder;
  const std::string script = "caption { text = 'a', from = 0.25, to = 0.375 }\n";
  const auto slowed = loaded(folder, "fps = 60", ball + script + "slow { from = 0, to = 0.25, factor = 0.5 }\n");
  CHECK(cues_of(*slowed) == std::vector<std::string>{"30-37: a"});
  const auto frozen = loaded(folder, "fps = 60", ball + script + "freeze { at = 0.25, seconds = 1 }\n");
  CHECK(cues_of(*frozen) == std::vector<std::string>{"15-82: a"});
  const auto carded = loaded(folder, "fps = 60", ball + script);
  CHECK(cues_of(*carded, 180) == std::vector<std::string>{"195-202: a"});
}

TEST_CASE("Subtitles of a lecture film are the captions of its steps, each when its step begins", "[film]") {
  const auto scenario = load_scenario("scenarios/lecture/gjk_epa.lua", {});
  const std::vector<std::string> cues = cues_of(*scenario);
  CHECK(cues.size() > 10);
  CHECK_THAT(cues[0], Contains("Minkowski difference | Every corner of B"));
  double seconds = 0;
  std::size_t begun = 0;
  std::string before;
  for (const Step& step : scenario->stories[0].steps) {
    const std::string first = std::to_string(std::llround(seconds * scenario->picture.fps)) + "-";
    const bool begins = step.caption != before || std::any_of(cues.begin(), cues.end(), [&](const std::string& cue) {
                          return cue.starts_with(first);
                        });
    if (begins) CHECK(cues[begun++].starts_with(first));
    before = step.caption;
    seconds += step.seconds;
  }
  CHECK(begun == cues.size());
}

TEST_CASE("Times of SubRip are hours, minutes, seconds and milliseconds; cues are numbered and parted by lines") {
  const std::vector<Cue> cues{{0, 59, {"one", "two"}}, {219660, 219660, {"late"}}};
  CHECK(srt_text(cues, 60) ==
        "1\n00:00:00,000 --> 00:00:01,000\none\ntwo\n\n"
        "2\n01:01:01,000 --> 01:01:01,017\nlate\n\n");
  CHECK(srt_text({}, 60).empty());
}

TEST_CASE("A contact sheet's frames are spread evenly from the first to the last") {
  std::optional<SheetGrid> grid = SheetGrid{3, 2};
  const auto pictures = sheet_pictures({10, 110}, {}, grid);
  REQUIRE(pictures.size() == 6);
  for (std::size_t i = 0; i < 6; ++i) CHECK(pictures[i].frame == 10 + 20 * static_cast<std::int64_t>(i));
  grid.reset();
  CHECK(sheet_pictures({0, 599}, {}, grid).size() == 12);
  CHECK(sheet_pictures({0, 599}, {}, grid).back().frame == 599);
}

TEST_CASE("A contact sheet of few frames has a place for each and no more") {
  std::optional<SheetGrid> grid = SheetGrid{4, 3};
  CHECK(sheet_pictures({5, 5}, {}, grid).size() == 1);
  CHECK(grid->columns == 1);
  CHECK(grid->rows == 1);
  grid = SheetGrid{4, 3};
  CHECK(sheet_pictures({0, 4}, {}, grid).size() == 5);
  CHECK(grid->columns == 4);
  CHECK(grid->rows == 2);
}

TEST_CASE("A contact sheet shows where every section has led to, and needs a place for each") {
  const std::vector<FilmSection> sections{{"a", 0, 9}, {"b", 10, 19}, {"c", 20, 99}};
  std::optional<SheetGrid> grid;
  const auto pictures = sheet_pictures({5, 50}, sections, grid);
  REQUIRE(pictures.size() == 3);
  CHECK(pictures[0].frame == 9);
  CHECK(pictures[2].frame == 50);
  CHECK(pictures[1].name == "b");
  CHECK(grid->columns == 2);
  CHECK(grid->rows == 2);
  grid = SheetGrid{1, 2};
  CHECK_THROWS_WITH(sheet_pictures({0, 99}, sections, grid), Contains("has 2 places") && Contains("3 sections: 2x2"));
}

TEST_CASE("A contact sheet holds its pictures byte for byte, in rows") {
  const ScratchFolder folder;
  const auto scenario = loaded(folder, "", ball);
  const std::vector<Image> frames = filmed(*scenario, whole_film(*scenario));
  const auto sheet = make_contact_sheet(
      folder / "a.png", {2, 2}, {64, 48}, Theme::light,
      {"A title that is far too long for a sheet so small as this", {"one", "", "", ""}, {"0 s", "1 s", "2 s", "3 s"}});
  for (std::size_t i = 0; i < 4; ++i) sheet->frame(frames[7 * i]);
  sheet->finish();
  const Image image = read_png(folder / "a.png");
  const auto holds = [&](const Image& part, int left, int top) {
    for (int y = 0; y < part.height_px; ++y) {
      if (!std::equal(part.row(y), part.row(y) + part.row_bytes(),
                      image.row(top + y) + 4 * static_cast<std::size_t>(left)))
        return false;
    }
    return true;
  };
  for (std::size_t i = 0; i < 4; ++i) {
    int found = 0;
    for (int y = 0; y + 48 <= image.height_px; ++y) {
      for (int x = 0; x + 64 <= image.width_px; ++x) found += holds(frames[7 * i], x, y) ? 1 : 0;
    }
    CHECK(found == 1);
  }
}

TEST_CASE("A contact sheet larger than pictures may be is refused") {
  CHECK_THROWS_WITH(make_contact_sheet("a.png", {100, 100}, {480, 270}, Theme::light, {}), Contains("smaller --size"));
}

}  // namespace proofreel
