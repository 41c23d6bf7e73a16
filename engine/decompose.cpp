#include "engine/decompose.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <limits>

#include "engine/outline.h"
#include "engine/polygon.h"
#include "engine/scene.h"

namespace proofreel {
namespace {

using Points = std::vector<Vec2d>;
using Index = std::uint16_t;  ///< of a corner of the outline

constexpr int never = std::numeric_limits<int>::max() / 4;  ///< parts of what cannot be cut

/// A square table over pairs of corners.
template <typename Value>
class PairTable {
 public:
  PairTable(std::size_t n, const Value& value) : n_(n), values_(n * n, value) {}
  Value& at(std::size_t i, std::size_t j) { return values_[i * n_ + j]; }
  const Value& at(std::size_t i, std::size_t j) const { return values_[i * n_ + j]; }

 private:
  std::size_t n_;
  std::vector<Value> values_;
};

/// How two corners of the outline see each other.
enum class Sight : std::uint8_t {
  blocked,  ///< the outline lies between them
  grazing,  ///< the way touches the outline, or is not known to be inside; it cannot be cut along
  clear     ///< neighbours on the outline, or a diagonal with nothing of the outline on it
};

/// Whether the way from corner i to corner j sets out into the inside; `grazing` when along an edge.
Sight sight_at_corner(const Points& outline, std::size_t i, std::size_t j) {
  const std::size_t n = outline.size();
  const Vec2d before = outline[(i + n - 1) % n];
  const Vec2d here = outline[i];
  const Vec2d after = outline[(i + 1) % n];
  const double left_of_after = orientation(here, after, outline[j]);
  const double left_of_before = orientation(before, here, outline[j]);
  const bool convex = orientation(before, here, after) > 0;
  const double worse = std::min(left_of_after, left_of_before);
  const double better = std::max(left_of_after, left_of_before);
  const double inside = convex ? worse : better;
  if (inside > 0) return Sight::clear;
  return inside < 0 ? Sight::blocked : Sight::grazing;
}

Sight sight_between(const Points& outline, std::size_t i, std::size_t j) {
  const std::size_t n = outline.size();
  if (j == i + 1 || (i == 0 && j == n - 1)) return Sight::clear;
  Sight sight = std::min(sight_at_corner(outline, i, j), sight_at_corner(outline, j, i));
  for (std::size_t k = 0; k < n && sight != Sight::blocked; ++k) {
    const std::size_t next = (k + 1) % n;
    if (k == i || k == j || next == i || next == j) continue;
    if (segments_cross(outline[i], outline[j], outline[k], outline[next])) return Sight::blocked;
    if (segments_meet(outline[i], outline[j], outline[k], outline[next])) sight = Sight::grazing;
  }
  return sight;
}

/// A convex chain i, first, ..., last, j of corners of the outline with i < first <= last < j: the rim of the part that
/// lies at the way from i to j, as far as it is known from this side. Everything behind its links is cut already.
struct Chain {
  int parts = 0;    ///< behind its links
  int corners = 0;  ///< it turns at, i and j not counted
  Index first = 0;
  Index last = 0;
  int before = -1;        ///< the chain from i to `last` that it makes longer, as an index; -1: `last` is `first`
  bool closable = false;  ///< it makes a sound part together with the way from j back to i
  /// How thick that part is: the thicker, the sooner does a longer chain make a sound one. Infinite when it is sound,
  /// or when thickness is not looked at.
  double width = std::numeric_limits<double>::infinity();
};

/// The width of the narrowest strip along one of its edges.
double width_of(const Points& part) {
  double width = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < part.size(); ++i) {
    const Vec2d a = part[i];
    const Vec2d b = part[(i + 1) % part.size()];
    double height = 0;
    for (const Vec2d p : part) height = std::max(height, orientation(a, b, p) / distance(a, b));
    width = std::min(width, height);
  }
  return part.empty() ? 0 : width;
}

bool is_sound_part(const Points& part) { return std::holds_alternative<Points>(clean_polygon(part)); }

enum class Thickness : std::uint8_t { any, sound };

/// The chains between all pairs of corners, shorter ones first.
class Decomposition {
 public:
  /// Looking at the thickness of the parts takes longer, and is only needed when one turns out too thin without.
  Decomposition(const Points& outline, const PairTable<Sight>& sight, Thickness thickness);

  /// Always, when parts may be thin.
  bool found() const { return parts_.at(0, outline_.size() - 1) < never; }

  template <typename Observer>
  ConvexParts parts(Observer observer) const {
    ConvexParts parts;
    collect(0, outline_.size() - 1, parts, observer);
    return parts;
  }

