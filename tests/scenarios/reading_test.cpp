// Lecture films as an audience sees them: what is written stays long enough, and pictures agree with their words.

#include "scenarios/demonstrations/reading.h"
#include "film_marks.h"
#include "scene_text.h"

using namespace proofreel;
using namespace proofreel::films;

namespace {

const Points vectors{{2.4, 0.6}, {1.4, 1.6}, {1.3, 1.1}, {1.5, -1.3}, {-0.9, 1.5}, {-1.7, -0.8}};

/// Steps of one caption, as numbers: the first, and one past the last.
std::size_t end_of_caption(const Story& story, std::size_t first) {
  std::size_t end = first;
  while (end < story.steps.size() && story.steps[end].caption == story.steps[first].caption) ++end;
  return end;
}

/// At `stretch` times the usual pace.
Story readable(Algorithm algorithm, const std::vector<Story>& before, double stretch) {
  Story story = told({algorithm, vectors, {}, stretch * usual_pace(algorithm), {}});
  give_time_to_read(story, before, stretch);
  return story;
}

double seconds_of(const Story& story, std::size_t first, std::size_t end) {
  double seconds = 0;
  for (std::size_t i = first; i < end; ++i) seconds += story.steps[i].seconds;
  return seconds;
}

/// How far the bar of P_{number} reaches in the second pane; negative to the left.
double reach_of_bar(const Step& step, int number) {
  const StoryMark* bar = mark_called(step, MarkKind::bar, "P_{" + std::to_string(number) + "}");
  REQUIRE(bar != nullptr);
  return bar->points[1].x - bar->points[0].x;
}

}  // namespace

TEST_CASE("A caption takes a second and 0.3 s for every word; what was read before is recognised") {
  std::set<std::string> known;
  CHECK(seconds_to_read("Three new words", known) == Approx(1.9));
  CHECK(seconds_to_read("Three words again", known) == Approx(1 + 0.3 + 2 * 0.2));
  CHECK(seconds_to_read("Three = words + again", known) == Approx(0.5));
  CHECK(seconds_to_read("Three words again: 3.5", known) == Approx(1 + 2 * 0.3 + 2 * 0.2));
  CHECK(seconds_to_read("Three words again: 7.5", known) == Approx(0.5 + 0.3));
  CHECK(seconds_to_read("", known) == Approx(0.5));
}

TEST_CASE("In every lecture film captions can be read, and motions keep their speed") {
  int read = 0;
  for (const Algorithm algorithm : {Algorithm::dot_product, Algorithm::cross_product, Algorithm::gift_wrapping}) {
    const Story story = readable(algorithm, {}, 1);
    std::set<std::string> known;
    for (std::size_t first = 0, end = 0; first < story.steps.size(); first = end) {
      end = end_of_caption(story, first);
      const double needed = seconds_to_read(story.steps[first].caption, known);
      seconds_to_read(story.steps[first].heading, known);
      CHECK(seconds_of(story, first, end) > needed - 1e-9);
      for (std::size_t i = first; i + 2 < end; ++i)
        CHECK(story.steps[i].seconds == Approx(story.steps[i + 1].seconds));  // all but the last, which stands still
      ++read;
    }
  }
  CHECK(read > 40);
}

TEST_CASE("A pace twice as slow makes a whole film last twice as long, pauses for reading included") {
  const Story usual = readable(Algorithm::dot_product, {}, 1), slow = readable(Algorithm::dot_product, {}, 2);
  REQUIRE(slow.steps.size() == usual.steps.size());
  CHECK(duration_of({slow}) == Approx(2 * duration_of({usual})));
}

TEST_CASE("What an earlier part of a film has said takes less time when it is said again") {
  const Story first = readable(Algorithm::dot_product, {}, 1), again = readable(Algorithm::dot_product, {first}, 1);
  CHECK(duration_of({again}) < 0.9 * duration_of({first}));
  const std::string text = "demonstrate{algorithm='centroid', points={{0, 0}, {2, 0}, {1, 2}}}\n";
  const double once = load_text("scenario{}\n" + text)->duration;
  CHECK(load_text("scenario{}\n" + text + text)->duration < 1.9 * once);
  CHECK(once >
        duration_of({told({Algorithm::centroid, {{0, 0}, {2, 0}, {1, 2}}, {}, usual_pace(Algorithm::centroid), {}})}));
}

TEST_CASE("Bars of products are as long as the figures beside them say") {
  const Story dots = told(Algorithm::dot_product, vectors);
  const Story crosses = told(Algorithm::cross_product, vectors);
  const Step& in_front = dots.steps[dots.steps.size() - 3];
  const Step& seen = dots.steps[dots.steps.size() - 2];
  const Vec2d a = vectors[0];
  for (int i = 1; i <= 4; ++i) {
    const Vec2d p = vectors[static_cast<std::size_t>(i) + 1], first = vectors[2];
    INFO(i);
    CHECK(reach_of_bar(in_front, i) / reach_of_bar(in_front, 1) == Approx(dot(a, p) / dot(a, first)));
    CHECK(reach_of_bar(seen, i) / reach_of_bar(seen, 1) ==
          Approx(dot(a, p) * length(first) / (dot(a, first) * length(p))));  // of cosines
    CHECK(reach_of_bar(crosses.steps.back(), i) / reach_of_bar(crosses.steps.back(), 1) ==
          Approx(cross(a, p) / cross(a, first)));
  }
}

TEST_CASE("The way out that a separating axis tells is from where one shape begins to where the other ends") {
  const DemonstrationShape a = box_at({0, 0}, 2, 2), b = box_at({1.5, 0.5}, 2, 2);
  const Story story = told(Algorithm::separating_axes, {a, b});
  step_saying(story, "A ends at $1.00$ and B begins at $0.50$: a way out of $0.50$ m");
  step_saying(story, "B ends at $2.50$ and A begins at $\u22121.00$");
}

TEST_CASE("The first box of a tree is its first leaf as soon as that is said") {
  const Story story = told(Algorithm::tree_insertion, {disc_at({0, 0}, 1), disc_at({3, 0}, 1)});
  const Step& first = story.steps.front();
  CHECK_THAT(first.caption, Catch::Contains("a tree of one leaf"));
  CHECK(std::any_of(first.marks.begin(), first.marks.end(),
                    [](const StoryMark& mark) { return mark.pane == 1 && mark.kind == MarkKind::dot; }));
}
