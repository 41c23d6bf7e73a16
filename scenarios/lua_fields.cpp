#include "scenarios/lua_fields.h"

#include <algorithm>
#include <cmath>

#include "scenarios/lua_values.h"

namespace proofreel {
namespace {

std::vector<std::string> texts_of(std::span<const Name> names) {
  std::vector<std::string> texts;
  for (const Name& name : names) texts.emplace_back(name.text);
  return texts;
}

const Name* find_name(const std::string& text, std::span<const Name> names) {
  const auto found = std::find_if(names.begin(), names.end(), [&](const Name& n) { return text == n.text; });
  return found == names.end() ? nullptr : &*found;
}

bool in_range(double number, Range range) {
  switch (range) {
    case Range::any:
      return true;
    case Range::finite:
    case Range::place:
      return std::isfinite(number);
    case Range::not_negative:
      return std::isfinite(number) && number >= 0;
    case Range::positive:
      return std::isfinite(number) && number > 0;
  }
  return false;
}

const char* range_words(Range range) {
  switch (range) {
    case Range::not_negative:
      return "a number that is not negative";
    case Range::positive:
      return "a positive number";
    default:
      return "a finite number";
  }
}

}  // namespace

Fields::Fields(lua_State* state, int index, std::string word, std::span<const Name> keys, int positional)
    : state_(state), index_(lua_absindex(state, index)), word_(std::move(word)) {
  check_keys(keys, positional);
}

Fields::Fields(lua_State* state, int index, std::string word, std::span<const Name> keys, std::string prefix,
               const std::vector<ParsedOverride>* overrides)
    : state_(state),
      index_(lua_absindex(state, index)),
      word_(std::move(word)),
      prefix_(std::move(prefix)),
      overrides_(overrides) {
  check_keys(keys, 0);
}

void Fields::check_keys(std::span<const Name> keys, int positional) const {
  if (lua_type(state_, index_) != LUA_TTABLE) {
    throw Problem(word_ + " needs a table, " + word_ + "{...}, got " + described(state_, index_));
  }
  // Lua walks tables in no fixed order; the message must not depend on it.
  std::vector<std::string> wrong;
  for (lua_pushnil(state_); lua_next(state_, index_) != 0; lua_pop(state_, 1)) {
    if (lua_type(state_, -2) == LUA_TSTRING) {
      const std::string key = lua_tostring(state_, -2);
      if (find_name(key, keys) == nullptr) wrong.push_back(key);
    } else if (!lua_isinteger(state_, -2) || lua_tointeger(state_, -2) < 1 || lua_tointeger(state_, -2) > positional) {
      wrong.push_back(shown(state_, -2));
    }
  }
  if (wrong.empty()) return;
  refuse_key(*std::min_element(wrong.begin(), wrong.end()), keys);
}

void Fields::refuse_key(const std::string& key, std::span<const Name> keys) const {
  throw Problem(word_ + ": unknown key " + quote(key) + ", " + did_you_mean(key, texts_of(keys)), key);
}

bool Fields::push(const char* key) const {
  lua_pushstring(state_, key);
  if (lua_rawget(state_, index_) != LUA_TNIL) return true;
  lua_pop(state_, 1);
  return false;
}

bool Fields::has(const char* key) const {
  if (!push(key)) return false;
  lua_pop(state_, 1);
  return true;
}

void Fields::missing(const char* key) const { throw Problem(word_ + " needs " + key + "="); }

void Fields::refuse(const char* key, const std::string& what) const {
  const std::string path = prefix_ + key;
  if (overrides_ != nullptr) {
    const auto set =
        std::find_if(overrides_->rbegin(), overrides_->rend(), [&](const auto& o) { return o.path == path; });
    if (set != overrides_->rend()) throw Problem(set->origin + ": " + path + " " + what);
  }
  throw Problem(word_ + ": " + key + " " + what, key);
}

void Fields::refuse_value(const char* key, const char* wanted) const {
  push(key);
  refuse(key, std::string("must be ") + wanted + ", got " + described(state_, -1));
}

std::optional<double> Fields::number(const char* key, Range range) const {
  if (!push(key)) return std::nullopt;
  if (lua_type(state_, -1) != LUA_TNUMBER) refuse_value(key, "a number");
  const double number = lua_tonumber(state_, -1);
  lua_pop(state_, 1);
  if (!in_range(number, range)) refuse_value(key, range_words(range));
  return number;
}

std::optional<std::int64_t> Fields::integer(const char* key, std::int64_t low, std::int64_t high) const {
  if (!push(key)) return std::nullopt;
  int is_integer = 0;
  const std::int64_t number = lua_tointegerx(state_, -1, &is_integer);
  if (lua_type(state_, -1) != LUA_TNUMBER || is_integer == 0) refuse_value(key, "a whole number");
  lua_pop(state_, 1);
  if (number < low || number > high) {
    refuse(key, "must lie between " + std::to_string(low) + " and " + std::to_string(high) + ", got " +
                    std::to_string(number));
  }
  return number;
}

std::optional<bool> Fields::boolean(const char* key) const {
  if (!push(key)) return std::nullopt;
  if (lua_type(state_, -1) != LUA_TBOOLEAN) refuse_value(key, "true or false");
  const bool value = lua_toboolean(state_, -1) != 0;
  lua_pop(state_, 1);
  return value;
}

std::optional<std::string> Fields::text(const char* key) const {
  if (!push(key)) return std::nullopt;
  if (lua_type(state_, -1) != LUA_TSTRING) refuse_value(key, "a text in quotes");
  std::string value = text_to_show(state_, -1, word_ + ": " + key);
  lua_pop(state_, 1);
  return value;
}

std::optional<Vec2d> Fields::vector(const char* key, Range range) const {
  if (!push(key)) return std::nullopt;
  const auto v = to_vector(state_, -1);
  if (!v) refuse_value(key, "a vector {x, y}");
  lua_pop(state_, 1);
  if (range != Range::any && !is_finite(*v)) refuse(key, "must be finite");
  constexpr double farthest = 1e9;
  if (range == Range::place && std::max(std::abs(v->x), std::abs(v->y)) > farthest)
    refuse(key, "must lie within 1e9 m of the origin");
  return v;
}

std::optional<std::size_t> Fields::choice(const char* key, std::span<const Name> names) const {
  const auto value = text(key);
  if (!value) return std::nullopt;
  const Name* name = find_name(*value, names);
  if (name == nullptr) refuse(key, "cannot be " + quote(*value) + ", " + did_you_mean(*value, texts_of(names)));
  return static_cast<std::size_t>(name - names.data());
}

}  // namespace proofreel
