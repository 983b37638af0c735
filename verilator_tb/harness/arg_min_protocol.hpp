#pragma once

#include <cstdint>

#include "protocol.hpp"

/// The messages between the host and the simulator of an arg-min engine, by the rules of
/// protocol.hpp: a request is one load of candidates and the rows after it; its response holds the
/// rows that left.
namespace mixcmp::harness::wire {

/// The head of a request, followed by the candidates, item_bytes for each, and the rows, row_bytes
/// for each.
struct LoadRequest {
  std::uint64_t candidates;
  std::uint64_t rows;
  /// Not 0: once this many rows were accepted, load the same candidates again, ahead of the others.
  std::uint64_t reload_after;
  /// Not 0: reset the engine this many cycles after the first candidate was offered.
  std::uint64_t reset_after;
  std::uint64_t last;  ///< not 0: the simulator ends after it
};

enum class LoadState : std::uint64_t {
  complete,     ///< every row has left
  interrupted,  ///< the reset came before all rows had left
  stopped,      ///< the engine stands still, or max_violations were seen; the simulator ends
};

/// The head of a response. After it come the rows that left, in the order of leaving, the
/// violations, one CounterValues for each lane with only `counted` set, and, if they are counted,
/// the answers of each reference since reset (std::uint64_t).
struct LoadResponse {
  std::uint64_t rows;
  std::uint64_t violations;
  std::uint64_t loading_cycles;  ///< from the first candidate's acceptance to the first row's
  std::uint64_t cycles;          ///< from the first row's acceptance to the last one's departure
  std::uint64_t overrun;         ///< value of the port when the last row had left
  /// The engine's counters since reset: rows, stalled cycles. For stalled cycles only `counted` is
  /// set.
  CounterValues counters;
  LoadState state;
};

struct RowResult {
  std::uint64_t index;
  std::uint64_t cycle_accepted;
  std::uint64_t cycle_left;
};

}  // namespace mixcmp::harness::wire
