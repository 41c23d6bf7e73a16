#include "golden/state_change.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "golden/words.h"
#include "scenarios/formatted.h"

namespace proofreel {
namespace {

constexpr double degrees = 57.29577951308232;
constexpr std::size_t most_names = 3;

/// Turns below this many degrees are noise beside a movement.
constexpr double least_turn = 1e-3;

std::string short_number(double value) { return formatted(value < 99.5 ? "%.2g" : "%.0f", value); }

std::string text_of(const BodyMove& move) {
  std::string text;
  if (move.distance > 0) text.append("moved ").append(short_number(move.distance)).append(" m");
  if (degrees * move.turn >= least_turn || (move.turn > 0 && move.distance == 0)) {
    text.append(text.empty() ? "turned " : ", turned ").append(short_number(degrees * move.turn)).append(" deg");
  }
  return text;
}

bool is_farther(const BodyMove& a, const BodyMove& b) {
  return a.distance != b.distance ? a.distance > b.distance : a.turn > b.turn;
}

/// Both lists are in order of id.
void compare_bodies(const std::vector<BodyPose>& then, const std::vector<BodyPose>& now, StateChange& change) {
  auto a = then.begin(), b = now.begin();
  while (a != then.end() || b != now.end()) {
    if (b == now.end() || (a != then.end() && a->id < b->id)) {
      change.gone.push_back((a++)->id);
    } else if (a == then.end() || b->id < a->id) {
      change.appeared.push_back((b++)->id);
    } else {
      const double dx = b->x - a->x, dy = b->y - a->y;
      const BodyMove move{b->id, std::sqrt(dx * dx + dy * dy), std::fabs(b->angle - a->angle)};
      if (move.distance > 0 || move.turn > 0) change.moved.push_back(move);
      ++a, ++b;
    }
  }
  std::stable_sort(change.moved.begin(), change.moved.end(), is_farther);
}

/// "a, b and 4 more".
std::string list_of(const std::vector<std::string>& names) {
  std::string text;
  const std::size_t shown = names.size() > most_names + 1 ? most_names : names.size();
  for (std::size_t i = 0; i < shown; ++i) {
    if (i > 0) text.append(i + 1 == names.size() ? " and " : ", ");
    text.append(names[i]);
  }
  if (shown < names.size())
    text.append(" and ").append(count_text(static_cast<std::int64_t>(names.size() - shown))).append(" more");
  return text;
}

void append(std::string& text, const std::string& part) { text.append(text.empty() ? "" : "; ").append(part); }

void append_bodies(std::string& text, const std::vector<std::uint32_t>& bodies, const char* what,
                   const BodyNames& names) {
  if (bodies.empty()) return;
  std::vector<std::string> list;
  for (const std::uint32_t body : bodies) list.push_back(names.of(body));
  append(text, list_of(list).append(bodies.size() == 1 ? " is " : " are ").append(what));
}

void append_contacts(std::string& text, const std::vector<Touch>& contacts, const char* what, const BodyNames& names) {
  if (contacts.empty()) return;
  std::vector<std::string> list;
  for (const Touch& touch : contacts) list.push_back(words({names.of(touch.a), " - ", names.of(touch.b)}));
  append(text,
         std::string(contacts.size() == 1 ? "contact " : "contacts ").append(list_of(list)).append(" ").append(what));
}

std::string sentence_about_moves(const std::vector<BodyMove>& moved, const BodyNames& names) {
  const std::string farthest = words({names.of(moved.front().body), " ", text_of(moved.front())});
  if (moved.size() == 1) return farthest;
  return words({farthest, ", the farthest of ", count_text(static_cast<std::int64_t>(moved.size())), " bodies"});
}

}  // namespace

void BodyNames::add(const std::vector<BodyPose>& bodies) {
  for (const BodyPose& body : bodies) {
    if (names_.try_emplace(body.id, body.name).second) ++uses_[body.name];
  }
}

std::uint32_t BodyNames::largest_id() const { return names_.empty() ? 0 : names_.rbegin()->first; }

std::string BodyNames::of(std::uint32_t body) const {
  if (body == 0) return "the world";
  const std::string number = words({"body ", std::to_string(body)});
  const auto found = names_.find(body);
  if (found == names_.end() || found->second.empty()) return number;
  return uses_.at(found->second) == 1 ? found->second : words({found->second, " (", number, ")"});
}

std::string StateChange::fate_of(std::uint32_t body) const {
  const auto is_it = [body](const BodyMove& move) { return move.body == body; };
  const auto move = std::find_if(moved.begin(), moved.end(), is_it);
  if (move != moved.end()) return text_of(*move);
  if (std::binary_search(appeared.begin(), appeared.end(), body)) return "new";
  return std::binary_search(gone.begin(), gone.end(), body) ? "gone" : "";
}

StateChange change_between(const GoldenFrame& then, const ObservedFrame& now) {
  StateChange change;
  compare_bodies(then.bodies, now.bodies, change);
  if (!then.touching) return change;
  std::set_difference(now.touching.begin(), now.touching.end(), then.touching->begin(), then.touching->end(),
                      std::back_inserter(change.met));
  std::set_difference(then.touching->begin(), then.touching->end(), now.touching.begin(), now.touching.end(),
                      std::back_inserter(change.parted));
  return change;
}

std::string sentence_about(const StateChange& change, const BodyNames& names) {
  std::string text;
  append_bodies(text, change.gone, "gone", names);
  append_bodies(text, change.appeared, "new", names);
  if (!change.moved.empty()) append(text, sentence_about_moves(change.moved, names));
  append_contacts(text, change.parted, "gone", names);
  append_contacts(text, change.met, "new", names);
  return text.empty() ? "no body stands elsewhere, so it is velocities or the way there that differ" : text;
}

}  // namespace proofreel
