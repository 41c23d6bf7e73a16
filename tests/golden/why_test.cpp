#include "golden/why.h"

#include <catch2/catch.hpp>

#include "golden/compare.h"

namespace proofreel {
namespace {

constexpr int side = 40;

/// Two pictures of squares of one colour each, and whose they are.
class Pair {
 public:
  /// A square of 4 x 4 pixels; its grey value is its owner's place.
  void then(const Owner& owner, int x, int y) { paint(owners_then_, expected_, owner, x, y); }
  void now(const Owner& owner, int x, int y) { paint(owners_now_, actual_, owner, x, y); }
  void both(const Owner& owner, int x, int y) { then(owner, x, y), now(owner, x, y); }
  /// Another grey there, without another owner.
  void spoil(int x, int y) { actual_.row(y)[4 * x] = 77; }

  std::int64_t different() const { return compare(expected_, actual_, 0).different; }

  std::vector<Cause> causes(const StateChange& change, bool same_state, bool knows_then = true) const {
    BodyNames names;
    names.add({{1, "a", 0, 0, 0}, {2, "b", 0, 0, 0}});
    return causes_of({expected_, actual_, knows_then ? &owners_then_ : nullptr, owners_now_, change, same_state},
                     names);
  }

 private:
  static OwnerPicture nobody() { return {side, side, {Owner{}}, std::vector<std::uint32_t>(side * side, 0)}; }

  void paint(OwnerPicture& owners, Image& image, const Owner& owner, int x, int y) {
    const auto index = static_cast<std::uint32_t>(owners.owners.size());
    owners.owners.push_back(owner);
    for (int v = y; v < y + 4; ++v) {
      for (int u = x; u < x + 4; ++u) {
        owners.indices[static_cast<std::size_t>(v * side + u)] = index;
        image.row(v)[4 * u] = static_cast<std::uint8_t>(100 + 10 * owner.a + static_cast<unsigned>(owner.kind));
      }
    }
  }

  Image expected_{side, side}, actual_{side, side};
  OwnerPicture owners_then_ = nobody(), owners_now_ = nobody();
};

const Owner a{OwnerKind::body, 1}, b{OwnerKind::body, 2}, contact{OwnerKind::contact, 1, 2};
const Owner label{OwnerKind::label, 2, 0, "speed"};

StateChange moved(std::uint32_t body) {
  StateChange change;
  change.moved.push_back({body, 0.41, 0.2});
  return change;
}

TEST_CASE("A body that moved explains the place it left and the one it came to", "[why]") {
  Pair pair;
  pair.then(a, 5, 5);
  pair.now(a, 20, 5);
  pair.both(b, 5, 20);
  const auto causes = pair.causes(moved(1), false);
  REQUIRE(causes.size() == 1);
  CHECK(causes[0].name == "a");
  CHECK(causes[0].change == "moved 0.41 m, turned 11 deg");
  CHECK(causes[0].pixels == 32);
  CHECK(causes[0].explains);
  CHECK(share_explained(causes) == "Explains all of 32 differing pixels.");
}

TEST_CASE("What stands still does not explain the pixels that differ in it", "[why]") {
  Pair pair;
  pair.then(a, 5, 5);
  pair.now(a, 6, 5);
  pair.both(label, 20, 20);
  pair.spoil(21, 21);
  const auto causes = pair.causes(moved(1), false);
  REQUIRE(causes.size() == 2);
  CHECK_FALSE(causes[1].explains);
  CHECK(share_explained(causes) == "Explains 88 % of 9 differing pixels; the rest is near label \"speed\".");
}

TEST_CASE("A pixel of the background is told with what is nearest to it, if anything is near", "[why]") {
  Pair pair;
  pair.both(label, 20, 20);
  pair.spoil(26, 22);
  CHECK(pair.causes({}, true)[0].name == "label \"speed\"");
  Pair far;
  far.both(label, 0, 0);
  far.spoil(35, 35);
  CHECK(far.causes({}, true)[0].name == "the background");
}

TEST_CASE("What is drawn in one of the pictures only has changed, even in an equal state", "[why]") {
  Pair pair;
  pair.then(contact, 5, 5);
  pair.now({OwnerKind::caption, 0, 0, "new"}, 20, 20);
  const auto causes = pair.causes({}, true);
  REQUIRE(causes.size() == 2);
  CHECK(causes[0].name == "caption \"new\"");
  CHECK(causes[0].change == "drawn only now");
  CHECK(causes[1].name == "contact a - b");
  CHECK(causes[1].change == "not drawn any more");
  CHECK(whereabouts(causes) ==
        "They are in caption \"new\" (drawn only now: 16) and contact a - b (not drawn any more: 16).");
}

TEST_CASE("All marks of a kind that vanish together are one cause", "[why]") {
  Pair pair;
  pair.then(contact, 5, 5);
  pair.then({OwnerKind::contact, 2, 3}, 15, 15);
  const auto causes = pair.causes({}, true);
  REQUIRE(causes.size() == 1);
  CHECK(causes[0].name == "all contact marks");
  CHECK(causes[0].pixels == 32);
}

TEST_CASE("Three and more of a kind are told together", "[why]") {
  Pair pair;
  for (int i = 0; i < 4; ++i) {
    pair.both({OwnerKind::label, 0, 0, "label " + std::to_string(i)}, 8 * i, 20);
    pair.spoil(8 * i + 1, 21);
    pair.spoil(8 * i + 2, 22);
  }
  pair.both(a, 5, 5);
  pair.spoil(6, 6);
  CHECK(whereabouts(pair.causes({}, true)) == "They are in label \"label 0\" and 3 more labels (8) and a (1).");
}

TEST_CASE("Without the owners of then, those of now are asked alone", "[why]") {
  Pair pair;
  pair.then(a, 5, 5);
  pair.now(a, 20, 5);
  const auto causes = pair.causes(moved(1), false, false);
  REQUIRE(causes.size() == 2);
  CHECK(causes[0].pixels == 16);
  CHECK(causes[1].name == "the background");
}

TEST_CASE("What shows how bodies got there follows another state, wherever it stands", "[why]") {
  Pair pair;
  pair.both({OwnerKind::trail, 2}, 20, 20);
  pair.spoil(21, 21);
  CHECK_FALSE(pair.causes({}, true)[0].explains);
  CHECK(pair.causes({}, false)[0].explains);
}

TEST_CASE("Every pixel that differs is counted once", "[why]") {
  Pair pair;
  pair.then(a, 5, 5);
  pair.now(a, 7, 6);
  pair.now(b, 8, 8);
  pair.spoil(30, 30);
  std::int64_t sum = 0;
  for (const Cause& cause : pair.causes(moved(1), false)) sum += cause.pixels;
  CHECK(sum == pair.different());
}

}  // namespace
}  // namespace proofreel
