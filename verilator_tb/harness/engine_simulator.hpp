#pragma once

#include <cstdint>
#include <initializer_list>
#include <vector>

#include "clocked_model.hpp"
#include "counter_reader.hpp"
#include "hold_checker.hpp"
#include "ports.hpp"
#include "protocol.hpp"
#include "settings.hpp"
#include "system.hpp"
#include "traffic.hpp"

namespace mixcmp::harness {

/// The base of all engines' simulators: the model, its clock, resets, protocol violations,
/// counters.
template <class EnginePorts>
class EngineSimulator {
protected:
  EngineSimulator(int count, char** words)
      : settings_(read_settings(count, words)),
        traffic_(settings_.traffic, settings_.seed),
        clocked_(settings_, count, words),
        ports_(clocked_.ports<EnginePorts>()),
        hold_(system::output_streams) {
    clocked_.open_trace(settings_.trace);
  }

  /// Resets the engine. `entering`: the tvalid of each input stream; they are low meanwhile.
  void reset_engine(std::initializer_list<Port*> entering) {
    for (HoldChecker<>& hold : hold_) hold.reset();
    counter_reader_.clear();
    for (Port* tvalid : entering) tvalid->set_bit(0, false);
    for (std::size_t s = 0; s < hold_.size(); ++s) ports_.m_axis_tready.set_bit(s, false);
    ports_.aresetn.set_bit(0, false);
    for (int k = 0; k < reset_cycles; ++k) {
      clocked_.settle(cycle_);
      rise();
    }
    for (std::size_t s = 0; s < hold_.size(); ++s) {
      if (ports_.m_axis_tvalid.bit(s)) violate(wire::Fault::valid_in_reset, 0);
    }
    ports_.aresetn.set_bit(0, true);
  }

  void settle() {
    clocked_.settle(cycle_);
    if (!clocked_.unknown_streams().empty()) violate(wire::Fault::unknown_value, 0);
  }

  void rise() {
    clocked_.rise(cycle_);
    ++cycle_;
  }

  void violate(wire::Fault fault, std::uint64_t tag) {
    violations_.push_back({fault, 0, wire::no_position, tag, cycle_});
    if (++violation_count_ >= wire::max_violations) stopped_ = true;
  }

  void hang() {
    violate(wire::Fault::hung, 0);
    stopped_ = true;
  }

  /// Fetches the counters where they are on a bus. `step` simulates a cycle in which the engine has
  /// nothing to do.
  template <class Step>
  void fetch_counters(Step step) {
    if (const auto fault = counter_reader_.read(step)) violate(*fault, 0);
  }

  /// Reads the engine's own counters into end.counted, from its first place on.
  void read_counters(wire::CounterValues& end, std::initializer_list<const Port*> counters) const {
    if (system::counter_bits == 0) return;
    int place = 0;
    for (const Port* counter : counters) {
      end.counted[place++] = counter->field(0, system::counter_bits);
    }
  }

  const int index_field_bits = (system::index_bits + 7) / 8 * 8;

  Settings settings_;
  Traffic traffic_;
  ClockedModel clocked_;
  EnginePorts ports_;
  CounterReader counter_reader_{ports_.bus};
  std::vector<HoldChecker<>> hold_;          ///< of each stream that leaves
  std::vector<wire::Violation> violations_;  ///< since the last response
  std::uint64_t cycle_ = 0;
  bool stopped_ = false;  ///< the engine hung, or max_violations were seen

private:
  static constexpr int reset_cycles = 1;  ///< as few as docs/ports.md promises

  std::uint64_t violation_count_ = 0;
};

}  // namespace mixcmp::harness
