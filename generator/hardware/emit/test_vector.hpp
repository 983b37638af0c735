#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "model/base/number/verdict.hpp"

namespace mixcmp::emit {

/// A comparison that the test bench sends, and the word in which the result must return.
struct TestVector {
  std::vector<std::uint8_t> tdata;  ///< s_axis_tdata of one lane, the lowest byte first
  ResultWord expected;
};

/// A set of items for a pairwise engine, and the word that the lane of each pair must find.
struct PairwiseVectors {
  std::vector<std::vector<std::uint8_t>> items;  ///< s_axis_tdata of each, at least two
  std::size_t targets = 0;           ///< the first items, which only meet the others; 0: all meet
  std::vector<ResultWord> expected;  ///< of the pairs, in the order of the first item, then of the
                                     ///< second: (0,1), (0,2), ..., (1,2), ...
};

/// A row for an arg-min engine.
struct RowVector {
  std::vector<std::uint8_t> tdata;
  std::uint32_t choice = 0;         ///< the candidate that must leave
  std::vector<bool> is_recomputed;  ///< [lane]: its comparison is recomputed
};

/// Candidates and rows for an arg-min engine.
struct ArgMinVectors {
  std::vector<std::vector<std::uint8_t>> candidates;  ///< s_candidate_tdata of each
  std::vector<RowVector> rows;
};

/// The vectors of an engine's test bench; std::monostate without an engine.
using EngineVectors = std::variant<std::monostate, PairwiseVectors, ArgMinVectors>;

}  // namespace mixcmp::emit
