#pragma once

#include <cstdint>
#include <optional>

#include "protocol.hpp"

namespace mixcmp::harness {

/// Checks on one stream the AXI4-Stream rule that valid and payload, once raised, hold until
/// accepted. `Data` is tdata's type.
template <class Data = std::uint64_t>
class HoldChecker {
public:
  std::optional<wire::Fault> observe(bool valid, bool ready, const Data& data, std::uint64_t user) {
    std::optional<wire::Fault> fault;
    if (waiting_ && !valid) {
      fault = wire::Fault::valid_dropped;
    } else if (waiting_ && (data != data_ || user != user_)) {
      fault = wire::Fault::payload_changed;
    }
    waiting_ = valid && !ready;
    data_ = data;
    user_ = user;
    return fault;
  }

  void reset() { waiting_ = false; }

private:
  bool waiting_ = false;
  Data data_{};
  std::uint64_t user_ = 0;
};

}  // namespace mixcmp::harness
