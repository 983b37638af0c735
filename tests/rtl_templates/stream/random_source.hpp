#pragma once

#include <cstdint>
#include <random>

namespace mixcmp::test {

/// The seeded randomness of one run.
class RandomSource {
public:
  explicit RandomSource(std::uint64_t seed) : engine_(seed) {}

  bool chance(double probability) {
    return static_cast<double>(engine_() >> 11) * 0x1p-53 < probability;
  }
  std::uint32_t word() { return static_cast<std::uint32_t>(engine_() >> 32); }
  std::uint32_t below(std::uint32_t limit) { return word() % limit; }

private:
  std::mt19937_64 engine_;
};

}  // namespace mixcmp::test
