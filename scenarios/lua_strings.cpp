#include "scenarios/lua_strings.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "scenarios/lua_bodies.h"
#include "scenarios/lua_values.h"
#include "scenarios/lua_words.h"
#include "scenarios/pattern.h"

namespace proofreel {
namespace {

constexpr std::uint64_t most_pattern_steps = 10'000'000;  // of one call: some 50 ms

std::string_view text_argument(lua_State* state, int index) {
  std::size_t size = 0;
  const char* text = luaL_checklstring(state, index, &size);
  return {text, size};
}

/// Steps of matching count as work of the script.
class MeteredSteps {
 public:
  explicit MeteredSteps(lua_State* state) : sandbox_(sandbox_of(state)) {}
  std::optional<PatternMatch> find(const Pattern& pattern, std::string_view subject, std::size_t from) {
    auto match = find_match(pattern, subject, from, left_);
    settle();
    return match;
  }
  std::optional<std::size_t> find_text(std::string_view needle, std::string_view subject, std::size_t from) {
    auto place = find_plain(needle, subject, from, left_);
    settle();
    return place;
  }

 private:
  void settle() {
    sandbox_.charge(settled_ - left_);
    settled_ = left_;
  }
  Sandbox& sandbox_;
  std::uint64_t left_ = most_pattern_steps;
  std::uint64_t settled_ = most_pattern_steps;
};

Pattern pattern_argument(lua_State* state, std::string_view text, bool caret_anchors) {
  sandbox_of(state).charge(text.size());
  return compile_pattern(text, caret_anchors);
}

/// Where a search that starts at the optional argument `index` begins; nothing when that is beyond the end.
std::optional<std::size_t> start_argument(lua_State* state, int index, std::size_t size) {
  const auto length = static_cast<lua_Integer>(size);
  lua_Integer start = luaL_optinteger(state, index, 1);
  if (start < 0) start = std::max<lua_Integer>(length + start + 1, 1);
  start = std::max<lua_Integer>(start, 1);
  if (start > length + 1) return std::nullopt;
  return static_cast<std::size_t>(start - 1);
}

void push_text(lua_State* state, std::string_view text) { lua_pushlstring(state, text.data(), text.size()); }

void push_capture(lua_State* state, const PatternCapture& capture, std::string_view subject) {
  if (capture.is_place) {
    lua_pushinteger(state, static_cast<lua_Integer>(capture.begin) + 1);
  } else {
    push_text(state, subject.substr(capture.begin, capture.end - capture.begin));
  }
}

/// All captures, or the whole match when there are none. How many values that is.
int push_captures(lua_State* state, const PatternMatch& match, std::string_view subject, bool whole_if_none) {
  luaL_checkstack(state, max_pattern_captures, "too many captures");
  for (const PatternCapture& capture : match.captures) push_capture(state, capture, subject);
  if (!match.captures.empty() || !whole_if_none) return static_cast<int>(match.captures.size());
  push_capture(state, {match.begin, match.end, false}, subject);
  return 1;
}

int push_range(lua_State* state, std::size_t begin, std::size_t end) {
  lua_pushinteger(state, static_cast<lua_Integer>(begin) + 1);
  lua_pushinteger(state, static_cast<lua_Integer>(end));
  return 2;
}

int push_nothing(lua_State* state) {
  lua_pushnil(state);
  return 1;
}

int find(lua_State* state) {
  const std::string_view subject = text_argument(state, 1);
  const std::string_view text = text_argument(state, 2);
  const auto from = start_argument(state, 3, subject.size());
  if (!from) return push_nothing(state);
  MeteredSteps steps(state);
  const bool plain = lua_toboolean(state, 4) != 0 || text.find_first_of("^$*+?.([%-") == std::string_view::npos;
  if (plain) {
    const auto place = steps.find_text(text, subject, *from);
    return place ? push_range(state, *place, *place + text.size()) : push_nothing(state);
  }
  const auto match = steps.find(pattern_argument(state, text, true), subject, *from);
  if (!match) return push_nothing(state);
  return push_range(state, match->begin, match->end) + push_captures(state, *match, subject, false);
}

int match(lua_State* state) {
  const std::string_view subject = text_argument(state, 1);
  const Pattern pattern = pattern_argument(state, text_argument(state, 2), true);
  const auto from = start_argument(state, 3, subject.size());
  if (!from) return push_nothing(state);
  const auto found = MeteredSteps(state).find(pattern, subject, *from);
  return found ? push_captures(state, *found, subject, true) : push_nothing(state);
}

/// Upvalues: subject, pattern, where to go on, where the last match ended (-1 before the first).
int next_match(lua_State* state) {
  const std::string_view subject = text_argument(state, lua_upvalueindex(1));
  const Pattern pattern = pattern_argument(state, text_argument(state, lua_upvalueindex(2)), false);
  const lua_Integer last_end = lua_tointeger(state, lua_upvalueindex(4));
  MeteredSteps steps(state);
  auto from = static_cast<std::size_t>(lua_tointeger(state, lua_upvalueindex(3)));
  for (; from <= subject.size(); ++from) {
    const auto found = steps.find(pattern, subject, from);
    if (!found) return 0;
    const auto end = static_cast<lua_Integer>(found->end);
    from = found->begin;
    if (end == last_end) continue;  // the same place again, found empty
    lua_pushinteger(state, end);
    lua_copy(state, -1, lua_upvalueindex(3));
    lua_replace(state, lua_upvalueindex(4));
    return push_captures(state, *found, subject, true);
  }
  return 0;
}

int gmatch(lua_State* state) {
  const std::string_view subject = text_argument(state, 1);
  text_argument(state, 2);
  const std::size_t from = start_argument(state, 3, subject.size()).value_or(subject.size() + 1);
  lua_settop(state, 2);
  lua_pushinteger(state, static_cast<lua_Integer>(from));
  lua_pushinteger(state, -1);
  lua_pushcclosure(state, guarded<next_match>, 4);
  return 1;
}

/// Appends to a result that lies outside Lua's memory until it is complete.
void append(lua_State* state, std::string& result, std::string_view text) {
  constexpr std::size_t bytes_per_work_unit = 16;
  sandbox_of(state).charge(1 + text.size() / bytes_per_work_unit);
  if (result.size() + text.size() > memory_limit) throw Problem("string.gsub: the result is too long");
  result += text;
}

/// Appends what `%c` stands for in a gsub replacement.
void append_escape(lua_State* state, char c, const PatternMatch& match, std::string_view subject, std::string& result) {
  const auto index = static_cast<std::size_t>(c - '0');
  const bool is_digit = c >= '0' && c <= '9';
  if (c == '%') {
    append(state, result, "%");
  } else if (is_digit && (index == 0 || (index == 1 && match.captures.empty()))) {
    append(state, result, subject.substr(match.begin, match.end - match.begin));
  } else if (is_digit && index <= match.captures.size()) {
    push_capture(state, match.captures[index - 1], subject);
    append(state, result, text_argument(state, -1));
    lua_pop(state, 1);
  } else {
    throw Problem("string.gsub: invalid use of '%' in the replacement, or no such capture");
  }
}

/// The text of a gsub replacement with its %0 to %9 filled in.
std::string filled(lua_State* state, std::string_view text, const PatternMatch& match, std::string_view subject) {
  std::string result;
  while (!text.empty()) {
    const std::size_t plain = std::min(text.find('%'), text.size());
    append(state, result, text.substr(0, plain));
    text.remove_prefix(plain);
    if (text.empty()) break;
    append_escape(state, text.size() > 1 ? text[1] : '\0', match, subject, result);
    text.remove_prefix(std::min<std::size_t>(2, text.size()));
  }
  return result;
}

/// Pushes what the third argument of gsub makes of a match.
void push_replacement(lua_State* state, const PatternMatch& match, std::string_view subject) {
  const int type = lua_type(state, 3);
  if (type == LUA_TTABLE) {
    const auto whole = PatternCapture{match.begin, match.end, false};
    push_capture(state, match.captures.empty() ? whole : match.captures.front(), subject);
    lua_gettable(state, 3);
  } else if (type == LUA_TFUNCTION) {
    lua_pushvalue(state, 3);
    lua_call(state, push_captures(state, match, subject, true), 1);
  } else {
    push_text(state, filled(state, text_argument(state, 3), match, subject));
  }
}

/// Appends the replacement of one match; false or nil keeps what was there.
void append_replacement(lua_State* state, const PatternMatch& match, std::string_view subject, std::string& result) {
  push_replacement(state, match, subject);
  if (lua_toboolean(state, -1) == 0) {
    append(state, result, subject.substr(match.begin, match.end - match.begin));
  } else if (lua_isstring(state, -1) == 0) {
    throw Problem("string.gsub: a replacement must be a string or a number, got " + described(state, -1));
  } else {
    append(state, result, text_argument(state, -1));
  }
  lua_pop(state, 1);
}

int gsub(lua_State* state) {
  const std::string_view subject = text_argument(state, 1);
  const Pattern pattern = pattern_argument(state, text_argument(state, 2), true);
  const int type = lua_type(state, 3);
  if (type != LUA_TNUMBER && type != LUA_TSTRING && type != LUA_TTABLE && type != LUA_TFUNCTION) {
    throw Problem("string.gsub: the replacement must be a string, a table or a function, got " + described(state, 3));
  }
  const auto most = static_cast<lua_Integer>(subject.size()) + 1;
  const lua_Integer limit = luaL_optinteger(state, 4, most);
  MeteredSteps steps(state);
  std::string result;
  lua_Integer count = 0;
  std::size_t copied = 0;  // up to here the subject is in the result
  std::size_t from = 0;
  std::size_t last_end = std::string_view::npos;
  while (count < limit && from <= subject.size()) {
    const auto found = steps.find(pattern, subject, from);
    if (!found) break;
    if (found->end == last_end) {
      from = found->begin + 1;
    } else {
      append(state, result, subject.substr(copied, found->begin - copied));
      append_replacement(state, *found, subject, result);
      ++count;
      copied = from = last_end = found->end;
    }
    if (pattern.anchored) break;
  }
  append(state, result, subject.substr(copied));
  push_text(state, result);
  lua_pushinteger(state, count);
  return 2;
}

int machine_dependent(lua_State*) {
  throw Problem("string.pack, unpack and packsize are not offered: their results differ between machines");
}

constexpr std::array kept{"byte", "char", "len", "lower", "reverse", "sub", "upper"};

}  // namespace

void open_strings(lua_State* state) {
  luaL_requiref(state, LUA_STRLIBNAME, luaopen_string, 0);
  lua_newtable(state);
  for (const char* name : kept) {
    lua_getfield(state, -2, name);
    lua_setfield(state, -2, name);
  }
  open_formats(state);
  set_word<find>(state, "find");
  set_word<match>(state, "match");
  set_word<gmatch>(state, "gmatch");
  set_word<gsub>(state, "gsub");
  set_word<machine_dependent>(state, "pack");
  set_word<machine_dependent>(state, "unpack");
  set_word<machine_dependent>(state, "packsize");
  // ("x"):rep(3) looks methods up in the metatable of strings.
  lua_pushliteral(state, "");
  lua_getmetatable(state, -1);
  lua_pushvalue(state, -3);
  lua_setfield(state, -2, "__index");
  lua_pop(state, 2);
  lua_setglobal(state, LUA_STRLIBNAME);
  lua_pop(state, 1);
}

}  // namespace proofreel
