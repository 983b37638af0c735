#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "model/base/number/double.hpp"
#include "model/base/number/dyadic.hpp"
#include "model/judge/golden/fixed_evaluate.hpp"
#include "model/judge/proof/function_enclosure.hpp"
#include "model/lane/fixed/fixed_lane.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/function_comparisons.hpp"
#include "tests/support/function_values.hpp"

/// Tests lanes whose expressions have functions: each node's number against the real one by MPFR,
/// and each verdict against the truth.
namespace mixcmp::test::functions_test {
namespace {

using fixed::FixedLane;
using fixed::FixedNode;
using Random = std::mt19937_64;
using Values = std::vector<std::optional<mpz_class>>;

/// The real number that a node stands for, in a narrow range; none if the node does not tell.
using Truth = std::optional<Range>;

/// Rounds outward to multiples of 2^-400, so that numbers stay short.
Range shortened(const Range& range) {
  const mpq_class unit = power_of_two(-400);
  return {floor_of(range.low / unit) * unit, ceiling_of(range.high / unit) * unit};
}

Range root_near(const Range& radicand) {
  return {root_of(std::max<mpq_class>(0, radicand.low), 300), root_above(radicand.high, 300)};
}

bool is_point(const Range& range) {
  return range.low == range.high;
}

/// Computes the numbers that the nodes of a lane stand for from the real operands. Nodes inside a
/// function stand for themselves.
class Truths {
public:
  Truths(const FixedLane& lane, const std::vector<double>& operands, const Values& values)
      : lane_(lane), operands_(operands), values_(values) {
    const auto functions = proof::functions_of(lane);
    for (const proof::FunctionNodes& each : *functions) {
      arguments_[each.result] = each.argument;
      inside_.insert(each.inside.begin(), each.inside.end());
    }
    for (std::size_t id = 0; id < lane_.nodes.size(); ++id) {
      truths_.push_back(truth_of(static_cast<NodeId>(id)));
    }
  }

  const Truth& operator[](std::size_t id) const { return truths_[id]; }

private:
  Truth function_of(const FixedNode& node, NodeId argument) const {
    const Truth& x = truths_[argument];
    const Domain accepted = domain(*node.function);
    if (!x || !accepted.contains(x->low) || !accepted.contains(x->high)) return std::nullopt;
    return value_near(*node.function, *x);
  }

  Truth truth_of(NodeId id) const {
    const FixedNode& node = lane_.nodes[id];
    if (!values_[id]) return std::nullopt;
    if (inside_.contains(id)) {
      const mpq_class itself = *values_[id] * node.format.unit();
      return Range{itself, itself};
    }
    const auto argument = arguments_.find(id);
    return argument == arguments_.end() ? ordinary(node) : function_of(node, argument->second);
  }

  Truth ordinary(const FixedNode& node) const {
    if (node.operation == Operation::input) {
      if (!std::isfinite(operands_[node.input])) return std::nullopt;  // it has an encoding
      const mpq_class operand = operands_[node.input];
      return Range{operand, operand};
    }
    if (node.operation == Operation::constant) {
      if (!is_point(node.error)) return std::nullopt;  // a function's value everywhere
      const mpq_class value = node.value.low - node.error.low;
      return shortened({value, value});
    }
    const Truth& a = truths_[node.operands[0]];
    const Truth& b = arity(node.operation) > 1 ? truths_[node.operands[1]] : a;
    if (!a || !b) return std::nullopt;
    switch (node.operation) {
      case Operation::convert: return a;
      case Operation::negate: return negated(*a);
      case Operation::absolute: return absolute(*a);
      case Operation::add: return sum(*a, *b);
      case Operation::subtract: return difference(*a, *b);
      case Operation::multiply: return shortened(product(*a, *b));
      case Operation::square: return shortened(square(*a));
      case Operation::minimum: return minimum(*a, *b);
      case Operation::maximum: return maximum(*a, *b);
      case Operation::square_root: return shortened(root_near(*a));
      default: ADD_FAILURE() << to_string(node.operation); return std::nullopt;
    }
  }

