#pragma once

#include <string>
#include <utility>
#include <vector>

namespace proofreel {

/// How a run of the program ended.
struct Outcome {
  int status = -1;  ///< exit status; -1 when a signal ended it
  int signal = 0;
  std::string out;  ///< standard output
  std::string err;  ///< standard error
};

/// A running program, started with `arguments` in `folder`; `environment` is set on top of ours.
class Program {
 public:
  using Environment = std::vector<std::pair<std::string, std::string>>;

  Program(const std::vector<std::string>& arguments, const std::string& folder, const Environment& environment = {});
  void send(int signal) const;
  /// Waits for the end.
  Outcome wait();

 private:
  int pid_ = 0;
  std::string out_path_;
  std::string err_path_;
};

/// Runs proofreel to its end.
Outcome proofreel_program(const std::vector<std::string>& arguments, const std::string& folder = ".",
                          const Program::Environment& environment = {});

}  // namespace proofreel
