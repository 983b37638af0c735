#include "model/judge/emulator/combine_parts.hpp"

#include <array>
#include <cstdint>

namespace mixcmp::emulator {
namespace {

/// The rank of each Decision. When parts are combined, the highest rank wins.
constexpr std::array<std::uint8_t, 5> ranks_of_all = {0, 1, 4, 2, 3};
constexpr std::array<std::uint8_t, 5> ranks_of_any = {4, 1, 0, 2, 3};

}  // namespace

void combine_parts(Combination combination, std::span<Decision> decisions,
                   std::span<const Decision> further) {
  const auto& ranks = combination == Combination::all ? ranks_of_all : ranks_of_any;
  const auto rank = [&](Decision decision) { return ranks[static_cast<std::size_t>(decision)]; };
  for (std::size_t k = 0; k < decisions.size(); ++k) {
    if (rank(further[k]) > rank(decisions[k])) decisions[k] = further[k];
  }
}

}  // namespace mixcmp::emulator
