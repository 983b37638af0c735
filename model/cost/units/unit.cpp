#include "model/cost/units/unit.hpp"

#include <bit>
#include <cstdint>

namespace mixcmp::units {

double Parameter::size() const {
  if (!is_literal()) return static_cast<double>(static_cast<std::int64_t>(bits));
  const auto high = static_cast<std::uint64_t>(bits >> 64);
  return std::popcount(high) + std::popcount(static_cast<std::uint64_t>(bits));
}

Parameter integer(std::string name, long long value) {
  return {.name = std::move(name), .bits = static_cast<std::uint64_t>(value)};
}

}  // namespace mixcmp::units
