#pragma once

#include <cstdint>

/// The messages between the host and a simulator over the simulator's standard input, in the
/// machine's byte order. This file is compiled into both. Positions number the comparisons of a run
/// from 0, in the order the host sends them. Every request gets one response; a comparison's result
/// is in the response to its own block or in a later one, in any order.
namespace mixcmp::harness::wire {

/// The head of a request. After it come `resets` positions (each std::uint64_t: reset the system
/// once this many comparisons were offered), then the operands, tdata_bytes for each comparison.
struct Request {
  std::uint64_t comparisons;
  std::uint64_t resets;
  std::uint64_t last;  ///< not 0: let everything leave, answer, end
};

enum class State : std::uint64_t {
  running,
  drained,  ///< after the last request: nothing is inside
  stopped,  ///< a lane stands still, or max_violations were seen; the simulator ends
};

/// The head of a response. After it come the results, the violations and, when drained, one
/// CounterValues for each lane, or group of lanes, and, if they are counted, the answers of each
/// reference (std::uint64_t).
struct Response {
  std::uint64_t results;
  std::uint64_t violations;
  std::uint64_t cycles;  ///< from the first offer to the last result
  State state;
};

/// The most violations that one run reports.
inline constexpr std::uint64_t max_violations = 64;

struct Result {
  std::uint64_t position;
  std::uint64_t cycle_accepted;
  std::uint64_t cycle_left;
  std::uint32_t lane;
  std::uint32_t tdata;  ///< as on m_axis_tdata
};

/// How a system can violate its protocol.
enum class Fault : std::uint32_t {
  valid_dropped,    ///< tvalid fell before tready
  payload_changed,  ///< the payload changed before tready
  unknown_tag,
  duplicate_tag,      ///< a second result of one comparison
  stale_after_reset,  ///< a result of a comparison that a reset had discarded
  valid_in_reset,
  order_broken,  ///< results out of order, in a system that promises order
  lost,          ///< never left, though its lane goes on
  hung,          ///< never left, and its lane takes nothing more
  unknown_refetch,
  unknown_value,      ///< x in a handshake or a beat; only an event-driven simulator sees it
  after_the_end,      ///< pairwise engine: a report behind the closing beat
  closed_early,       ///< pairwise engine: a closing beat before the last item
  loaded_among_rows,  ///< arg-min engine: a candidate accepted while a row is inside
  counter_port,       ///< the AXI4-Lite port of the counters broke a rule of the bus
};

struct Violation {
  Fault fault;
  std::uint32_t lane;      ///< on a refetch stream: its number
  std::uint64_t position;  ///< of the comparison, or no_position
  std::uint64_t tag;
  std::uint64_t cycle;
};

inline constexpr std::uint64_t no_position = ~std::uint64_t{0};

/// Three counters of a lane, a group of lanes or an engine since the last reset, by the hardware
/// and by the harness.
struct CounterValues {
  std::uint64_t counted[3];
  std::uint64_t observed[3];
};

}  // namespace mixcmp::harness::wire
