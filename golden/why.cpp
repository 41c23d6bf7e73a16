#include "golden/why.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <map>

#include "golden/words.h"

namespace proofreel {
namespace {

constexpr int near_px = 8;
constexpr const char* background = "the background";
constexpr std::size_t longest_text = 40;

std::string shortened(const std::string& text) {
  if (text.size() <= longest_text) return text;
  const std::size_t space = text.rfind(' ', longest_text);
  return words({text.substr(0, space == std::string::npos ? 0 : space), " ..."});
}

std::string name_of(const Owner& owner, const BodyNames& names) {
  const char* kind = name_of(owner.kind);
  switch (owner.kind) {
    case OwnerKind::nothing:
      return background;
    case OwnerKind::grid:
    case OwnerKind::water:
    case OwnerKind::clock:
    case OwnerKind::energy:
      return words({"the ", kind});
    case OwnerKind::bvh:
      return "the hierarchy";
    case OwnerKind::aabbs:
      return "the boxes of shapes";
    case OwnerKind::body:
      return names.of(owner.a);
    case OwnerKind::highlight:
      return owner.a == 0 ? "a highlight" : words({kind, " of ", names.of(owner.a)});
    case OwnerKind::trail:
    case OwnerKind::vector:
    case OwnerKind::mass:
    case OwnerKind::id:
      return words({kind, " of ", names.of(owner.a)});
    case OwnerKind::joint:
    case OwnerKind::contact:
    case OwnerKind::force:
      return words({kind, " ", names.of(owner.a), " - ", names.of(owner.b)});
    case OwnerKind::caption:
    case OwnerKind::plot:
    case OwnerKind::label:
    case OwnerKind::pane:
    case OwnerKind::note:
      return words({kind, " \"", shortened(owner.text), "\""});
  }
  return "";
}

/// Whether it shows what happened to bodies, or on the way, wherever it stands.
bool follows_state(OwnerKind kind) {
  switch (kind) {
    case OwnerKind::trail:
    case OwnerKind::vector:
    case OwnerKind::plot:
    case OwnerKind::bvh:
    case OwnerKind::aabbs:
    case OwnerKind::contact:
    case OwnerKind::joint:
    case OwnerKind::pane:
    case OwnerKind::force:
    case OwnerKind::mass:
    case OwnerKind::id:
    case OwnerKind::energy:
    case OwnerKind::highlight:
      return true;
    default:
      return false;
  }
}

bool has_body(const Owner& owner, std::uint32_t body) { return body != 0 && (owner.a == body || owner.b == body); }

bool concerns(const StateChange& change, const Owner& owner) {
  const auto is_its = [&owner](std::uint32_t body) { return has_body(owner, body); };
  return std::any_of(change.moved.begin(), change.moved.end(), [&](const BodyMove& m) { return is_its(m.body); }) ||
         std::any_of(change.appeared.begin(), change.appeared.end(), is_its) ||
         std::any_of(change.gone.begin(), change.gone.end(), is_its);
}

/// One owner of either picture.
struct Candidate {
  Owner owner;
  bool then = false;
  bool now = false;
  bool changed = false;
  std::int64_t explained = 0;    ///< pixels
  std::int64_t unexplained = 0;  ///< pixels
};

bool differs(const Image& a, const Image& b, int x, int y) {
  const std::size_t at = 4 * static_cast<std::size_t>(x);
  return std::memcmp(a.row(y) + at, b.row(y) + at, 4) != 0;
}

class Attribution {
 public:
  explicit Attribution(const TwoPictures& pictures) : p_(pictures) {
    now_ = enlist(p_.owners_now, &Candidate::now);
    if (p_.owners_then != nullptr) then_ = enlist(*p_.owners_then, &Candidate::then);
    for (Candidate& candidate : candidates_) candidate.changed = has_changed(candidate);
  }

  void attribute_all() {
    for (int y = 0; y < p_.actual.height_px; ++y) {
      if (std::memcmp(p_.expected.row(y), p_.actual.row(y), p_.actual.row_bytes()) == 0) continue;
      for (int x = 0; x < p_.actual.width_px; ++x) {
        if (differs(p_.expected, p_.actual, x, y)) attribute(x, y);
      }
    }
  }

