#pragma once

#include <bit>
#include <cstdint>
#include <utility>

namespace mixcmp::data {

/// A pseudo-random permutation of [0, size): a Feistel network on the next even number of bits,
/// applied repeatedly until its value lies in the range (cycle walking). Its first n values are a
/// sample without replacement.
class Permutation {
public:
  Permutation(std::uint64_t size, std::uint64_t seed)
      : size_(size), half_bits_((static_cast<int>(std::bit_width(size)) + 1) / 2), seed_(seed) {}

  std::uint64_t operator()(std::uint64_t index) const {
    do {
      index = scramble(index);
    } while (index >= size_);
    return index;
  }

private:
  /// SplitMix64's finaliser (Steele, Lea, Flood 2014).
  static std::uint64_t mix(std::uint64_t value) {
    value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9;
    value = (value ^ (value >> 27)) * 0x94d049bb133111eb;
    return value ^ (value >> 31);
  }

  std::uint64_t scramble(std::uint64_t index) const {
    const std::uint64_t mask = (std::uint64_t{1} << half_bits_) - 1;
    std::uint64_t left = index >> half_bits_, right = index & mask;
    for (std::uint64_t round = 0; round < 4; ++round) {
      left ^= mix(seed_ + mix(right * 4 + round)) & mask;
      std::swap(left, right);
    }
    return left << half_bits_ | right;
  }

  std::uint64_t size_;
  int half_bits_;
  std::uint64_t seed_;
};

}  // namespace mixcmp::data
