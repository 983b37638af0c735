#include "model/judge/proof/claims.hpp"

#include <algorithm>

#include "model/lane/error/error_analysis.hpp"

namespace mixcmp::proof {
namespace {

constexpr long kept_digits = 460;

enum class Direction { down, up };

/// Rounds a value to about `kept_digits` binary digits.
mpq_class shortened(const mpq_class& value, Direction direction) {
  if (value == 0) return value;
  const mpq_class unit = power_of_two(binade_of(value) - kept_digits);
  const mpq_class steps = value / unit;
  mpz_class whole = steps.get_num() / steps.get_den();
  if (direction == Direction::up && whole != steps) ++whole;
  return whole * unit;
}

}  // namespace

std::vector<NodeClaim> relative_claims(const error::Lane& lane) {
  std::vector<bool> nonnegative;
  for (int input = 0; input < lane.graph.input_count; ++input) {
    nonnegative.push_back(is_checked_nonnegative(lane.checks, input));
  }
  std::vector<NodeClaim> claims;
  for (const error::NodeBound& bound : error::analyse_errors(lane.graph, nonnegative).nodes) {
    claims.push_back({bound.relative, bound.unrounded, bound.nonnegative, bound.nonpositive});
  }
  return claims;
}

bool is_checked_nonnegative(const std::vector<error::RangeCheck>& checks, int input) {
  return std::any_of(checks.begin(), checks.end(), [&](const error::RangeCheck& check) {
    return check.input == input && check.sign == error::RequiredSign::nonnegative;
  });
}

error::RelativeBound provable(const error::RelativeBound& bound, int depth) {
  if (bound.low == 1 && bound.high == 1) return bound;
  const mpq_class widening = power_of_two(2L * depth - widening_bits);
  return {shortened(bound.low * (1 - widening), Direction::down),
          shortened(bound.high * (1 + widening), Direction::up)};
}

mpq_class rounded_down(const mpq_class& value) {
  return shortened(value, Direction::down);
}

mpq_class rounded_up(const mpq_class& value) {
  return shortened(value, Direction::up);
}

long binade_of(const mpq_class& value) {
  const auto bits = [](const mpz_class& number) {
    return static_cast<long>(mpz_sizeinbase(number.get_mpz_t(), 2));
  };
  return bits(value.get_num()) - bits(value.get_den());
}

}  // namespace mixcmp::proof
