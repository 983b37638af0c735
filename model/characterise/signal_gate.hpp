#pragma once

#include <signal.h>

#include <chrono>

namespace mixcmp::model {

/// Holds back, while it lives, what would end the program from outside (an interrupt, a request to
/// end, a lost terminal) and the news of children, so that they are taken where it suits. A signal
/// that the program was told to ignore, as nohup does, stays ignored.
class SignalGate {
public:
  SignalGate();
  ~SignalGate();
  SignalGate(const SignalGate&) = delete;
  SignalGate& operator=(const SignalGate&) = delete;

  /// The first signal held back within this time; 0: none came.
  int wait(std::chrono::milliseconds patience) const;

  /// For a new child: signals do again what they did before.
  void restore() const;

private:
  sigset_t held_;
  sigset_t before_;
};

}  // namespace mixcmp::model
