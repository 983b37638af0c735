#include "model/scene/expression_notes.hpp"

#include <gtest/gtest.h>

#include "model/comparison/expression/parser.hpp"

namespace mixcmp::test::expression_notes_test {
namespace {

Graph graph_of(const std::string& f, const std::string& g) {
  Graph graph;
  const Result<NodeId> left = parse_expression(graph, f, {});
  const Result<NodeId> right = parse_expression(graph, g, {});
  EXPECT_TRUE(left.ok() && right.ok());
  graph.compare(*left, *right);
  return graph;
}

std::vector<std::string> notes(const std::string& f, const std::string& g, data::Pairing pairing) {
  return scene::pairing_notes(graph_of(f, g), pairing);
}

/// The note on fixed point of these parts, whose inputs all have this range; "" without a note.
std::string fixed_point_note(const std::vector<std::pair<std::string, std::string>>& parts,
                             const std::optional<Range>& range) {
  Graph graph;
  std::vector<Sides> sides;
  for (const auto& [f, g] : parts) {
    sides.push_back({*parse_expression(graph, f, {}), *parse_expression(graph, g, {})});
  }
  graph.compare(sides, Combination::all);
  const std::vector<std::optional<Range>> ranges(graph.inputs().size(), range);
  return scene::fixed_point_note(graph, FloatFormat::make(24, 8).value(), ranges).value_or("");
}

TEST(FixedPointNotes, NameQuotientsByNumbersOfBothSigns) {
  const std::string divides =
      "no lane in fixed point can be planned: the divisor may be below 0 and above it: ";
  EXPECT_EQ(fixed_point_note({{"a / b", "c"}}, Range{-1, 2}), divides + "a / b");
  EXPECT_EQ(fixed_point_note({{"a", "2 + b / (c - a)"}}, Range{1, 2}), divides + "b / (c - a)");
  EXPECT_EQ(fixed_point_note({{"a", "b"}, {"1 / a", "b"}}, Range{-1, 2}), divides + "1 / a");
  EXPECT_EQ(fixed_point_note({{"a / b", "c"}}, Range{1, 2}), "");
  EXPECT_EQ(fixed_point_note({{"a / 3", "b * c"}}, Range{-1, 2}), "");
}

TEST(DividerNotes, NameTheFirstConstantDivisor) {
  const auto note = [](const std::string& f, const std::string& g) {
    return scene::divider_note(graph_of(f, g)).value_or("");
  };
  EXPECT_EQ(
      note("a - b", "a + c^2 / 24"),
      "references have a divider for c^2 / 24 in g, which rounds once; lanes multiply by the "
      "rounded reciprocal where it is a normal number of their format, as both do in x * (1 / 24)");
  EXPECT_EQ(note("a / 8", "b * (1 / 24)"), "") << "these are products";
  EXPECT_EQ(note("a / b", "c"), "") << "no constant";
}

TEST(FixedPointNotes, NameARootOfWhatMayBeNegative) {
  const std::vector<std::pair<std::string, std::string>> root = {{"sqrt(a - b)", "c"}};
  EXPECT_EQ(fixed_point_note(root, Range{0, 1}),
            "no lane in fixed point can be planned: the radicand of a root may be negative: "
            "sqrt(a - b)");
  EXPECT_EQ(fixed_point_note({{"sqrt(a + b)", "c"}}, Range{0, 1}), "");
  EXPECT_EQ(fixed_point_note(root, std::nullopt), "") << "the ranges are missing first of all";
}

const std::string no_cost =
    "g is not f with candidate j in the place of i, as it is written: unless the two are equal "
    "otherwise, the contests are no arg-min of one cost";

TEST(PairingNotes, OneCostOfTwoCandidatesNeedsNone) {
  const auto none = std::vector<std::string>{};
  EXPECT_EQ(notes("sum(k in 0..3, (p[k] - ci[k])^2)", "sum(k in 0..3, (p[k] - cj[k])^2)",
                  data::Pairing::arg_min),
            none);
  EXPECT_EQ(
      notes("wi * sqrt(abs(p - ci)) + 2", "2 + sqrt(abs(p - cj)) * wj", data::Pairing::arg_min),
      none);
  EXPECT_EQ(notes("(ai - aj)^2", "(ri + rj)^2", data::Pairing::all), none);
}

TEST(PairingNotes, OtherThanOneCostIsTold) {
  const std::vector<std::string> told = {no_cost};
  EXPECT_EQ(notes("(p - cj)^2", "(p - ci)^2", data::Pairing::arg_min), told);
  EXPECT_EQ(notes("(p - ci)^2", "(p - cj)^2 + 1", data::Pairing::arg_min), told);
  EXPECT_EQ(notes("(p - ci)^2", "abs(p - cj)", data::Pairing::arg_min), told);
  EXPECT_EQ(notes("ai - bi", "bj - aj", data::Pairing::arg_min), told);
  EXPECT_EQ(notes("ci + dj", "cj + dj", data::Pairing::arg_min).size(), 1U);
  EXPECT_TRUE(notes("(p - cj)^2", "(p - ci)^2", data::Pairing::all).empty());
}

TEST(PairingNotes, AnInputOfOneItemAloneIsTold) {
  EXPECT_EQ(notes("phi * ci[2]", "phi * cj[2]", data::Pairing::arg_min),
            std::vector<std::string>{
                "the input phi is a column of candidate i by its last letter, and there is no phj: "
                "if that is not meant, give it another name"});
  EXPECT_EQ(notes("ci[1]", "cj[2]", data::Pairing::all).size(), 2U);
  EXPECT_TRUE(notes("ai", "bj", data::Pairing::cross).empty()) << "of two tables";
  EXPECT_TRUE(notes("phi", "b", data::Pairing::rows).empty());
}

}  // namespace
}  // namespace mixcmp::test::expression_notes_test
