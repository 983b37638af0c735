#include "model/scene/pairing_notes.hpp"

#include <gtest/gtest.h>

#include "model/comparison/expression/parser.hpp"

namespace mixcmp::test::pairing_notes_test {
namespace {

std::vector<std::string> notes(const std::string& f, const std::string& g, data::Pairing pairing) {
  Graph graph;
  const Result<NodeId> left = parse_expression(graph, f, {});
  const Result<NodeId> right = parse_expression(graph, g, {});
  EXPECT_TRUE(left.ok() && right.ok());
  graph.compare(*left, *right);
  return scene::pairing_notes(graph, pairing);
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
}  // namespace mixcmp::test::pairing_notes_test