  const FixedLane& lane_;
  const std::vector<double>& operands_;
  const Values& values_;
  std::map<NodeId, NodeId> arguments_;  ///< of functions, by their results
  std::set<NodeId> inside_;
  std::vector<Truth> truths_;
};

struct Counts {
  int errors = 0;     ///< of nodes with a known real number
  int functions = 0;  ///< of those, functions
  int decided = 0;
};

/// Whether a node is an operand's encoding, limited or not: no number that approaches the operand.
bool is_encoding(const FixedLane& lane, const FixedNode& node) {
  return node.is_encoding || fixed::is_limited_encoding(lane.nodes, node);
}

/// Checks each node that has a value: its format, its enclosure and, where the real number is
/// known, its error.
void expect_enclosed(const FixedLane& lane, const std::vector<double>& operands,
                     const Values& values, Counts& counts) {
  const Truths truths(lane, operands, values);
  for (std::size_t id = 0; id < values.size(); ++id) {
    if (!values[id]) continue;
    const FixedNode& node = lane.nodes[id];
    const mpq_class value = *values[id] * node.format.unit();
    EXPECT_TRUE(node.value.low <= value && value <= node.value.high)
        << "node " << id << ", " << to_string(node.operation) << ": " << value.get_d()
        << " is not in [" << node.value.low.get_d() << ", " << node.value.high.get_d() << "]";
    EXPECT_TRUE(node.format.smallest() <= *values[id] && *values[id] <= node.format.largest())
        << "node " << id << ": " << *values[id] << " in " << node.format.name();
    if (!truths[id] || is_encoding(lane, node)) continue;
    EXPECT_TRUE(value - truths[id]->low >= node.error.low &&
                value - truths[id]->high <= node.error.high)
        << "node " << id << ", " << to_string(node.operation) << ": off by "
        << mpq_class(value - truths[id]->low).get_d() << ", not in [" << node.error.low.get_d()
        << ", " << node.error.high.get_d() << "]";
    ++counts.errors;
    if (node.function && !(node.error == Range{0, 0})) ++counts.functions;
  }
}

class Functions : public testing::TestWithParam<FunctionComparison> {
protected:
  /// An operand that the input may have: a number of binary32, or of the format in fixed point.
  double operand(std::size_t input, Random& random) const {
    const std::vector<OperandFormat> formats = GetParam().operand_formats();
    if (!formats.empty()) {
      const FixedFormat& fixed = *formats[input].fixed();
      const mpz_class span = fixed.largest() - fixed.smallest() + 1;
      const mpz_class number = fixed.smallest() + mpz_class(random() >> 1) % span;
      return mpq_class(number * fixed.unit()).get_d();
    }
    return static_cast<float>(hard_operand(GetParam().ranges[input], random));
  }
};

std::vector<Bits> encoded(FloatFormat format, const std::vector<double>& operands) {
  std::vector<Bits> bits;
  for (const double operand : operands) bits.push_back(from_double(format, operand));
  return bits;
}

std::string describe(const FunctionComparison& comparison, int bits,
                     const std::vector<double>& operands) {
  std::string text = comparison.name + fmt::format(", q{}:", bits);
  for (const double operand : operands) text += fmt::format(" {:a}", operand);
  return text;
}

/// A reference orders f and g rightly where they differ by more than the error of their difference.
TEST_P(Functions, AreOrderedRightlyByReferencesWithinTheirError) {
  const Graph graph = GetParam().graph();
  const FloatFormat format = GetParam().formats.empty() ? format_of(24, 8) : format_of(53, 11);
  Random random(2);
  int ordered = 0, references = 0;
  for (const int bits : {4, 9, 16}) {
    const Result<FixedLane> made = GetParam().lane(format, bits, true);
    if (!made.ok() || made->parts.size() > 1) continue;
    ++references;
    for (int k = 0; k < 100; ++k) {
      std::vector<double> operands;
      for (std::size_t input = 0; input < graph.inputs().size(); ++input) {
        operands.push_back(operand(input, random));
      }
      const std::vector<Bits> inputs = encoded(format, operands);
      const Values values = golden::evaluate(*made, inputs);
      const golden::LaneResult result = golden::evaluate_lane(*made, inputs);
      ASSERT_TRUE(result.decided);
      const NodeId difference = made->parts[0].difference;
      ASSERT_EQ(result.verdict == Verdict::unordered, !values[difference]);
      Counts counts;
      expect_enclosed(*made, operands, values, counts);
      const Truth truth = Truths(*made, operands, values)[difference];
      const Range& error = made->nodes[difference].error;
      const bool above = truth && truth->low > -error.low;
      const bool below = truth && truth->high < -error.high;
      EXPECT_TRUE(!above || result.verdict == Verdict::greater);
      EXPECT_TRUE(!below || result.verdict == Verdict::less);
      ordered += above || below;
      if (HasFailure()) FAIL() << describe(GetParam(), bits, operands);
    }
  }
  // References take no limits, so that some have poles. Values of constants have no known truth.
  EXPECT_GE(ordered, GetParam().functions == 0 ? 0 : 5 * references);
}

TEST_P(Functions, AreEnclosedAndDecidedAsTheRealNumbersAre) {
  const Graph graph = GetParam().graph();
  const bool is_fixed = !GetParam().formats.empty();
  const FloatFormat format = is_fixed ? format_of(53, 11) : format_of(24, 8);
  Random random(1);
  Counts counts;
  int lanes = 0;
  for (const int bits : {1, 2, 3, 5, 8, 11, 14}) {
    const Result<FixedLane> made = GetParam().lane(format, bits);
    if (!made.ok()) continue;
    ++lanes;
    for (int k = 0; k < 150; ++k) {
      std::vector<double> operands;
      for (std::size_t input = 0; input < graph.inputs().size(); ++input) {
        operands.push_back(operand(input, random));
      }
      const std::vector<Bits> inputs = encoded(format, operands);
      expect_enclosed(*made, operands, golden::evaluate(*made, inputs), counts);
      const golden::LaneResult result = golden::evaluate_lane(*made, inputs);
      if (result.decided) {
        ++counts.decided;
        EXPECT_EQ(result.verdict, golden::true_verdict(graph, format, inputs));
      }
      if (HasFailure()) FAIL() << describe(GetParam(), bits, operands);
    }
  }
  EXPECT_GE(lanes, 3);
  EXPECT_GT(counts.decided, 100);
  EXPECT_GE(counts.functions, GetParam().functions);
}

/// Pieces that shrink towards 0 have a word for 0 itself.
TEST(FunctionOfZero, HasAValueBehindASearchForTheLeadingOne) {
  const FunctionComparison comparison = {"", {{"a^0.9", "b"}}, {{0, 3}, {0, 3}}};
  const FloatFormat format = format_of(24, 8);
  const FixedLane reference = comparison.lane(format, 20, true).value();
  ASSERT_TRUE(std::any_of(reference.nodes.begin(), reference.nodes.end(), fixed::is_floating_code));
  const auto verdict = [&](double a, double b) {
    return golden::evaluate_lane(reference, encoded(format, {a, b})).verdict;
  };
  EXPECT_EQ(verdict(0, 0), Verdict::equal);
  EXPECT_EQ(verdict(0, 0x1p-7), Verdict::less);
  EXPECT_EQ(verdict(0x1p-17, 0), Verdict::greater);
}

INSTANTIATE_TEST_SUITE_P(Comparisons, Functions, testing::ValuesIn(function_comparisons()),
                         [](const auto& parameter) { return parameter.param.name; });

}  // namespace
}  // namespace mixcmp::test::functions_test
