#pragma once

#include <cstdint>

namespace mixcmp::harness {

/// Decides in which cycles the two sides of a stream are ready to transfer. A decision depends only
/// on the seed, the stream and the cycle.
class Traffic {
public:
  enum class Kind { full_rate, stressed };

  Traffic(Kind kind, std::uint64_t seed) : kind_(kind), seed_(seed) {}

  /// `stream` numbers the streams of a system, each direction by itself.
  bool willing(std::uint64_t stream, std::uint64_t cycle) const {
    if (kind_ == Kind::full_rate) return true;
    // The density changes every 64 cycles, so that FIFOs run empty, run full, and sit in between.
    constexpr unsigned densities[8] = {256, 256, 224, 160, 128, 64, 16, 0};
    const unsigned density = densities[random(2 * stream, cycle / 64) % 8];
    return random(2 * stream + 1, cycle) % 256 < density;
  }

  /// Extra cycles until a memory answers.
  std::uint64_t memory_latency(std::uint64_t stream, std::uint64_t cycle) const {
    return kind_ == Kind::full_rate ? 4 : random(2 * stream, cycle) % 32;
  }

private:
  /// SplitMix64's finaliser over the mixed key.
  std::uint64_t random(std::uint64_t stream, std::uint64_t counter) const {
    std::uint64_t z = seed_ + stream * 0xd1342543de82ef95u + counter * 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return z ^ z >> 31;
  }

  Kind kind_;
  std::uint64_t seed_;
};

}  // namespace mixcmp::harness
