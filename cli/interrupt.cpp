#include "cli/interrupt.h"

#include <csignal>
#include <initializer_list>

namespace proofreel {
namespace {

volatile std::sig_atomic_t noted_signal = 0;

void note(int signal) { noted_signal = signal; }

}  // namespace

int Interrupted::die() const {
  std::signal(signal_, SIG_DFL);
  std::raise(signal_);
  return 128 + signal_;
}

void note_interrupts() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action {};
    action.sa_handler = note;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(signal, &action, nullptr);
  }
}

void stop_if_interrupted() {
  if (noted_signal != 0) throw Interrupted(noted_signal);
}

}  // namespace proofreel
