#include "model/cost/performance/pairwise.hpp"

#include <algorithm>

namespace mixcmp::performance {

std::uint64_t pairwise_word_cycles(std::uint64_t items, std::uint64_t others, int lanes) {
  const auto block = static_cast<std::uint64_t>(lanes);
  std::uint64_t cycles = 0;
  for (std::uint64_t first = 0; first < items; first += block) {
    const std::uint64_t left = items - first;
    cycles += others > 0 ? std::min(block, left) + others : left;
  }
  return cycles;
}

}  // namespace mixcmp::performance
