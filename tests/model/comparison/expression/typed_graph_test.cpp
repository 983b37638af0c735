#include "model/comparison/expression/typed_graph.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "model/base/number/decimal.hpp"
#include "model/comparison/expression/text.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/graphs.hpp"

namespace mixcmp::test::typed_graph_test {
namespace {

const FloatFormat wide = format_of(53, 8);
const Arithmetic narrow{format_of(17, 8)};

/// The nodes of a graph, one on each line: "operation operands' format > result's format", with
/// operands by position.
std::string describe(const TypedGraph& graph) {
  std::string text;
  for (const TypedNode& node : graph.nodes) {
    text += to_string(node.operation);
    for (int k = 0; k < arity(node.operation); ++k) text += " " + std::to_string(node.operands[k]);
    if (node.operation == Operation::input) text += " " + graph.input_names[node.input];
    if (node.operation == Operation::constant) text += " " + node.value.get_str();
    const bool rounds = node.operand_format != node.format;
    text += ": " + (rounds ? node.operand_format.name() + " > " : "") + node.format.name() + "\n";
  }
  return text + "f " + std::to_string(graph.f()) + ", g " + std::to_string(graph.g()) + "\n";
}

std::string lane(const std::string& f, const std::string& g, LaneInputs inputs) {
  return describe(lane_graph(graph_of(f, g), wide, narrow, inputs));
}

TEST(ReferenceGraph, ConvertsNothing) {
  EXPECT_EQ(describe(reference_graph(graph_of("(a - b)^2", "0.5 * a"), {wide})),
            "input a: s53e8\n"
            "input b: s53e8\n"
            "subtract 0 1: s53e8\n"
            "square 2: s53e8\n"
            "constant 1/2: s53e8\n"
            "multiply 0 4: s53e8\n"
            "f 3, g 5\n");
}

const Arithmetic fusing{.format = wide, .sums = Sums::fused};

/// The fused sums of a graph in the order of their nodes, one on each line: "+0*0 -1*2 +3". "sign
/// of" precedes a sum that is only compared with 0.
std::string fused(const TypedGraph& graph) {
  std::string text;
  for (const TypedNode& node : graph.nodes) {
    if (node.operation != Operation::fused_sum) continue;
    std::string line;
    for (const FusedTerm& term : node.terms) {
      line += fmt::format("{}{}{}", line.empty() ? "" : " ", term.negated ? "-" : "+",
                          to_text(graph.nodes, graph.input_names, term.a, 60));
      if (!term.is_product()) continue;
      line += "*" + to_text(graph.nodes, graph.input_names, term.b, 60);
    }
    text += (node.is_sign_of_sum() ? "sign of " : "") + line + "\n";
  }
  return text;
}

/// The fused sums of a graph that computes f and g.
std::string fused(const std::string& f, const std::string& g) {
  return fused(sides_graph(graph_of(f, g), fusing));
}

/// The fused sums of a graph that a reference computes.
std::string compared(const std::string& f, const std::string& g) {
  return fused(reference_graph(graph_of(f, g), fusing));
}

TEST(FusedSums, HaveTheTermsOfTheWholeSum) {
  EXPECT_EQ(fused("a^2 + b * c - (d - a * b)", "a"), "+a*a +b*c -d +a*b\n");
  EXPECT_EQ(fused("a - (b + c)", "-(a + b) + c^2"), "+a -b -c\n-a -b +c*c\n");
  EXPECT_EQ(fused("(a - b)^2 + c^2", "a"), "+a - b*a - b +c*c\n");
}

TEST(FusedSums, AreThoseThatComposedArithmeticRoundsTwice) {
  EXPECT_EQ(fused("a - b", "a * b"), "");
  EXPECT_EQ(fused("a * 4 - b / 2", "a + 0.25 * b"), "");
  EXPECT_EQ(fused("a * 3 - b", "a"), "+a*3 -b\n");
  EXPECT_EQ(fused("sqrt(a^2 + b^2)", "(a + b + c) * d"), "+a*a +b*b\n+a +b +c\n");
}

TEST(FusedSums, OfSumsThatOthersReadTooAreRoundedForThose) {
  EXPECT_EQ(fused("a * b + c + d", "max(a * b + c, d)"), "+a*b +c +d\n+a*b +c\n");
}

TEST(FusedSums, OfBothSidesAreOneThatIsComparedWithZero) {
  EXPECT_EQ(compared("(a - b)^2 + c^2", "(a + b)^2 - c"),
            "sign of +a - b*a - b +c*c -a + b*a + b +c\n");
  EXPECT_EQ(compared("a * b", "c"), "sign of +a*b -c\n");
  EXPECT_EQ(compared("a", "-(b * c)"), "sign of +a +b*c\n");
  EXPECT_EQ(compared("a + b + c", "max(a, b)"), "sign of +a +b +c -max(a, b)\n");
}

TEST(FusedSums, OfSidesWithAMinusBeforeThemHaveTermsOfOtherSigns) {
  EXPECT_EQ(compared("-(a * b + c)", "d"), "sign of -a*b -c -d\n");
  EXPECT_EQ(compared("d", "--(-(a * b - c))"), "sign of +d +a*b -c\n");
  EXPECT_EQ(compared("-(a * b) + c", "d"), "sign of -a*b +c -d\n");
  EXPECT_EQ(compared("-(a - b)", "c"), "");
  EXPECT_EQ(compared("-(a * b + c)", "(a * b + c) * d"),
            "+a*b +c\nsign of +-(a * b + c) -a * b + c*d\n");
}

/// A difference a - b may cancel before c is subtracted. If c is a term of its own, it loses no
/// digit.
TEST(FusedSums, LeaveSidesThatAreRoundedOnceAsTheyAre) {
  EXPECT_EQ(compared("a - b", "c"), "");
  EXPECT_EQ(compared("a - b", "a * 2"), "");
  EXPECT_EQ(compared("a - b", "a * c"), "sign of +a - b -a*c\n");
  EXPECT_EQ(compared("sqrt(a * b + c)", "abs(a)"), "+a*b +c\n");
}

TEST(FusedSums, OfSidesThatHaveOtherReadersAreRounded) {
  EXPECT_EQ(compared("a * b + c", "(a * b + c) * 3"), "+a*b +c\nsign of +a * b + c -a * b + c*3\n");
  const Graph twice = graph_of({{"a * b + c", "a"}, {"a * b + c", "b * c"}}, Combination::all);
  EXPECT_EQ(fused(reference_graph(twice, fusing)), "+a*b +c\nsign of +a * b + c -b*c\n");
}

TEST(FusedSums, OfMoreTermsThanAUnitTakesAreComparedByTheirSides) {
  std::string f = "a * b", g = "c * b";
  for (int k = 0; k < 40; ++k) f += " + a * d", g += " + c * d";
  EXPECT_EQ(compared(f, g).find("sign of"), std::string::npos);
  EXPECT_NE(compared(f, "c * b + d").find("sign of"), std::string::npos);
}

TEST(ReferenceGraph, OfAFusedDifferenceComparesItsSignWithZero) {
  const TypedGraph graph = reference_graph(graph_of("a * b", "c"), fusing);
  EXPECT_TRUE(graph.nodes[graph.f()].is_sign_of_sum());
  EXPECT_EQ(graph.nodes[graph.g()].operation, Operation::constant);
  EXPECT_EQ(graph.nodes[graph.g()].value, 0);
}

TEST(FusedSums, AreCountedUpToTheMostThatAUnitTakes) {
  const Graph graph = graph_of("a * b + c + d", "a");
  EXPECT_EQ(longest_fused_sum(graph), 3u);
  std::string doubled = "a * b + c";
  for (int k = 0; k < 100; ++k) doubled = "(" + doubled + ") + d";
  EXPECT_EQ(longest_fused_sum(graph_of(doubled, "a")), max_fused_terms + 1);
}

TEST(FusedSums, StayInPartsTakenAlone) {
  const TypedGraph graph =
      sides_graph(graph_of({{"c", "d"}, {"a * b + c", "d"}}, Combination::all), fusing);
  const GraphPart part = part_of(graph, 1);
  const TypedNode& sum = part.graph.nodes[part.graph.f()];
  ASSERT_EQ(sum.terms.size(), 2u);
  EXPECT_EQ(part.graph.nodes[sum.terms[0].a].input,
            graph.nodes[graph.nodes[graph.parts[1].f].terms[0].a].input);
  EXPECT_EQ(to_text(part.graph.nodes, part.graph.input_names, part.graph.f(), 60), "c + a * b");
}

TEST(ReferenceGraph, MayCompareInputs) {
  EXPECT_EQ(describe(reference_graph(graph_of("a", "a"), {wide})),
            "input a: s53e8\n"
            "f 0, g 0\n");
}

TEST(LaneGraph, RoundsEachInputOnce) {
  EXPECT_EQ(lane("(a - b)^2", "a * b", LaneInputs::rounded),
            "input a: s53e8\n"
            "convert 0: s53e8 > s17e8\n"
            "input b: s53e8\n"
            "convert 2: s53e8 > s17e8\n"
            "subtract 1 3: s17e8\n"
            "square 4: s17e8\n"
            "multiply 1 3: s17e8\n"
            "f 5, g 6\n");
}

TEST(LaneGraph, TakesExactInputsIntoTheFirstOperation) {
  EXPECT_EQ(lane("(a - b)^2", "a * b", LaneInputs::exact),
            "input a: s53e8\n"
            "input b: s53e8\n"
            "subtract 0 1: s53e8 > s17e8\n"
            "square 2: s17e8\n"
            "multiply 0 1: s53e8 > s17e8\n"
            "f 3, g 4\n");
}

TEST(LaneGraph, RoundsInputsToTheDigitsOfTheFirstOperation) {
  EXPECT_EQ(lane("(a - b)^2", "a * b", LaneInputs::of_digits(20)),
            "input a: s53e8\n"
            "convert 0: s53e8 > s20e8\n"
            "input b: s53e8\n"
            "convert 2: s53e8 > s20e8\n"
            "subtract 1 3: s20e8 > s17e8\n"
            "square 4: s17e8\n"
            "multiply 1 3: s20e8 > s17e8\n"
            "f 5, g 6\n");
}

/// An operand that later operations read is rounded to the lane's digits once, where it arrives.
TEST(LaneGraph, RoundsAnInputOnceForEachWidth) {
  EXPECT_EQ(lane("min(a, b) - 0.1", "(a * b) * min(a, b)", LaneInputs::of_digits(20)),
            "input a: s53e8\n"
            "convert 0: s53e8 > s20e8\n"
            "input b: s53e8\n"
            "convert 2: s53e8 > s20e8\n"
            "minimum 1 3: s20e8\n"
            "constant 1/10: s20e8\n"
            "subtract 4 5: s20e8 > s17e8\n"
            "convert 0: s53e8 > s17e8\n"
            "convert 2: s53e8 > s17e8\n"
            "minimum 7 8: s17e8\n"
            "multiply 1 3: s20e8 > s17e8\n"
            "multiply 9 10: s17e8\n"
            "f 6, g 11\n");
}

TEST(LaneGraph, RoundsInputsToTheExponentsOfTheLane) {
  const auto graph =
      lane_graph(graph_of("a - b", "0"), wide, {format_of(17, 6)}, LaneInputs::of_digits(20));
  EXPECT_EQ(graph.nodes[1].format.name(), "s20e6");
}

/// A profile holds lanes of all precisions against one graph, so their graphs have the same nodes.
TEST(LaneGraph, OfMoreDigitsThanItsInputsHasItsOwnDigitsAndTheSameNodes) {
  const Graph graph = graph_of("min(a, b) - 0.1", "(a * b) * min(a, b)");
  const auto nodes = [&](int precision) {
    return lane_graph(graph, wide, {format_of(precision, 8)}, LaneInputs::of_digits(20)).nodes;
  };
  const auto fewer = nodes(17), more = nodes(24);
  ASSERT_EQ(fewer.size(), more.size());
  for (std::size_t id = 0; id < more.size(); ++id) {
    EXPECT_EQ(fewer[id].operation, more[id].operation);
    EXPECT_EQ(fewer[id].operands, more[id].operands);
  }
  EXPECT_EQ(more[1].format, format_of(24, 8));
}

TEST(LaneGraph, TakesAsManyDigitsAsTheReferenceHasAsTheyArrive) {
  EXPECT_EQ(lane("(a - b)^2", "min(a, 0.1)", LaneInputs::of_digits(53)),
            lane("(a - b)^2", "min(a, 0.1)", LaneInputs::exact));
}

TEST(LaneGraph, ConvertsAnInputThatMeetsAnInexactOperand) {
  EXPECT_EQ(lane("a * b + a", "a / (b * b)", LaneInputs::exact),
            "input a: s53e8\n"
            "convert 0: s53e8 > s17e8\n"
            "input b: s53e8\n"
            "multiply 0 2: s53e8 > s17e8\n"
            "add 1 3: s17e8\n"
            "square 2: s53e8 > s17e8\n"
            "divide 1 5: s17e8\n"
            "f 4, g 6\n");
}

TEST(LaneGraph, ConvertsInputsThatAreCompared) {
  EXPECT_EQ(lane("a", "-b", LaneInputs::exact),
            "input a: s53e8\n"
            "convert 0: s53e8 > s17e8\n"
            "input b: s53e8\n"
            "negate 2: s53e8\n"
            "convert 3: s53e8 > s17e8\n"
            "f 1, g 4\n");
}

TEST(LaneGraph, KeepsSelectionsOfExactOperandsExact) {
  EXPECT_EQ(lane("min(abs(a), -b) - a", "max(a, b * b)", LaneInputs::exact),
            "input a: s53e8\n"
            "absolute 0: s53e8\n"
            "input b: s53e8\n"
            "negate 2: s53e8\n"
            "minimum 1 3: s53e8\n"
            "subtract 4 0: s53e8 > s17e8\n"
            "convert 0: s53e8 > s17e8\n"
            "square 2: s53e8 > s17e8\n"
            "maximum 6 7: s17e8\n"
            "f 5, g 8\n");
}

TEST(LaneGraph, KeepsSelectionsOfRoundedInputsInTheLanesFormat) {
  EXPECT_EQ(lane("min(a, b)", "-a", LaneInputs::rounded),
            "input a: s53e8\n"
            "convert 0: s53e8 > s17e8\n"
            "input b: s53e8\n"
            "convert 2: s53e8 > s17e8\n"
            "minimum 1 3: s17e8\n"
            "negate 1: s17e8\n"
            "f 4, g 5\n");
}

TEST(LaneGraph, EncodesAConstantWhereItIsUsed) {
  const TypedGraph graph =
      lane_graph(graph_of("0.1 * a", "0.1 * (a * a)"), wide, narrow, LaneInputs::exact);
  EXPECT_EQ(describe(graph),
            "input a: s53e8\n"
            "constant 1/10: s53e8\n"
            "multiply 0 1: s53e8 > s17e8\n"
            "constant 1/10: s17e8\n"
            "square 0: s53e8 > s17e8\n"
            "multiply 3 4: s17e8\n"
            "f 2, g 5\n");
  EXPECT_EQ(graph.nodes[1].constant, *from_text(wide, "0.1"));
  EXPECT_EQ(graph.nodes[3].constant, *from_text(narrow.format, "0.1"));
}

TEST(LaneGraph, MultipliesByTheReciprocalOfAConstantDivisor) {
  EXPECT_EQ(lane("a / 24 - b", "(a + b) / -3", LaneInputs::exact),
            "input a: s53e8\n"
            "constant 1/24: s53e8\n"
            "multiply 0 1: s53e8 > s17e8\n"
            "input b: s53e8\n"
            "convert 3: s53e8 > s17e8\n"
            "subtract 2 4: s17e8\n"
            "add 0 3: s53e8 > s17e8\n"
            "constant -1/3: s17e8\n"
            "multiply 6 7: s17e8\n"
            "f 5, g 8\n");
  const auto divides = [](const std::string& f) {
    return lane(f, "b", LaneInputs::rounded).find("divide") != std::string::npos;
  };
  EXPECT_FALSE(divides("a / 0x1.8p-126"));
  EXPECT_FALSE(divides("a / 0x1.8p125"));
  EXPECT_TRUE(divides("a / 0x1.8p127")) << "the reciprocal is subnormal";
  EXPECT_TRUE(divides("a / 0x1.8p-140")) << "the reciprocal overflows";
  const TypedGraph reference = reference_graph(graph_of("a / 24", "b"), {wide});
  EXPECT_EQ(reference.nodes[2].operation, Operation::divide) << "as IEEE 754 rounds it";
}

TEST(LaneGraph, LeavesOutWhatIsNotUsed) {
  Graph graph = graph_of("a * b", "c");
  graph.apply(Operation::square_root, graph.apply(Operation::add, graph.f(), graph.input("d")));
  EXPECT_EQ(lane_graph(graph, wide, narrow, LaneInputs::exact).nodes.size(), 5u);
  EXPECT_EQ(reference_graph(graph, {wide}).nodes.size(), 4u);
}

TEST(LaneGraph, PutsOperandsFirst) {
  const TypedGraph graph =
      lane_graph(graph_of("(a - b)^2 / (c + 1) + a * 0.3", "sqrt(max(a * b, c)) - a"), wide, narrow,
                 LaneInputs::exact);
  for (size_t id = 0; id < graph.nodes.size(); ++id) {
    const TypedNode& node = graph.nodes[id];
    for (int k = 0; k < arity(node.operation); ++k) {
      ASSERT_LT(node.operands[k], static_cast<int>(id));
      EXPECT_EQ(graph.nodes[node.operands[k]].format, node.operand_format);
    }
  }
}

}  // namespace
}  // namespace mixcmp::test::typed_graph_test
