#include "verilator_tb/arg_min_chain.hpp"

#include <algorithm>

#include "verilator_tb/judgement.hpp"

namespace mixcmp::verilator_tb {

std::uint64_t ArgMinChain::choose(std::uint64_t row, std::uint64_t candidates,
                                  const std::function<void(const ChainComparison&)>& see) {
  const std::uint64_t all = comparisons_.tables()[1].rows(), last = candidates - 1;
  std::uint64_t best = 0;
  for (std::size_t lane = 0; lane < static_cast<std::size_t>(design_.lane_count()); ++lane) {
    const data::Items items = {.row = row,
                               .first = std::min(best, last) % all,
                               .second = std::min<std::uint64_t>(lane + 1, last) % all};
    comparisons_.fetch(items, operands_);
    const std::size_t group = design_.group_of_lane(static_cast<int>(lane));
    const ResultWord word = expected_word(design_, group, operands_);
    see({lane, items, operands_, word});
    if (word.verdict() == Verdict::greater) best = lane + 1;
  }
  return best;
}

}  // namespace mixcmp::verilator_tb
