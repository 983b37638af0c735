#include "model/lane/fixed/function_error.hpp"

#include <algorithm>

#include "model/base/number/dyadic.hpp"
#include "model/lane/fixed/node_enclosure.hpp"
#include "model/lane/function/taylor.hpp"

namespace mixcmp::fixed {
namespace {

using function::Interval;

/// A function's value has at most W + 8 bits.
constexpr int spare_function_bits = 8;

/// Whether |f(x) - f(y)| <= f(|x - y|): the function is concave and 0 at 0.
bool is_subadditive(const Function& function) {
  if (function.kind() != Function::power) return false;
  return 0 < function.parameter() && function.parameter() < 1;
}

}  // namespace

Range stood_for(const Range& computed, const Range& error) {
  return difference(computed, error);
}

std::optional<Range> moved_by(const Function& function, const Range& computed, const Range& error) {
  const Range real = stood_for(computed, error);
  const Range both = {std::min(computed.low, real.low), std::max(computed.high, real.high)};
  const std::vector<Interval> series = function::taylor_on(function, both, 2);
  if (!series.front().is_bounded()) return std::nullopt;
  if (error == Range{0, 0}) return error;
  std::optional<Range> moved;
  if (series.back().is_bounded()) moved = product(series.back().range(), error);
  if (is_subadditive(function)) {
    const mpq_class furthest = abs(function.inner().factor) * absolute(error).high;
    const Range most = function::value(function.outer(), Interval(furthest)).range();
    if (!moved) moved = {-most.high, most.high};
    narrow(*moved, {-most.high, most.high});
  }
  return moved;
}

int unit_exponent_for(const Range& values, const mpq_class& effect, int bits) {
  const mpq_class greatest = absolute(values).high;
  const int largest = greatest == 0 ? 0 : static_cast<int>(floor_log2(greatest));
  const int digits = largest + 1 - bits;
  if (effect == 0) return digits;
  return std::clamp(static_cast<int>(floor_log2(effect)) - 1, digits - spare_function_bits,
                    largest);
}

}  // namespace mixcmp::fixed
