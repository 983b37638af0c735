#include "model/expression/parser.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <random>

#include "model/expression/name.hpp"
#include "model/expression/typed_graph.hpp"

namespace mixcmp::model {
namespace {

using Inputs = std::vector<std::pair<std::string, mpq_class>>;

/// The value of `node` by exact rationals; square roots are not evaluated.
mpq_class evaluate(const Graph& graph, NodeId id, const Inputs& inputs) {
  const Node& node = graph.nodes()[static_cast<std::size_t>(id)];
  const auto operand = [&](int k) {
    return evaluate(graph, node.operands[static_cast<std::size_t>(k)], inputs);
  };
  switch (node.operation) {
    case Operation::input:
      for (const auto& [name, value] : inputs) {
        if (name == graph.inputs()[static_cast<std::size_t>(node.input)]) return value;
      }
      break;
    case Operation::constant: return node.value;
    case Operation::negate: return -operand(0);
    case Operation::absolute: return abs(operand(0));
    case Operation::add: return operand(0) + operand(1);
    case Operation::subtract: return operand(0) - operand(1);
    case Operation::multiply: return operand(0) * operand(1);
    case Operation::square: return operand(0) * operand(0);
    case Operation::divide: return operand(0) / operand(1);
    case Operation::minimum: return std::min(operand(0), operand(1));
    case Operation::maximum: return std::max(operand(0), operand(1));
    case Operation::convert:
    case Operation::square_root: break;
  }
  ADD_FAILURE() << "node " << id << " has no exact value";
  return 0;
}

mpq_class value_of(const std::string& text, const Inputs& inputs = {},
                   const std::vector<LetDefinition>& lets = {}) {
  Graph graph;
  const Result<NodeId> node = parse_expression(graph, text, lets);
  EXPECT_TRUE(node.ok()) << text << ": " << (node.ok() ? "" : node.error().to_string());
  return node.ok() ? evaluate(graph, *node, inputs) : 0;
}

Error error_of(const std::string& text, const std::vector<LetDefinition>& lets = {}) {
  Graph graph;
  const Result<NodeId> node = parse_expression(graph, text, lets);
  EXPECT_FALSE(node.ok()) << text;
  return node.ok() ? Error{} : node.error();
}

int count(const Graph& graph, Operation operation) {
  int total = 0;
  for (const Node& node : graph.nodes()) total += node.operation == operation;
  return total;
}

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
  std::string accepted;  ///< a part of it
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
        Mistake{"(x + y", 7, "the '(' at column 1 is not closed", "the end", "')'"},
        Mistake{"x * (y + (z)", 13, "the '(' at column 5 is not closed", "the end", "')'"},
        Mistake{"x $ y", 3, "unexpected character", "'$'", "an operator"},
        Mistake{"x + \xc3\xa9", 5, "unexpected character", "byte 0xc3", "a number, a name"},
        Mistake{"a + squrt(b)", 5, "unknown function", "squrt", "sqrt (the nearest)"},
        Mistake{"sqrt(a, b)", 1, "sqrt takes 1 argument", "2 arguments", "1 argument"},
        Mistake{"1 + min(a)", 5, "min takes 2 arguments", "1 argument", "2 arguments"},
        Mistake{"max()", 1, "max takes 2 arguments", "0 arguments", "2 arguments"},
        Mistake{"min(a,)", 7, "unexpected character", "')'", "a number, a name"},
        Mistake{"sqrt + 1", 1, "the function sqrt needs its arguments", "sqrt", "sqrt(...)"},
        Mistake{"x^0", 3, "power out of range", "0", "1..16"},
        Mistake{"x^17", 3, "power out of range", "17", "1..16"},
        Mistake{"x^99999999999999999999", 3, "power out of range", "99999999999999999999", "1..16"},
        Mistake{"x^-2", 3, "unexpected character", "'-'", "1..16"},
        Mistake{"x^2.5", 3, "unexpected character", "'2'", "an integer literal"},
        Mistake{"x^y", 3, "unexpected character", "'y'", "an integer literal"},
        Mistake{"x^2^3", 4, "unexpected character", "'^'", "an operator"},
        Mistake{"x / (1 - 1)", 5, "division by zero", "0", "other than zero"},
        Mistake{"sqrt(-4)", 6, "square root of a negative constant", "-4", "at least zero"},
        Mistake{"a + wire", 5, "\"wire\" is a Verilog or SystemVerilog keyword", "wire", "letter"},
        Mistake{"x + 1e999999999", 5, "the constant is too long", "1e999999999", "bits"},
        Mistake{"1 + (9e9999^16)^16", 6, "the constant is too long", "", "bits"}));

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
  const std::string alphabet = "xy12.0^+-*/(),  sqrtabminexp\n\xff\0";
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
  for (const char* keyword : {"module", "reg", "logic", "xor", "accept_on", "global"}) {
    EXPECT_NE(name_problem(keyword), "") << keyword;
  }
}

}  // namespace
}  // namespace mixcmp::model
