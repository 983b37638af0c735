#pragma once

#include <signal.h>

#include <chrono>

namespace mixcmp::characterise {

/// Blocks SIGINT, SIGTERM and SIGHUP while it lives, so the program receives them when it calls
/// `wait`. Threads that start meanwhile inherit the block. A signal that the program was told to
/// ignore, as by nohup, stays ignored.
class SignalGate {
public:
  SignalGate();
  ~SignalGate();
  SignalGate(const SignalGate&) = delete;
  SignalGate& operator=(const SignalGate&) = delete;

  /// Waits at most this long for a blocked signal and returns it; 0 if none came.
  int wait(std::chrono::milliseconds patience) const;

private:
  sigset_t held_;
  sigset_t before_;
};

}  // namespace mixcmp::characterise
