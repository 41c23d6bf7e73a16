#include "scenarios/film.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "moving_disc.h"

using namespace proofreel;
using Catch::Contains;

TEST_CASE("A frame holds the snapshot of its moment") {
  auto r = run("");
  const Frame frame = frame_at(r, 50);
  CHECK(frame.index == 7);
  CHECK(frame.snapshot.tick == 50);
  CHECK(frame.view.center == Vec2d{0, 5});
  CHECK(frame.view.height == 10);
}

TEST_CASE("A camera move starts and ends at rest and passes its middle half way") {
  auto r = run("camera{at=1, center={4, 5}, height=6, over=2}");
  CHECK(frame_at(r, 100).view.center.x == 0);
  CHECK(frame_at(r, 101).view.center.x < 0.01);
  CHECK(frame_at(r, 200).view.center.x == Approx(2));
  CHECK(frame_at(r, 200).view.height == Approx(8));
  CHECK(frame_at(r, 300).view.center.x == Approx(4));
  CHECK(frame_at(r, 900).view.height == Approx(6));
}

TEST_CASE("A camera without time to move jumps") {
  auto r = run("camera{at=1, center={4, 5}}");
  CHECK(frame_at(r, 99).view.center.x == 0);
  CHECK(frame_at(r, 100).view.center.x == 4);
}

TEST_CASE("A following camera shows the body, and stays where it was removed") {
  auto r = run("camera{follow=b} at(2, function() b:remove() end)");
  const Vec2d shown = frame_at(r, 100).view.center;
  CHECK(shown == r.simulation->body(static_cast<BodyId>(1)).center);
  CHECK(frame_at(r, 300).view.center.x == Approx(2));
}

TEST_CASE("A move may begin while another is under way") {
  auto r = run("camera{at=0, center={10, 5}, over=4} camera{at=2, center={0, 5}, over=2}");
  const double before = frame_at(r, 199).view.center.x;
  const double after = frame_at(r, 201).view.center.x;
  CHECK(before == Approx(5).epsilon(0.01));
  CHECK(std::abs(after - before) < 0.1);
  CHECK(frame_at(r, 400).view.center.x == Approx(0).margin(1e-12));
}

TEST_CASE("Captions show from their first moment until just before their last") {
  auto r = run("caption{text='one', from=1, to=2} caption{text='two', at='top'}");
  CHECK(frame_at(r, 99).captions.size() == 1);
  CHECK(frame_at(r, 100).captions[0].text == "one");
  CHECK(frame_at(r, 199).captions.size() == 2);
  CHECK(frame_at(r, 200).captions[0].text == "two");
  CHECK(frame_at(r, 200).captions[0].at == Corner::top);
}

TEST_CASE("Labels keep clear of their body and go with it") {
  auto r = run("label{body=b, text='ball'} at(1, function() b:remove() end)");
  const Frame frame = frame_at(r, 50);
  REQUIRE(frame.labels.size() == 1);
  CHECK(frame.labels[0].anchor.x == Approx(0.5));
  CHECK(frame.labels[0].clearance == Approx(0.5));
  CHECK(frame_at(r, 101).labels.empty());
}

TEST_CASE("Arrows are as long as what they show") {
  auto r =
      run("vector{body=b, of='velocity', scale=3} vector{body=b, of='momentum'} vector{body=b, of='force'}"
          "vector{body=b, of='acceleration'} vector{body=b, of='contact_impulse'}");
  ContactView contact{BodyId::world, static_cast<BodyId>(1), {0, 1}, {}, 2};
  contact.points[0].normal_impulse = 2;
  contact.points[1].normal_impulse = 3;
  r.simulation->touching = {contact};
  const auto arrows = frame_at(r, 10).arrows;
  REQUIRE(arrows.size() == 5);
  const auto along = [&](std::size_t i) { return arrows[i].to - arrows[i].from; };
  CHECK(along(0).x == Approx(3));
  CHECK(along(1).x == Approx(2));
  CHECK(along(2).y == Approx(-2));
  CHECK(along(3).y == Approx(-1));
  CHECK(along(4).y == Approx(5));
}

