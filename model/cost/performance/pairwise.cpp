#include "model/cost/performance/pairwise.hpp"

#include <algorithm>

#include "model/base/common/check.hpp"
#include "model/cost/performance/streams.hpp"

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

double busy_share(const ItemSet& set, int lanes) {
  const auto items = static_cast<double>(set.items);
  const double pairs =
      set.others > 0 ? items * static_cast<double>(set.others) : items * (items - 1) / 2;
  return pairs / lanes / static_cast<double>(pairwise_word_cycles(set.items, set.others, lanes));
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

double report_words(const scene::EngineSpec& engine, double reported, double undecided) {
  const double to_recompute = engine.lanes_per_group * undecided;
  switch (engine.report_as) {
    case scene::ReportForm::pairs: return to_recompute + engine.lanes_per_group * reported;
    case scene::ReportForm::bitmap:
      return to_recompute + undecided_words(reported, engine.lanes_per_group);
    case scene::ReportForm::count: return to_recompute;
  }
  MIXCMP_CHECK(false);
}

double cycles_between_reports(const scene::EngineSpec& engine, int groups, double words) {
  const int of_busiest = (groups + engine.report_streams - 1) / engine.report_streams;
  return std::max(1.0, of_busiest * words);
}

}  // namespace mixcmp::performance
