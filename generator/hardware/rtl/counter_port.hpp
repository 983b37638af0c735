#pragma once

#include <string>
#include <vector>

#include "generator/hardware/rtl/system_shape.hpp"

/// Counters of a top module, whatever its kind, and the AXI4-Lite port on which software reads
/// them.
namespace mixcmp::rtl {

/// Counters of one kind. They are one output of a module, with a field for each; the first is in
/// the lowest bits.
struct Counters {
  std::string name;
  int count = 1;
};

/// The address at which software finds the counters of one kind.
struct CounterOffset {
  Counters counters;
  int offset = 0;  ///< bytes to the first one; each is counter_stride bytes behind the one before
};
inline constexpr int counter_stride = 8;  ///< a low and a high word of 32 bits

/// The offsets of all counters, in their order.
std::vector<CounterOffset> counter_offsets(const std::vector<Counters>& counters);
/// Bits of an address on the port.
int counter_address_bits(const std::vector<Counters>& counters);

/// The width of counters that the port widens, if each counts up to `events_per_cycle` events in a
/// cycle. A counter may wrap once, but not twice, before the port looks at it again.
int narrow_counter_bits(const std::vector<Counters>& counters, int events_per_cycle);

/// The counters of a system's top: comparisons, recomputations and stalls of each lane. If they are
/// read on a port, the answers of each reference are also counted. None if the system does not
/// count.
std::vector<Counters> system_counters(const SystemShape& shape);
/// The answers of each reference, if they are counted; else none.
std::vector<Counters> answer_counters(const SystemShape& shape);

/// Adds the counters to a module's ports.
void add_counters(const std::vector<Counters>& counters, const SystemShape& shape,
                  std::vector<Port>& ports);

/// Turns the ports `counters` of a top module into wires, and adds an AXI4-Lite port that reads
/// them.
Module with_counter_port(Module top, const std::vector<Counters>& counters,
                         const SystemShape& shape);

}  // namespace mixcmp::rtl
