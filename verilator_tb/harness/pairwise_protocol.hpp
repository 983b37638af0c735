#pragma once

#include <cstdint>

#include "protocol.hpp"

/// The messages between the host and the simulator of a pairwise engine, by the rules of
/// protocol.hpp: a request is one set of items; its response holds the reports that left.
namespace mixcmp::harness::wire {

/// The head of a request, followed by the items, item_bytes for each.
struct SetRequest {
  std::uint64_t items;
  std::uint64_t targets;  ///< the first items, which only meet the others; 0: all meet
  /// Not 0: reset the engine this many cycles after the first item was offered.
  std::uint64_t reset_after;
  std::uint64_t last;  ///< not 0: the simulator ends after it
};

enum class SetState : std::uint64_t {
  closed,       ///< the closing beat has left
  interrupted,  ///< the reset came before the closing beat
  stopped,      ///< the engine stands still, or max_violations were seen; the simulator ends
};

/// The head of a response, followed by the reports, the violations, a StreamEnd for each stream
/// and, if they are counted, the answers of each reference since reset (std::uint64_t).
struct SetResponse {
  std::uint64_t reports;
  std::uint64_t violations;
  std::uint64_t cycles;  ///< from the first item's acceptance to the last closing beat's
  /// The engine's counters since reset: recomputations, busy cycles, stalled cycles; only of the
  /// busy cycles `observed` is set.
  CounterValues counters;
  SetState state;
};

/// One pair of a report; a beat of a bitmap has several.
struct ReportedPair {
  std::uint64_t cycle;
  std::uint32_t i;
  std::uint32_t j;
  std::uint64_t tuser;
};

/// The totals of one stream of reports, with its closing beat.
struct StreamEnd {
  std::uint64_t closing_tdata;  ///< of the closing beat
  std::uint64_t closing_tuser;
  std::uint64_t beats;           ///< reports of this set
  std::uint64_t counted_beats;   ///< since reset, by the hardware
  std::uint64_t observed_beats;  ///< since reset, by the harness
};

}  // namespace mixcmp::harness::wire
