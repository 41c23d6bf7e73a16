#include <catch2/catch.hpp>

#include "scene_text.h"

using namespace proofreel;
using Catch::Contains;
using Catch::StartsWith;

namespace {

const std::string wrap = "demonstrate{algorithm='gift_wrapping', points={{0, 0}, {2, 0}, {1, 2}, {1, 1}}}";

}  // namespace

TEST_CASE("A lecture film lasts as long as its steps unless the scenario says otherwise") {
  const auto usual = load_text("scenario{}\n" + wrap);
  CHECK(usual->duration == Approx(duration_of(usual->stories)));
  CHECK(usual->stories.size() == 1);
  CHECK(load_text("scenario{duration=3}\n" + wrap)->duration == 3);
  CHECK(load_text("scenario{}\n" + wrap, {{"duration", "2"}})->duration == 2);
  const auto twice = load_text("scenario{}\n" + wrap + "\n" + wrap);
  CHECK(twice->stories.size() == 2);
  CHECK(twice->duration == Approx(duration_of(twice->stories)));
}

TEST_CASE("The pace stretches a lecture film") {
  const std::string slower = "demonstrate{algorithm='centroid', pace=3, points={{0, 0}, {2, 0}, {1, 2}}}";
  const std::string faster = "demonstrate{algorithm='centroid', pace=1, points={{0, 0}, {2, 0}, {1, 2}}}";
  CHECK(load_text("scenario{}\n" + slower)->duration == Approx(3 * load_text("scenario{}\n" + faster)->duration));
}

TEST_CASE("Every frame of a lecture film shows its demonstration, and no other film has one") {
  const auto scenario = load_text("scenario{}\n" + wrap);
  Runner runner(*scenario);
  CHECK(runner.frame(0).demonstration->caption == scenario->stories[0].steps[0].caption);
  while (!runner.finished()) runner.step();
  CHECK(runner.frame(1).demonstration->caption == scenario->stories[0].steps.back().caption);
  const auto other = load_text("scenario{}\nbody{shape=circle{radius=1}}");
  CHECK_FALSE(Runner(*other).frame(0).demonstration);
}

TEST_CASE("What an algorithm did is part of the trajectory hash") {
  const auto hash_of_text = [](const std::string& text) {
    const auto scenario = load_text("scenario{duration=0.1}\n" + text);
    return Runner(*scenario).finish().trajectory_hash;
  };
  CHECK(hash_of_text(wrap) == hash_of_text(wrap));
  CHECK(hash_of_text(wrap) != hash_of_text(""));
  CHECK(hash_of_text(wrap) !=
        hash_of_text("demonstrate{algorithm='gift_wrapping', points={{0, 0}, {2, 0}, {1, 2}, {1, 0.5}}}"));
}

TEST_CASE("Concave shapes and circles go into a tree") {
  const auto scenario = load_text(R"(scenario{}
    demonstrate{algorithm='tree_pairs', shapes={circle{radius=1}, polygon{{0, 0}, {3, 0}, {1, 1}, {0, 3}},
                                               capsule{a={4, 0}, b={5, 0}, radius=0.2}}})");
  CHECK(scenario->stories.size() == 1);
}

TEST_CASE("Densities and coefficients of friction of its shapes count in a demonstration") {
  const auto hash_with = [](const std::string& algorithm, const std::string& key) {
    const std::string box = "box{width=2, height=0.5, friction={static=0.5, kinetic=0.3}, " + key + "}";
    const std::string other = algorithm == "friction_cone" ? "" : ", box{at={3, 0}, width=1, height=1}";
    const auto scenario =
        load_text("scenario{}\ndemonstrate{algorithm='" + algorithm + "', shapes={" + box + other + "}}");
    return hash_of(scenario->stories);
  };
  CHECK(hash_with("center_of_mass", "density=1") == hash_with("center_of_mass", ""));
  CHECK(hash_with("center_of_mass", "density=3") != hash_with("center_of_mass", ""));
  CHECK(hash_with("friction_cone", "friction={static=0.6, kinetic=0.3}") != hash_with("friction_cone", ""));
}

