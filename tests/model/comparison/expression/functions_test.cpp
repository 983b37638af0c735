#include <fmt/core.h>
#include <gtest/gtest.h>

#include "model/comparison/expression/parser.hpp"
#include "model/comparison/expression/text.hpp"
#include "tests/support/parsed.hpp"

/// Tests functions, powers and tables in texts.
namespace mixcmp::test::functions_in_texts_test {
namespace {

TEST(FunctionsInTexts, FunctionsAreNodes) {
  for (const Function function : all_functions) {
    Graph graph;
    const std::string name(to_string(function));
    const auto node = parse_expression(graph, name + "(x) + " + name + "(x)", {});
    ASSERT_TRUE(node.ok()) << node.error().to_string();
    EXPECT_EQ(count(graph, Operation::function), 1) << name;
    EXPECT_EQ(graph.first_function(), function);
    EXPECT_TRUE(is_function_name(name));
  }
}

TEST(FunctionsInTexts, OtherPowersThanProductsAreFunctions) {
  const std::vector<LetDefinition> lets = {{"gamma", "1 / 2.4"}};
  for (const auto& [text, exponent] : {std::pair{"x^2.4", mpq_class(12, 5)},
                                       {"x^-0.5", mpq_class(-1, 2)},
                                       {"x^(-1/2)", mpq_class(-1, 2)},
                                       {"x^gamma", mpq_class(5, 12)},
                                       {"x^20", mpq_class(20)},
                                       {"x^ - - 2.4", mpq_class(12, 5)}}) {
    Graph graph;
    const auto node = parse_expression(graph, text, lets);
    ASSERT_TRUE(node.ok()) << node.error().to_string();
    EXPECT_EQ(graph.first_function(), Function::power_of(exponent)) << text;
  }
  EXPECT_EQ(value_of("4^-2"), mpq_class(1, 16));
  EXPECT_EQ(value_of("x^-3", {{"x", 2}}), mpq_class(1, 8));
  Graph graph;
  ASSERT_TRUE(parse_expression(graph, "x^0.5", {}).ok());
  EXPECT_EQ(graph.nodes().back().operation, Operation::square_root);
  Graph printed;
  const NodeId node = parse_expression(printed, "(a + b)^(1/3) * -c^2.4", {}).value();
  EXPECT_EQ(to_text(printed, node, 100), "(a + b)^(1/3) * -c^2.4");
}

/// Reads y = x^2 at 0, 1 and 2 from "squares.csv".
Result<Interpolation> read_squares(const std::string& file, int degree) {
  if (file == "squares.csv") return Interpolation::through({0, 1, 2}, {0, 1, 4}, degree);
  return Error{.file = file, .message = "no such file"};
}

TEST(FunctionsInTexts, TablesAreFunctions) {
  for (const auto& [text, degree] :
       {std::pair{"table('squares.csv', x)", 1}, {"table( \"squares.csv\" , x, 1 + 1)", 2}}) {
    Graph graph;
    const auto node = parse_expression(graph, text, {}, nullptr, {}, read_squares);
    ASSERT_TRUE(node.ok()) << node.error().to_string();
    const Function function = *graph.first_function();
    EXPECT_EQ(function, Function::through("", read_squares("squares.csv", degree).value()));
    EXPECT_EQ(to_text(graph, *node, 100),
              degree == 1 ? "table(\"squares.csv\", x)" : "table(\"squares.csv\", x, 2)");
  }
  const auto mistake = [](const char* text) {
    Graph graph;
    return parse_expression(graph, text, {}, nullptr, {}, read_squares).error();
  };
  EXPECT_EQ(mistake("1 + table('cubes.csv', x)").file, "cubes.csv");
  EXPECT_EQ(mistake("table(x, 'squares.csv')").message, "the first argument of table is a file");
  EXPECT_EQ(mistake("table('squares.csv')").received, "1 argument");
  EXPECT_EQ(mistake("table('squares.csv', x, 8)").message, "the degree of a table is out of range");
  EXPECT_EQ(mistake("table('squares.csv', x, y)").message, "unknown constant");
  EXPECT_EQ(mistake("table('squares.csv', 3)").accepted, "a number 0..2");
  EXPECT_EQ(mistake("x + 'squares.csv'").message, "a text in quotes is no number");
  EXPECT_EQ(mistake("table('squares.csv, x)").column, 7);
  Graph graph;
  EXPECT_EQ(parse_expression(graph, "table('a.csv', x)", {}).error().accepted,
            "f and g of a scene");
}

TEST(FunctionsInTexts, RemaindersAndSignsOfConstantsAreConstants) {
  EXPECT_EQ(value_of("mod(-7, 3)"), 2);
  EXPECT_EQ(value_of("mod(7.5, 2.5)"), 0);
  EXPECT_EQ(value_of("sign(-0.5) + sign(0) * 3 + sign(2)"), 3);
  Graph graph;
  ASSERT_TRUE(parse_expression(graph, "mod(x, 2 * 180)", {}).ok());
  EXPECT_EQ(graph.first_function(), Function::remainder_by(360));
  for (const char* text : {"mod(x, 0)", "mod(x, -1)"}) {
    EXPECT_EQ(error_of(text).message, "mod divides by a number above 0");
  }
  EXPECT_EQ(error_of("mod(x)").accepted, "a value and a divisor");
  EXPECT_EQ(error_of("mod(x, y)").message, "unknown constant");
}

TEST(FunctionsInTexts, AnglesAreOfDirections) {
  Graph graph;
  ASSERT_TRUE(parse_expression(graph, "atan2(y, x)", {}).ok());
  EXPECT_EQ(graph.inputs(), (std::vector<std::string>{"y", "x"}));
  EXPECT_EQ(count(graph, Operation::divide), 1);
  EXPECT_EQ(error_of("atan2(0, 0)").message, "atan2 has no value there");
  EXPECT_EQ(error_of("atan2(x)").accepted, "y and x");
}

TEST(FunctionsInTexts, UnknownFunctionsAreAnsweredWithTheNearest) {
  for (const auto& [wrong, right] : {std::pair{"expp", "exp"},
                                     {"lg2", "log2"},
                                     {"tanhh", "tanh"},
                                     {"coss", "cos"},
                                     {"log1", "log1p"},
                                     {"sqr", "sqrt"}}) {
    const Error error = error_of(fmt::format("x + {}(x)", wrong));
    EXPECT_EQ(error.message, "unknown function");
    EXPECT_EQ(error.column, 5);
    EXPECT_EQ(error.received, wrong);
    EXPECT_NE(error.accepted.find(right), std::string::npos) << error.accepted;
  }
}

TEST(FunctionsInTexts, LogarithmsOfConstantsOutsideTheDomainAreRefused) {
  for (const char* text : {"x + log(0)", "x + log(-1)", "x + log2(-0.5)", "x + log(1 - 1)",
                           "x + log1p(-1)", "x + log1p(-3)"}) {
    const Error error = error_of(text);
    EXPECT_NE(error.message.find("has no value there"), std::string::npos) << error.message;
    EXPECT_GE(error.column, 5) << text;
    EXPECT_FALSE(error.accepted.empty());
  }
  for (const char* text : {"log(0.5)", "log1p(-0.5)", "log2(1e-300)", "tan(-7)", "exp(-1)"}) {
    Graph graph;
    EXPECT_TRUE(parse_expression(graph, text, {}).ok()) << text;
  }
}

TEST(FunctionsInTexts, FunctionsTakeOneArgument) {
  for (const Function function : all_functions) {
    const std::string name(to_string(function));
    EXPECT_EQ(error_of(name + "(x, y)").message, name + " takes 1 argument");
    EXPECT_EQ(error_of(name + "(x, y)").received, "2 arguments");
    EXPECT_FALSE(error_of(name + "()").message.empty());
    EXPECT_FALSE(error_of(name + "(k in 0..3, x)").message.empty());
    EXPECT_EQ(error_of(name).column, 1) << "no input has the name";
    EXPECT_FALSE(error_of("sum(" + name + " in 0..3, x)").message.empty());
  }
}

}  // namespace
}  // namespace mixcmp::test::functions_in_texts_test
