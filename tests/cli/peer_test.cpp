#include <catch2/catch.hpp>

#include "golden/json.h"
#include "tests/cli/collection.h"

namespace proofreel {
namespace {

using Catch::Matchers::Contains;

/// The claim, and the name it is made under.
struct PeerName {
  std::string option;
  std::string name;
};
PeerName each_peer() { return GENERATE(PeerName{"box2d", "Box2D"}, PeerName{"chipmunk", "Chipmunk"}); }

/// A collection with "ball", which falls freely for half a second: 30 steps at 60 a second.
class PeerCollection : public Collection {
 public:
  explicit PeerCollection(const std::string& extra = "") { write("ball", falling_ball(extra)); }
  Outcome run_ball(const PeerName& peer, const std::vector<std::string>& options = {}) const {
    std::vector<std::string> arguments{"run", "ball", "--peer", peer.option, "--set", "rate=60"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run(arguments);
  }
};

TEST_CASE("run --peer reports a free fall as the peer's Euler steps add up, and says who stepped it", "[cli]") {
  const PeerCollection c;
  const PeerName peer = each_peer();
  const Outcome o = c.run_ball(peer, {"--json", "--csv", "y.csv"});
  REQUIRE(o.err.empty());
  REQUIRE(o.status == 0);
  const Json json = Json::parse(o.out);
  REQUIRE(json.at("ticks") == 30);
  const Json& engine = json.at("engine");
  REQUIRE(engine.at("name") == peer.name);
  REQUIRE_THAT(engine.at("version").get<std::string>(), Catch::Matchers::Matches("[0-9]+\\.[0-9]+\\.[0-9]+"));
  REQUIRE(engine.at("settings").at("steps_per_second") == 60);
  // Box2D moves by the new velocity, Chipmunk by the old one.
  const double fall = 9.81 / 3600 * 30 * (peer.option == "box2d" ? 31 : 29) / 2;
  const Json& y = json.at("measures").at("y");
  REQUIRE(y.at("final").get<double>() == Approx(5 - fall).margin(1e-5));
  REQUIRE(y.at("max_error").get<double>() == Approx(9.81 * 0.5 / 60 / 2).margin(1e-5));
  REQUIRE(json.at("energy_grew").is_null());
  const std::string table = read_text(c / "y.csv");
  REQUIRE(std::count(table.begin(), table.end(), '\n') == 32);
}

TEST_CASE("A peer's settings are its declared ones, and our engine names itself without any", "[cli]") {
  const PeerCollection c;
  const auto engine = [&](const std::vector<std::string>& words) { return Json::parse(c.run(words).out).at("engine"); };
  const Json box2d = engine({"run", "ball", "--json", "--peer", "box2d"}).at("settings");
  REQUIRE(
      box2d ==
      Json{{"steps_per_second", 240}, {"precision", "single"}, {"velocity_iterations", 8}, {"position_iterations", 3}});
  const Json chipmunk = engine({"run", "ball", "--json", "--peer", "chipmunk"}).at("settings");
  REQUIRE(chipmunk ==
          Json{{"steps_per_second", 240}, {"precision", "double"}, {"iterations", 10}, {"collision_slop", 0.005}});
  const Json own = engine({"run", "ball", "--json"});
  REQUIRE(own.at("name") == "proofreel");
  REQUIRE(own.at("settings").is_null());
}

TEST_CASE("The text of a peer's run is nobody's to mistake for ours", "[cli]") {
  const PeerCollection c;
  const PeerName peer = each_peer();
  REQUIRE_THAT(c.run_ball(peer).out, Contains("stepped by " + peer.name) && Contains("not by proofreel") &&
                                         Contains("steps_per_second=60") && Contains("the hashes are its own") &&
                                         Contains("work done during steps included"));
  REQUIRE_THAT(c.run({"run", "ball"}).out, !Contains("stepped by") && !Contains("included"));
}

TEST_CASE("A peer's box rests on the floor within its own skin or slop", "[cli]") {
  const Collection c;
  c.write("rest",
          "scenario { duration = 2, rate = 60 }\nground { y = 0 }\n"
          "local b = body { at = {0, 0.5}, shape = box { width = 1, height = 1 } }\n"
          "measure('y', function() return b:position().y end)\n"
          "expect('it stays', function() return math.abs(b:position().y - 0.5) < 0.02 end, { always = true })\n"
          "expect('the floor carries its weight', function()\n"
          "  local sum = 0\n"
          "  for _, contact in ipairs(contacts(b)) do sum = sum + contact.impulse end\n"
          "  return math.abs(sum - 9.81 / 60) < 1e-4\n"
          "end)\n");
  const Outcome o = c.run({"run", "rest", "--peer", each_peer().option});
  CAPTURE(o.out, o.err);
  REQUIRE(o.status == 0);
}

TEST_CASE("A peer's run fails by the expectations that do not hold, as any other", "[cli]") {
  const PeerCollection c("expect('the ball rises', function() return ball:position().y > 5 end)\n");
  const Outcome o = c.run_ball(each_peer(), {"--json"});
  REQUIRE(o.status == 1);
  REQUIRE_THAT(o.err, Contains("the ball rises"));
  REQUIRE(Json::parse(o.out).at("expectations").at(0).at("held") == false);
}

TEST_CASE("The same scene gives a peer the same hashes twice, and other ones than ours", "[cli]") {
  const PeerCollection c;
  const PeerName peer = each_peer();
  const auto hash = [](const Outcome& o) { return Json::parse(o.out).at("trajectory_hash").get<std::string>(); };
  const std::string first = hash(c.run_ball(peer, {"--json"}));
  REQUIRE(first == hash(c.run_ball(peer, {"--json"})));
  REQUIRE(first != hash(c.run({"run", "ball", "--set", "rate=60", "--json"})));
}

TEST_CASE("What a peer does not know is one sentence that names the body, at the start and on the way", "[cli]") {
  const Collection c;
  const std::string roller = "body { name = 'roller', shape = circle { radius = 1 }, rolling_resistance = 0.1 }";
  c.write("now", "scenario { duration = 1 }\n" + roller);
  c.write("later", "scenario { duration = 1 }\nat(0.5, function() " + roller + " end)");
  const PeerName peer = each_peer();
  const std::string sentence = peer.name + " cannot step body \"roller\": it has rolling resistance";
  const Outcome now = c.run({"run", "now", "--peer", peer.option});
  REQUIRE(now.status == 2);
  REQUIRE(now.out.empty());
  REQUIRE_THAT(now.err, Contains("now.lua: " + sentence));
  const Outcome later = c.run({"run", "later", "--peer", peer.option, "--csv", "later.csv"});
  REQUIRE(later.status == 2);
  REQUIRE(later.out.empty());
  REQUIRE_THAT(later.err, Contains("later.lua: line 2: " + sentence) && Contains("at 0.5 s"));
  REQUIRE_FALSE(std::filesystem::exists(c / "later.csv"));
}

TEST_CASE("A motion that becomes infinite, or a peer that gives up, ends with a sentence", "[cli]") {
  const Collection c;
  c.write("wild",
          "scenario { duration = 1, rate = 60 }\nlocal a = body { at = {0, 0.3}, shape = circle { radius = 0.5 } }\n"
          "local b = body { at = {0, 0.4}, shape = circle { radius = 0.5 } }\n"
          "field(function() return 0, -1e308 end)\nrevolute { a, b, at = {3, 3} }\n");
  const PeerName peer = each_peer();
  const Outcome o = c.run({"run", "wild", "--peer", peer.option});
  CAPTURE(o.err);
  REQUIRE(o.status == 2);
  REQUIRE(o.out.empty());
  REQUIRE_THAT(o.err, Contains("became infinite") || Contains("The peer cannot step this scene any further"));
}

TEST_CASE("What makes no sense with a peer is refused", "[cli]") {
  const PeerCollection c;
  const Refusals wrong{
      {{"--peer", "havok"}, "There is no peer \"havok\": known are \"box2d\" and \"chipmunk\"."},
      {{"--peer", "Box2D"}, "There is no peer \"Box2D\""},
      {{"--peer"}, "--peer"},
      {{"--peer="}, "--peer"},
      {{"--peer", "box2d", "--peer", "chipmunk"}, "--peer"},
      {{"--peer", "box2d", "--save", "0.1:a.run"}, "--save excludes --peer"},
      {{"--peer", "box2d", "--resume", "a.run"}, "--peer"},
      {{"--peer", "box2d", "--set", "substeps=4"}, "--set method.substeps=4 says how our own engine steps"},
      {{"--peer", "chipmunk", "--set", "method.precision=single"}, "Chipmunk has a method of its own"},
      {{"--peer", "box2d", "--set", "integrator=symplectic_euler"}, "leave out either this or --peer"},
      {{"--peer", "box2d", "--set", "effects={contacts}"}, "cannot leave out"}};
  require_refused(c, {"run", "ball"}, wrong);
  REQUIRE_FALSE(std::filesystem::exists(c / "a.run"));
  REQUIRE(c.run({"run", "ball", "--peer", "box2d", "--set", "duration=0.25"}).status == 0);
}

}  // namespace
}  // namespace proofreel
