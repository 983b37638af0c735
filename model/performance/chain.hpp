#pragma once

#include <cstdint>
#include <functional>

#include "model/performance/streams.hpp"

/// How long the chain of an arg-min engine takes for a stream of rows: a row is offered in every
/// cycle, a result is always taken. docs/performance.md derives each.
namespace mixcmp::performance {

/// The lanes of an arg-min engine, one behind the other, all alike.
struct Chain {
  int lanes = 1;                ///< p_L: one for each candidate but the first
  LaneStreams streams;          ///< of each lane; its order is in_order
  int references = 1;           ///< p_H
  int word_latency_cycles = 0;  ///< of the conversion
};

/// Cycles from a row's entry to its exit where no lane leaves it undecided.
int way_cycles(const Chain& chain);
/// Cycles by which a recomputation holds up its row, and the rows behind it in the same lane, where
/// the reference is free.
int recomputation_delay_cycles(const Chain& chain);

/// Whether lane `lane` (0 .. p_L - 1) leaves row `row` undecided.
using Undecided = std::function<bool(std::uint64_t row, int lane)>;

/// Cycles from the first row's entry to the last one's exit. A row enters a lane one cycle after
/// the row before it at the earliest, and when that lane has a free slot. Rows do not overtake.
double chain_cycles(const Chain& chain, std::uint64_t rows, const Undecided& undecided);

/// The cycles to expect where each comparison is undecided by itself with this probability.
double random_chain_cycles(const Chain& chain, std::uint64_t rows, double rate);

/// Recomputations that no row can be spared: the most that lie on a path through lanes and rows on
/// which each lane has one at most and no row comes before an earlier one. Expected for many rows
/// and lanes where each comparison is undecided by itself: oriented digital boiling (J. Gravner,
/// C. Tracy, H. Widom, "Limit theorems for height fluctuations in a class of discrete space and
/// time growth models", J. Stat. Phys. 102, 2001).
double recomputations_in_turn(int lanes, std::uint64_t rows, double rate);

}  // namespace mixcmp::performance
