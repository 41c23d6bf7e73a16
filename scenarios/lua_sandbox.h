#pragma once

/// Runs Lua so that a script cannot do harm, hang or depend on the machine. A script is stopped, with a sentence, when
/// it works too much, takes too much memory or too long in one turn; C functions it can call are metered as well.
/// Inside a turn all errors are Lua errors or C++ exceptions; outside they are ScenarioErrors.

#include <chrono>
#include <cstdint>
#include <functional>
#include <lua.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace proofreel {

/// What a script may use in one turn. Work counts virtual machine instructions and what library functions do in their
/// stead, so that the same script is stopped at the same place on every machine; time is the last resort.
inline constexpr std::uint64_t work_limit = 200'000'000;
inline constexpr std::size_t memory_limit = std::size_t{256} << 20;
inline constexpr std::chrono::seconds time_limit{60};

/// What a word of the language throws: a sentence. Becomes a script error at the line of the call, or, when `key` is
/// given, at the line after that where the key is written.
class Problem : public std::runtime_error {
 public:
  explicit Problem(const std::string& message, std::string key = {})
      : std::runtime_error(message), key_(std::move(key)) {}
  const std::string& key() const { return key_; }

 private:
  std::string key_;
};

class Sandbox {
 public:
  /// `client` is what words find through `client()`.
  Sandbox(std::string path, void* client);
  ~Sandbox();
  Sandbox(const Sandbox&) = delete;
  Sandbox& operator=(const Sandbox&) = delete;

  /// One uninterrupted stretch of script: calls `body` with the limits set anew. Throws ScenarioError.
  void turn(const std::function<void(lua_State*)>& body);

  /// Inside a turn: pushes the compiled source.
  void compile(const std::string& path, const std::string& text);
  /// Inside a turn: counts work done in C++ on the script's behalf.
  void charge(std::uint64_t work);

  const std::string& path() const { return path_; }
  /// XXH3 of all sources compiled so far, in order.
  std::uint64_t source_hash() const;
  void* client() const { return client_; }
  /// Where `key` of the word that is called now is written, as sentences begin: "ball.lua: line 12: ".
  std::string place(const std::string& key) const { return sentence(location(key)); }
  /// Raises `problem` as a Lua error that says where.
  [[noreturn]] void raise(const Problem& problem);
  /// Names the message of an unknown global is compared with.
  void set_known_names(std::vector<std::string> names) { known_names_ = std::move(names); }

 private:
  struct Source {
    std::string path;
    std::string text;
  };
  enum class Stop : std::uint8_t { none, work, memory, time };

  static void* allocate(void* self, void* block, std::size_t old_size, std::size_t size);
  static void on_count(lua_State* state, lua_Debug* record);
  static int on_error(lua_State* state);
  void start_turn();
  void check_limits();
  std::string location(const std::string& key) const;
  int line_of_key(const Source& source, int first_line, const std::string& key) const;
  const Source* source_of(std::string_view token) const;
  bool says_where(std::string_view message) const;
  std::string sentence(std::string_view message) const;
  std::string with_hint(std::string message) const;
  std::string stop_sentence() const;

  std::string path_;
  void* client_;
  lua_State* state_ = nullptr;
  std::vector<Source> sources_;
  std::vector<std::string> known_names_;
  std::size_t bytes_ = 0;
  std::uint64_t work_ = 0;
  bool metered_ = false;
  Stop stop_ = Stop::none;
  std::string stop_location_;
  std::chrono::steady_clock::time_point turn_start_;
};

Sandbox& sandbox_of(lua_State* state);

using Word = int (*)(lua_State*);

/// A word as Lua may call it: C++ exceptions become Lua errors.
template <Word word>
int guarded(lua_State* state) {
  try {
    return word(state);
  } catch (const Problem& problem) {
    sandbox_of(state).raise(problem);
  } catch (const std::exception& error) {
    sandbox_of(state).raise(Problem(error.what()));
  }
}

/// Sets field `name` of the table on top of the stack to a word.
template <Word word>
void set_word(lua_State* state, const char* name) {
  lua_pushcfunction(state, guarded<word>);
  lua_setfield(state, -2, name);
}

/// Calls the library function in the first upvalue with all arguments.
int call_original(lua_State* state);

/// Sets field `name` of the table on top of the stack to a word wrapped around the field of that name in the table
/// below it.
template <Word word>
void wrap_word(lua_State* state, const char* name) {
  lua_getfield(state, -2, name);
  lua_pushcclosure(state, guarded<word>, 1);
  lua_setfield(state, -2, name);
}

}  // namespace proofreel
