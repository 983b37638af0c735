#include "model/lane/function/piecewise.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <array>
#include <initializer_list>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "model/base/number/dyadic.hpp"
#include "tests/support/function_values.hpp"

/// Tests piecewise polynomials against values by MPFR: every argument of few bits, and the ends of
/// pieces among many.
namespace mixcmp::test::piecewise_test {
namespace {

using function::approximate;
using function::evaluate;
using function::Piecewise;
using function::ProductKind;

std::string describe(const Function& function, const Piecewise& piecewise,
                     const mpz_class& argument) {
  return fmt::format("{} of {} in {}, {} address bits, degree {}, to {}", to_string(function),
                     argument.get_str(), piecewise.argument.format.name(), piecewise.address_bits(),
                     piecewise.degree(), piecewise.result.name());
}

bool holds(const FixedFormat& format, const mpz_class& number) {
  return format.smallest() <= number && number <= format.largest();
}

/// Checks what a table promises of its shape.
void expect_well_formed(const Piecewise& piecewise, int unit_exponent) {
  const mpq_class unit = power_of_two(unit_exponent);
  EXPECT_TRUE(-unit < piecewise.error.low && piecewise.error.high < unit);
  EXPECT_LE(piecewise.error.low, piecewise.error.high);
  EXPECT_EQ(piecewise.result.unit_exponent, unit_exponent);
  EXPECT_LE(piecewise.address_bits(), function::most_address_bits);
  EXPECT_GE(piecewise.piece_bits, 0);
  const bool has_sign_in_address = piecewise.argument.format.is_signed && piecewise.starts.empty();
  EXPECT_GE(piecewise.address_bits(), has_sign_in_address ? 1 : 0);
  for (const auto& coefficient : piecewise.coefficients) {
    ASSERT_EQ(coefficient.words.size(), std::size_t{1} << piecewise.address_bits());
    for (std::size_t k = 0; k < coefficient.words.size(); ++k) {
      EXPECT_TRUE(holds(coefficient.format, coefficient.words[k]));
    }
  }
}

/// Checks the result at one argument.
void expect_right(const Function& function, const Piecewise& piecewise, const mpz_class& argument) {
  const mpz_class result = evaluate(piecewise, argument);
  const mpq_class computed = result * piecewise.result.unit();
  const Range truth = value_at(function, argument * piecewise.argument.format.unit());
  EXPECT_TRUE(holds(piecewise.result, result)) << describe(function, piecewise, argument);
  EXPECT_TRUE(computed - truth.low >= piecewise.error.low &&
              computed - truth.high <= piecewise.error.high)
      << describe(function, piecewise, argument) << ": off by "
      << mpq_class(computed - truth.low).get_d() << ", not within [" << piecewise.error.low.get_d()
      << ", " << piecewise.error.high.get_d() << "]";
}

/// The arguments that are tried lie between both numbers, where the function has values.
struct Arguments {
  FixedFormat format;
  mpz_class least, greatest;
};

/// Ranges of a format: all of it; without its ends, so that the outermost pieces are not full; one
/// argument; around 0.
std::vector<Arguments> ranges_of(const FixedFormat& format) {
  const mpz_class low = format.smallest(), high = format.largest(), middle = (low + high) / 2;
  std::vector<Arguments> all = {{format, low, high},
                                {format, low + 3, high - 5},
                                {format, middle + 1, high},
                                {format, middle + 7, middle + 7},
                                {format, high, high}};
  if (format.is_signed) all.push_back({format, -3, 2});
  return all;
}

/// Maps of both directions, exact and not in binary.
const std::vector<AffineMap> maps = {
    {}, {.factor = -1}, {.factor = mpq_class(-1, 3), .offset = mpq_class(2, 7)}, {.offset = 1}};

/// The function of a map's value. Lanes have no such tables of points.
Function mapped(const Function& function, const AffineMap& map) {
  return function.kind() == Function::table ? function : function.of(map);
}

/// The real arguments; they lie in the domain of the function.
bool has_values(const Function& function, const Arguments& arguments) {
  const mpq_class unit = arguments.format.unit();
  const Range argument = {arguments.least * unit, arguments.greatest * unit};
  const Range real = function.inner().of(argument);
  const Domain accepted = domain(function);
  if (accepted.low && !accepted.contains(argument.low)) return false;
  if (accepted.high && !accepted.contains(argument.high)) return function.kind() == Function::table;
  return function.kind() != Function::tan ||
         (real.low > mpq_class(-3, 2) && real.high < mpq_class(3, 2));
}

class EveryArgument : public testing::TestWithParam<Function> {};

/// Arguments below 2^reach in magnitude, in so many bits.
FixedFormat format_below(int reach, int width, bool is_signed) {
  return {width, reach - (is_signed ? width - 1 : width), is_signed};
}

TEST_P(EveryArgument, HasAResultWithinTheError) {
  constexpr std::array reaches = {-2, 0, 1, 3};
  constexpr std::array unit_exponents = {-13, -7, -2};
  std::size_t tables = 0;
  for (int width = 6; width <= 12; ++width) {
    for (const bool is_signed : {false, true}) {
      for (std::size_t range = 0; range < 6; ++range, ++tables) {
        const FixedFormat format = format_below(reaches[tables % 4], width, is_signed);
        const int unit_exponent = unit_exponents[tables % 3];
        const std::vector<Arguments> ranges = ranges_of(format);
        const Function function = mapped(GetParam(), maps[tables / 3 % maps.size()]);
        if (range >= ranges.size() || !has_values(function, ranges[range])) continue;
        const Arguments& arguments = ranges[range];
        const ProductKind products = tables % 5 < 3 ? ProductKind::embedded : ProductKind::logic;
        const auto piecewise = approximate(function, {format}, arguments.least, arguments.greatest,
                                           unit_exponent, products);
        // Otherwise a table may have a word for each argument.
        if (!piecewise && width > function::most_address_bits) continue;
        ASSERT_TRUE(piecewise) << format.name() << ", " << unit_exponent;
        expect_well_formed(*piecewise, unit_exponent);
        for (mpz_class x = arguments.least; x <= arguments.greatest; ++x) {
          expect_right(function, *piecewise, x);
        }
        if (HasFailure()) return;
      }
    }
  }
}

/// The arguments at which a piece begins and their neighbours, both ends of the range, and some in
/// between.
std::set<mpz_class> hard_arguments(const Piecewise& piecewise, const Arguments& arguments,
                                   std::mt19937_64& random) {
  std::set<mpz_class> all = {arguments.least, arguments.greatest};
  const auto include = [&](const mpz_class& x) {
    if (arguments.least <= x && x <= arguments.greatest) all.insert(x);
  };
  const mpz_class span = arguments.greatest - arguments.least + 1;
  for (int k = 0; k < 200; ++k) include(arguments.least + mpz_class(random() >> 1) % span);
  for (const mpz_class& start : piecewise.starts) {
    for (int near = -2; near <= 1; ++near) include(start + near);
  }
  const mpz_class piece = shifted_left(1, piecewise.piece_bits);
  const mpz_class first = floor_of(mpq_class(arguments.least) / piece);
  const mpz_class last = floor_of(mpq_class(arguments.greatest) / piece);
  for (mpz_class k = first; k <= last + 1; ++k) {
    for (int near = -2; near <= 1; ++near) include(k * piece + near);
    include(k * piece + piece / 2);
  }
  return all;
}

/// Checks hard arguments of formats with these bits, and results with these units. Returns the
/// number of tables.
int expect_right_tables(Function function, std::initializer_list<std::pair<int, int>> formats) {
  std::mt19937_64 random(1);
  int tables = 0;
  for (const auto& [width, unit_exponent] : formats) {
    for (const bool is_signed : {false, true}) {
      for (const int reach : {-5, 0, 2}) {
        const FixedFormat format = format_below(reach, width, is_signed);
        const mpz_class low = format.smallest(), high = format.largest();
        const mpz_class eighth = (high - low) / 8;
        for (const Arguments& arguments :
             {Arguments{format, low, high}, {format, high - 3 * eighth, high - eighth + 1}}) {
          if (!has_values(function, arguments)) continue;
          const auto piecewise =
              approximate(function, {format}, arguments.least, arguments.greatest, unit_exponent);
          if (!piecewise) continue;
          ++tables;
          expect_well_formed(*piecewise, unit_exponent);
          for (const mpz_class& x : hard_arguments(*piecewise, arguments, random)) {
            expect_right(function, *piecewise, x);
          }
          if (testing::Test::HasFailure()) return tables;
        }
      }
    }
  }
  return tables;
}

TEST_P(EveryArgument, OfManyBitsHasAResultWithinTheError) {
  EXPECT_GT(expect_right_tables(GetParam(), {{20, -12}, {20, -22}}), 4);
}

TEST_P(EveryArgument, OfMoreBitsHasAResultWithinTheError) {
  EXPECT_GT(expect_right_tables(GetParam(), {{27, -20}}), 2);
}

TEST_P(EveryArgument, OfMostBitsHasAResultWithinTheError) {
  EXPECT_GT(expect_right_tables(GetParam(), {{32, -16}}), 2);
}

INSTANTIATE_TEST_SUITE_P(Functions, EveryArgument, testing::ValuesIn(tested_functions()),
                         [](const auto& parameter) {
                           return fmt::format("{}{}", to_string(parameter.param), parameter.index);
                         });

INSTANTIATE_TEST_SUITE_P(Formulas, EveryArgument, testing::ValuesIn(tested_formulas()),
                         [](const auto& parameter) { return fmt::format("{}", parameter.index); });

/// The piecewise polynomial of arguments in units of 2^-6.
std::optional<Piecewise> of_sixty_fourths(const Function& function, const mpz_class& least,
                                          const mpz_class& greatest, int unit_exponent = -8) {
  const FixedFormat format = {.width = 10, .unit_exponent = -6, .is_signed = true};
  return approximate(function, {format}, least, greatest, unit_exponent);
}

TEST(Piecewise, IsNoneWhereTheFunctionHasNoValue) {
  for (const Function::Kind logarithm : {Function::log, Function::log2}) {
    EXPECT_FALSE(of_sixty_fourths(logarithm, 0, 100));
    EXPECT_FALSE(of_sixty_fourths(logarithm, -5, 100));
    EXPECT_FALSE(of_sixty_fourths(logarithm, -100, -5));
    EXPECT_FALSE(of_sixty_fourths(logarithm, 0, 0));
    EXPECT_TRUE(of_sixty_fourths(logarithm, 1, 100));
  }
  EXPECT_FALSE(of_sixty_fourths(Function::log1p, -64, 100));
  EXPECT_FALSE(of_sixty_fourths(Function::log1p, -100, -65));
  EXPECT_FALSE(of_sixty_fourths(Function::log1p, -64, -64));
  EXPECT_TRUE(of_sixty_fourths(Function::log1p, -63, 100));
}

/// tan has a pole between 100 and 101 sixty-fourths.
TEST(Piecewise, IsNoneAcrossAPole) {
  EXPECT_FALSE(of_sixty_fourths(Function::tan, 0, 110));
  EXPECT_FALSE(of_sixty_fourths(Function::tan, -110, 110));
  EXPECT_TRUE(of_sixty_fourths(Function::tan, 102, 110));
  for (const int beside : {100, 101}) {
    const auto piecewise = of_sixty_fourths(Function::tan, beside, beside);
    ASSERT_TRUE(piecewise);
    expect_right(Function::tan, *piecewise, beside);
  }
}

/// A table with a word for each of 2^12 arguments would be too large, and no polynomial follows
/// 40 oscillations on each piece.
TEST(Piecewise, IsNoneWhereItWouldNeedMorePieces) {
  const FixedFormat format = {.width = 20, .unit_exponent = -2};
  EXPECT_FALSE(approximate(Function::sin, {format}, 0, format.largest(), -8));
}

/// No piece of few bits follows a corner between two arguments: pieces begin at the points.
TEST(Piecewise, OfATableBeginsAtItsPointsWhereUnitsAreFine) {
  const FixedFormat format = {.width = 31, .unit_exponent = -30};
  const auto coarse = approximate(measured(1), {format}, 0, format.largest(), -6);
  const auto fine = approximate(measured(1), {format}, 0, format.largest(), -28);
  ASSERT_TRUE(coarse && fine);
  EXPECT_TRUE(coarse->starts.empty());
  const std::vector<mpz_class> starts = {0, (shifted_left(1, 30) + 6) / 7};
  EXPECT_EQ(fine->starts, starts);
  EXPECT_EQ(fine->degree(), 1);
  for (const mpz_class& start : starts) {
    for (int near = -1; near <= 1; ++near) {
      if (start + near >= 0) expect_right(measured(1), *fine, start + near);
    }
  }
}

TEST(Piecewise, OfATableWithTooManyPointsIsNone) {
  std::vector<mpq_class> x, y;
  for (int k = 0; k <= 300; ++k) {
    x.emplace_back(k, 300);
    y.emplace_back(k % 2);
  }
  for (mpq_class& place : x) place.canonicalize();
  const Function zigzag = Function::through("", Interpolation::through(x, y, 1).value());
  const FixedFormat format = {.width = 20, .unit_exponent = -20};
  EXPECT_FALSE(approximate(zigzag, {format}, 0, format.largest(), -10));
}

TEST(Piecewise, OfEqualCallsIsEqual) {
  const auto first = of_sixty_fourths(Function::exp, -90, 90);
  ASSERT_TRUE(first);
  EXPECT_EQ(first, of_sixty_fourths(Function::exp, -90, 90));
  EXPECT_NE(first, of_sixty_fourths(Function::exp, -90, 91));
  EXPECT_NE(first, of_sixty_fourths(Function::exp2, -90, 90));
  EXPECT_NE(first, of_sixty_fourths(Function::exp, -90, 90, -9));
  for (const AffineMap& inner : {AffineMap{.factor = -1}, AffineMap{.offset = mpq_class(1, 64)}}) {
    EXPECT_NE(first, of_sixty_fourths(Function(Function::exp).of(inner), -90, 90));
  }
}

/// A product of logic grows with t, a multiplier block does not.
TEST(Piecewise, HasNoWiderFactorsInLogic) {
  int narrower = 0;
  for (int width = 13; width <= 22; ++width) {
    const FixedFormat format = {.width = width, .unit_exponent = -width};
    const auto bits_of_factors = [&](ProductKind products) {
      const auto made = approximate(Function::exp, {format}, 0, format.largest(), -width, products);
      return made->degree() * made->piece_bits;
    };
    const int logic = bits_of_factors(ProductKind::logic);
    const int embedded = bits_of_factors(ProductKind::embedded);
    EXPECT_LE(logic, embedded) << width;
    narrower += logic < embedded;
  }
  EXPECT_GT(narrower, 0);
}

/// A coarse unit, as in a lane of few bits, needs no words of arguments that do not occur.
/// So that the upper half of a table whose arguments reach only the lower one costs nothing.
TEST(Piecewise, HasWordsOfOtherPiecesWhereNoArgumentIs) {
  const auto piecewise = of_sixty_fourths(Function::exp2, -200, 5, -20);
  ASSERT_TRUE(piecewise);
  ASSERT_GT(piecewise->address_bits(), 1);
  const int bits = piecewise->piece_bits;
  const mpz_class first = floor_of(scaled(mpq_class(-200), -bits)), last = mpz_class(5) >> bits;
  const function::Words& words = piecewise->coefficients.front().words;
  std::vector<bool> is_read(words.size(), false);
  for (mpz_class piece = first; piece <= last; ++piece) {
    const mpz_class address = piece + mpz_class(words.size());
    is_read[address.get_ui() % words.size()] = true;
  }
  int unread = 0;
  for (std::size_t address = 0; address < words.size(); ++address) {
    if (is_read[address]) continue;
    ++unread;
    bool is_of_another = false;
    for (std::size_t bit = 1; bit < words.size(); bit *= 2) {
      is_of_another = is_of_another || words[address] == words[address ^ bit];
    }
    EXPECT_TRUE(is_of_another) << address;
  }
  EXPECT_GT(unread, 0);
}

}  // namespace
}  // namespace mixcmp::test::piecewise_test
