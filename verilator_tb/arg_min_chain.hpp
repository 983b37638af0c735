#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "model/base/number/verdict.hpp"
#include "model/comparison/data/comparisons.hpp"
#include "model/design/design.hpp"

namespace mixcmp::verilator_tb {

/// What one lane of the chain does for a row.
struct ChainComparison {
  std::size_t lane = 0;
  data::Items items;
  std::span<const Bits> operands;
  ResultWord word;  ///< what the lane, or the reference that it asks, must answer
};

/// The chain of lanes of an arg-min engine, by the golden model: lane k compares the best candidate
/// so far with candidate k + 1.
class ArgMinChain {
public:
  ArgMinChain(const design::Design& design, const data::Comparisons& comparisons)
      : design_(design), comparisons_(comparisons), operands_(comparisons.input_count()) {}

  /// The candidate that a row must be given, where `candidates` were loaded: in a short load the
  /// last one stands in for those that are missing; a load longer than the data starts again with
  /// their first candidate. `see` is called with each comparison.
  std::uint64_t choose(std::uint64_t row, std::uint64_t candidates,
                       const std::function<void(const ChainComparison&)>& see);

private:
  const design::Design& design_;
  const data::Comparisons& comparisons_;
  std::vector<Bits> operands_;
};

}  // namespace mixcmp::verilator_tb
