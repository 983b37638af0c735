#include <time.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cfenv>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <limits>
#include <new>
#include <string>
#include <thread>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

template <class Real>
using BitsOf = std::conditional_t<sizeof(Real) == 8, std::uint64_t, std::uint32_t>;

inline float magnitude(float x) {
  return std::fabs(x);
}
inline double magnitude(double x) {
  return std::fabs(x);
}
inline float square_root(float x) {
  return std::sqrt(x);
}
inline double square_root(double x) {
  return std::sqrt(x);
}

/// minimum of IEEE 754-2019: a NaN operand gives a NaN, and -0 < +0. Equal numbers have the same
/// bits, except for the signs of zeros.
template <class Real>
inline Real minimum(Real a, Real b) {
  using Bits = BitsOf<Real>;
  const Real tied = std::bit_cast<Real>(std::bit_cast<Bits>(a) | std::bit_cast<Bits>(b));
  const Real smaller = a < b ? a : b;
  const Real ordered = a == b ? tied : smaller;
  return a != a ? a : ordered;
}

template <class Real>
inline Real maximum(Real a, Real b) {
  using Bits = BitsOf<Real>;
  const Real tied = std::bit_cast<Real>(std::bit_cast<Bits>(a) & std::bit_cast<Bits>(b));
  const Real larger = a > b ? a : b;
  const Real ordered = a == b ? tied : larger;
  return a != a ? a : ordered;
}

/// 2^floor(log2 |x|) of a normal number. It is 0 for zeros and for subnormal numbers. Subnormal
/// numbers are exact here, since an inexact one is exceptional.
inline float binade(float x) {
  return std::bit_cast<float>(std::bit_cast<std::uint32_t>(x) & 0x7f800000u);
}

/// A filter's condition on an operand: its sign (0: any, 1: sign bit clear, 2: set), and limits for
/// the leading bits of its magnitude.
struct Check {
  std::size_t input;
  int sign;
  int shift;
  std::uint64_t least, greatest;
};

}  // namespace
