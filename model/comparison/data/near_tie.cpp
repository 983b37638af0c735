#include "model/comparison/data/near_tie.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

#include "model/base/common/check.hpp"
#include "model/base/number/dyadic.hpp"

namespace mixcmp::data {
namespace {

/// 2^exponent; zero for a negative exponent.
mpz_class whole_power_of_two(int exponent) {
  return exponent < 0 ? mpz_class(0) : shifted_left(1, exponent);
}

struct Sides {
  mpz_class f;
  mpz_class g;
};

/// f and g of the numbers, each result passed through `round`.
template <class Round>
Sides sides_of(const std::array<mpz_class, 8>& numbers, const Round& round) {
  std::array<mpz_class, 3> squares;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const mpz_class difference = round(mpz_class(numbers[2 * axis] - numbers[2 * axis + 1]));
    squares[axis] = round(mpz_class(difference * difference));
  }
  const mpz_class radii = round(mpz_class(numbers[6] + numbers[7]));
  const mpz_class sum = round(mpz_class(squares[0] + squares[1]));
  return {round(mpz_class(sum + squares[2])), round(mpz_class(radii * radii))};
}

Sides exact_sides(const std::array<mpz_class, 8>& numbers) {
  return sides_of(numbers, [](mpz_class value) { return value; });
}

Sides lane_sides(std::array<mpz_class, 8> numbers, const NearTieTarget& target) {
  const auto round = [&](const mpz_class& value) {
    return rounded(value, target.precision, target.rounding);
  };
  const int digits = target.inputs.digits(target.precision, target.reference.precision());
  for (mpz_class& number : numbers) number = rounded(number, digits, target.rounding);
  return sides_of(numbers, round);
}

/// Numbers are integers in units of 2^-fraction_bits; distances lie just above 1.
class NearTieMaker {
public:
  using Numbers = std::array<mpz_class, 8>;

  NearTieMaker(const NearTieTarget& target, RowRandom& random)
      : target_(target),
        digits_(target.reference.precision()),
        read_digits_(target.inputs.digits(target.precision, digits_)),
        misread_inputs_(read_digits_ < digits_),
        fraction_bits_(std::min(2 * digits_ - 1, digits_ - 1 - target.reference.min_exponent())),
        shared_(misread_inputs_ || random.one_in(2)),
        quantum_bits_(shared_ ? std::max(0, fraction_bits_ - digits_ + 3) : 0),
        wrong_way_(random.sign()),
        random_(random) {
    MIXCMP_CHECK(target.precision <= digits_);
  }

  int fraction_bits() const { return fraction_bits_; }

  /// Makes the centres; the radii are not set yet.
  Numbers centres() {
    Numbers numbers;
    if (misread_inputs_) {
      misread_centres(numbers);
    } else {
      exact_centres(numbers);
    }
    return numbers;
  }

  /// The shortest sum of radii above the distance, or the longest below it.
  mpz_class closest_radii(const Numbers& numbers) const {
    const mpz_class square = exact_sides(numbers).f;
    mpz_class radii = quantized(root_of(square), quantum_bits_);
    if (wrong_way_ > 0) return radii + whole_power_of_two(quantum_bits_);
    if (radii * radii == square) radii -= whole_power_of_two(quantum_bits_);
    return radii;
  }

  /// A sum of radii that differs from `sum` by at most 10 * 2^-L of it.
  mpz_class moved(const mpz_class& sum) {
    const mpz_class step = sum * random_.between(-160, 160) >> (target_.precision + 4);
    return quantized(sum + step, quantum_bits_);
  }

  void share_radii(Numbers& numbers, const mpz_class& sum) {
    if (!shared_) {
      numbers[6] = quantized(sum, std::max(0, digits_of(sum) - digits_));
    } else {
      numbers[6] = quantized(sum * random_.below(257) / 256, quantum_bits_);
      if (misread_inputs_) {
        const mpz_class read = rounded(numbers[6], read_digits_, Rounding::toward_zero);
        numbers[6] = std::min(misread(read, read_digits_, wrong_way_), sum);
      }
    }
    numbers[7] = sum - numbers[6];
    if (random_.one_in(2)) std::swap(numbers[6], numbers[7]);
  }

