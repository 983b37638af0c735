#include "generator/synthesis/characterise/signal_gate.hpp"

#include <algorithm>

namespace mixcmp::characterise {
namespace {

bool is_ignored(int signal) {
  struct sigaction action = {};
  sigaction(signal, nullptr, &action);
  return action.sa_handler == SIG_IGN;
}

}  // namespace

SignalGate::SignalGate() {
  sigemptyset(&held_);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    if (!is_ignored(signal)) sigaddset(&held_, signal);
  }
  pthread_sigmask(SIG_BLOCK, &held_, &before_);
}

SignalGate::~SignalGate() {
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

int SignalGate::wait(std::chrono::milliseconds patience) const {
  const timespec timeout = {.tv_sec = patience.count() / 1000,
                            .tv_nsec = patience.count() % 1000 * 1'000'000};
  return std::max(sigtimedwait(&held_, nullptr, &timeout), 0);
}

}  // namespace mixcmp::characterise
