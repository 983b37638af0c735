#pragma once

#include <cstdint>

#include "protocol.hpp"

/// What the host and the simulator of a pairwise engine exchange, by the rules of protocol.hpp: a
/// request is one set of items; its response holds the reports that left.
namespace mixcmp::harness::wire {

/// The head of a request, followed by the items, item_bytes for each.
struct SetRequest {
  std::uint64_t items;
  /// Not 0: reset the engine so many cycles after the first item was offered.
  std::uint64_t reset_after;
  std::uint64_t last;  ///< not 0: the simulator ends after it
};

enum class SetState : std::uint64_t {
  closed,       ///< the closing beat has left
  interrupted,  ///< the reset came before the closing beat
  stopped,      ///< the engine stands still, or max_violations were seen; the simulator ends
};

/// The head of a response, followed by the reports, the violations and one CounterValues for each
/// lane, of which only `counted` is set.
struct SetResponse {
  std::uint64_t reports;
  std::uint64_t violations;
  std::uint64_t cycles;         ///< from the first item's acceptance to the closing beat's
  std::uint64_t closing_tdata;  ///< of the closing beat
  std::uint64_t closing_tuser;
  /// The engine's counters since reset: reports, busy cycles, stalled cycles; of the last only
  /// `counted` is set.
  CounterValues counters;
  SetState state;
};

struct ReportedPair {
  std::uint64_t cycle;
  std::uint32_t i;
  std::uint32_t j;
  std::uint64_t tuser;
};

}  // namespace mixcmp::harness::wire