  /// By how much, in units of 2^-L, the lane's order contradicts the order for which the radii were
  /// made.
  double contradiction_ulp(const Numbers& numbers) const {
    const Sides lane = lane_sides(numbers, target_);
    const mpz_class difference = shifted_left(lane.f - lane.g, target_.precision);
    const mpz_class& larger = std::max(lane.f, lane.g);
    return larger == 0 ? 0 : wrong_way_ * mpq_class(difference, larger).get_d();
  }

private:
  bool to_nearest() const { return target_.rounding == Rounding::nearest_even; }

  /// The largest error of rounding to `digits` around `value`: half a last place to nearest, a
  /// whole one toward zero.
  mpz_class reach(const mpz_class& value, int digits) const {
    return whole_power_of_two(digits_of(value) - 1 - digits + (to_nearest() ? 0 : 1));
  }
  mpz_class one() const { return whole_power_of_two(fraction_bits_); }
  /// 1 plus this many last places of a number of `digits`.
  mpz_class one_and(const mpz_class& last_places, int digits) const {
    return one() + shifted_left(last_places, std::max(0, fraction_bits_ - digits + 1));
  }

  /// A random power of two that is small compared with reach(), or zero.
  mpz_class hair(int digits) {
    const int least = quantum_bits_ + (to_nearest() ? -1 : 2);
    const int end = fraction_bits_ - digits - 1;
    const int exponent = random_.between(least, std::max(least, end));
    return exponent < quantum_bits_ || exponent >= end ? mpz_class(0)
                                                       : whole_power_of_two(exponent);
  }

  /// A number that is rounded to `value`, a number of `digits`, although it is larger (way 1) or
  /// smaller (way -1) by nearly reach(). Rounding toward zero never rounds up. The number is then a
  /// hair larger instead of smaller, so that later roundings do not fall below `value`.
  mpz_class misread(const mpz_class& value, int digits, int way) {
    if (!to_nearest() && way < 0) return value + hair(digits);
    const mpz_class error = std::max<mpz_class>(reach(value, digits) - hair(digits), 0);
    return value + way * quantized(error, quantum_bits_);
  }

  /// m such that the rounding error of (1 + 2um)^2 is near its maximum: 4u^2m^2 is just below (way
  /// 1) or above (way -1) an odd multiple of u; with rounding toward zero, an even one. In one case
  /// out of five it is any m of that size.
  mpz_class misleading_places(int k, int way) {
    if (random_.one_in(5)) return random_.integer(target_.precision / 2 + 1);
    const int multiple = 2 * k + (to_nearest() ? 1 : 2);
    const mpz_class root = root_of(shifted_left(multiple, target_.precision - 2));
    return way < 0 ? mpz_class(root + 1) : root;
  }

  /// A number of the lane's format below `value`, by at most a quarter of it or, in longer lanes,
  /// by 8 * 2^(-L/2) of it. It is the best of several such numbers: its square has the largest
  /// rounding error in the wanted direction.
  mpz_class near_misleading_square(const mpz_class& value, int way) {
    constexpr int tries = 8;
    const int nearness = std::max(2, target_.precision / 2 - 3);
    mpz_class best, best_error = -1;
    for (int k = 0; k < tries; ++k) {
      const mpz_class below = (value * random_.below(1 << 10)) >> (10 + nearness);
      const mpz_class candidate =
          rounded(mpz_class(value - below), target_.precision, Rounding::toward_zero);
      const mpz_class square = candidate * candidate;
      const mpz_class error = way * (square - rounded(square, target_.precision, target_.rounding));
      if (error <= best_error) continue;
      best = candidate;
      best_error = error;
    }
    return best;
  }

  void exact_centres(Numbers& numbers) {
    constexpr int tries = 16;  // lanes of few digits may have no such diagonal
    for (int k = 0; target_.shape == NearTieShape::diagonal && k < tries; ++k) {
      if (diagonal_centres(numbers)) return;
    }
    while (!centres_along_axis(numbers)) {
    }
  }

  /// Makes a near tie with x and r just above 1. False if no y makes the distance r.
  bool centres_along_axis(Numbers& numbers) {
    const int k = random_.below(3);
    const mpz_class x_places = misleading_places(k, -wrong_way_);
    const mpz_class r_places = misleading_places(k + random_.between(1, 4), wrong_way_);
    const int digits = target_.precision;
    const mpz_class x = misread(one_and(x_places, digits), digits, -wrong_way_);
    const mpz_class r = misread(one_and(r_places, digits), digits, wrong_way_);
    mpz_class z_square = shifted_left(reach(one(), digits), fraction_bits_);
    z_square += wrong_way_ * (z_square >> random_.between(1, target_.precision / 2 + 2));
    return place_with(numbers, x, root_of(z_square), r);
  }

