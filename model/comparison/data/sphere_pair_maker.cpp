#include "model/comparison/data/sphere_pair_maker.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "model/base/number/dyadic.hpp"
#include "model/base/number/exact.hpp"

namespace mixcmp::data {
namespace {

constexpr std::size_t radius_i = 6, radius_j = 7;
constexpr std::size_t first_of_axis[] = {0, 2, 4};

/// floor(log2 100): the largest exponent of a coordinate in the cube of side 100. The exponent of a
/// scale adds to it.
constexpr int cube_exponent = 6;

constexpr NearTieEffort near_tie_effort = {.attempts = 32,
                                           .enough_ulp = std::numeric_limits<double>::infinity()};
/// In samples of 10^6 ordinary pairs, the errors of f and g sum to less than this `enough_ulp`.
constexpr NearTieEffort counterexample_effort = {.attempts = 128, .enough_ulp = 7.25};

mpq_class power_of_ten(int exponent) {
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(exponent));
  return power;
}

/// A Pythagorean quadruple, a^2 + b^2 + c^2 = d^2, by Lebesgue's parametrisation.
struct Quadruple {
  std::array<int, 3> sides;
  int diagonal;
};

Quadruple quadruple(RowRandom& random) {
  const int m = random.below(7), n = random.below(7), p = random.below(7), q = random.below(7);
  return {{m * m + n * n - p * p - q * q, 2 * (m * q + n * p), 2 * (n * q - m * p)},
          m * m + n * n + p * p + q * q};
}

}  // namespace

SpherePairMaker::Row SpherePairMaker::uniform() {
  Row row;
  for (Bits& number : row) number = coordinate(0);
  row[radius_i] = encode(unit(25));
  row[radius_j] = encode(unit(25));
  return row;
}

SpherePairMaker::Row SpherePairMaker::tangent() {
  constexpr int quadruple_digits = 8;  // a diagonal is at most 144
  const Quadruple pythagorean = quadruple(random_);
  // The scaled numbers, and their sums with one digit more, are exact in the format.
  const int digits = random_.between(0, std::max(0, format_.precision() - quadruple_digits - 1));
  const mpz_class factor = random_.integer(digits) + 1;
  Row row;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const mpz_class from = random_.integer(quadruple_digits + digits);
    const mpz_class to = from + factor * pythagorean.sides[axis];
    row[2 * axis] = encode(scaled(from, -digits));
    row[2 * axis + 1] = encode(scaled(to, -digits));
  }
  const mpz_class radii = factor * pythagorean.diagonal;
  const mpz_class share = radii * random_.below(257) / 256;
  row[radius_i] = encode(scaled(share, -digits));
  row[radius_j] = encode(scaled(mpz_class(radii - share), -digits));
  if (random_.one_in(3)) {
    Bits& changed = row[static_cast<std::size_t>(random_.below(8))];
    changed = next(changed, random_.sign());
  }
  return row;
}

SpherePairMaker::Row SpherePairMaker::coincident() {
  Row row = uniform();
  for (const std::size_t at : first_of_axis) row[at + 1] = row[at];
  switch (random_.below(4)) {
    case 0: row[radius_i] = row[radius_j] = format_.zero(false); break;
    case 1:
      row[radius_i] =
          encode(scaled(1, random_.between(format_.min_exponent() - format_.fraction_bits(),
                                           format_.min_exponent() / 2)));
      row[radius_j] = random_.one_in(2) ? row[radius_i] : format_.zero(false);
      break;
  }
  return row;
}

SpherePairMaker::Row SpherePairMaker::nested() {
  Row row = uniform();
  const mpq_class outer = 1 + unit(24), inner = unit(1) * outer;
  const mpq_class reach = scaled(mpq_class(outer - inner), -2 - random_.below(40));
  for (const std::size_t at : first_of_axis) {
    const mpq_class away = random_.sign() * unit(1) * reach;
    row[at + 1] = encode(decode(row[at]) + away);
  }
  row[radius_i] = encode(outer);
  row[radius_j] = encode(inner);
  return row;
}

SpherePairMaker::Row SpherePairMaker::far_from_origin(int decimal_exponent) {
  Row row = uniform();
  const mpq_class away = power_of_ten(decimal_exponent);
  for (std::size_t k = 0; k < radius_i; ++k) row[k] = encode(away + unit(100));
  if (random_.one_in(2)) touch(row);
  return row;
}

