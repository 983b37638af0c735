#include "model/lane/fixed/scale_degree.hpp"

#include <gtest/gtest.h>

#include "tests/support/graphs.hpp"

/// Tests the power by which f and g grow with their operands.
namespace mixcmp::test::scale_degree_test {
namespace {

struct Case {
  const char* f;
  const char* g;
  mpq_class degree;
};

TEST(ScaleDegrees, AreThoseOfBothSides) {
  const Case cases[] = {
      {"a", "b", 1},
      {"a * b", "c^2", 2},
      {"a^3 - b * c^2", "0.3 * max(a, -b) * c^2", 3},
      {"sqrt(a^2 + b^2)", "abs(c)", 1},
      {"sqrt(a)", "sqrt(b)", mpq_class(1, 2)},
      {"sqrt(sqrt(a))", "0", mpq_class(1, 4)},
      {"max(a, 0)", "b / 3", 1},
      {"a * b / c", "a", 1},
      {"0 * a + b^2", "c^2", 2},
      {"0", "a", 1},
      {"0", "0 * a", 0},
      {"2", "3", 0},
      {"a / b", "2", 0},
  };
  for (const Case& c : cases) {
    const auto degrees = fixed::scale_degrees(graph_of(c.f, c.g));
    ASSERT_TRUE(degrees.ok()) << c.f << " against " << c.g << ": " << degrees.error().to_string();
    EXPECT_EQ(*degrees, std::vector<mpq_class>{c.degree}) << c.f << " against " << c.g;
  }
}

TEST(CutDegrees, CountWhatIsLinearAsOne) {
  const Case cases[] = {
      {"(a + 1)^2", "c^2", 2},
      {"(a - 0.3) * b", "max(c, 2)^2", 2},
      {"(2 * a - b / 4)^2", "c^2", 2},
      {"3 * a * b", "c * d", 2},
      {"sqrt(a^2 + b^2)", "c + 1", 1},
      {"a - 5", "b", 0},
      {"(a - 5)^3", "b * c * (d + 1)", 3},
  };
  for (const Case& c : cases) {
    const auto degrees = fixed::cut_degrees(graph_of(c.f, c.g));
    ASSERT_TRUE(degrees.ok()) << c.f << " against " << c.g << ": " << degrees.error().to_string();
    EXPECT_EQ(*degrees, std::vector<mpq_class>{c.degree}) << c.f << " against " << c.g;
  }
  for (const auto& [f, g] : {std::pair("a^2", "b"), {"a * b", "4"}, {"a^2 + b", "c^2"}}) {
    EXPECT_FALSE(fixed::cut_degrees(graph_of(f, g)).ok()) << f << " against " << g;
  }
}

TEST(ScaleDegrees, MayDifferFromPartToPart) {
  const Graph graph = graph_of({{"a", "b"}, {"a^2", "b * c"}}, Combination::any);
  EXPECT_EQ(*fixed::scale_degrees(graph), (std::vector<mpq_class>{1, 2}));
}

TEST(ScaleDegrees, WhatDoesNotGrowAlikeIsNamed) {
  const std::pair<const char*, const char*> cases[] = {
      {"a + b * c", "operands of degrees 1 and 2: a + b * c"},
      {"a^2 - 1", "operands of degrees 2 and 0: a^2 - 1"},
      {"max(a, 1)^2", "operands of degrees 1 and 0: max(a, 1)"},
      {"a * b", "f has the degree 2 and g 1: a * b"},
      {"within(a - b, 0, 1)", "a limit does not grow: a - b"},
  };
  for (const auto& [f, message] : cases) {
    const auto degrees = fixed::scale_degrees(graph_of(f, "c"));
    ASSERT_FALSE(degrees.ok()) << f;
    EXPECT_NE(degrees.error().message.find(message), std::string::npos) << degrees.error().message;
    EXPECT_EQ(degrees.error().field, "reduced.format");
  }
}

}  // namespace
}  // namespace mixcmp::test::scale_degree_test
