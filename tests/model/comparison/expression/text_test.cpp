#include "model/comparison/expression/text.hpp"

#include <gtest/gtest.h>

#include "model/comparison/expression/parser.hpp"

namespace mixcmp::test::text_test {
namespace {

TEST(NumberText, IsExactWhereThatIsShort) {
  EXPECT_EQ(to_text(mpq_class(0)), "0");
  EXPECT_EQ(to_text(mpq_class(-12)), "-12");
  EXPECT_EQ(to_text(mpq_class(1, 10)), "0.1");
  EXPECT_EQ(to_text(mpq_class(-1, 1024)), "-0.0009765625");
  EXPECT_EQ(to_text(mpq_class(-3, 7)), "-3/7");
}

TEST(NumberText, SaysAboutWhereItIsNot) {
  EXPECT_EQ(to_text(mpq_class(1, 3) + mpq_class(1, 1'000'000'007)), "about 0.333333");
  mpz_class huge;
  mpz_ui_pow_ui(huge.get_mpz_t(), 10, 400);
  EXPECT_EQ(to_text(mpq_class(-3 * huge)), "about -3e+400");
  EXPECT_EQ(to_text(mpq_class(5, 4) / huge), "about 1.25e-400");
}

std::string printed(const std::string& text, std::size_t max_length = 100) {
  Graph graph;
  const NodeId root = parse_expression(graph, text, {}).value();
  graph.compare(root, root);
  const TypedGraph typed = reference_graph(graph, {FloatFormat::parse("binary64").value()});
  return to_text(typed.nodes, graph.inputs(), typed.f(), max_length);
}

TEST(ExpressionText, ReadsBackAsTheSameExpression) {
  for (const std::string text :
       {"x - (y - z)", "x - y - z", "(x + y) * z", "x / (y * z)", "-(x + y)^2", "(-x)^2", "-x * y",
        "x * -y", "min(x + 1, -y)", "sqrt(abs(x))", "x * (1/3)", "x - -0.5", "((x^2)^2)^2",
        "max(x, y) / 3"}) {
    Graph graph;
    const NodeId first = parse_expression(graph, text, {}).value();
    const Result<NodeId> again = parse_expression(graph, printed(text), {});
    ASSERT_TRUE(again.ok()) << text << " became " << printed(text);
    EXPECT_EQ(*again, first) << text << " became " << printed(text);
  }
}

TEST(ExpressionText, IsCutShort) {
  EXPECT_EQ(printed("(a + b) * (c + d)"), "(a + b) * (c + d)");
  EXPECT_EQ(printed("(a + b) * (c + d)", 8), "(a + b) ...");
}

}  // namespace
}  // namespace mixcmp::test::text_test
