#include "model/comparison/expression/parser.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <bit>
#include <random>

#include "model/comparison/expression/name.hpp"
#include "model/comparison/expression/typed_graph.hpp"
#include "tests/support/parsed.hpp"

namespace mixcmp::test::parser_test {
namespace {

TEST(Parser, ReadsConstantsExactly) {
  EXPECT_EQ(value_of("0.1"), mpq_class(1, 10));
  EXPECT_EQ(value_of("12"), 12);
  EXPECT_EQ(value_of(".5"), mpq_class(1, 2));
  EXPECT_EQ(value_of("3."), 3);
  EXPECT_EQ(value_of("1.25e-2"), mpq_class(1, 80));
  EXPECT_EQ(value_of("2E+3"), 2000);
  EXPECT_EQ(value_of("0x1.8p-3"), mpq_class(3, 16));
  EXPECT_EQ(value_of("0XfF"), 255);
  EXPECT_EQ(value_of("0x.8P+1"), 1);
  EXPECT_EQ(value_of("010"), 10);
}

TEST(Parser, BindsAsMathematicsDoes) {
  const Inputs xyz = {{"x", 3}, {"y", 5}, {"z", 7}};
  EXPECT_EQ(value_of("x + y * z", xyz), 38);
  EXPECT_EQ(value_of("(x + y) * z", xyz), 56);
  EXPECT_EQ(value_of("x - y - z", xyz), -9);
  EXPECT_EQ(value_of("x / y / z", xyz), mpq_class(3, 35));
  EXPECT_EQ(value_of("x / y * z", xyz), mpq_class(21, 5));
  EXPECT_EQ(value_of("-x^2", xyz), -9);
  EXPECT_EQ(value_of("(-x)^2", xyz), 9);
  EXPECT_EQ(value_of("2 * -x", xyz), -6);
  EXPECT_EQ(value_of("- - x", xyz), 3);
  EXPECT_EQ(value_of("x - -y", xyz), 8);
  EXPECT_EQ(value_of("-x * y", xyz), -15);
  EXPECT_EQ(value_of("min(x, y) + max(y, z) * abs(-x)", xyz), 24);
  EXPECT_EQ(value_of("\t x\n+\r\n y ", xyz), 8);
}

TEST(Parser, RaisesToEverySmallPower) {
  mpq_class expected = 1;
  for (int power = 1; power <= 16; ++power) {
    expected *= 3;
    EXPECT_EQ(value_of(fmt::format("x^{}", power), {{"x", 3}}), expected) << power;
    EXPECT_EQ(value_of(fmt::format("3^{}", power)), expected) << power;
  }
}

TEST(Parser, PowersAreSquaresAndFewMultiplications) {
  Graph graph;
  ASSERT_TRUE(parse_expression(graph, "x^16", {}).ok());
  EXPECT_EQ(count(graph, Operation::square), 4);
  EXPECT_EQ(count(graph, Operation::multiply), 0);
  Graph fifteen;
  ASSERT_TRUE(parse_expression(fifteen, "x^15", {}).ok());
  EXPECT_EQ(count(fifteen, Operation::square), 3);
  EXPECT_EQ(count(fifteen, Operation::multiply), 3);
}

TEST(Parser, SharesCommonSubexpressions) {
  Graph graph;
  const std::vector<LetDefinition> lets = {{"s", "a + b"}};
  const auto f = parse_expression(graph, "(a + b)^2", lets);
  const auto g = parse_expression(graph, "(b + a) * s", lets);
  ASSERT_TRUE(f.ok() && g.ok());
  EXPECT_EQ(*f, *g);
  EXPECT_EQ(graph.nodes().size(), 4U);  // a, b, a + b, its square
}

TEST(Parser, InputsAreListedInOrderOfFirstAppearance) {
  Graph graph;
  ASSERT_TRUE(parse_expression(graph, "b + s * a", std::vector<LetDefinition>{{"s", "z"}}).ok());
  EXPECT_EQ(graph.inputs(), (std::vector<std::string>{"b", "z", "a"}));
}

TEST(Parser, ConstantsFoldAndLeaveNoNode) {
  Graph graph;
  ASSERT_TRUE(parse_expression(graph, "x * -(1/3 + 0.5)^2", {}).ok());
  ASSERT_EQ(graph.nodes().size(), 3U);  // x, the constant, their product
  EXPECT_EQ(graph.nodes()[1].value, mpq_class(-25, 36));
  Graph root;
  ASSERT_TRUE(parse_expression(root, "sqrt(2)", {}).ok());
  EXPECT_EQ(count(root, Operation::square_root), 1);
}

TEST(Parser, DivisionsByPowersOfTwoAreScalings) {
  for (const char* divisor : {"4", "2^16", "0x1p-20", "-0.5", "1"}) {
    Graph graph;
    const auto node = parse_expression(graph, fmt::format("x / ({})", divisor), {});
    ASSERT_TRUE(node.ok());
    EXPECT_EQ(count(graph, Operation::divide), 0) << divisor;
    EXPECT_EQ(evaluate(graph, *node, {{"x", 3}}), 3 / value_of(divisor)) << divisor;
  }
  for (const char* divisor : {"3", "0.1", "6", "sqrt(4)", "y"}) {
    Graph graph;
    ASSERT_TRUE(parse_expression(graph, fmt::format("x / {}", divisor), {}).ok());
    EXPECT_EQ(count(graph, Operation::divide), 1) << divisor;
  }
}

TEST(Parser, LetsMayStandInAnyOrder) {
  const std::vector<LetDefinition> lets = {{"a", "b + 1"}, {"b", "x * 2"}, {"unused", "a"}};
  EXPECT_EQ(value_of("a * b", {{"x", 5}}, lets), 110);
  Graph graph;
  std::set<std::string> used;
  ASSERT_TRUE(parse_expression(graph, "a", lets, &used).ok());
  EXPECT_EQ(used, (std::set<std::string>{"a", "b"}));
}

TEST(Parser, LetsThatDoubleAreReadOnce) {
  std::vector<LetDefinition> lets = {{"d0", "x"}};
  for (int k = 1; k <= 60; ++k) {
    lets.push_back({fmt::format("d{}", k), fmt::format("d{0} * d{0} + d{0}", k - 1)});
  }
  Graph graph;
  EXPECT_TRUE(parse_expression(graph, "d60", lets).ok());
}

struct Mistake {
  std::string text;
  int column;
  std::string message;
  std::string received;
  std::string accepted;  ///< a part of the accepted values
};

class ParserMistake : public testing::TestWithParam<Mistake> {};

TEST_P(ParserMistake, NamesColumnReceivedAndAccepted) {
  const Mistake& mistake = GetParam();
  const Error error = error_of(mistake.text);
  EXPECT_EQ(error.column, mistake.column) << mistake.text << ": " << error.to_string();
  EXPECT_EQ(error.message, mistake.message) << mistake.text;
  EXPECT_EQ(error.received, mistake.received) << mistake.text;
  EXPECT_NE(error.accepted.find(mistake.accepted), std::string::npos)
      << mistake.text << ": " << error.accepted;
}

INSTANTIATE_TEST_SUITE_P(
    All, ParserMistake,
    testing::Values(
        Mistake{"", 1, "unexpected end", "the end", "a number, a name"},
        Mistake{"x +", 4, "unexpected end", "the end", "a number, a name"},
        Mistake{"x + * y", 5, "unexpected character", "'*'", "a number, a name"},
        Mistake{"x y", 3, "unexpected character", "'y'", "an operator + - * / or the end"},
        Mistake{"2x", 2, "unexpected character", "'x'", "an operator"},
        Mistake{"x + y)", 6, "unexpected character", "')'", "an operator"},
        Mistake{"(x + y", 7, "the '(' at character 1 of the text is not closed", "the end", "')'"},
        Mistake{"x * (y + (z)", 13, "the '(' at character 5 of the text is not closed", "the end",
                "')'"},
        Mistake{"x $ y", 3, "unexpected character", "'$'", "an operator"},
        Mistake{"x + \xc3\xa9", 5, "unexpected character", "byte 0xc3", "a number, a name"},
        Mistake{"a + squrt(b)", 5, "unknown function", "squrt", "sqrt (the nearest)"},
        Mistake{"sqrt(a, b)", 1, "sqrt takes 1 argument", "2 arguments", "1 argument"},
        Mistake{"within(a, 1)", 1, "within takes 3 arguments", "2 arguments", "its greatest"},
        Mistake{"within(2, 1, 3)", 8, "a constant needs no limits", "2", "inputs"},
        Mistake{"within(a, 3, 2)", 11, "the limits are empty", "[3, 2]", "not below"},
        Mistake{"within(a, b, 2)", 11, "unknown constant", "b", "constant"},
        Mistake{"within(a, 0, sqrt(2))", 14, "not a constant", "an input, a root or a function",
                "numbers"},
        Mistake{"within(a, 0, 1) - within(a, 2, 3)", 29,
                "no number is within all limits of this value", "[2, 3]", "not below"},
        Mistake{"within(k in 0..1, a)", 1, "within takes no index", "k in", "sum, product"},
        Mistake{"1 + min(a)", 5, "min takes 2 arguments or more", "1 argument", "k in 0..3"},
        Mistake{"max()", 1, "max takes 2 arguments or more", "0 arguments", "2 arguments"},
        Mistake{"min(a,)", 7, "unexpected character", "')'", "a number, a name"},
        Mistake{"sqrt + 1", 1, "the function sqrt needs its arguments", "sqrt", "sqrt(...)"},
        Mistake{"x^0", 3, "power out of range", "0", "other than 0"},
        Mistake{"x^-17", 3, "power out of range", "-17", "16 if it is whole and below 0"},
        Mistake{"x^1025", 3, "power out of range", "1025", "at most 1024"},
        Mistake{"x^99999999999999999999", 3, "power out of range", "99999999999999999999", "1024"},
        Mistake{"x^(1/1000001)", 3, "power out of range", "1/1000001", "at most 1000000"},
        Mistake{"x^y", 3, "unknown constant", "y", "a let that is a constant"},
        Mistake{"x^", 3, "unexpected end", "the end", "a number"},
        Mistake{"x^-", 4, "unexpected end", "the end", "a number"},
        Mistake{"x^sqrt(2)", 3, "not a constant", "an input, a root or a function",
                "exp2(y * log2(x))"},
        Mistake{"(-2)^0.3 + x", 1, "x^0.3 has no value there", "-2", "a number of at least 0"},
        Mistake{"0^-0.3 + x", 1, "x^-0.3 has no value there", "0", "a number above 0"},
        Mistake{"0^-1 + x", 1, "division by zero", "0", "other than zero"},
        Mistake{"x^2^3", 4, "unexpected character", "'^'", "an operator"},
        Mistake{"x / (1 - 1)", 5, "division by zero", "0", "other than zero"},
        Mistake{"sqrt(-4)", 6, "square root of a negative constant", "-4", "at least zero"},
        Mistake{"a + wire", 5, "\"wire\" is a Verilog or SystemVerilog keyword", "wire", "letter"},
        Mistake{"x + 1e999999999", 5, "the constant is too long", "1e999999999", "bits"},
        Mistake{"1 + (9e9999^16)^16", 6, "the constant is too long", "", "bits"}));

INSTANTIATE_TEST_SUITE_P(
    Indices, ParserMistake,
    testing::Values(
        Mistake{"sum(k in 0..-1, x)", 10, "an empty range", "0..-1", "not below it"},
        Mistake{"sum(k in 2..1, x)", 10, "an empty range", "2..1", "not below it"},
        Mistake{"sum(k in 0..1, min(j in k..0, x))", 25, "an empty range, with k = 1", "1..0",
                "not below it"},
        Mistake{"sum(k in 0..3/2, x)", 13, "not an integer", "1.5", "an integer"},
        Mistake{"x + p[1/2]", 7, "not an integer", "0.5", "an integer"},
        Mistake{"sum(k in 0..sqrt(4), x)", 13, "not a constant", "an input, a root or a function",
                "an integer"},
        Mistake{"sum(k in 0..10^7, x)", 13, "too large", "10000000", "999999"},
        Mistake{"sum(k in 0..D, x)", 13, "unknown constant", "D", "a let that is a constant"},
        Mistake{"sum(key in 0..1, p[kye])", 20, "unknown constant", "kye", "key (the nearest)"},
        Mistake{"p[k]", 3, "unknown constant", "k", "a reduction around it"},
        Mistake{"sum(k in 0..1, p[k]) + p[k]", 26, "unknown constant", "k",
                "a reduction around it"},
        Mistake{"p[-1]", 3, "a subscript below zero", "-1", "0.."},
        Mistake{"sum(k in 0..3, p[k - 2])", 18, "a subscript below zero, with k = 0", "-2", "0.."},
        Mistake{"sum(k in 0..1, k[0])", 16, "an index takes no subscript", "k[...]", "k"},
        Mistake{"sum(sqrt in 0..1, x)", 5, "the index sqrt hides a function", "sqrt", "a name of"},
        Mistake{"sum(k in 0..1, sum(k in 0..1, x))", 20, "the index k hides an index", "k",
                "a name of"},
        Mistake{"k + sum(k in 0..1, x)", 9, "the index k has the name of an input", "k",
                "a name of"},
        Mistake{"sum(k in 0..1, x) + k", 5, "the index k has the name of an input", "k",
                "a name of"},
        Mistake{"1 + sqrt(k in 0..1, x)", 5, "sqrt takes no index", "k in", "sum, product"},
        Mistake{"summ(k in 0..1, x)", 1, "unknown function", "summ", "sum (the nearest)"},
        Mistake{"1 + sum(x)", 5, "sum takes 2 arguments or more", "1 argument", "k in 0..3"},
        Mistake{"sum(k in 0..4096, x)", 1, "too many terms", "0..4096", "at most 4096"},
        Mistake{"sum(k in 0..99, max(j in 0..99, x))", 17, "too many terms", "0..99", "4096"},
        Mistake{"sum(k in 0.5, x)", 13, "unexpected character", "','", "'..'"},
        Mistake{"sum(k in 0..1)", 14, "unexpected character", "')'", "',' and the term"},
        Mistake{"sum(k in , x)", 10, "unexpected character", "','", "a number, a name"},
        Mistake{"sum(k in 0..1, 1 / k)", 20, "division by zero, with k = 0", "0", "other than"},
        Mistake{"sum(k on 0..2, x)", 7, "unexpected character", "'o'", "\"in\" after an index"},
        Mistake{"sum(k = 0..2, x)", 7, "unexpected character", "'='", "\"in\" after an index"},
        Mistake{"min(x, k on 0..2)", 10, "the '(' at character 4 of the text is not closed", "'o'",
                "an operator, ',' or ')'"},
        Mistake{"sum(k", 6, "the '(' at character 4 of the text is not closed", "the end", "','"},
        Mistake{"p[1", 4, "the '[' at character 2 of the text is not closed", "the end", "']'"},
        Mistake{"p[(1]", 5, "the '(' at character 3 of the text is not closed", "']'", "')'"},
        Mistake{"p[]", 3, "unexpected character", "']'", "a number, a name"},
        Mistake{"sqrt[1] + wire[x]", 16, "unknown constant", "x", "a reduction"}));

TEST(Parser, SubscriptsAreAnotherSpellingOfTheName) {
  Graph graph;
  const auto subscripted = parse_expression(graph, "p[2] * c[1][0] + d [ 7 ]", {});
  const auto plain = parse_expression(graph, "p_2 * c_1_0 + d_7", {});
  ASSERT_TRUE(subscripted.ok() && plain.ok());
  EXPECT_EQ(*subscripted, *plain);
  EXPECT_EQ(graph.inputs(), (std::vector<std::string>{"p_2", "c_1_0", "d_7"}));
}

TEST(Parser, ReductionsRunOverAnIndex) {
  const Inputs point = {{"p_0", 3}, {"p_1", 5}, {"p_2", 7}, {"a_0", 1}, {"a_1", 1}, {"a_2", 2}};
  const std::vector<LetDefinition> lets = {{"D", "3"}};
  EXPECT_EQ(value_of("sum(k in 0..D-1, (p[k] - a[k])^2)", point, lets), 4 + 16 + 25);
  EXPECT_EQ(value_of("product(k in 0..2, p[k] + 1)", point), 4 * 6 * 8);
  EXPECT_EQ(value_of("min(k in 0..2, p[2 - k] - k)", point), 1);
  EXPECT_EQ(value_of("max(k in 0..2, -p[k])", point), -3);
  EXPECT_EQ(value_of("sum(k in 1..1, p[k])", point), 5);
  EXPECT_EQ(value_of("sum(k in -2..2, k^2)"), 10);
  EXPECT_EQ(value_of("sum(k in 0 .. 2^2-3 , p[k] * k) + sum(k in 2..2, k)", point), 7);
  EXPECT_EQ(value_of("2*sum(index in 0..2, index*p[index])/2", point), 19);
}

TEST(Parser, ReductionsNest) {
  EXPECT_EQ(value_of("sum(i in 0..3, product(j in 0..i, i + j))"), 0 + 2 + 24 + 360);
  const Inputs values = {{"s_0_0", 2}, {"s_0_1", 3}, {"s_1_0", 5}, {"s_1_1", 7}};
  EXPECT_EQ(value_of("max(i in 0..1, sum(j in 0..1, s[i][j] * s[j][i]))", values), 15 + 49);
  EXPECT_EQ(value_of("sum(i in 0..sum(j in 0..1, j), s[i][product(2, i) - i])", values), 9);
}

TEST(Parser, MinimumAndMaximumTakeAnyNumberOfArguments) {
  const Inputs xyz = {{"x", 3}, {"y", 5}, {"z", -7}};
  EXPECT_EQ(value_of("min(x, y, z)", xyz), -7);
  EXPECT_EQ(value_of("max(z, x, y, 4, z)", xyz), 5);
  EXPECT_EQ(value_of("sum(x, y, z) * product(x, 2, y)", xyz), 30);
}

/// The number of nodes on the longest way down from `id`.
int depth(const Graph& graph, NodeId id) {
  const Node& node = graph.nodes()[static_cast<std::size_t>(id)];
  int deepest = 0;
  for (int k = 0; k < arity(node.operation); ++k) {
    deepest = std::max(deepest, 1 + depth(graph, node.operands[static_cast<std::size_t>(k)]));
  }
  return deepest;
}

TEST(Parser, LimitsAreThoseOfTheExpressionWhereverItOccurs) {
  Graph graph;
  const std::vector<LetDefinition> lets = {{"D", "3"}};
  const NodeId limited = parse_expression(graph, "within(a - b, -D, 2^2 / 8)", lets).value();
  EXPECT_EQ(limited, parse_expression(graph, "a - b", {}).value());
  const Range first = {-3, mpq_class(1, 2)};
  EXPECT_EQ(graph.limits(), (std::map<NodeId, Range>{{limited, first}}));
  ASSERT_TRUE(parse_expression(graph, "within(a - b, -1, 1) + b", {}).ok());
  const Range both = {-1, mpq_class(1, 2)};
  EXPECT_EQ(graph.limits(), (std::map<NodeId, Range>{{limited, both}})) << "both hold";
}

TEST(Parser, SumsAreBalancedTreesInOrder) {
  const auto same = [](const std::string& a, const std::string& b) {
    Graph graph;
    return *parse_expression(graph, a, {}) == *parse_expression(graph, b, {});
  };
  EXPECT_TRUE(same("sum(k in 0..3, p[k])", "(p_0 + p_1) + (p_2 + p_3)"));
  EXPECT_FALSE(same("sum(k in 0..3, p[k])", "p_0 + p_1 + p_2 + p_3"));
  EXPECT_TRUE(same("sum(k in 0..4, p[k])", "((p_0 + p_1) + (p_2 + p_3)) + p_4"));
  EXPECT_TRUE(same("sum(k in 0..5, p[k])", "((p_0 + p_1) + (p_2 + p_3)) + (p_4 + p_5)"));
  EXPECT_TRUE(same("product(p[0], p[1], p[2], p[3])", "(p_0 * p_1) * (p_2 * p_3)"));
  EXPECT_TRUE(same("sum(k in 0..2, p[k])", "p_0 + p_1 + p_2"));
  for (int terms = 1; terms <= 70; ++terms) {
    Graph graph;
    const auto node = parse_expression(graph, fmt::format("max(k in 1..{}, x[k])", terms), {});
    ASSERT_TRUE(node.ok());
    EXPECT_EQ(depth(graph, *node), std::bit_width(static_cast<unsigned>(terms - 1))) << terms;
    EXPECT_EQ(count(graph, Operation::maximum), terms - 1);
  }
}

TEST(Parser, LetsHaveIndicesOfTheirOwn) {
  const std::vector<LetDefinition> lets = {
      {"D", "2"}, {"d", "sum(k in 0..D-1, p[k])"}, {"w_0", "10"}, {"w_1", "20"}};
  const Inputs point = {{"p_0", 3}, {"p_1", 5}};
  EXPECT_EQ(value_of("sum(k in 0..D-1, d * k)", point, lets), 8);
  EXPECT_EQ(value_of("sum(k in 0..1, w[k] * p[k])", point, lets), 130);
  const Error outer = error_of("sum(k in 0..1, d)", {{"d", "p[k]"}});
  EXPECT_EQ(outer.field, "let.d");
  EXPECT_EQ(outer.message, "unknown constant");
  EXPECT_EQ(outer.column, 3);
  const Error subscripted = error_of("sum(k in 0..1, d[k])", {{"d", "x"}});
  EXPECT_EQ(subscripted.message, "a let takes no subscript");
  EXPECT_EQ(subscripted.column, 16);
  const Error hidden = error_of("sum(d in 0..1, x)", {{"d", "x"}});
  EXPECT_EQ(hidden.message, "the index d hides a let");
  const Error no_constant = error_of("sum(k in 0..d, x)", {{"d", "x + 1"}});
  EXPECT_EQ(no_constant.message, "not a constant");
  EXPECT_EQ(no_constant.column, 13);
  const Error inside = error_of("k + d", {{"d", "sum(k in 0..1, x)"}});
  EXPECT_EQ(inside.field, "let.d");
  EXPECT_EQ(inside.column, 5);
}

TEST(Parser, ConstantLetsInBoundsAreUsed) {
  Graph graph;
  std::set<std::string> used;
  const std::vector<LetDefinition> lets = {{"D", "E"}, {"E", "2"}};
  ASSERT_TRUE(parse_expression(graph, "sum(k in 0..D, p[k])", lets, &used).ok());
  EXPECT_EQ(used, (std::set<std::string>{"D", "E"}));
}

TEST(Parser, ReadsRangesAlone) {
  const std::vector<LetDefinition> lets = {{"D", "3"}};
  const auto range = parse_index_range(" k in 1-1..D-1 ", lets);
  ASSERT_TRUE(range.ok()) << range.error().to_string();
  EXPECT_EQ(range->name, "k");
  EXPECT_EQ(range->first, 0);
  EXPECT_EQ(range->last, 2);
  EXPECT_EQ(parse_index_range("k", lets).error().accepted, "an index and its values: k in 0..3");
  const Error error = parse_index_range(" k = 0..2", lets).error();
  EXPECT_EQ(error.column, 2);
  EXPECT_EQ(error.message, "no index and its values");
  EXPECT_EQ(error.received, "\"k = 0..2\"");
  EXPECT_EQ(parse_index_range("k in 0..3, x", lets).error().column, 10);
  EXPECT_EQ(parse_index_range("k in 1..0", lets).error().message, "an empty range");
  Graph graph;
  const std::vector<IndexValue> indices = {{"k", 2}};
  ASSERT_TRUE(parse_expression(graph, "p[k] * k", lets, nullptr, indices).ok());
  EXPECT_EQ(graph.inputs(), std::vector<std::string>{"p_2"});
}

TEST(Parser, LongChainsOfOneKindAreNoDeepTrees) {
  std::string text = "x";
  for (int k = 0; k < 200'000; ++k) text += k % 2 == 0 ? " + x" : " - x";
  EXPECT_EQ(error_of(text).message, "the expressions are too large");
  std::string constants = "1";
  for (int k = 0; k < 200'000; ++k) constants += k % 2 == 0 ? " + 1" : " - 1";
  EXPECT_EQ(value_of(constants), 1);
}

TEST(Parser, MistakesInLetsNameTheLet) {
  const Error error = error_of("x + d", {{"d", "(x + 1"}});
  EXPECT_EQ(error.field, "let.d");
  EXPECT_EQ(error.column, 7);
}

TEST(Parser, LetCyclesAreShown) {
  const Error error = error_of("a", {{"a", "1 + b"}, {"b", "c * 2"}, {"c", "x - a"}});
  EXPECT_EQ(error.field, "let.c");
  EXPECT_EQ(error.column, 5);
  EXPECT_EQ(error.message, "a let needs itself");
  EXPECT_EQ(error.received, "a -> b -> c -> a");
}

TEST(Parser, DeepNestingIsRefusedNotCrashedOn) {
  const std::string deep(100'000, '(');
  EXPECT_EQ(error_of(deep + "x").message, "nested too deeply");
  EXPECT_EQ(error_of(deep + "x").column, 101);
  std::string calls;
  for (int k = 0; k < 20'000; ++k) calls += "abs(";
  EXPECT_EQ(error_of(calls).message, "nested too deeply");
  EXPECT_EQ(value_of(std::string(100'001, '-') + "x", {{"x", 3}}), -3);
  EXPECT_EQ(value_of(std::string(100, '(') + "x" + std::string(100, ')'), {{"x", 3}}), 3);
}

TEST(Parser, LongChainsOfLetsAreRefusedNotCrashedOn) {
  std::vector<LetDefinition> lets = {{"d0", "x"}};
  for (int k = 1; k <= 20'000; ++k) {
    lets.push_back({fmt::format("d{}", k), fmt::format("d{} + 1", k - 1)});
  }
  EXPECT_EQ(error_of("d20000", lets).message, "nested too deeply");
}

TEST(Parser, HugeExpressionsAreRefused) {
  std::string text = "x0";
  for (int k = 1; k <= 5000; ++k) text += fmt::format(" + x{}", k);
  EXPECT_EQ(error_of(text).message, "the expressions are too large");
}

TEST(Parser, RandomTextGivesErrorsNotCrashes) {
  std::mt19937 random(1);
  const std::string alphabet = "xy12.0^+-*/(),  sqrtabminexp[]..sum\n\xff\0";
  int errors = 0;
  for (int round = 0; round < 20'000; ++round) {
    std::string text;
    for (auto length = random() % 24; length > 0; --length) {
      text += alphabet[random() % alphabet.size()];
    }
    Graph graph;
    const Result<NodeId> node = parse_expression(graph, text, {});
    if (node.ok()) continue;
    ++errors;
    ASSERT_GE(node.error().column, 1) << text;
    ASSERT_LE(node.error().column, static_cast<int>(text.size()) + 1) << text;
    ASSERT_FALSE(node.error().message.empty()) << text;
  }
  EXPECT_GT(errors, 10'000);
}

TEST(Names, FollowTheRuleOfVerilogIdentifiers) {
  EXPECT_EQ(name_problem("sphere_collision"), "");
  EXPECT_EQ(name_problem("_x9"), "");
  EXPECT_EQ(name_problem(std::string(64, 'a')), "");
  EXPECT_EQ(name_problem(""), "the name is empty");
  EXPECT_EQ(name_problem(std::string(65, 'a')), "the name is too long");
  EXPECT_EQ(name_problem("9x"), "not a name");
  EXPECT_EQ(name_problem("a-b"), "not a name");
  EXPECT_EQ(name_problem("a$"), "not a name");
  for (const char* keyword : {"module", "reg", "logic", "xor", "accept_on", "global", "bool",
                              "wreal", "process", "mailbox", "semaphore", "verilator_x"}) {
    EXPECT_NE(name_problem(keyword), "") << keyword;
  }
}

}  // namespace
}  // namespace mixcmp::test::parser_test