SpherePairMaker::Row SpherePairMaker::smallest() {
  const Bits normal = format_.smallest_normal(false);
  switch (random_.below(3)) {
    case 0: return encodings_around(0, 16);
    case 1: return encodings_around(normal, 16);
    default: return touching(format_.min_exponent() / 2 - cube_exponent + random_.between(-8, 8));
  }
}

SpherePairMaker::Row SpherePairMaker::largest() {
  switch (random_.below(3)) {
    case 0: return encodings_around(format_.largest_finite(false), 16);
    case 1: return touching(format_.max_exponent() - random_.below(8));
    default: return touching(format_.max_exponent() / 2 - cube_exponent + random_.between(-4, 4));
  }
}

SpherePairMaker::Row SpherePairMaker::scales() {
  return touching(random_.between(format_.min_exponent() - format_.fraction_bits() - cube_exponent,
                                  format_.max_exponent()));
}

SpherePairMaker::Row SpherePairMaker::mixed_scales() {
  if (random_.one_in(2)) return vanishing();
  Row row;
  for (Bits& number : row) number = signed_randomly(encode(any_exponent()));
  for (const std::size_t k : {radius_i, radius_j}) row[k] = format_.magnitude(row[k]);
  return row;
}

SpherePairMaker::Row SpherePairMaker::vanishing() {
  const int digits = format_.precision();
  const int huge = random_.between(-format_.bias() / 2, format_.bias() / 2 - 2);
  Row row;
  for (const std::size_t at : first_of_axis) {
    const int tiny = huge - random_.between(digits / 2, 2 * digits);
    row[at] = encode(scaled(unit(1), tiny));
    row[at + 1] = random_.one_in(2) ? row[at] : encode(scaled(unit(1), tiny));
  }
  const std::size_t axis = first_of_axis[random_.below(3)];
  const bool halves = random_.one_in(2);
  const mpq_class distance = 1 + unit(1);
  row[axis] = encode(scaled(distance, huge));
  row[axis + 1] = format_.zero(false);
  row[radius_i] = halves ? encode(scaled(distance, huge - 1)) : row[axis];
  row[radius_j] = halves ? row[radius_i] : format_.zero(false);
  return row;
}

SpherePairMaker::Row SpherePairMaker::zero_radii() {
  Row row = uniform();
  const int relation = random_.below(4);
  for (const std::size_t at : first_of_axis) {
    if (relation < 2) row[at + 1] = row[at];
  }
  if (relation == 0) {
    Bits& changed = row[static_cast<std::size_t>(random_.below(6))];
    changed = next(changed, random_.sign());
  }
  for (const std::size_t k : {radius_i, radius_j}) row[k] = signed_randomly(format_.zero(false));
  return row;
}

SpherePairMaker::Row SpherePairMaker::negative_radii() {
  Row row = touching(0);
  row[radius_i] ^= format_.zero(true);
  if (random_.one_in(2)) row[radius_j] ^= format_.zero(true);
  return row;
}

SpherePairMaker::Row SpherePairMaker::grid() {
  const int exponent = -random_.below(8);
  Row row;
  int square = 0;
  for (const std::size_t at : first_of_axis) {
    const int from = random_.below(16);
    const int to = random_.one_in(2) ? from : random_.below(16);
    row[at] = encode(scaled(from, exponent));
    row[at + 1] = encode(scaled(to, exponent));
    square += (to - from) * (to - from);
  }
  const int distance = static_cast<int>(root_of(mpz_class(square)).get_si());
  const int sum = random_.one_in(2) ? distance : random_.below(26);
  const int share = random_.below(sum + 1);
  row[radius_i] = encode(scaled(share, exponent));
  row[radius_j] = encode(scaled(sum - share, exponent));
  return row;
}

SpherePairMaker::Row SpherePairMaker::infinities_and_nans() {
  Row row = uniform();
  const Bits values[] = {format_.infinity(false),      format_.infinity(true),
                         format_.quiet_nan(),          format_.zero(false),
                         format_.zero(true),           format_.largest_finite(false),
                         format_.largest_finite(true), 1};
  for (int changes = random_.between(0, 2); changes > 0; --changes) {
    row[static_cast<std::size_t>(random_.below(8))] = values[random_.below(8)];
  }
  row[static_cast<std::size_t>(random_.below(8))] = values[random_.below(3)];
  return row;
}