TEST_CASE("A demonstration that cannot be made is refused with the line and what is taken") {
  const auto [call, problem] = GENERATE(table<std::string, std::string>({
      {"{}", "demonstrate needs algorithm="},
      {"{algorithm='gift_wraping', points={}}",
       "algorithm cannot be \"gift_wraping\", did you mean \"gift_wrapping\"?"},
      {"{algorithm='centroid', point={}}", "unknown key \"point\", did you mean \"points\"?"},
      {"{algorithm='gift_wrapping'}", "gift_wrapping takes points={{x, y}, ...}, 3 to 32 points"},
      {"{algorithm='gift_wrapping', shapes={circle{radius=1}}}", "gift_wrapping takes points={{x, y}, ...}"},
      {"{algorithm='gift_wrapping', points={{0, 0}, {1, 0}}}", "gift_wrapping takes 3 to 32 points, got 2"},
      {"{algorithm='gift_wrapping', points={{0, 0}, {1, 0}, {2, 0}}}", "not all on one line"},
      {"{algorithm='gift_wrapping', points={{0, 0}, {1, 0}, {2, 0/0}}}", "point 3 does not"},
      {"{algorithm='gift_wrapping', points={{0, 0}, {1, 0}, {2, 1e10}}}", "within 1e9 m"},
      {"{algorithm='gift_wrapping', points={{0, 0}, {1, 0}, 7}}", "but holds 7 in place 3"},
      {"{algorithm='gift_wrapping', points={{0, 0}, {1, 0}, [4]={0, 1}}}",
       "points must be a list of points {x, y} and nothing"},
      {"{algorithm='gift_wrapping', points=7}", "points must be a list of points {x, y}, got 7"},
      {"{algorithm='centroid', points={{0, 0}, {2, 2}, {2, 0}, {0, 2}}}", "centroid takes an outline, but"},
      {"{algorithm='centroid', points={{0, 0}, {1, 0}, {2, 0}, {0, 2}}}", "none within a straight edge"},
      {"{algorithm='diagonal_test', points={{0, 0}, {1, 0}, {0, 2}}}", "diagonal_test takes 4 points, got 3"},
      {"{algorithm='gjk_epa', shapes={circle{radius=1}, box{width=1, height=1}}}",
       "two convex polygons without rounding"},
      {"{algorithm='gjk_epa', shapes={box{width=1, height=1}}}", "gjk_epa takes 2 shapes, got 1"},
      {"{algorithm='gjk_epa', shapes={7, 8}}", "must be a list of shapes such as box{...}, but holds 7 in place 1"},
      {"{algorithm='gjk_epa', shapes={box{width=1, height=-1}, box{width=1, height=1}}}",
       "the height of its box must be"},
      {"{algorithm='separating_axes', shapes={regular{sides=9, radius=1}, box{width=1, height=1}}}",
       "at most 8 corners each"},
      {"{algorithm='separating_axes', shapes={regular{sides=7, radius=1}, box{width=1, height=1}}}",
       "at most 10 corners together"},
      {"{algorithm='tree_pairs', shapes={box{width=1, height=1}, box{width=1, height=1}}}",
       "shape 1 and shape 2 have the same one"},
      {"{algorithm='circle_contact', shapes={box{width=1, height=1}, circle{radius=1}}}",
       "takes a circle, and then a circle or"},
      {"{algorithm='bounding_volumes', shapes={circle{radius=1}}}", "takes a polygon, convex or concave"},
      {"{algorithm='centroid', points={{0, 0}, {2, 0}, {0, 2}}, angle=1}",
       "centroid takes no scale={x, y}, angle= and"},
      {"{algorithm='transforms', shapes={box{width=1, height=1}}}", "transforms takes scale={x, y}, angle= and at="},
      {"{algorithm='transforms', shapes={box{width=1, height=1}}, scale={0/0, 1}}", "scale must"},
      {"{algorithm='transforms', shapes={box{width=1, height=1}}, at={1e10, 0}}", "at must"},
      {"{algorithm='transforms', shapes={box{width=1, height=1}}, scale={1, 0}}", "scales between 0.01 and 100"},
      {"{algorithm='dot_product', points={{1, 0}, {0, 0}, {1, 1}}}", "none of them {0, 0}: change point 2"},
      {"{algorithm='cross_product', points={{1, 0}, {0, 0/0}, {1, 1}}}", "point 2 does not"},
      {"{algorithm='gjk_line', shapes={segment{a={0, 1}, b={1, 1}}, segment{a={0, 0}, b={1, 0}}}}",
       "takes two intervals of the x axis"},
      {"{algorithm='center_of_mass', shapes={circle{radius=1}}}", "center_of_mass takes 2 to 6 shapes, got 1"},
      {"{algorithm='friction_cone', shapes={box{width=1, height=0.4}}}",
       "friction={static=, kinetic=} between 0.2 and 1"},
      {"{algorithm='sequential_impulses', shapes={box{width=1, height=1}, box{at={3, 3}, width=1, height=1}}}",
       "shape 2 touches nothing"},
      {"{algorithm='centroid', points={{0, 0}, {2, 0}, {0, 2}}, pace=0}", "pace must be a positive number"},
      {"{algorithm='centroid', points={{0, 0}, {2, 0}, {0, 2}}, pace=100}", "pace must not be larger than 60"},
  }));
  INFO(call);
  CHECK_THAT(error_of("scenario{}\n\ndemonstrate" + call),
             StartsWith("scene.lua: line 3: demonstrate") && Contains(problem));
}

TEST_CASE("A scenario either films an algorithm or has bodies") {
  const std::string body = "body{shape=circle{radius=1}}";
  CHECK_THAT(error_of("scenario{}\n" + body + "\n" + wrap),
             StartsWith("scene.lua: line 3: ") && Contains("has no bodies"));
  CHECK_THAT(error_of("scenario{}\n" + wrap + "\n" + body), Contains("has no bodies"));
  CHECK_THAT(error_of("scenario{}\nat(1, function()\n" + wrap + "\nend)"), Contains("belongs at the top level"));
}
