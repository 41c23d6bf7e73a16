#include "scenarios/lua_sandbox.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>

#include "engine/state_hash.h"
#include "scenarios/scenario.h"
#include "scenarios/suggest.h"

namespace proofreel {
namespace {

constexpr int hook_interval = 1000;              // instructions
constexpr std::size_t bytes_per_work_unit = 16;  // copying so much takes about as long as one instruction

const std::vector<std::string>& refused_globals() {
  static const std::vector<std::string> names{
      "os",       "io",     "debug",      "coroutine", "package", "require",      "utf8",         "load",
      "loadfile", "dofile", "loadstring", "pcall",     "xpcall",  "next",         "rawget",       "rawset",
      "rawequal", "rawlen", "_G",         "warn",      "unpack",  "getmetatable", "setmetatable", "collectgarbage"};
  return names;
}

bool is_word_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// Whether `line` sets `key` in a table: the whole word, then an equals sign.
bool sets_key(std::string_view line, std::string_view key) {
  for (std::size_t at = line.find(key); at != std::string_view::npos; at = line.find(key, at + 1)) {
    if (at > 0 && is_word_character(line[at - 1])) continue;
    const std::size_t next = line.find_first_not_of(" \t", at + key.size());
    if (next != std::string_view::npos && line[next] == '=') return true;
  }
  return false;
}

int call_body(lua_State* state) {
  const auto* body = static_cast<const std::function<void(lua_State*)>*>(lua_touserdata(state, 1));
  lua_settop(state, 0);
  (*body)(state);
  return 0;
}

}  // namespace

int call_original(lua_State* state) {
  lua_pushvalue(state, lua_upvalueindex(1));
  lua_insert(state, 1);
  lua_call(state, lua_gettop(state) - 1, LUA_MULTRET);
  return lua_gettop(state);
}

Sandbox& sandbox_of(lua_State* state) { return **static_cast<Sandbox**>(lua_getextraspace(state)); }

Sandbox::Sandbox(std::string path, void* client) : path_(std::move(path)), client_(client) {
  state_ = lua_newstate(allocate, this);
  if (state_ == nullptr) throw std::bad_alloc();
  *static_cast<Sandbox**>(lua_getextraspace(state_)) = this;
  lua_sethook(state_, on_count, LUA_MASKCOUNT, hook_interval);
}

Sandbox::~Sandbox() { lua_close(state_); }

void Sandbox::turn(const std::function<void(lua_State*)>& body) {
  lua_settop(state_, 0);
  start_turn();
  lua_pushcfunction(state_, on_error);
  lua_pushcfunction(state_, guarded<call_body>);
  lua_pushlightuserdata(state_, const_cast<std::function<void(lua_State*)>*>(&body));
  const int status = lua_pcall(state_, 1, 0, 1);
  metered_ = false;
  if (status == LUA_OK) return;
  const bool stopped = status == LUA_ERRMEM && stop_ != Stop::none;
  const char* message = lua_tostring(state_, -1);
  throw ScenarioError(sentence(stopped ? stop_location_ + stop_sentence() : message != nullptr ? message : "error"));
}

void Sandbox::start_turn() {
  work_ = 0;
  stop_ = Stop::none;
  metered_ = true;
  turn_start_ = std::chrono::steady_clock::now();
}

void Sandbox::compile(const std::string& path, const std::string& text) {
  if (text.starts_with(LUA_SIGNATURE)) throw Problem("a compiled file cannot be run: give its Lua source");
  sources_.push_back({path, text});
  // Lua puts the chunk's name before its messages. A short token survives its shortening of long names; the path takes
  // its place at the end.
  const std::string token = "=<" + std::to_string(sources_.size()) + ">";
  if (luaL_loadbufferx(state_, text.data(), text.size(), token.c_str(), "t") != LUA_OK) lua_error(state_);
}

std::uint64_t Sandbox::source_hash() const {
  std::uint64_t hash = 0;
  for (const Source& source : sources_) hash = chained_hash(hash, hash_of(source.text.data(), source.text.size()));
  return hash;
}

void Sandbox::charge(std::uint64_t work) {
  work_ += std::min(work, work_limit + 1);
  check_limits();
}

void Sandbox::check_limits() {
  if (work_ > work_limit) {
    stop_ = Stop::work;
  } else if (std::chrono::steady_clock::now() - turn_start_ > time_limit) {
    stop_ = Stop::time;
  } else {
    return;
  }
  throw Problem(stop_sentence());
}

void Sandbox::on_count(lua_State* state, lua_Debug*) {
  Sandbox& self = sandbox_of(state);
  try {
    self.charge(hook_interval);
  } catch (const Problem& problem) {
    self.raise(problem);
  }
}

void* Sandbox::allocate(void* self, void* block, std::size_t old_size, std::size_t size) {
  auto& sandbox = *static_cast<Sandbox*>(self);
  const std::size_t held = block != nullptr ? old_size : 0;  // without a block, old_size tells what it is for
  if (size == 0) {
    std::free(block);
    sandbox.bytes_ -= held;
    return nullptr;
  }
  if (size > held && sandbox.metered_) {
    sandbox.work_ += size / bytes_per_work_unit;
    sandbox.stop_ = sandbox.work_ > work_limit                      ? Stop::work
                    : size > memory_limit - (sandbox.bytes_ - held) ? Stop::memory
                                                                    : Stop::none;
    if (sandbox.stop_ != Stop::none) {
      sandbox.stop_location_ = sandbox.location({});
      return nullptr;
    }
  }
  void* moved = std::realloc(block, size);
  if (moved != nullptr) sandbox.bytes_ = sandbox.bytes_ - held + size;
  return moved;
}

void Sandbox::raise(const Problem& problem) {
  const std::string_view message = problem.what();
  const std::string where = says_where(message) ? std::string{} : location(problem.key());
  lua_pushlstring(state_, where.data(), where.size());
  lua_pushlstring(state_, message.data(), message.size());
  lua_concat(state_, 2);
  lua_error(state_);
  std::abort();  // lua_error does not return, but its declaration does not say so
}

/// Gives every error a text and a place.
int Sandbox::on_error(lua_State* state) {
  Sandbox& self = sandbox_of(state);
  if (lua_type(state, 1) != LUA_TSTRING) {
    const std::string text = "error() was called with a " + std::string(luaL_typename(state, 1)) + " instead of a text";
    lua_pushlstring(state, text.data(), text.size());
    lua_replace(state, 1);
  }
  const std::string_view message = lua_tostring(state, 1);
  if (message.starts_with("<") || self.says_where(message)) return 1;
  const std::string where = self.location({});
  lua_pushlstring(state, where.data(), where.size());
  lua_insert(state, 1);
  lua_concat(state, 2);
  return 1;
}

/// `<1>:12: ` of the innermost Lua function that runs; empty when none does.
std::string Sandbox::location(const std::string& key) const {
  if (state_ == nullptr) return {};
  lua_Debug record{};
  for (int level = 0; lua_getstack(state_, level, &record) != 0; ++level) {
    if (lua_getinfo(state_, "Sl", &record) == 0 || record.currentline <= 0) continue;
    const Source* source = source_of(record.short_src);
    const bool look = source != nullptr && !key.empty();
    const int line = look ? line_of_key(*source, record.currentline, key) : record.currentline;
    return std::string(record.short_src) + ":" + std::to_string(line) + ": ";
  }
  return {};
}

/// Lua knows the line a call begins on; the key may stand further down in its table.
int Sandbox::line_of_key(const Source& source, int first_line, const std::string& key) const {
  constexpr int longest_table = 100;
  std::string_view text = source.text;
  for (int line = 1; line < first_line + longest_table && !text.empty(); ++line) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    if (line >= first_line && sets_key(text.substr(0, end), key)) return line;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return first_line;
}

const Sandbox::Source* Sandbox::source_of(std::string_view token) const {
  std::size_t number = 0;
  if (token.size() < 3 || token.front() != '<') return nullptr;
  const auto [end, error] = std::from_chars(token.data() + 1, token.data() + token.size(), number);
  if (error != std::errc{} || *end != '>' || number == 0 || number > sources_.size()) return nullptr;
  return &sources_[number - 1];
}

/// What overrides a value of `scenario{}` stands elsewhere than where that is called.
bool Sandbox::says_where(std::string_view message) const {
  return message.starts_with("--set ") || message.starts_with(path_ + ": line ");
}

/// `<1>:12: text` as `path: line 12: text`.
std::string Sandbox::sentence(std::string_view message) const {
  if (says_where(message)) return std::string(message);
  const std::size_t token_end = message.find(">:");
  const Source* source = source_of(message);
  if (source == nullptr || token_end == std::string_view::npos) return path_ + ": " + with_hint(std::string(message));
  const std::string_view rest = message.substr(token_end + 2);
  const std::size_t colon = std::min(rest.find(": "), rest.size());
  const std::string_view text = rest.substr(std::min(colon + 2, rest.size()));
  return source->path + ": line " + std::string(rest.substr(0, colon)) + ": " + with_hint(std::string(text));
}

/// Calls of globals that do not exist are most often misspelt words.
std::string Sandbox::with_hint(std::string message) const {
  constexpr std::string_view mark = "a nil value (global '";
  const std::size_t at = message.find(mark);
  if (at == std::string::npos) return message;
  const std::size_t begin = at + mark.size();
  const std::string name = message.substr(begin, message.find('\'', begin) - begin);
  const auto& refused = refused_globals();
  if (std::find(refused.begin(), refused.end(), name) != refused.end()) {
    return message + "; scenarios are not offered " + quote(name);
  }
  const std::string_view near = nearest(name, known_names_);
  return near.empty() ? message : message + "; did you mean " + quote(near) + "?";
}

std::string Sandbox::stop_sentence() const {
  switch (stop_) {
    case Stop::work:
      return "the script was stopped after " + std::to_string(work_limit / 1'000'000) +
             " million instructions in one go; does a loop not end?";
    case Stop::memory:
      return "the script needs more than " + std::to_string(memory_limit >> 20) + " MB of memory";
    case Stop::time:
      return "the script was stopped after " + std::to_string(time_limit.count()) + " seconds in one go";
    case Stop::none:
      break;
  }
  return {};
}

}  // namespace proofreel
