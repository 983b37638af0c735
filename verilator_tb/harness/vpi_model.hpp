#pragma once

#include <cstdint>
#include <vector>

namespace mixcmp::harness {

/// A model in an event-driven simulator, with the interface of a verilated one: its ports as bytes
/// in memory, and eval(). The harness runs in a thread of its own. The simulator calls the system
/// task $mixcmp_exchange in each time unit: it hands the outputs to the harness, waits until the
/// harness calls eval(), and takes the inputs. One of the two always waits.
class VpiModel {
public:
  /// Bits from the lowest byte up, in whole words of 32 bits.
  struct Port {
    const char* name;  ///< a variable of the module `bench`, or a net that an output drives
    bool is_output;
    int width;
    std::uint8_t* bytes;
  };

  VpiModel(const VpiModel&) = delete;
  VpiModel& operator=(const VpiModel&) = delete;

  /// Lets the simulator run for a time unit with the inputs as they are, and reads its outputs.
  void eval();

  /// Whether the last eval() left an unknown bit in a handshake, or in the payload of a stream of
  /// m_axis whose tvalid is 1. Other outputs, counters among them, are not looked at.
  bool has_unknown() const { return has_unknown_; }

protected:
  explicit VpiModel(std::vector<Port> ports);
  ~VpiModel() = default;

private:
  friend class VpiExchange;

  std::vector<Port> ports_;
  bool has_unknown_ = false;
};

}  // namespace mixcmp::harness
