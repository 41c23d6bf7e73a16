#pragma once

namespace proofreel {

/// Thrown in place of dying at once, so that files in the making are cleaned away on the way out.
class Interrupted {
 public:
  explicit Interrupted(int signal) : signal_(signal) {}
  /// Ends the program the way the signal would have, which is what the caller's shell looks at.
  int die() const;

 private:
  int signal_;
};

/// From now on the first SIGINT, SIGTERM or SIGHUP is only noted; a second one kills.
void note_interrupts();

/// Throws Interrupted when a signal has been noted.
void stop_if_interrupted();

}  // namespace proofreel
