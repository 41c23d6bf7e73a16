#include "scenarios/lua_watch.h"

#include <set>
#include <string_view>

#include "engine/bits.h"
#include "engine/state_hash.h"
#include "scenarios/lua_values.h"

namespace proofreel {
namespace {

constexpr int most_values = 100'000;
constexpr int deepest = 100;

/// All functions take the value on top of the stack and leave it there.
class Walk {
 public:
  explicit Walk(lua_State* state) : state_(state) {}

  void look_into_function() {
    if (!functions_.insert(lua_topointer(state_, -1)).second || !goes_on()) return;
    ++depth_;
    for (int i = 1;; ++i) {
      const char* name = lua_getupvalue(state_, -1, i);
      if (name == nullptr) break;
      if (std::string_view(name) == "_ENV" && lua_type(state_, -1) == LUA_TTABLE) {
        look_at_globals();
      } else {
        look_at(name);
      }
      lua_pop(state_, 1);
    }
    --depth_;
  }
  bool too_much() const { return too_much_; }
  const SeenVariables& seen() const { return seen_; }

 private:
  bool goes_on() {
    too_much_ = too_much_ || ++values_ > most_values || depth_ > deepest;
    if (!too_much_) luaL_checkstack(state_, 8, nullptr);
    return !too_much_;
  }

  void look_at_globals() {
    if (!tables_.insert({lua_topointer(state_, -1), 0}).second || !goes_on()) return;
    for (lua_pushnil(state_); lua_next(state_, -2) != 0; lua_pop(state_, 1)) {
      look_at(lua_type(state_, -2) == LUA_TSTRING ? lua_tostring(state_, -2) : "_ENV");
    }
  }

  void look_at(const char* name) {
    const std::uint64_t held = hash_of_value();
    std::uint64_t& hash = seen_[name];
    hash = chained_hash(hash, held);
  }

  std::uint64_t hash_of_value() {
    if (!goes_on()) return 0;
    const auto kind = static_cast<std::uint64_t>(lua_type(state_, -1));
    switch (lua_type(state_, -1)) {
      case LUA_TNIL:
        return kind;
      case LUA_TBOOLEAN:
        return chained_hash(kind, static_cast<std::uint64_t>(lua_toboolean(state_, -1)));
      case LUA_TNUMBER:
        return hash_of_number();
      case LUA_TSTRING: {
        std::size_t size = 0;
        const char* text = lua_tolstring(state_, -1, &size);
        return chained_hash(kind, hash_of(text, size));
      }
      case LUA_TTABLE:
        return hash_of_table();
      case LUA_TFUNCTION:
        look_into_function();
        break;
      default:
        break;
    }
    return chained_hash(kind, reinterpret_cast<std::uintptr_t>(lua_topointer(state_, -1)));
  }

  /// 1 and 1.0 are not the same: dividing them is not.
  std::uint64_t hash_of_number() const {
    if (lua_isinteger(state_, -1) != 0) return chained_hash(0, static_cast<std::uint64_t>(lua_tointeger(state_, -1)));
    return chained_hash(1, bits_as<std::uint64_t>(lua_tonumber(state_, -1)));
  }

  /// A sum, so that the order of the entries does not matter.
  std::uint64_t hash_of_table() {
    const void* const table = lua_topointer(state_, -1);
    const auto known = tables_.find(table);
    if (known != tables_.end()) return known->second;
    tables_[table] = 0;  // for tables that hold themselves
    ++depth_;
    std::uint64_t sum = 1;
    for (lua_pushnil(state_); lua_next(state_, -2) != 0; lua_pop(state_, 1)) {
      const std::uint64_t value = hash_of_value();
      lua_pushvalue(state_, -2);
      sum += chained_hash(hash_of_value(), value);
      lua_pop(state_, 1);
    }
    --depth_;
    return tables_[table] = sum;
  }

  lua_State* state_;
  SeenVariables seen_;
  std::set<const void*> functions_;
  std::map<const void*, std::uint64_t> tables_;  ///< looked at already, and their hashes
  int values_ = 0;
  int depth_ = 0;
  bool too_much_ = false;
};

}  // namespace

std::optional<SeenVariables> variables_seen_by(lua_State* state, int function) {
  Walk walk(state);
  push_function(state, function);
  walk.look_into_function();
  lua_pop(state, 1);
  if (walk.too_much()) return std::nullopt;
  return walk.seen();
}

std::optional<std::string> difference(const std::optional<SeenVariables>& before,
                                      const std::optional<SeenVariables>& now) {
  if (!before || !now) return "more variables than can be looked at";
  for (const auto& [name, hash] : *before) {
    const auto found = now->find(name);
    if (found == now->end() || found->second != hash) return name;
  }
  for (const auto& [name, hash] : *now) {
    if (!before->contains(name)) return name;
  }
  return std::nullopt;
}

}  // namespace proofreel
