#pragma once

#include <signal.h>

#include <chrono>

namespace mixcmp::model {

/// Holds back, while it lives, what would end the program from outside (an interrupt, a request to
/// end, a lost terminal), so that it is taken where it suits. Threads that start meanwhile hold the
/// same back. A signal that the program was told to ignore, as nohup does, stays ignored.
class SignalGate {
public:
  SignalGate();
  ~SignalGate();
  SignalGate(const SignalGate&) = delete;
  SignalGate& operator=(const SignalGate&) = delete;

  /// The first signal held back within this time; 0: none came.
  int wait(std::chrono::milliseconds patience) const;

private:
  sigset_t held_;
  sigset_t before_;
};

}  // namespace mixcmp::model