 private:
  void solve_pair(std::size_t i, std::size_t j);
  void prolong(std::size_t i, std::size_t l, std::size_t j);
  void add(std::size_t i, std::size_t j, Chain chain);
  void close(std::size_t i, std::size_t j);
  bool can_be_link(std::size_t i, std::size_t j) const {
    return sight_.at(i, j) == Sight::clear && parts_.at(i, j) < never;
  }
  void look_at_thickness(std::size_t i, std::size_t j, Chain& chain) const;
  bool can_replace(std::size_t i, std::size_t j, const Chain& a, const Chain& b) const;
  double side(std::size_t a, std::size_t b, std::size_t c) const {
    return orientation(outline_[a], outline_[b], outline_[c]);
  }
  std::vector<std::size_t> corners_of(std::size_t i, std::size_t j, Chain chain) const;
  Points part_of(const std::vector<std::size_t>& corners) const;
  template <typename Observer>
  void collect(std::size_t i, std::size_t j, ConvexParts& parts, Observer observer) const;

  const Points& outline_;
  const PairTable<Sight>& sight_;
  PairTable<std::vector<Chain>> chains_;
  PairTable<int> parts_;  ///< the fewest between the way from i to j and the outline
  std::vector<bool> concave_;
  bool only_thick_;
};

Decomposition::Decomposition(const Points& outline, const PairTable<Sight>& sight, Thickness thickness)
    : outline_(outline),
      sight_(sight),
      chains_(outline.size(), {}),
      parts_(outline.size(), never),
      only_thick_(thickness == Thickness::sound) {
  const std::size_t n = outline.size();
  for (std::size_t i = 0; i < n; ++i) concave_.push_back(side((i + n - 1) % n, i, (i + 1) % n) <= 0);
  for (std::size_t i = 0; i + 1 < n; ++i) parts_.at(i, i + 1) = 0;
  for (std::size_t span = 2; span < n; ++span) {
    for (std::size_t i = 0; i + span < n; ++i) solve_pair(i, i + span);
  }
}

/// Finds all chains from i to j worth keeping, and the number of parts when the best of them is closed.
void Decomposition::solve_pair(std::size_t i, std::size_t j) {
  if (sight_.at(i, j) == Sight::blocked) return;
  for (std::size_t l = i + 1; l < j; ++l) {
    if (!can_be_link(l, j)) continue;
    const double turn = side(i, l, j);
    if (turn < 0) continue;
    const auto link = static_cast<Index>(l);
    if (can_be_link(i, l)) add(i, j, {parts_.at(i, l) + parts_.at(l, j), turn > 0 ? 1 : 0, link, link});
    prolong(i, l, j);
  }
  close(i, j);
}

/// Adds the link from l to j to every chain from i to l that stays convex by it.
void Decomposition::prolong(std::size_t i, std::size_t l, std::size_t j) {
  const std::vector<Chain>& chains = chains_.at(i, l);
  for (std::size_t c = 0; c < chains.size(); ++c) {
    const Chain& chain = chains[c];
    const double turn = side(chain.last, l, j);
    if (turn < 0 || side(i, chain.first, j) < 0) continue;
    add(i, j,
        {chain.parts + parts_.at(l, j), chain.corners + (turn > 0 ? 1 : 0), chain.first, static_cast<Index>(l),
         static_cast<int>(c)});
  }
}

void Decomposition::add(std::size_t i, std::size_t j, Chain chain) {
  if (chain.corners > max_polygon_vertices) return;
  const int ends = (side(j, i, chain.first) > 0 ? 1 : 0) + (side(chain.last, j, i) > 0 ? 1 : 0);
  chain.closable = sight_.at(i, j) == Sight::clear && chain.corners + ends <= max_polygon_vertices;
  std::vector<Chain>& chains = chains_.at(i, j);
  const auto replaced_by_one = [&] {
    return std::any_of(chains.begin(), chains.end(), [&](const Chain& c) { return can_replace(i, j, c, chain); });
  };
  if (replaced_by_one()) return;
  if (only_thick_) {
    look_at_thickness(i, j, chain);
    if (replaced_by_one()) return;
  }
  std::erase_if(chains, [&](const Chain& c) { return can_replace(i, j, chain, c); });
  chains.push_back(chain);
}

void Decomposition::look_at_thickness(std::size_t i, std::size_t j, Chain& chain) const {
  const Points part = part_of(corners_of(i, j, chain));
  if (is_sound_part(part)) return;
  chain.closable = false;
  chain.width = width_of(part);
}

/// A chain with no fewer parts behind it than the whole has when it is cut off here is of no more use: the cut leaves
/// the chains that come after the most freedom. Except to be thick: what begins at the cut is thin again.
void Decomposition::close(std::size_t i, std::size_t j) {
  std::vector<Chain>& chains = chains_.at(i, j);
  int& parts = parts_.at(i, j);
  for (const Chain& chain : chains) {
    if (chain.closable) parts = std::min(parts, chain.parts + 1);
  }
  if (!only_thick_) std::erase_if(chains, [&](const Chain& c) { return c.parts >= parts; });
  chains.shrink_to_fit();
}

/// Whether `a` can take the place of `b` in every part: the angle at a convex corner of the outline never matters.
bool Decomposition::can_replace(std::size_t i, std::size_t j, const Chain& a, const Chain& b) const {
  if (a.parts > b.parts || a.corners > b.corners || a.closable < b.closable || a.width < b.width) return false;
  return (!concave_[i] || side(i, b.first, a.first) >= 0) && (!concave_[j] || side(j, a.last, b.last) >= 0);
}

/// From i to j.
std::vector<std::size_t> Decomposition::corners_of(std::size_t i, std::size_t j, Chain chain) const {
  std::vector<std::size_t> corners{j, chain.last};
  while (chain.before >= 0) {
    chain = chains_.at(i, chain.last)[static_cast<std::size_t>(chain.before)];
    corners.push_back(chain.last);
  }
  corners.push_back(i);
  std::reverse(corners.begin(), corners.end());
  return corners;
}

Points Decomposition::part_of(const std::vector<std::size_t>& corners) const {
  const std::size_t n = corners.size();
  Points part;
  for (std::size_t k = 0; k < n; ++k) {
    if (side(corners[(k + n - 1) % n], corners[k], corners[(k + 1) % n]) > 0) part.push_back(outline_[corners[k]]);
  }
  return part;
}

template <typename Observer>
void Decomposition::collect(std::size_t i, std::size_t j, ConvexParts& parts, Observer observer) const {
  const std::vector<Chain>& chains = chains_.at(i, j);
  const auto best = std::find_if(chains.begin(), chains.end(),
                                 [&](const Chain& c) { return c.closable && c.parts + 1 == parts_.at(i, j); });
  const std::vector<std::size_t> corners = corners_of(i, j, *best);
  parts.push_back(part_of(corners));
  for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
    if (corners[k + 1] == corners[k] + 1) continue;
    if constexpr (Observer::watches)
      observer([&] { return CutChosen{outline_[corners[k]], outline_[corners[k + 1]]}; });
    collect(corners[k], corners[k + 1], parts, observer);
  }
}

