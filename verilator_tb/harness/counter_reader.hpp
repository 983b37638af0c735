#pragma once

#include <cstdint>
#include <cstring>
#include <optional>
#include <utility>
#include <vector>

#include "ports.hpp"
#include "protocol.hpp"
#include "system.hpp"

namespace mixcmp::harness {

/// Software at the AXI4-Lite port of a system's counters. It stores the values that it reads in the
/// memory to which `ports.comparisons` and the others are bound, so they are used as if they were
/// ports of the model. A system with counters as ports, or with none, has an empty
/// system::counter_map, and nothing is read.
class CounterReader {
public:
  explicit CounterReader(CounterBus& bus) : bus_(bus) {
    if (!is_there()) return;
    for (Port* valid : {&bus_.arvalid, &bus_.rready, &bus_.awvalid, &bus_.wvalid, &bus_.bready}) {
      valid->set_bit(0, false);
    }
    clear();
  }

  static bool is_there() { return !system::counter_map.empty(); }

  /// Clears the values that were read, as a reset clears the counters.
  void clear() {
    for (const system::MappedCounters& counters : system::counter_map) {
      std::memset(counters.bytes, 0, counters.size);
    }
  }

  /// Reads every counter while nothing is counted. `step` simulates a cycle. Returns the fault on
  /// the bus, if there is one.
  template <class Step>
  std::optional<wire::Fault> read(Step step) {
    if (!is_there()) return {};
    // The port looks at each counter once in a round of two cycles for each.
    int mapped = 0;
    for (const system::MappedCounters& counters : system::counter_map) mapped += counters.count;
    for (int k = 0; k < 2 * mapped + quiet_cycles; ++k) step();
    if (!write(step)) return wire::Fault::counter_port;
    for (const system::MappedCounters& counters : system::counter_map) {
      for (int k = 0; k < counters.count; ++k) {
        if (!read_counter(counters, k, step)) return wire::Fault::counter_port;
      }
    }
    return {};
  }

private:
  static constexpr int quiet_cycles = 32;  ///< more than a count takes through the port
  static constexpr int most_cycles = 64;   ///< that the port may take to accept or to answer
  static constexpr int hold_cycles = 3;    ///< for which a word must wait

  template <class Step>
  bool read_counter(const system::MappedCounters& counters, int k, Step& step) {
    const auto address = static_cast<std::uint64_t>(counters.offset + 8 * k);
    const auto low = read_word(address, step);
    const auto high = read_word(address + 4, step);
    if (!low || !high) return false;
    const std::uint64_t count = *low | *high << 32;
    Port(*counters.bytes)
        .set_field(static_cast<std::size_t>(k) * system::counter_bits, system::counter_bits, count);
    return system::counter_bits == 64 || count >> system::counter_bits % 64 == 0;
  }

  /// Waits for an output of the port. Every output is a register, so its value of a cycle is there
  /// when the cycle begins.
  template <class Step>
  bool wait_for(const Port& signal, Step& step) {
    for (int k = 0; k < most_cycles && !signal.bit(0); ++k) step();
    return signal.bit(0);
  }

  template <class Step>
  std::optional<std::uint64_t> read_word(std::uint64_t address, Step& step) {
    bus_.araddr.set_field(0, system::counter_address_bits, address);
    bus_.arvalid.set_bit(0, true);
    if (bus_.rvalid.bit(0) || !wait_for(bus_.arready, step)) return {};
    step();
    bus_.arvalid.set_bit(0, false);
    if (!wait_for(bus_.rvalid, step)) return {};
    const std::uint64_t word = bus_.rdata.field(0, 32);
    for (int k = 0; k < hold_cycles; ++k) {
      step();
      if (!bus_.rvalid.bit(0) || bus_.rdata.field(0, 32) != word) return {};
    }
    if (bus_.rresp.field(0, 2) != 0) return {};
    bus_.rready.set_bit(0, true);
    step();
    bus_.rready.set_bit(0, false);
    if (bus_.rvalid.bit(0)) return {};
    return word;
  }

  /// Writes ones to the first counter, which the port must refuse.
  template <class Step>
  bool write(Step& step) {
    constexpr std::uint64_t slave_error = 2;
    bus_.awaddr.set_field(0, system::counter_address_bits, 0);
    bus_.wdata.set_field(0, 32, 0xffffffff);
    bus_.wstrb.set_field(0, 4, 0xf);
    bus_.awvalid.set_bit(0, true);
    bus_.wvalid.set_bit(0, true);
    if (!wait_for(bus_.awready, step) || !bus_.wready.bit(0)) return false;
    step();
    bus_.awvalid.set_bit(0, false);
    bus_.wvalid.set_bit(0, false);
    if (!wait_for(bus_.bvalid, step) || bus_.bresp.field(0, 2) != slave_error) return false;
    bus_.bready.set_bit(0, true);
    step();
    bus_.bready.set_bit(0, false);
    return !bus_.bvalid.bit(0);
  }

  CounterBus& bus_;
};

/// The answers that each reference has given since the last reset; empty if they are not counted.
inline std::vector<std::uint64_t> counted_answers(const Port& answers) {
  std::vector<std::uint64_t> counted(system::counted_answers);
  for (std::size_t k = 0; k < counted.size(); ++k) {
    counted[k] = answers.field(k * system::counter_bits, system::counter_bits);
  }
  return counted;
}

}  // namespace mixcmp::harness