  const std::vector<Candidate>& candidates() const { return candidates_; }
  bool knows_then() const { return p_.owners_then != nullptr; }

 private:
  /// Where the owners of a picture are among the candidates.
  std::vector<std::size_t> enlist(const OwnerPicture& picture, bool Candidate::*where) {
    std::vector<std::size_t> places;
    for (const Owner& owner : picture.owners) {
      const auto [place, is_new] = place_of_.try_emplace(owner, candidates_.size());
      if (is_new) candidates_.push_back({owner});
      candidates_[place->second].*where = true;
      places.push_back(place->second);
    }
    return places;
  }

  bool has_changed(const Candidate& candidate) const {
    if (candidate.owner.kind == OwnerKind::nothing) return false;
    if (knows_then() && candidate.then != candidate.now) return true;
    if (concerns(p_.change, candidate.owner)) return true;
    return !p_.same_state && follows_state(candidate.owner.kind);
  }

  Candidate& now_at(int x, int y) { return candidates_[now_[p_.owners_now.index_at(x, y)]]; }
  Candidate& then_at(int x, int y) {
    return knows_then() ? candidates_[then_[p_.owners_then->index_at(x, y)]] : now_at(x, y);
  }

  void attribute(int x, int y) {
    Candidate &now = now_at(x, y), &then = then_at(x, y);
    if (now.changed) {
      ++now.explained;
    } else if (then.changed) {
      ++then.explained;
    } else if (now.owner.kind != OwnerKind::nothing) {
      ++now.unexplained;
    } else if (then.owner.kind != OwnerKind::nothing) {
      ++then.unexplained;
    } else {
      ++nearest(x, y).unexplained;
    }
  }

  /// The owner nearest to a pixel of the background, or the background.
  Candidate& nearest(int x, int y) {
    Candidate* best = &now_at(x, y);
    int least = near_px * near_px + 1;
    for (int v = std::max(0, y - near_px); v <= std::min(p_.actual.height_px - 1, y + near_px); ++v) {
      for (int u = std::max(0, x - near_px); u <= std::min(p_.actual.width_px - 1, x + near_px); ++u) {
        const int square = (u - x) * (u - x) + (v - y) * (v - y);
        if (square >= least || now_at(u, v).owner.kind == OwnerKind::nothing) continue;
        least = square;
        best = &now_at(u, v);
      }
    }
    return *best;
  }

  const TwoPictures& p_;
  std::map<Owner, std::size_t> place_of_;
  std::vector<Candidate> candidates_;
  std::vector<std::size_t> now_, then_;  ///< the candidates of each picture's owners
};

/// Owners of a kind that has vanished from the picture, or is new to it, as a whole: a layer, most often.
class WholeKinds {
 public:
  explicit WholeKinds(const std::vector<Candidate>& candidates) {
    for (const Candidate& candidate : candidates) {
      Count& count = counts_[static_cast<std::size_t>(candidate.owner.kind)];
      count.then += candidate.then ? 1 : 0;
      count.now += candidate.now ? 1 : 0;
    }
  }
  bool hold(const Owner& owner) const {
    const Count& count = counts_[static_cast<std::size_t>(owner.kind)];
    return owner.kind != OwnerKind::body && (count.then == 0 || count.now == 0) && count.then + count.now > 1;
  }

