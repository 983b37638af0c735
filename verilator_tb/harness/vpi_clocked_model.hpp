#pragma once

#include <cstdint>
#include <string>

#include "settings.hpp"
#include "system_ports.hpp"

namespace mixcmp::harness {

/// The model in an event-driven simulator with its clock; as that of clocked_model.hpp, whose
/// name this file has in a build. Its waves are the simulator's own.
class ClockedModel {
public:
  ClockedModel(const Settings&, int, char**) {}

  system::Model& model() { return model_; }
  bool has_unknown() const { return model_.has_unknown(); }

  /// Lowers the clock. Inputs are changed while it is high, outputs are read while it is low.
  void settle(std::uint64_t) { evaluate(0); }
  void rise(std::uint64_t) { evaluate(1); }

  void open_trace(const std::string&) {}

private:
  void evaluate(std::uint8_t clock) {
    model_.aclk[0] = clock;
    model_.eval();
  }

  system::Model model_;
};

}  // namespace mixcmp::harness