SpherePairMaker::Row SpherePairMaker::counterexample() {
  const int last = std::min(last_counterexample, format_.precision());
  const int precision =
      first_counterexample +
      static_cast<int>(row_ % static_cast<std::uint64_t>(last - first_counterexample + 1));
  const NearTieTarget target = {precision, LaneInputs::exact, Rounding::nearest_even,
                                NearTieShape::along_axis, format_};
  return encode(data::near_tie(target, counterexample_effort, random_).pair);
}

SpherePairMaker::Row SpherePairMaker::near_tie(int precision) {
  const LaneInputs inputs = row_ % 2 != 0 ? LaneInputs::rounded : LaneInputs::exact;
  const Rounding rounding = row_ % 4 < 2 ? Rounding::nearest_even : Rounding::toward_zero;
  const NearTieShape shape = random_.one_in(2) ? NearTieShape::along_axis : NearTieShape::diagonal;
  const NearTieTarget target = {precision, inputs, rounding, shape, format_};
  if (random_.one_in(2)) return encode(near_edge(target, random_));
  return encode(data::near_tie(target, near_tie_effort, random_).pair);
}

Bits SpherePairMaker::encode(const mpq_class& value) {
  const Bits bits = from_rational(format_, value);
  overflowed_ = overflowed_ || format_.is_infinite(bits);
  return bits;
}

mpq_class SpherePairMaker::decode(Bits bits) const {
  return format_.is_infinite(bits) ? mpq_class(0) : to_rational(format_, bits);
}

SpherePairMaker::Row SpherePairMaker::encode(const DyadicPair& pair) {
  const int scale = random_.between(0, std::min(3, format_.max_exponent() / 4));
  Row row;
  for (std::size_t k = 0; k < row.size(); ++k) {
    row[k] = encode(scaled(pair.numbers[k], pair.exponent + scale));
  }
  return row;
}

mpq_class SpherePairMaker::unit(const mpq_class& limit) {
  const int digits = format_.precision();
  return scaled(limit * random_.integer(digits), -digits);
}

Bits SpherePairMaker::coordinate(int exponent) {
  return encode(scaled(unit(100), exponent));
}

mpq_class SpherePairMaker::any_exponent() {
  const int exponent =
      random_.between(format_.min_exponent() - format_.fraction_bits(), format_.max_exponent() - 1);
  return scaled(1 + unit(1), exponent);
}

Bits SpherePairMaker::next(Bits value, int steps) const {
  const Bits magnitude = format_.magnitude(value);
  if (steps < 0 && magnitude == 0) return value;
  return magnitude == format_.largest_finite(false) && steps > 0 ? value : value + Bits(steps);
}

Bits SpherePairMaker::signed_randomly(Bits magnitude) {
  return random_.one_in(2) ? magnitude : magnitude | format_.zero(true);
}

void SpherePairMaker::touch(Row& row) {
  constexpr int guard_digits = 16;
  const int digits = format_.precision();
  mpq_class square = 0;
  for (const std::size_t at : first_of_axis) {
    const mpq_class away = decode(row[at]) - decode(row[at + 1]);
    square += away * away;
  }
  mpq_class sum = root_of(square, digits + guard_digits);
  if (!random_.one_in(4)) {
    sum *= 1 + scaled(random_.between(-16, 16), -4 - random_.between(2, digits + 2));
  }
  row[radius_i] = encode(scaled(sum * random_.below(257), -8));
  row[radius_j] = encode(sum - decode(row[radius_i]));
}

SpherePairMaker::Row SpherePairMaker::touching(int exponent) {
  // Radii may sum to 100 * sqrt(3) * 5/4.
  const int fitting = std::min(exponent, format_.max_exponent() - cube_exponent - 2);
  Row row = {};
  for (std::size_t k = 0; k < radius_i; ++k) row[k] = coordinate(fitting);
  touch(row);
  return row;
}

SpherePairMaker::Row SpherePairMaker::encodings_around(Bits middle, int reach) {
  Row row;
  for (std::size_t k = 0; k < row.size(); ++k) {
    const Bits least = middle < Bits(reach) ? 0 : middle - Bits(reach);
    const Bits magnitude = least + Bits(random_.below(2 * reach + 1));
    row[k] = std::min(magnitude, format_.largest_finite(false));
    if (k < radius_i) row[k] = signed_randomly(row[k]);
  }
  return row;
}

}  // namespace mixcmp::data
