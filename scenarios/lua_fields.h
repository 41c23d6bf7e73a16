#pragma once

/// Reads the table a word is called with: checks its keys, types and ranges, and says what is wrong with them.

#include <cstdint>
#include <lua.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/vec2.h"
#include "scenarios/lua_sandbox.h"
#include "scenarios/overrides.h"
#include "scenarios/suggest.h"

namespace proofreel {

/// A key, or a name a key can be set to.
struct Name {
  const char* text;
};

enum class Range : std::uint8_t {
  any,     ///< every number, even NaN: geometry, which is judged as a whole later
  finite,  ///< finite
  not_negative,
  positive,
  place  ///< of a vector: a point the engine can reckon with, within a billion metres
};

class Fields {
 public:
  /// The table at `index`, an argument of `word` that may hold `keys` and `positional` values. Throws Problem for
  /// everything else that is in it.
  Fields(lua_State* state, int index, std::string word, std::span<const Name> keys, int positional = 0);
  /// The same for a table of `scenario{}`, whose values may come from the command line; `prefix` is "" or "view.".
  Fields(lua_State* state, int index, std::string word, std::span<const Name> keys, std::string prefix,
         const std::vector<ParsedOverride>* overrides);

  lua_State* state() const { return state_; }
  const std::string& word() const { return word_; }
  /// Pushes the value of a key; false, with nothing pushed, when it is not set.
  bool push(const char* key) const;
  bool has(const char* key) const;

  std::optional<double> number(const char* key, Range range = Range::finite) const;
  std::optional<std::int64_t> integer(const char* key, std::int64_t low, std::int64_t high) const;
  std::optional<bool> boolean(const char* key) const;
  std::optional<std::string> text(const char* key) const;
  std::optional<Vec2d> vector(const char* key, Range range = Range::finite) const;
  /// The index of the value among `names`.
  std::optional<std::size_t> choice(const char* key, std::span<const Name> names) const;

  /// The value of an option that must be set.
  template <typename Value>
  Value required(const char* key, std::optional<Value> value) const {
    if (!value) missing(key);
    return *value;
  }

  [[noreturn]] void missing(const char* key) const;
  /// Throws a Problem: "body: density must be positive, got -1".
  [[noreturn]] void refuse(const char* key, const std::string& what) const;

 private:
  void check_keys(std::span<const Name> keys, int positional) const;
  [[noreturn]] void refuse_key(const std::string& key, std::span<const Name> keys) const;
  [[noreturn]] void refuse_value(const char* key, const char* wanted) const;

  lua_State* state_;
  int index_;
  std::string word_;
  std::string prefix_;
  const std::vector<ParsedOverride>* overrides_ = nullptr;
};

}  // namespace proofreel
