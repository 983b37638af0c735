#include "model/comparison/expression/interpolation.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "model/comparison/expression/function.hpp"

namespace mixcmp::test::interpolation_test {
namespace {

const std::vector<mpq_class> places = {-3, -1, mpq_class(-1, 3), 0, mpq_class(5, 7), 2, 5};

/// A polynomial of degree 3.
mpq_class cubic(const mpq_class& x) {
  return 2 * x * x * x - x * x / 3 + 5 * x - 7;
}

Interpolation of_cubic(int degree) {
  std::vector<mpq_class> values;
  for (const mpq_class& x : places) values.push_back(cubic(x));
  return Interpolation::through(places, values, degree).value();
}

TEST(Interpolation, OfDegreeOneIsTheLineBetweenNeighbours) {
  const Interpolation line = Interpolation::through({0, 2, 3}, {1, 5, -1}, 1).value();
  EXPECT_EQ(line.at(0), 1);
  EXPECT_EQ(line.at(mpq_class(1, 2)), 2);
  EXPECT_EQ(line.at(2), 5);
  EXPECT_EQ(line.at(mpq_class(7, 3)), 3);
  EXPECT_EQ(line.at(3), -1);
  EXPECT_EQ(line.at(-1), 1) << "beyond the ends";
  EXPECT_EQ(line.at(100), -1);
}

TEST(Interpolation, MeetsEveryPointFromBothSides) {
  for (int degree = 1; degree <= 6; ++degree) {
    const Interpolation table = of_cubic(degree);
    for (std::size_t k = 0; k + 1 < places.size(); ++k) {
      const std::vector<mpq_class>& polynomial = table.polynomial(k);
      ASSERT_EQ(polynomial.size(), static_cast<std::size_t>(degree) + 1);
      const mpq_class width = places[k + 1] - places[k];
      mpq_class end = 0;
      for (auto c = polynomial.rbegin(); c != polynomial.rend(); ++c) end = end * width + *c;
      EXPECT_EQ(polynomial[0], cubic(places[k]));
      EXPECT_EQ(end, cubic(places[k + 1])) << degree << ", segment " << k;
    }
  }
}

/// A polynomial of degree 3 is its own interpolation of that degree or a higher one.
TEST(Interpolation, OfAPolynomialIsThePolynomial) {
  for (const mpq_class& x : {mpq_class(-2), mpq_class(-1, 9), mpq_class(1, 3), mpq_class(4)}) {
    for (int degree = 3; degree <= 6; ++degree) EXPECT_EQ(of_cubic(degree).at(x), cubic(x));
    EXPECT_NE(of_cubic(1).at(x), cubic(x));
    EXPECT_NE(of_cubic(2).at(x), cubic(x));
  }
}

/// Degree 3 takes two points on either side, except at the ends.
TEST(Interpolation, TakesTheNeighboursOfASegment) {
  std::vector<mpq_class> values(places.size(), 0);
  values[6] = 1;  // the last point
  const Interpolation table = Interpolation::through(places, values, 3).value();
  EXPECT_EQ(table.at(mpq_class(1, 2)), 0);  // between points 3 and 4: through 2, 3, 4, 5
  EXPECT_NE(table.at(1), 0);                // between points 4 and 5: through 3, 4, 5, 6
}

TEST(Interpolation, RefusesPointsOutOfOrder) {
  const auto error = [](std::vector<mpq_class> x, int degree) {
    std::vector<mpq_class> y(x.size(), 1);
    return Interpolation::through(std::move(x), std::move(y), degree).error();
  };
  EXPECT_EQ(error({0}, 1).message, "too few points for a table of degree 1");
  EXPECT_EQ(error({0, 1, 2}, 3).accepted, "4..4096 points");
  EXPECT_EQ(error({0, 2, 2, 3}, 1).message, "x of point 2 is not above that of the point before");
  EXPECT_EQ(error({0, 2, 1}, 1).received, "1 after 2");
}

TEST(Function, OfEqualTablesIsEqual) {
  const Function one = Function::through("a.csv", of_cubic(1));
  EXPECT_EQ(one, Function::through("b.csv", of_cubic(1)));
  EXPECT_NE(one, Function::through("a.csv", of_cubic(2)));
  EXPECT_NE(one, Function::power_of(2));
  EXPECT_NE(Function::power_of(mpq_class(1, 3)), Function::power_of(mpq_class(1, 2)));
  EXPECT_EQ(applied_text(Function::through("a.csv", of_cubic(2)), "x"), "table(\"a.csv\", x, 2)");
  EXPECT_EQ(domain(one).low->at, -3);
  EXPECT_FALSE(domain(one).contains(mpq_class(51, 10)));
}

}  // namespace
}  // namespace mixcmp::test::interpolation_test
