#pragma once

#include <cstdint>
#include <functional>

#include "model/cost/performance/streams.hpp"

/// The time that the chain of an arg-min engine takes for a stream of rows. A row is offered in
/// every cycle, and a result is always taken. docs/theory.md derives each formula.
namespace mixcmp::performance {

/// The lanes of an arg-min engine, one behind the other, all alike.
struct Chain {
  int lanes = 1;                ///< p_L: one for each candidate but the first
  LaneStreams streams;          ///< of each lane; its order is in_order
  int references = 1;           ///< p_H; 0: every lane decides every row
  int word_latency_cycles = 0;  ///< of the conversion
};

/// Cycles from a row's entry to its exit if every lane decides it.
int way_cycles(const Chain& chain);
/// Cycles by which a recomputation delays its row, and later rows in the same lane, if the
/// reference is free.
int recomputation_delay_cycles(const Chain& chain);

/// Whether lane `lane` (0 .. p_L - 1) leaves row `row` undecided.
using Undecided = std::function<bool(std::uint64_t row, int lane)>;

/// Cycles from the first row's entry to the last one's exit. A row enters a lane when that has a
/// free slot, at least one cycle after the previous row. Rows do not overtake.
double chain_cycles(const Chain& chain, std::uint64_t rows, const Undecided& undecided);

/// The expected cycles if each comparison is undecided independently with probability `rate`.
double random_chain_cycles(const Chain& chain, std::uint64_t rows, double rate);

/// Recomputations that must follow one another: the most on any path through lanes and rows on
/// which each lane has at most one and no row comes before an earlier one. This is the expected
/// number for many rows and lanes if comparisons are undecided independently: oriented digital
/// boiling (J. Gravner, C. Tracy, H. Widom, "Limit theorems for height fluctuations in a class of
/// discrete space and time growth models", J. Stat. Phys. 102, 2001).
double recomputations_in_turn(int lanes, std::uint64_t rows, double rate);

}  // namespace mixcmp::performance
