#include "golden/judge.h"

#include <catch2/catch.hpp>

#include "golden/hex.h"

namespace proofreel {
namespace {

using Catch::Matchers::Contains;

/// A golden of frames 0 and 60 of one moving ball and one resting block.
Golden golden_example() {
  Golden golden;
  golden.scenario = "ball";
  golden.size = {4, 4};
  golden.ticks = 480;
  golden.final_trajectory_hash = hex(99);
  golden.frames.push_back({0, hex(1), "", "", "", {{1, "ball", 0, 5, 0}, {2, "", 1, 1, 0}}});
  golden.frames.push_back({60, hex(2), "", "", "", {{1, "ball", 0, 3, 0.5}, {2, "", 1, 1, 0}}});
  return golden;
}

/// What a run gives that agrees with it.
Observation observation_example() {
  Observation now;
  now.final_trajectory_hash = hex(99);
  now.report.ticks = 480;
  for (const GoldenFrame& frame : golden_example().frames) {
    now.frames.push_back({frame.frame, frame.trajectory_hash, Image(4, 4), frame.bodies});
  }
  return now;
}

/// Says of the pictures of frames 0 and 60 what it is told to.
JudgePicture pictures(Verdict at_0, Verdict at_60) {
  return [=](const Golden&, const GoldenFrame&, const ObservedFrame& now) {
    const Verdict verdict = now.frame == 0 ? at_0 : at_60;
    Finding finding{now.frame, verdict, verdict == Verdict::exact ? "" : "pixels differ.", {}};
    finding.comparison.different = verdict == Verdict::exact ? 0 : 12;
    return finding;
  };
}

std::vector<Verdict> verdicts(const std::vector<Finding>& findings) {
  std::vector<Verdict> list;
  for (const Finding& finding : findings) list.push_back(finding.verdict);
  return list;
}

using Verdicts = std::vector<Verdict>;

TEST_CASE("Equal hashes and equal pictures are exact, at every frame and at the end", "[judge]") {
  const Verdicts all_exact(3, Verdict::exact);
  REQUIRE(verdicts(judge(golden_example(), observation_example(), pictures(Verdict::exact, Verdict::exact))) ==
          all_exact);
  REQUIRE(verdicts(judge(golden_example(), observation_example(), {})) == all_exact);
}

TEST_CASE("Other state is physics, and the message names the body that moved most", "[judge]") {
  Observation now = observation_example();
  now.frames[1].trajectory_hash = hex(3);
  now.frames[1].bodies[0].y = 2.75;
  now.frames[1].bodies[1].x = 1.01;
  for (const JudgePicture& judge_picture : {JudgePicture(), pictures(Verdict::exact, Verdict::drawing)}) {
    const std::vector<Finding> findings = judge(golden_example(), now, judge_picture);
    REQUIRE(verdicts(findings) == Verdicts{Verdict::exact, Verdict::physics, Verdict::exact});
    REQUIRE_THAT(findings[1].message, Contains("ball moved 0.25 m, the farthest of 2 bodies."));
  }
}

TEST_CASE("A state that another golden frame shows is known again", "[judge]") {
  Observation now = observation_example();
  now.frames[1].trajectory_hash = hex(1);
  now.frames[1].bodies = now.frames[0].bodies;
  const std::vector<Finding> findings = judge(golden_example(), now, {});
  REQUIRE_THAT(findings[1].message, Contains("its state is that of golden frame 0"));
}

TEST_CASE("Bodies that are new or gone are named", "[judge]") {
  Observation now = observation_example();
  now.frames[1].trajectory_hash = hex(3);
  now.frames[1].bodies = {{2, "", 1, 1, 0}, {3, "", 0, 0, 0}, {4, "", 0, 0, 0}};
  const std::vector<Finding> findings = judge(golden_example(), now, {});
  REQUIRE_THAT(findings[1].message, Contains("ball is gone") && Contains("body 3 and body 4 are new"));
}

TEST_CASE("Same state with other pixels is drawing", "[judge]") {
  const auto findings = judge(golden_example(), observation_example(), pictures(Verdict::exact, Verdict::drawing));
  REQUIRE(verdicts(findings) == Verdicts{Verdict::exact, Verdict::drawing, Verdict::exact});
}

TEST_CASE("It is both when the drawing is proven to have changed at a frame of equal state", "[judge]") {
  Observation now = observation_example();
  now.frames[1].trajectory_hash = hex(3);
  const auto findings = judge(golden_example(), now, pictures(Verdict::drawing, Verdict::drawing));
  REQUIRE(verdicts(findings) == Verdicts{Verdict::drawing, Verdict::both, Verdict::exact});
}

TEST_CASE("A difference that only shows after the last golden frame is found at the end", "[judge]") {
  Observation now = observation_example();
  now.final_trajectory_hash = hex(98);
  REQUIRE(verdicts(judge(golden_example(), now, {})).back() == Verdict::physics);
  now = observation_example();
  now.report.ticks = 479;
  REQUIRE_THAT(judge(golden_example(), now, {}).back().message, Contains("479 ticks instead of 480"));
}

TEST_CASE("A frame without reference is missing, a reference without frame is an orphan", "[judge]") {
  Golden golden = golden_example();
  golden.frames[1].frame = 61;
  const auto findings = judge(golden, observation_example(), {});
  REQUIRE(verdicts(findings) == Verdicts{Verdict::orphan, Verdict::exact, Verdict::missing, Verdict::exact});
  REQUIRE(findings[0].frame == 61);
  REQUIRE(findings[2].frame == 60);
}

TEST_CASE("Without any golden everything is missing", "[judge]") {
  REQUIRE(verdicts(judge(std::nullopt, observation_example(), {})) == Verdicts(3, Verdict::missing));
}

TEST_CASE("A reference picture that cannot be used stays missing though the state differs too", "[judge]") {
  Observation now = observation_example();
  now.frames[1].trajectory_hash = hex(3);
  const auto findings = judge(golden_example(), now, pictures(Verdict::exact, Verdict::missing));
  REQUIRE(findings[1].verdict == Verdict::missing);
}

TEST_CASE("Only exact and tolerated pass", "[judge]") {
  for (const Verdict verdict : {Verdict::physics, Verdict::drawing, Verdict::both, Verdict::missing, Verdict::size,
                                Verdict::orphan, Verdict::nondeterministic}) {
    REQUIRE_FALSE(passes(verdict));
  }
  REQUIRE(passes(Verdict::exact));
  REQUIRE(passes(Verdict::tolerated));
}

}  // namespace
}  // namespace proofreel