/// The corner of a part that is nearest to being straight: what makes a thin part thin.
Vec2d flattest_corner(const Points& part) {
  const std::size_t n = part.size();
  Vec2d flattest;
  double least = 2;
  for (std::size_t k = 0; k < n; ++k) {
    const Vec2d back = normalized(part[(k + n - 1) % n] - part[k]);
    const Vec2d ahead = normalized(part[(k + 1) % n] - part[k]);
    if (dot(back, ahead) >= least) continue;
    least = dot(back, ahead);
    flattest = part[k];
  }
  return flattest;
}

std::string in_words(double x) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.10g", x);
  return text.data();
}

std::string thinness_sentence(Vec2d corner) {
  return "however it is cut into convex parts, one at its corner {" + in_words(corner.x) + ", " + in_words(corner.y) +
         "} is thinner than a millionth of its extent: move that corner or leave it out";
}

PairTable<Sight> all_sights(const Points& outline) {
  const std::size_t n = outline.size();
  PairTable<Sight> sight(n, Sight::blocked);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) sight.at(i, j) = sight_between(outline, i, j);
  }
  return sight;
}

}  // namespace

template <typename Observer>
std::variant<ConvexParts, std::string> convex_parts(const std::vector<Vec2d>& outline, Observer observer) {
  if (outline.size() <= max_polygon_vertices && is_convex(outline)) return ConvexParts{outline};
  const PairTable<Sight> sight = all_sights(outline);
  const Decomposition decomposition(outline, sight, Thickness::any);
  const ConvexParts parts = decomposition.parts(NoObserver{});
  const auto thin = std::find_if_not(parts.begin(), parts.end(), is_sound_part);
  if (thin == parts.end()) return decomposition.parts(observer);
  const Decomposition thicker(outline, sight, Thickness::sound);
  if (!thicker.found()) return thinness_sentence(flattest_corner(*thin));
  return thicker.parts(observer);
}

template std::variant<ConvexParts, std::string> convex_parts<NoObserver>(const std::vector<Vec2d>&, NoObserver);
template std::variant<ConvexParts, std::string> convex_parts<Observer>(const std::vector<Vec2d>&, Observer);

}  // namespace proofreel
