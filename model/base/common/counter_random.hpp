#pragma once

#include <cstdint>

namespace mixcmp::inline common {

/// SplitMix64's output for a counter: the same however the work is split.
constexpr std::uint64_t counter_random(std::uint64_t seed, std::uint64_t counter) {
  std::uint64_t z = seed * 0xd1342543de82ef95u + (counter + 1) * 0x9e3779b97f4a7c15u;
  z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
  z = (z ^ z >> 27) * 0x94d049bb133111ebu;
  return z ^ z >> 31;
}

}  // namespace mixcmp::inline common
