#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "model/base/number/dyadic.hpp"
#include "model/judge/proof/fixed_proof.hpp"
#include "model/judge/proof/function_enclosure.hpp"
#include "model/judge/proof/gappa.hpp"
#include "model/judge/proof/provers.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/function_comparisons.hpp"

/// Tests the proof of lanes with functions, and that it notices wrong words, ranges and reads.
namespace mixcmp::test::function_proof_test {
namespace {

using fixed::Conversion;
using fixed::FixedLane;
using fixed::FixedNode;
using proof::FunctionNodes;
using proof::Outcome;

FunctionComparison comparison(const std::string& name) {
  for (const FunctionComparison& each : function_comparisons()) {
    if (each.name == name) return each;
  }
  ADD_FAILURE() << name;
  return {};
}

FloatFormat operand_format_of(const FunctionComparison& comparison) {
  return comparison.formats.empty() ? format_of(24, 8) : format_of(53, 11);
}

FixedLane lane_of(const std::string& name, int bits) {
  const FunctionComparison tested = comparison(name);
  return tested.lane(operand_format_of(tested), bits).value();
}

/// Without Gappa: functions, formats and thresholds only.
proof::LaneProof quick_proof(const FixedLane& lane) {
  return proof::prove_fixed(lane, [](const std::string&) {
    return proof::ScriptResult{Outcome::proven, "", ""};
  });
}

std::string not_proven(const FixedLane& lane) {
  std::string all;
  for (const proof::Finding& finding : quick_proof(lane).findings) {
    if (finding.outcome != Outcome::proven) all += finding.what + ": " + finding.detail + "\n";
  }
  return all;
}

class FunctionProof : public testing::TestWithParam<FunctionComparison> {};

TEST_P(FunctionProof, FindsTheErrorsOfTheLane) {
  int lanes = 0;
  for (const int bits : {1, 5, 8, 13}) {
    const auto lane = GetParam().lane(operand_format_of(GetParam()), bits);
    if (!lane.ok()) continue;
    ++lanes;
    EXPECT_EQ(not_proven(*lane), "") << bits;
    const auto functions = proof::functions_of(*lane);
    ASSERT_TRUE(functions) << bits;
    for (const FunctionNodes& function : *functions) {
      const auto found = proof::enclose_function(*lane, lane->nodes, function);
      ASSERT_TRUE(found) << bits;
      const FixedNode& result = lane->nodes[function.result];
      // The same words have about the same error, however it is derived.
      const mpq_class most = result.format.unit() / 2;
      EXPECT_LE(abs(found->error.low - result.error.low), most) << bits;
      EXPECT_LE(abs(found->error.high - result.error.high), most) << bits;
    }
  }
  EXPECT_GE(lanes, 2);
}

INSTANTIATE_TEST_SUITE_P(Comparisons, FunctionProof, testing::ValuesIn(function_comparisons()),
                         [](const auto& parameter) { return parameter.param.name; });

TEST(FunctionProofByGappa, IsCompleteButForWhatItSays) {
  if (!proof::gappa_version().ok()) GTEST_SKIP() << "gappa is not installed";
  proof::QuickProver prover(60);
  EXPECT_EQ(proof::prove_fixed(lane_of("Within", 12), std::ref(prover)).verdict(),
            "machine-checked but for theorems 1 (operands), 2 (dropped bits), 2 (limits), 10 and "
            "3, by hand");
  // Two functions, one of them behind a limit.
  EXPECT_EQ(proof::prove_fixed(lane_of("Parts", 17), std::ref(prover)).verdict(),
            "machine-checked but for theorems 1 (operands), 2 (dropped bits), 2 (limits), 10 and "
            "3, by hand");
}

/// An encoding grows with the operand, but is not near it.
TEST(FunctionProofOfEncodings, RefusesThatOthersComputeWithThem) {
  const FixedLane lane = lane_of("LogOfDecades", 13);
  ASSERT_TRUE(proof::functions_of(lane));
  int tried = 0;
  for (std::size_t id = 0; id < lane.nodes.size(); ++id) {
    const FixedNode& node = lane.nodes[id];
    if (!node.is_encoding && !fixed::is_limited_encoding(lane.nodes, node)) continue;
    FixedLane wrong = lane;
    FixedNode& difference = wrong.nodes[lane.parts[0].difference];
    difference.operands[1] = static_cast<NodeId>(id);
    EXPECT_FALSE(proof::functions_of(wrong)) << "node " << id;
    ++tried;
  }
  EXPECT_EQ(tried, 4);  // of two logarithms
}

/// A node inside a polynomial has no error, so that nothing is said about it by itself.
TEST(FunctionProofFindings, NameFunctionsAndNotTheirParts) {
  const proof::LaneProof proof = quick_proof(lane_of("Gaussian", 13));
  int functions = 0;
  for (const proof::Finding& finding : proof.findings) {
    EXPECT_EQ(finding.what.find("look_up"), std::string::npos) << finding.what;
    if (!finding.detail.starts_with("by theorem 10, ")) continue;
    ++functions;
    EXPECT_TRUE(finding.what.starts_with("value and error of exp(")) << finding.what;
  }
  EXPECT_EQ(functions, 1);
}

/// The nodes of the lane's first function for which a condition holds.
std::vector<NodeId> nodes_of(const FixedLane& lane,
                             const std::function<bool(const FixedNode&)>& is) {
  std::vector<NodeId> all;
  for (NodeId id = 0; id < static_cast<NodeId>(lane.nodes.size()); ++id) {
    if (is(lane.nodes[id])) all.push_back(id);
  }
  return all;
}

std::vector<NodeId> tables_of(const FixedLane& lane) {
  return nodes_of(lane, [](const FixedNode& node) { return node.operation == Operation::look_up; });
}

std::vector<NodeId> conversions_of(const FixedLane& lane, Conversion conversion) {
  return nodes_of(lane, [&](const FixedNode& node) { return node.conversion == conversion; });
}

/// Changes one word of a table. A word that stays within the table's format and range still has
/// the wrong value.
FixedLane with_word(FixedLane lane, NodeId table, std::size_t address, const mpz_class& word) {
  std::vector<mpz_class> words;
  const function::Words& old = lane.nodes[table].words;
  for (std::size_t k = 0; k < old.size(); ++k) words.push_back(k == address ? word : old[k]);
  lane.nodes[table].words = function::Words(std::move(words));
  return lane;
}

class WrongWord : public testing::TestWithParam<std::tuple<const char*, int>> {};

/// Every word that an argument reads, moved towards the middle of its table by a few units of the
/// result.
TEST_P(WrongWord, IsRefused) {
  const auto& [name, bits] = GetParam();
  const FixedLane lane = lane_of(name, bits);
  ASSERT_EQ(not_proven(lane), "");
  const auto functions = proof::functions_of(lane);
  ASSERT_TRUE(functions && !functions->empty());
  int tried = 0;
  for (const NodeId table : tables_of(lane)) {
    const FixedNode& node = lane.nodes[table];
    if (node.power > 0) continue;
    const FixedNode& result = lane.nodes[functions->front().result];
    const mpq_class units = (result.error.high - result.error.low) / node.format.unit();
    const mpz_class step = ceiling_of(units) + 1, middle = node.words[node.words.size() / 2];
    const NodeId argument = node.operands[0];
    const mpz_class first =
        floor_of(lane.nodes[argument].value.low / lane.nodes[argument].format.unit());
    const int piece_bits = fixed::piece_bits(lane.nodes, node);
    const mpz_class mask = node.words.size() - 1;
    for (int piece = 0; piece < 3; ++piece) {
      const mpz_class number = (first >> static_cast<mp_bitcnt_t>(piece_bits)) + piece;
      const mpz_class address = number & mask;
      const mpz_class& word = node.words[address.get_ui()];
      const mpz_class moved = word + (word < middle ? step : mpz_class(-step));
      EXPECT_NE(not_proven(with_word(lane, table, address.get_ui(), moved)), "")
          << "node " << table << ", address " << address;
      ++tried;
    }
  }
  EXPECT_GE(tried, 3);
}

INSTANTIATE_TEST_SUITE_P(Lanes, WrongWord,
                         testing::Values(std::tuple("Metropolis", 8), std::tuple("Metropolis", 17),
                                         std::tuple("Sin", 13), std::tuple("LogOfMore", 16)),
                         [](const auto& tested) {
                           return fmt::format("{}_{}", std::get<0>(tested.param),
                                              std::get<1>(tested.param));
                         });

/// A lane that passes what its table was not made for: numbers down to 0, or below the table's
/// first argument.
TEST(WiderArgument, IsRefused) {
  for (const int bits : {8, 13, 17}) {
    for (const char* const name : {"LogTouchingZero", "Log2TouchingZero", "WithinPole"}) {
      SCOPED_TRACE(fmt::format("{} {}", name, bits));
      FixedLane lane = lane_of(name, bits);
      ASSERT_EQ(not_proven(lane), "");
      const std::vector<NodeId> limits = conversions_of(lane, Conversion::limit);
      ASSERT_EQ(limits.size(), 1U);
      FixedNode& limit = lane.nodes[limits[0]];
      limit.value = lane.nodes[limit.operands[0]].value;
      EXPECT_NE(not_proven(lane), "");
    }
  }
}

TEST(OtherFunction, IsRefused) {
  FixedLane lane = lane_of("Metropolis", 13);
  const auto functions = proof::functions_of(lane);
  ASSERT_TRUE(functions && functions->size() == 1);
  lane.nodes[functions->front().result].function = Function::sinh;
  EXPECT_NE(not_proven(lane), "");
}

/// Bits that are in neither address nor t, or in both.
TEST(BitsOfTheArgument, AreDividedAmongAddressAndPlace) {
  const FixedLane lane = lane_of("Sin", 17);
  const std::vector<NodeId> places = conversions_of(lane, Conversion::place);
  ASSERT_EQ(places.size(), 1U);
  for (const int change : {-1, 1}) {
    FixedLane changed = lane;
    changed.nodes[places[0]].format.width += change;
    EXPECT_NE(not_proven(changed), "") << change;
  }
  FixedLane shifted = lane;
  const NodeId result = conversions_of(lane, Conversion::function_value).at(0);
  ++shifted.nodes[result].dropped_bits;
  EXPECT_NE(not_proven(shifted), "");
}

std::vector<NodeId> constants_of_remainders(const FixedLane& lane) {
  std::vector<NodeId> all;
  for (const FixedNode& node : lane.nodes) {
    const bool is_quotient =
        node.function && node.function->kind() == Function::remainder &&
        (node.operation == Operation::multiply || node.operation == Operation::add);
    if (is_quotient) all.push_back(node.operands[1]);
  }
  return all;
}

/// A reciprocal that is off gives some argument, next to a multiple, the wrong quotient.
TEST(WrongQuotient, IsRefused) {
  for (const char* const name : {"WrapOfIntegers", "WrapOfRadians", "Wrap"}) {
    const FixedLane lane = lane_of(name, 13);
    ASSERT_EQ(not_proven(lane), "") << name;
    const std::vector<NodeId> constants = constants_of_remainders(lane);
    ASSERT_FALSE(constants.empty()) << name;
    for (const mpz_class& factor : {mpz_class(-1), mpz_class(2)}) {
      FixedLane changed = lane;
      FixedNode& constant = changed.nodes[constants[0]];
      constant.constant *= factor;
      constant.value = {constant.value.low * factor, constant.value.high * factor};
      EXPECT_NE(not_proven(changed), "") << name << " times " << factor;
    }
  }
}

/// A rounded argument next to a multiple may have another quotient than the real one.
TEST(RemainderOfARoundedArgument, NeedsItsLimit) {
  FixedLane lane = lane_of("WrapOfRoundedArguments", 13);
  ASSERT_EQ(not_proven(lane), "");
  const std::vector<NodeId> limits = conversions_of(lane, Conversion::limit);
  ASSERT_EQ(limits.size(), 1U);
  FixedNode& limit = lane.nodes[limits[0]];
  limit.value.low -= limit.format.unit();
  EXPECT_NE(not_proven(lane), "");
}

TEST(WrongSign, IsRefused) {
  const FixedLane lane = lane_of("Sign", 8);
  ASSERT_EQ(not_proven(lane), "");
  for (const NodeId table : tables_of(lane)) {
    EXPECT_NE(not_proven(with_word(lane, table, 0, -1)), "");
    EXPECT_NE(not_proven(with_word(lane, table, 1, 1)), "");
  }
}

/// Pieces that begin at the points of a table.
TEST(WrongStart, IsRefused) {
  const FixedLane lane = lane_of("Measured", 14);
  ASSERT_EQ(not_proven(lane), "");
  int tried = 0;
  for (const NodeId table : tables_of(lane)) {
    if (lane.nodes[table].power >= 0) continue;
    const mpz_class word = lane.nodes[table].words[1];
    EXPECT_NE(not_proven(with_word(lane, table, 1, word - 9)), "");
    ++tried;
  }
  EXPECT_EQ(tried, 1);
}

/// t and a table's word are no numbers of the comparison.
TEST(NumberInsideAPolynomial, IsReadNowhereElse) {
  const FixedLane lane = lane_of("Sin", 17);
  for (const NodeId inside :
       {conversions_of(lane, Conversion::place).at(0), tables_of(lane).at(0)}) {
    FixedLane changed = lane;
    changed.nodes[changed.parts[0].difference].operands[1] = inside;
    EXPECT_NE(not_proven(changed).find("only polynomials read"), std::string::npos);
    changed = lane;
    changed.parts[0].difference = inside;
    EXPECT_NE(not_proven(changed).find("only polynomials read"), std::string::npos);
  }
}

}  // namespace
}  // namespace mixcmp::test::function_proof_test
