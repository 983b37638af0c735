#include "model/cost/performance/pairwise.hpp"

#include <algorithm>

namespace mixcmp::performance {
namespace {

constexpr double cycles_per_segment = 3;
constexpr double fetch_cycles = 1;  ///< of the items' memory, for a pair

}  // namespace

std::uint64_t pairwise_word_cycles(std::uint64_t items, std::uint64_t others, int lanes) {
  const auto block = static_cast<std::uint64_t>(lanes);
  std::uint64_t cycles = 0;
  for (std::uint64_t first = 0; first < items; first += block) {
    const std::uint64_t left = items - first;
    cycles += others > 0 ? std::min(block, left) + others : left;
  }
  return cycles;
}

double pairwise_cycles(const PairwiseSet& set) {
  const auto words = static_cast<double>(pairwise_word_cycles(set.items, set.others, set.lanes));
  const auto exceptions = static_cast<double>(set.exceptions);
  double recomputing = 0;
  if (set.references > 0) {
    const double each = std::max(fetch_cycles, double(set.initiation_interval) / set.references);
    recomputing = static_cast<double>(set.recomputations) * each;
  }
  const double latency = cycles_per_segment * set.segments + set.lane_latency_cycles;
  const auto again = static_cast<double>(set.second_tier_cycles);
  return std::max({words, exceptions, again, recomputing}) + latency;
}

}  // namespace mixcmp::performance