  /// Makes a near tie with x just above 1, z near sqrt(1/2) and r just below sqrt(2). False if no y
  /// makes the distance r.
  bool diagonal_centres(Numbers& numbers) {
    const mpz_class root_of_half = root_of(whole_power_of_two(2 * fraction_bits_ - 1));
    const int digits = target_.precision;
    const mpz_class x = one_and(misleading_places(random_.below(3), -wrong_way_), digits);
    const mpz_class z = near_misleading_square(root_of_half, -wrong_way_);
    const mpz_class r = near_misleading_square(2 * root_of_half, wrong_way_);
    return place_with(numbers, misread(x, digits, -wrong_way_), misread(z, digits, -wrong_way_),
                      misread(r, digits, wrong_way_));
  }

  /// Sets the centres (x, y, z) apart, with the y that makes their distance r; false if there is no
  /// such y. x and y may change places.
  bool place_with(Numbers& numbers, const mpz_class& x, const mpz_class& z, const mpz_class& r) {
    const mpz_class y_square = r * r - x * x - z * z;
    if (y_square <= 0) return false;
    const std::size_t first = random_.one_in(2) ? 2 : 0;
    place(numbers, first, x);
    place(numbers, 2 - first, root_of(y_square));
    place(numbers, 4, z);
    return true;
  }

  /// Sets two coordinates to this distance, rounded to the quantum.
  void place(Numbers& numbers, std::size_t at, mpz_class distance) {
    distance = quantized(distance, quantum_bits_);
    mpz_class& first = numbers[at];
    mpz_class& second = numbers[at + 1];
    if (shared_) {
      second = shifted_left(random_.integer(fraction_bits_ - quantum_bits_), quantum_bits_);
      first = second + distance;
    } else {
      first = quantized(distance, std::max(0, digits_of(distance) - digits_));
      second = first - distance;
    }
    if (random_.one_in(2)) std::swap(first, second);
  }

  void misread_centres(Numbers& numbers) {
    for (const std::size_t at : {0, 2, 4}) {
      mpz_class near = one_and(random_.integer(read_digits_ - 1), read_digits_);
      mpz_class far = one_and(random_.integer(read_digits_ - 1), read_digits_);
      if (near > far) std::swap(near, far);
      numbers[at] = misread(far, read_digits_, -wrong_way_);
      numbers[at + 1] = misread(near, read_digits_, wrong_way_);
      if (random_.one_in(2)) std::swap(numbers[at], numbers[at + 1]);
    }
  }

  NearTieTarget target_;
  int digits_;
  int read_digits_;      ///< of the operands as the lane reads them
  bool misread_inputs_;  ///< the lane rounds the operands themselves
  int fraction_bits_;
  bool shared_;  ///< both items share a distance; else one has all except its last digits
  int quantum_bits_;
  int wrong_way_;  ///< 1: the truth is less, the lane shall say greater; -1: the reverse
  RowRandom& random_;
};

}  // namespace

NearTie near_tie(const NearTieTarget& target, const NearTieEffort& effort, RowRandom& random) {
  NearTieMaker builder(target, random);
  NearTie best = {{{}, -builder.fraction_bits()}, -std::numeric_limits<double>::infinity()};
  for (int attempt = 0; attempt < effort.attempts && best.contradiction_ulp < effort.enough_ulp;
       ++attempt) {
    NearTieMaker::Numbers numbers = builder.centres();
    builder.share_radii(numbers, builder.closest_radii(numbers));
    const double contradiction_ulp = builder.contradiction_ulp(numbers);
    if (contradiction_ulp <= best.contradiction_ulp) continue;
    best.contradiction_ulp = contradiction_ulp;
    best.pair.numbers = std::move(numbers);
  }
  return best;
}

DyadicPair near_edge(const NearTieTarget& target, RowRandom& random) {
  NearTieMaker builder(target, random);
  NearTieMaker::Numbers numbers = builder.centres();
  builder.share_radii(numbers, builder.moved(builder.closest_radii(numbers)));
  return {std::move(numbers), -builder.fraction_bits()};
}

}  // namespace mixcmp::data