TEST_CASE("Ghosts stay where their body stood at even times, turned as it was") {
  auto r = run("ghost{body=b, every=0.5} at(2.2, function() b:remove() end)");
  const auto early = frame_at(r, 49).ghosts.at(0).poses;
  REQUIRE(early.size() == 1);
  const auto poses = frame_at(r, 300).ghosts.at(0).poses;
  REQUIRE(poses.size() == 5);
  for (std::size_t i = 0; i < poses.size(); ++i)
    CHECK(poses[i].position.x == Approx(0.5 * static_cast<double>(i)).margin(1e-9));
}

TEST_CASE("A ghost needs a body and a time") {
  CHECK_THAT(error_of("scenario{}\nlocal b = body{shape=circle{radius=1}}\nghost{body=b}"), Contains("every"));
  CHECK_THAT(error_of("scenario{}\nlocal b = body{shape=circle{radius=1}}\nghost{body=b, every=0}"),
             Contains("positive"));
  CHECK_THAT(error_of("scenario{}\nghost{every=1}"), Contains("body"));
}

TEST_CASE("A trail shows the last seconds and ends at the body") {
  auto r = run("trail{body=b, seconds=0.5}");
  const auto early = frame_at(r, 20).trails.at(0).points;
  CHECK(early.size() == 21);
  CHECK(early.front().x == 0);
  const auto late = frame_at(r, 300).trails.at(0).points;
  CHECK(late.size() == 51);
  CHECK(late.front().x == Approx(2.5));
  CHECK(late.back().x == Approx(3));
}

TEST_CASE("The trail of a removed body fades out") {
  auto r = run("trail{body=b, seconds=0.5} at(1, function() b:remove() end)");
  CHECK(frame_at(r, 120).trails.at(0).points.size() == 31);
  CHECK(frame_at(r, 200).trails.at(0).points.empty());
}

TEST_CASE("A plot holds the samples of its last seconds, curves in order of their names") {
  auto r = run("plot{title='p', y={t=time, minus=function() return -time() end}, seconds=1, at='top_left'}");
  const PlotView plot = frame_at(r, 300).plots.at(0);
  CHECK(plot.title == "p");
  CHECK(plot.at == Corner::top_left);
  CHECK(plot.curves == std::vector<std::string>{"minus", "t"});
  REQUIRE(plot.times.size() == 51);
  CHECK(plot.times.front() == Approx(2));
  CHECK(plot.times.back() == Approx(3));
  CHECK(plot.values[0].back() == Approx(-3));
  CHECK(plot.values[1].front() == Approx(2));
}

TEST_CASE("A trail may be that of a point of the body") {
  auto r = run("trail{body=b, seconds=0.5, point={0.5, 0}} b:set{spin=1}");
  const auto points = frame_at(r, 100).trails.at(0).points;
  const BodyState body = r.simulation->body(static_cast<BodyId>(1));
  CHECK(distance(points.back(), body.position) == Approx(0.5));
  CHECK(points.front().x == Approx(0.5 + 0.5 * std::cos(0.5)).margin(0.02));
}

TEST_CASE("A camera move at one speed is half way at half the time, and a quarter of the way after a quarter") {
  auto r = run("camera{at=1, center={4, 5}, over=2, ease='linear'}");
  CHECK(frame_at(r, 100).view.center.x == 0);
  CHECK(frame_at(r, 150).view.center.x == Approx(1));
  CHECK(frame_at(r, 200).view.center.x == Approx(2));
  CHECK(frame_at(r, 400).view.center.x == Approx(4));
  CHECK_THAT(error_of("scenario{}\ncamera{center={0,0}, ease='fast'}"), Contains("line 2") && Contains("smooth"));
}
