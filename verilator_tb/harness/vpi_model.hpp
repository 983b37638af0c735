#pragma once

#include <cstdint>
#include <set>
#include <vector>

namespace mixcmp::harness {

/// A model in an event-driven simulator, with the interface of a verilated one: its ports as bytes
/// in memory, and eval(). The simulator calls the system task $mixcmp_exchange in each time unit:
/// it hands the outputs to the harness, which runs on a stack of its own until it calls eval(), and
/// then takes the inputs.
class VpiModel {
public:
  /// Bits from the lowest byte up, in whole words of 32 bits.
  struct Port {
    const char* name;  ///< a variable of the module `testbench`, or a net that an output drives
    bool is_output;
    int width;
    std::uint8_t* bytes;
  };

  VpiModel(const VpiModel&) = delete;
  VpiModel& operator=(const VpiModel&) = delete;

  /// Lets the simulator run for a time unit with the inputs as they are, and reads its outputs. An
  /// x reads as 1, a z as 0. In handshakes other than m_axis_tvalid each reads as 0: no transfer.
  void eval();

  /// The numbers of the streams in which the last eval() left an unknown bit in a handshake, or in
  /// the payload of a stream that leaves with tvalid 1. Other outputs, counters among them, are not
  /// looked at.
  const std::set<std::uint32_t>& unknown_streams() const { return unknown_streams_; }

protected:
  explicit VpiModel(std::vector<Port> ports);
  ~VpiModel() = default;

private:
  friend class VpiExchange;

  std::vector<Port> ports_;
  std::set<std::uint32_t> unknown_streams_;
};

}  // namespace mixcmp::harness
