#pragma once

/// Work in a process of its own, so that what hangs, crashes or eats the machine's memory takes nothing else with it,
/// and so that nothing of one run (caches, memory, threads) is left for the next one.

#include <functional>
#include <string>

namespace proofreel {

/// How such work ended.
struct ChildEnd {
  std::string answer;        ///< what the work returned; empty when it came to no end
  bool out_of_time = false;  ///< it was stopped at its limit
  std::string died_of;       ///< "Aborted: what it said last"; empty when it came to its end
};

/// Runs at once. Whoever makes one must have no threads of its own, since only the calling one goes on in the child.
class Child {
 public:
  /// `work` returns bytes; from beyond `cpu_limit_s` seconds of CPU time (rounded up) it is killed. It dies with its
  /// parent. Throws EnvironmentError when the machine has no process to spare.
  Child(const std::function<std::string()>& work, double cpu_limit_s);
  /// Kills what has not been waited for.
  ~Child();
  Child(Child&& other) noexcept;
  Child& operator=(Child&& other) noexcept;

  /// Readable whenever `take` would not block.
  int file() const { return answer_file_; }
  /// Takes what the child has written; false when it has written all.
  bool take();
  /// Waits for its end. An EnvironmentError of the work is thrown on here, any other exception as a runtime_error.
  ChildEnd end();

 private:
  void close_files();

  int pid_ = -1;
  int answer_file_ = -1;
  int words_file_ = -1;  ///< what it says on standard error
  std::string answer_;
};

}  // namespace proofreel
