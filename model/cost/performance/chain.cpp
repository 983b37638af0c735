#include "model/cost/performance/chain.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace mixcmp::performance {
namespace {

constexpr int stage_cycles = 1;  ///< of arg_min_stage, in front of each lane
constexpr int queue_cycles = 2;  ///< in front of the chain
/// Extra cycles of a request and its operands compared with lanes that carry these: one in the
/// lane's buffer, two in the engine's memory.
constexpr int refetch_cycles = 3;

int lane_cycles(const Chain& chain) {
  return decided_slot_cycles(chain.streams) + stage_cycles;
}

/// Cycles that the busiest reference needs if recomputations are spread evenly over the lanes. The
/// engine's memory starts one per cycle, for all references together.
double recomputing_cycles(const Chain& chain, double recomputations) {
  if (chain.references == 0) return 0;
  const int busiest = (chain.lanes + chain.references - 1) / chain.references;
  const double each = double(busiest) / chain.lanes * service_cycles(chain.streams);
  return recomputations * std::max(1.0, each);
}

/// The cycles in which a row enters each lane and finally leaves the chain. The latest rows are
/// stored, as many as a lane has slots.
class Entries {
public:
  explicit Entries(const Chain& chain)
      : chain_(chain), slots_(static_cast<std::uint64_t>(chain.streams.slots)), rows_(slots_) {}

  /// Adds the next row and returns its cycles.
  const std::vector<double>& add(const Undecided& undecided) {
    std::vector<double> entries(static_cast<std::size_t>(chain_.lanes) + 1);
    for (int lane = 0; lane <= chain_.lanes; ++lane) {
      double cycle = 0;
      if (lane > 0) {
        const bool waits = undecided(row_, lane - 1);
        cycle = entries[lane - 1] + lane_cycles(chain_) +
                (waits ? recomputation_delay_cycles(chain_) : 0);
      }
      entries[lane] = std::max(cycle, first_free(lane));
    }
    std::vector<double>& place = rows_[row_++ % slots_];
    place = std::move(entries);
    return place;
  }

private:
  /// The earliest cycle for a row at a lane: after the previous row, and with a free slot. A slot
  /// is free when the row that many slots earlier has left the lane.
  double first_free(int lane) const {
    if (row_ == 0) return 0;
    const double behind = rows_[(row_ - 1) % slots_][lane] + 1;
    if (row_ < slots_ || lane == chain_.lanes) return behind;
    return std::max(behind, rows_[row_ % slots_][lane + 1]);
  }

  const Chain& chain_;
  std::uint64_t slots_;
  std::uint64_t row_ = 0;
  std::vector<std::vector<double>> rows_;
};

}  // namespace

int way_cycles(const Chain& chain) {
  return chain.lanes * lane_cycles(chain) + chain.word_latency_cycles + queue_cycles;
}

int recomputation_delay_cycles(const Chain& chain) {
  return undecided_slot_cycles(chain.streams) - decided_slot_cycles(chain.streams) + refetch_cycles;
}

double chain_cycles(const Chain& chain, std::uint64_t rows, const Undecided& undecided) {
  std::uint64_t recomputations = 0;
  const Undecided counted = [&](std::uint64_t row, int lane) {
    const bool found = undecided(row, lane);
    recomputations += found ? 1 : 0;
    return found;
  };
  Entries entries(chain);
  double last = 0;
  for (std::uint64_t row = 0; row < rows; ++row) last = entries.add(counted).back() + 1;
  const double around = way_cycles(chain) - chain.lanes * lane_cycles(chain);
  const double recomputing = recomputing_cycles(chain, static_cast<double>(recomputations));
  return std::max(last + around, recomputing + way_cycles(chain));
}

double recomputations_in_turn(int lanes, std::uint64_t rows, double rate) {
  const auto k = static_cast<double>(lanes);
  const auto n = static_cast<double>(rows);
  if (rate * (k + n) >= k) return k;  // there is one for every lane
  return std::max(0.0, (k - n) * rate + 2 * std::sqrt(k * n * rate * (1 - rate)));
}

double random_chain_cycles(const Chain& chain, std::uint64_t rows, double rate) {
  const auto n = static_cast<double>(rows);
  const double in_turn = recomputations_in_turn(chain.lanes, rows, rate);
  const double recomputing = recomputing_cycles(chain, rate * n * chain.lanes);
  return std::max(n + in_turn * recomputation_delay_cycles(chain), recomputing) + way_cycles(chain);
}

}  // namespace mixcmp::performance
