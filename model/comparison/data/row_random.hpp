#pragma once

#include <gmpxx.h>

#include <cstdint>
#include <string_view>

#include "model/comparison/data/philox.hpp"

namespace mixcmp::data {

/// The stream of a name: its 32-bit FNV-1a hash.
constexpr std::uint32_t stream_of(std::string_view name) {
  std::uint32_t hash = 0x811c9dc5;
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 0x01000193;
  return hash;
}

/// The random numbers of one row: a pure function of seed, stream and row, so no row depends on the
/// number of rows. Block b of row n is philox(counter = {n low, n high, b, stream}, key = {seed
/// low, seed high}); two words make one number, high word first.
class RowRandom {
public:
  RowRandom(std::uint64_t seed, std::uint32_t stream, std::uint64_t row)
      : key_{low(seed), high(seed)}, counter_{low(row), high(row), 0, stream} {}

  std::uint64_t bits() {
    if (used_ == 4) {
      block_ = philox(counter_, key_);
      ++counter_[2];
      used_ = 0;
    }
    used_ += 2;
    return std::uint64_t{block_[used_ - 2]} << 32 | block_[used_ - 1];
  }

  /// Uniform in 0..end-1, up to a bias of at most end / 2^64, which no test here can detect.
  int below(int end) { return static_cast<int>(bits() % static_cast<std::uint64_t>(end)); }
  /// low..high, both included.
  int between(int low, int high) { return low + below(high - low + 1); }
  bool one_in(int count) { return below(count) == 0; }
  int sign() { return one_in(2) ? -1 : 1; }

  /// Uniform in [0, 2^count).
  mpz_class integer(int count) {
    mpz_class value;
    for (int have = 0; have < count; have += 64) {
      mpz_mul_2exp(value.get_mpz_t(), value.get_mpz_t(), 64);
      value += mpz_class(static_cast<unsigned long>(bits()));
    }
    mpz_fdiv_r_2exp(value.get_mpz_t(), value.get_mpz_t(), static_cast<mp_bitcnt_t>(count));
    return value;
  }

private:
  static constexpr std::uint32_t low(std::uint64_t value) {
    return static_cast<std::uint32_t>(value);
  }
  static constexpr std::uint32_t high(std::uint64_t value) {
    return static_cast<std::uint32_t>(value >> 32);
  }

  PhiloxKey key_;
  PhiloxCounter counter_;
  PhiloxCounter block_ = {};
  int used_ = 4;
};

}  // namespace mixcmp::data