 private:
  struct Count {
    int then = 0, now = 0;
  };
  std::array<Count, owner_kind_names.size()> counts_{};
};

std::string change_of(const Candidate& candidate, const StateChange& change, bool knows_then) {
  const Owner& owner = candidate.owner;
  if (owner.kind == OwnerKind::body) {
    const std::string fate = change.fate_of(owner.a);
    if (!fate.empty()) return fate;
  }
  if (!knows_then || candidate.then == candidate.now) return "";
  return candidate.now ? "drawn only now" : "not drawn any more";
}

void add_cause(std::vector<Cause>& causes, Cause cause) {
  if (cause.pixels == 0) return;
  const auto is_same = [&cause](const Cause& c) { return c.name == cause.name && c.explains == cause.explains; };
  const auto found = std::find_if(causes.begin(), causes.end(), is_same);
  if (found == causes.end()) {
    causes.push_back(std::move(cause));
  } else {
    found->pixels += cause.pixels;
  }
}

std::int64_t sum_of(const std::vector<Cause>& causes) {
  std::int64_t sum = 0;
  for (const Cause& cause : causes) sum += cause.pixels;
  return sum;
}

/// Causes of one kind, the first of which is named, told as one.
Cause joined(const std::vector<Cause>& alike) {
  Cause whole = alike.front();
  const std::string kinds = whole.kind == OwnerKind::body ? "bodies" : words({name_of(whole.kind), "s"});
  whole.name.append(words({" and ", std::to_string(alike.size() - 1), " more ", kinds}));
  whole.pixels = sum_of(alike);
  return whole;
}

/// Three or more of one kind to which the same happened are told as one.
std::vector<Cause> grouped(const std::vector<Cause>& causes) {
  std::vector<Cause> groups, rest = causes;
  while (!rest.empty()) {
    const Cause first = rest.front();
    const auto is_like = [&first](const Cause& c) { return c.kind == first.kind && c.change == first.change; };
    const auto others = std::stable_partition(rest.begin(), rest.end(), is_like);
    const std::vector<Cause> alike(rest.begin(), others);
    if (alike.size() < 3)
      groups.insert(groups.end(), alike.begin(), alike.end());
    else
      groups.push_back(joined(alike));
    rest.erase(rest.begin(), others);
  }
  std::stable_sort(groups.begin(), groups.end(), [](const Cause& a, const Cause& b) { return a.pixels > b.pixels; });
  return groups;
}

std::string pixels_text(std::int64_t count) {
  return words({count_text(count), count == 1 ? " differing pixel" : " differing pixels"});
}

}  // namespace

std::vector<Cause> causes_of(const TwoPictures& pictures, const BodyNames& names) {
  Attribution attribution(pictures);
  attribution.attribute_all();
  const WholeKinds whole_kinds(attribution.candidates());
  std::vector<Cause> causes;
  for (const Candidate& candidate : attribution.candidates()) {
    const bool whole = attribution.knows_then() && whole_kinds.hold(candidate.owner);
    const std::string name =
        whole ? words({"all ", name_of(candidate.owner.kind), " marks"}) : name_of(candidate.owner, names);
    const std::string change = change_of(candidate, pictures.change, attribution.knows_then());
    add_cause(causes, {name, candidate.explained, change, true, candidate.owner.kind});
    add_cause(causes, {name, candidate.unexplained, change, false, candidate.owner.kind});
  }
  std::stable_sort(causes.begin(), causes.end(), [](const Cause& a, const Cause& b) {
    return a.explains != b.explains ? a.explains : a.pixels > b.pixels;
  });
  return causes;
}

std::string share_explained(const std::vector<Cause>& causes) {
  const std::int64_t all = sum_of(causes);
  if (all == 0) return "";
  std::int64_t explained = 0;
  for (const Cause& cause : causes) explained += cause.explains ? cause.pixels : 0;
  if (explained == all) return words({"Explains all of ", pixels_text(all), "."});
  const auto rest = std::find_if(causes.begin(), causes.end(), [](const Cause& c) { return !c.explains; });
  const char* place = rest->name == background ? "; the rest is in " : "; the rest is near ";
  const std::string percent = std::to_string(100 * explained / all);
  return words({"Explains ", percent, " % of ", pixels_text(all), place, rest->name, "."});
}

std::string whereabouts(const std::vector<Cause>& causes) {
  constexpr std::size_t most = 3;
  if (causes.empty()) return "";
  const std::vector<Cause> groups = grouped(causes);
  std::string text = "They are in ";
  const std::size_t shown = groups.size() > most + 1 ? most : groups.size();
  for (std::size_t i = 0; i < shown; ++i) {
    text.append(i == 0 ? "" : i + 1 == groups.size() ? " and " : ", ").append(groups[i].name).append(" (");
    if (!groups[i].change.empty()) text.append(groups[i].change).append(": ");
    text.append(count_text(groups[i].pixels)).append(")");
  }
  const std::int64_t rest = sum_of({groups.begin() + static_cast<std::ptrdiff_t>(shown), groups.end()});
  if (rest > 0) text.append(" and elsewhere (").append(count_text(rest)).append(")");
  return text + ".";
}

}  // namespace proofreel
