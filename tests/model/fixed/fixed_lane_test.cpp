#include "model/fixed/fixed_lane.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "model/golden/fixed_evaluate.hpp"
#include "model/number/decimal.hpp"
#include "model/number/dyadic.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/graphs.hpp"

namespace mixcmp::test::fixed_lane_test {
namespace {

using fixed::ConstantThresholds;
using fixed::FixedBound;
using fixed::FixedLane;
using fixed::FixedNode;
using fixed::NormThresholds;

const char* const spheres = "(cxi - cxj)^2 + (cyi - cyj)^2 + (czi - czj)^2";

FixedLane lane_of(const Graph& graph, int bits, const Range& range,
                  std::optional<FixedBound> bound = {}) {
  const std::vector<std::optional<Range>> ranges(graph.inputs().size(), range);
  return fixed::fixed_lane(graph, format_of(53, 8),
                           {.format = {bits}, .bound = bound, .ranges = ranges})
      .value();
}

std::vector<std::string> formats_of(const FixedLane& lane) {
  std::vector<std::string> names;
  for (const FixedNode& node : lane.nodes) {
    names.push_back(std::string(to_string(node.operation)) + " " + node.format.name());
  }
  return names;
}

TEST(FixedFormat, HoldsNoMoreThanItMust) {
  EXPECT_EQ(FixedFormat::holding(0, 0, 3).name(), "ufix1_E3");
  EXPECT_EQ(FixedFormat::holding(0, 7, -2).name(), "ufix3_En2");
  EXPECT_EQ(FixedFormat::holding(0, 8, 0).name(), "ufix4_E0");
  EXPECT_EQ(FixedFormat::holding(-8, 7, 0).name(), "sfix4_E0");
  EXPECT_EQ(FixedFormat::holding(-9, 7, 0).name(), "sfix5_E0");
  EXPECT_EQ(FixedFormat::holding(-1, 8, 0).name(), "sfix5_E0");
  const FixedFormat format = FixedFormat::holding(-5, 3, 0);
  EXPECT_EQ(format.smallest(), -8);
  EXPECT_EQ(format.largest(), 7);
}

TEST(FixedLane, NodesAreAsWideAsTheirIntervals) {
  const FixedLane lane = lane_of(graph_of("(a - b)^2", "c"), 13, {0, 100});
  EXPECT_EQ(
      formats_of(lane),
      (std::vector<std::string>{"input ufix13_En6", "input ufix13_En6", "subtract sfix14_En6",
                                "square ufix26_En12", "input ufix13_En6", "subtract sfix27_En12"}));
}

TEST(FixedLane, ASphereIsDecidedByTheNormOfItsErrors) {
  const FixedLane lane = lane_of(graph_of(spheres, "(ri + rj)^2"), 13, {0, 100});
  const auto& norm = std::get<NormThresholds>(lane.parts.front().criterion);
  // Differences are off by less than a unit, their norm by sqrt(3); the radii's sum by two units,
  // downward only: 2 (sqrt(3) + 2) = 7.46 and 2 sqrt(3) = 3.46.
  EXPECT_EQ(norm.shift_above, 3) << "8 >= 2 (sqrt(3) + 2)";
  EXPECT_EQ(norm.shift_below, 2);
  EXPECT_EQ(norm.offset_above, 14) << "floor((sqrt(3) + 2)^2) + 1";
  EXPECT_EQ(lane.nodes[norm.radius].format.name(), "ufix14_En6");
}

TEST(FixedLane, ARadiusMayErrUpward) {
  const FixedLane lane = lane_of(graph_of("a^2", "abs(b - c)^2"), 13, {0, 100});
  const auto& norm = std::get<NormThresholds>(lane.parts.front().criterion);
  EXPECT_EQ(norm.shift_above, 2) << "4 = 2 (1 + 1): a unit of either side";
  EXPECT_EQ(norm.shift_below, 2);
}

TEST(FixedLane, TheRangesTopIsInside) {
  const FixedLane lane = lane_of(graph_of("a", "b"), 4, {0, 8});
  EXPECT_EQ(lane.nodes.front().format.name(), "ufix4_E0");
  const FloatFormat format = lane.input_format;
  const auto fits = [&](double value) {
    const std::vector<Bits> inputs(2, golden::from_rational(format, mpq_class(value)));
    return golden::evaluate(lane, inputs).front().has_value();
  };
  EXPECT_TRUE(fits(0));
  EXPECT_TRUE(fits(8));
  EXPECT_TRUE(fits(15.999));
  EXPECT_FALSE(fits(16));
  EXPECT_FALSE(fits(-1e-3));
}

TEST(FixedLane, TheTopIsAPowerOfTwoOfTheFormat) {
  const auto top_of = [](const Range& range) {
    const FixedLane lane = lane_of(graph_of("a", "b"), 10, range);
    return lane.nodes.front().format.unit_exponent + 10;
  };
  EXPECT_EQ(top_of({0, 100}), 7);
  EXPECT_EQ(top_of({0, 128}), 8);
  EXPECT_EQ(top_of({0, mpq_class(1, 100)}), -6);
  EXPECT_EQ(top_of({0, 0}), -125);
  EXPECT_EQ(top_of({0, mpq_class(1, mpz_class(1) << 140)}), -125);
  EXPECT_EQ(top_of({0, mpz_class(1) << 140}), 128);
}

TEST(FixedLane, WideResultsAreCut) {
  const FixedLane lane = lane_of(graph_of("a - b / 4096", "c"), 8, {0, 1});
  const FixedNode& sum = lane.nodes[4];
  ASSERT_EQ(sum.operation, Operation::subtract);
  // 1 < 2^8 2^-7, and b / 4096 counts 2^-19: 20 bits and a sign hold them, fewer than 2 * 8 + 16.
  EXPECT_EQ(sum.format.name(), "sfix21_En19");
  const FixedLane narrow = lane_of(graph_of("a - b / 1048576", "c"), 4, {0, 1});
  const FixedNode& cut = narrow.nodes[4];
  // a < 2 counts 2^-3 and is off by one, b / 2^20 2^-23; one of 25 bits is dropped, worth 2^-23.
  EXPECT_EQ(cut.format.name(), "sfix24_En22");
  EXPECT_EQ(cut.dropped_bits, 1);
  EXPECT_EQ(cut.error.low, mpq_class(-1, 8) - mpq_class(1, 1 << 23));
  EXPECT_EQ(cut.error.high, mpq_class(1, 1 << 23));
}

TEST(FixedLane, WhatIsCutHasNoNorm) {
  const std::vector<std::optional<Range>> ranges(3, Range{0, 1});
  const auto has_norm = [&](const char* f) {
    return fixed::fixed_lane(graph_of(f, "c^2"), format_of(53, 8),
                             {.format = {9}, .bound = FixedBound::norm, .ranges = ranges})
        .ok();
  };
  EXPECT_TRUE(has_norm("a^2 + (b / 128)^2")) << "32 bits";
  EXPECT_FALSE(has_norm("a^2 + (b / 512)^2")) << "36 bits, of which 2 * 9 + 16 stay";
}

TEST(FixedLane, FactorsHaveTheBitsThatTheirErrorsLeaveMeaning) {
  const FixedLane lane = lane_of(graph_of("(a^2)^2", "b"), 8, {0, 1});
  const FixedNode& factor = lane.nodes[2];
  ASSERT_EQ(factor.operation, Operation::convert);
  EXPECT_FALSE(is_limit(factor));
  // a < 2, in units of 2^-7, is 255 at most. The square of x + e, e >= -1, is off by 511, of which
  // a 16th is more than 2^4; dropping four bits costs 2^4 - 1.
  EXPECT_EQ(factor.dropped_bits, 4);
  EXPECT_EQ(factor.format.name(), "ufix12_En10");
  EXPECT_EQ(factor.error, (Range{mpq_class(-(511 + 15) / 2, 1 << 13), 0}));
  EXPECT_EQ(lane.nodes[3].operation, Operation::square);
  EXPECT_EQ(lane.nodes[3].format.name(), "ufix24_En20");
}

Range in_eighths(int low, int high) {
  Range range = {{low, 8}, {high, 8}};
  range.low.canonicalize();
  range.high.canonicalize();
  return range;
}

/// A factor that may be little but its error; one unit finer would leave no bit beside the sign.
TEST(FixedLane, ConversionsTakeBitsThatTheirOperandsHave) {
  for (const char* f : {"min(max(a - b, -1/4096), 1/4096) * c", "within(a - b, -1/4096, 1/4096)^2",
                        "within(a - b, -1/4096, 0) * c", "max(a - b, 0) * c"}) {
    const Graph graph = graph_of(f, "c");
    std::vector<std::optional<Range>> ranges(graph.inputs().size(), Range{-1, 1});
    ranges[1] = {mpq_class(-1, 64), mpq_class(1, 64)};
    for (int bits = 1; bits <= 16; ++bits) {
      const FixedLane lane =
          fixed::fixed_lane(graph, format_of(24, 8), {.format = {bits}, .ranges = ranges}).value();
      for (const FixedNode& node : lane.nodes) {
        if (node.operation != Operation::convert) continue;
        EXPECT_LE(node.dropped_bits + node.format.width, lane.nodes[node.operands[0]].format.width)
            << f << ", q" << bits;
      }
    }
  }
}

TEST(FixedLane, LimitsAreRoundedOutwardToUnits) {
  const auto limited = [](const char* f, const Range& range) {
    const FixedLane lane = lane_of(graph_of(f, "b"), 5, range);
    for (const FixedNode& node : lane.nodes) {
      if (is_limit(node)) return std::pair(node.value, node.format.name());
    }
    return std::pair(Range{0, 0}, std::string("none"));
  };
  using Limit = std::pair<Range, std::string>;
  const Range both = {-3, 3}, positive = {0, 3};  // units of 1/8
  EXPECT_EQ(limited("within(a, -1, 1.9)", both), Limit(in_eighths(-8, 16), "sfix6_En3"));
  EXPECT_EQ(limited("within(a, -1.9, 0)", both), Limit(in_eighths(-16, 0), "sfix5_En3"));
  EXPECT_EQ(limited("within(a, 0, 1)", both), Limit(in_eighths(0, 8), "ufix4_En3"));
  EXPECT_EQ(limited("within(a, 0.7, 0.8)", positive), Limit(in_eighths(5, 7), "ufix3_En3"));
  EXPECT_EQ(limited("within(a, 1, 1)", positive), Limit(in_eighths(8, 8), "ufix4_En3"));
  EXPECT_EQ(limited("within(a, 0, 0)", both), Limit(in_eighths(0, 0), "ufix1_En3"));
  EXPECT_EQ(limited("within(a, -4, 4)", both).second, "none") << "all that the operand can be";
  EXPECT_EQ(limited("within(a, -9, 9)", positive).second, "none");
}

TEST(FixedLane, ALimitLeavesOtherNumbersUndecided) {
  const FixedLane lane = lane_of(graph_of("within(a - b, 1, 2)", "-1"), 5, {0, 3});
  for (int difference = -4; difference <= 24; ++difference) {
    const std::vector<Bits> inputs = {
        golden::from_rational(lane.input_format, mpq_class(difference + 4, 8)),
        golden::from_rational(lane.input_format, mpq_class(4, 8))};
    EXPECT_EQ(golden::evaluate_lane(lane, inputs).decided, 8 <= difference && difference <= 16)
        << difference;
  }
}

TEST(FixedLane, ARootMayTakeWhatALimitKeepsFromZero) {
  const Graph graph = graph_of("sqrt(within(a - b, 0.5, 4))", "1");
  const std::vector<std::optional<Range>> ranges(2, Range{0, 3});
  const auto is_refused = [&](int bits) {
    return !fixed::fixed_lane(graph, format_of(53, 8), {.format = {bits}, .ranges = ranges}).ok();
  };
  EXPECT_TRUE(is_refused(2)) << "a unit of 1: 0 as computed may be below in truth";
  EXPECT_FALSE(is_refused(3)) << "a unit of 1/2, which the difference is off by at most";
}

using Values = std::vector<std::optional<mpz_class>>;

/// What common cuts multiply by: the largest power of two up to 1 that makes all their operands
/// fit W bits of magnitude.
mpq_class common_factor(const FixedLane& lane, const Values& values) {
  mpq_class factor = 1;
  const mpz_class beyond = mpz_class(1) << lane.format.bits;
  for (const NodeId id : fixed::cut_in_common(lane)) {
    while (floor_of(*values[id] * factor) >= beyond || floor_of(*values[id] * factor) < -beyond) {
      factor /= 2;
    }
  }
  return factor;
}

/// The real number that each node stands for: its operation on those of its operands.
std::vector<mpq_class> true_values(const FixedLane& lane, const std::vector<mpq_class>& inputs,
                                   const mpq_class& factor) {
  std::vector<mpq_class> values;
  for (const FixedNode& node : lane.nodes) {
    const mpq_class a = arity(node.operation) > 0 ? values[node.operands[0]] : 0;
    const mpq_class b = arity(node.operation) > 1 ? values[node.operands[1]] : 0;
    switch (node.operation) {
      case Operation::input: values.push_back(inputs[node.input]); break;
      case Operation::constant: values.push_back(node.value.low - node.error.low); break;
      case Operation::convert:
        values.push_back(fixed::is_common_cut(node) ? mpq_class(a * factor) : a);
        break;
      case Operation::negate: values.push_back(-a); break;
      case Operation::absolute: values.push_back(abs(a)); break;
      case Operation::add: values.push_back(a + b); break;
      case Operation::subtract: values.push_back(a - b); break;
      case Operation::multiply: values.push_back(a * b); break;
      case Operation::square: values.push_back(a * a); break;
      case Operation::minimum: values.push_back(std::min(a, b)); break;
      case Operation::maximum: values.push_back(std::max(a, b)); break;
      case Operation::square_root: values.push_back(root_of(a, 200)); break;
      default: ADD_FAILURE() << to_string(node.operation);
    }
  }
  return values;
}

/// Holds each node's enclosures of its value and of its error.
void expect_enclosed(const FixedLane& lane, const std::vector<mpq_class>& inputs) {
  std::vector<Bits> encodings;
  for (const mpq_class& input : inputs) {
    encodings.push_back(golden::from_rational(lane.input_format, input));
  }
  const auto values = golden::evaluate(lane, encodings);
  const std::vector<mpq_class> truth = true_values(lane, inputs, common_factor(lane, values));
  for (std::size_t id = 0; id < values.size(); ++id) {
    const FixedNode& node = lane.nodes[id];
    ASSERT_TRUE(values[id]) << id;
    const mpq_class value = *values[id] * node.format.unit(), error = value - truth[id];
    EXPECT_TRUE(node.value.low <= value && value <= node.value.high) << id << ": " << value;
    EXPECT_TRUE(node.error.low <= error && error <= node.error.high) << id << ": " << error;
    EXPECT_TRUE(node.format.smallest() <= *values[id] && *values[id] <= node.format.largest())
        << id << ": " << *values[id] << " in " << node.format.name();
  }
}

/// Every unit's multiple below 2 in magnitude, and what lies just above and just below it.
std::vector<mpq_class> around_units(int bits, bool is_signed) {
  const mpq_class unit = mpq_class(4) / (1 << bits), little = unit / 1024;
  std::vector<mpq_class> values;
  for (mpq_class value = is_signed ? mpq_class(unit - 4) : mpq_class(0); value < 4; value += unit) {
    for (const mpq_class& near : {value, mpq_class(value + little), mpq_class(value - little)}) {
      if (near >= 0 || is_signed) values.push_back(near);
    }
  }
  if (is_signed) values.push_back(little - 4);
  values.push_back(4 - little);
  return values;
}

TEST(GuardDigits, EnclosuresHoldWhereTheyAreTight) {
  constexpr std::array<std::pair<const char*, const char*>, 7> comparisons = {
      {{"(1.5 - a)^2", "b^2"},
       {"(a - b)^2", "(a + b)^2"},
       {"-a * (b - 2)", "b^2"},
       {"abs(a - b) * min(a, -b)", "-3 * a * b"},
       {"max(a, b / 4) * (a + b)", "(b + 3.5)^2"},
       {"(2 - abs(a))^2", "0.7 * (a - b)^2"},
       {"sqrt((a - b)^2 + a^2)", "abs(b)"}}};
  for (const auto& [f, g] : comparisons) {
    const Graph graph = graph_of(f, g);
    for (const auto& [bits, guard_digits] : {std::pair{1, 2}, {2, 1}, {3, 2}}) {
      const FixedPoint format = {.bits = bits, .guard_digits = guard_digits};
      for (const bool is_signed : {false, true}) {
        const auto lane = fixed::fixed_lane(
            graph, format_of(53, 8),
            {.format = format, .ranges = {graph.inputs().size(), Range{is_signed ? -3 : 0, 3}}});
        ASSERT_TRUE(lane.ok()) << lane.error().to_string();
        const std::vector<mpq_class> tried = around_units(bits + guard_digits, is_signed);
        for (const mpq_class& first : tried) {
          for (const mpq_class& second : tried) {
            expect_enclosed(*lane, {first, second});
            if (testing::Test::HasFailure()) FAIL() << f << ", " << format.name();
          }
        }
      }
    }
  }
}

TEST(FixedLane, EnclosuresHoldWhereTheyAreTight) {
  for (const char* f : {"a * b", "a^2", "abs(a)", "-a", "min(a, b)", "max(a, b)", "abs(a - b)",
                        "min(a, b / 4)", "max(3 * a, b)", "a * b + 0.3", "a^4", "(a * b)^3",
                        "a^2 * b^2 - b", "sqrt(abs(a))", "sqrt(abs(a) + 1)", "sqrt(a^2 + b^2)",
                        "sqrt((3 * a)^2 + (b / 64)^2)", "sqrt(a^4 + abs(b))"}) {
    const Graph graph = graph_of(f, "b");
    for (const int bits : {1, 2, 3, 5}) {
      for (const bool is_signed : {false, true}) {
        const FixedLane lane = lane_of(graph, bits, {is_signed ? -3 : 0, 3});
        const std::vector<mpq_class> tried = around_units(bits, is_signed);
        for (const mpq_class& a : tried) {
          for (const mpq_class& b : tried) {
            std::vector<mpq_class> inputs = {a, b};
            if (graph.inputs().front() == "b") std::swap(inputs[0], inputs[1]);
            expect_enclosed(lane, inputs);
            if (testing::Test::HasFailure()) FAIL() << f << ", q" << bits;
          }
        }
      }
    }
  }
}

TEST(FixedLane, AConstantIsNoFartherThanItsErrorSays) {
  const FixedLane lane = lane_of(graph_of("0.3 * a", "-2.5"), 5, {0, 1});
  const auto constant =
      std::find_if(lane.nodes.begin(), lane.nodes.end(),
                   [](const FixedNode& node) { return node.operation == Operation::constant; });
  ASSERT_NE(constant, lane.nodes.end());
  EXPECT_EQ(constant->format.name(), "ufix5_En6") << "19/64";
  EXPECT_EQ(constant->constant, 19);
  EXPECT_EQ(constant->error.low, mpq_class(19, 64) - mpq_class(3, 10));
  EXPECT_EQ(constant->error, (Range{constant->error.low, constant->error.low}));
}

FixedLane block_of(const Graph& graph, int bits, std::vector<std::optional<Range>> ranges = {}) {
  ranges.resize(graph.inputs().size());
  return fixed::fixed_lane(graph, format_of(24, 8),
                           {.format = {bits, true}, .ranges = std::move(ranges)})
      .value();
}

std::vector<std::optional<mpz_class>> in_block(const FixedLane& lane,
                                               const std::vector<const char*>& operands) {
  std::vector<Bits> inputs;
  for (const char* operand : operands) {
    inputs.push_back(from_text(lane.input_format, operand).value());
  }
  return golden::evaluate(lane, inputs);
}

TEST(BlockLane, NeedsNoRangesAndTakesSignsFromThem) {
  const Graph graph = graph_of("a - b", "c");
  EXPECT_EQ(formats_of(block_of(graph, 9)).front(), "input sfix10_En9");
  const FixedLane lane = block_of(graph, 9, {Range{0, 1000}, Range{-1, 1}});
  EXPECT_EQ(lane.nodes[0].format.name(), "ufix9_En9");
  EXPECT_EQ(lane.nodes[1].format.name(), "sfix10_En9");
}

/// 5 is the largest magnitude, so all are counted in units of 8 / 2^4.
TEST(BlockLane, CountsInUnitsOfTheLargestOperand) {
  const FixedLane lane = block_of(graph_of("a - b", "c"), 4);
  const auto values = in_block(lane, {"-5", "1.7", "0.4"});
  EXPECT_EQ(values[0], mpz_class(-11));  // one's complement
  EXPECT_EQ(values[1], mpz_class(3));
  EXPECT_EQ(in_block(lane, {"-0x5p100", "0x1.bp100", "0.4"})[0], values[0]);
  EXPECT_EQ(in_block(lane, {"8", "1.7", "0.4"})[0], mpz_class(8));
}

/// Below the least normal number the unit stays.
TEST(BlockLane, CountsSubnormalsInTheUnitOfNormals) {
  const FixedLane lane = block_of(graph_of("a", "b"), 4);
  EXPECT_EQ(in_block(lane, {"0x1p-127", "0"})[0], mpz_class(4));
  EXPECT_EQ(in_block(lane, {"0x1p-126", "0"})[0], mpz_class(8));
  EXPECT_EQ(in_block(lane, {"0x1.8p-126", "0"})[0], mpz_class(12));
}

TEST(BlockLane, MistakesNameTheFormat) {
  const auto mixed = fixed::fixed_lane(graph_of("a^2", "b"), format_of(24, 8),
                                       {.format = {9, true}, .ranges = {{}, {}}});
  ASSERT_FALSE(mixed.ok());
  EXPECT_EQ(mixed.error().received, "block9");
}

FixedLane guarded(const Graph& graph, FixedPoint format, const Range& range,
                  std::optional<FixedBound> bound = {}) {
  return fixed::fixed_lane(graph, format_of(24, 8),
                           {.format = format,
                            .bound = bound,
                            .ranges = {graph.inputs().size(), std::optional(range)}})
      .value();
}

TEST(GuardDigits, OperandsHaveThemAndWhatIsMultipliedHasNot) {
  const FixedLane lane =
      guarded(graph_of("(a - b)^2", "c^2"), {.bits = 9, .guard_digits = 3}, {0, 100});
  EXPECT_EQ(formats_of(lane),
            (std::vector<std::string>{"input ufix12_En5", "input ufix12_En5", "subtract sfix13_En5",
                                      "input ufix12_En5", "convert sfix10_En5", "convert ufix9_En5",
                                      "square ufix19_En10", "square ufix18_En10",
                                      "subtract sfix20_En10"}));
}

/// A difference of 5 units is off by one at most; without its last bit, which may be worth a unit
/// of before, by less than that: the thresholds are those of a lane without guard digits.
TEST(GuardDigits, BoundsAreThoseOfTheUnitBehindTheCut) {
  const Graph graph = graph_of(spheres, "(ri + rj)^2");
  const FixedLane lane = guarded(graph, {.bits = 13, .guard_digits = 4}, {0, 100});
  const auto& norm = std::get<NormThresholds>(lane.parts.front().criterion);
  EXPECT_EQ(norm.shift_above, 3);
  EXPECT_EQ(norm.shift_below, 2);
  EXPECT_EQ(norm.offset_above, 14);
  EXPECT_EQ(lane.nodes[norm.radius].format.name(), "ufix13_En10");
  EXPECT_EQ(lane.parts.front().degree, 2);
}

std::vector<std::optional<mpz_class>> cut_by(const FixedLane& lane,
                                             const std::vector<const char*>& operands) {
  const auto values = in_block(lane, operands);
  std::vector<std::optional<mpz_class>> cut;
  for (std::size_t id = 0; id < values.size(); ++id) {
    if (fixed::is_common_cut(lane.nodes[id])) cut.push_back(values[id]);
  }
  return cut;
}

/// In 4 + 3 bits of operands below 8, units of 1/16.
TEST(GuardDigits, ACutDropsNoMoreThanTheLargestNeeds) {
  const FixedLane lane = guarded(graph_of("(a - b)^2", "(c - b)^2"), {.bits = 4, .guard_digits = 3},
                                 {0, mpq_class(15, 2)});
  EXPECT_EQ(cut_by(lane, {"1.9375", "1", "0.5"}), (Values{15, -8})) << "15/16 and -8/16";
  EXPECT_EQ(cut_by(lane, {"1", "2", "0.5"}), (Values{-8, -12})) << "-24 needs one bit";
  EXPECT_EQ(cut_by(lane, {"7", "0.1875", "0"}), (Values{mpz_class(109 / 8), -1}))
      << "109 needs three bits, -3/8 is rounded down";
  EXPECT_EQ(cut_by(lane, {"8", "1", "1"}), (Values{{}, {}})) << "out of range";
}

TEST(GuardDigits, AffinePartsAreDecidedWithAllDigits) {
  const Graph graph = graph_of({{"a - b", "0.3"}, {"a * b", "c^2"}}, Combination::all);
  const FixedLane lane = guarded(graph, {.bits = 5, .guard_digits = 6}, {0, 1});
  const FixedNode& affine = lane.nodes[lane.parts[0].difference];
  EXPECT_EQ(affine.operation, Operation::subtract);
  EXPECT_LT(affine.format.unit_exponent, -11) << "0.3 has eleven digits, from 2^-2 on";
  EXPECT_EQ(lane.parts[0].degree, 0);
  EXPECT_EQ(lane.parts[1].degree, 2);
}

/// Finer units of a radius would only take digits from the coordinates.
TEST(GuardDigits, NormsHaveOneUnit) {
  const Graph graph = graph_of("(a - b)^2", "c^2");
  const fixed::FixedOptions options{.format = {.bits = 6, .guard_digits = 4},
                                    .ranges = {Range{0, 100}, Range{0, 100}, Range{0, 3}}};
  const FixedLane lane = fixed::fixed_lane(graph, format_of(24, 8), options).value();
  for (const FixedNode& node : lane.nodes) {
    if (fixed::is_common_cut(node)) {
      EXPECT_EQ(node.format.unit_exponent, -3);
    }
  }
}

TEST(GuardDigits, MistakesSayWhatTheyNeed) {
  const auto error_of = [](const char* f, const char* g) {
    const Graph graph = graph_of(f, g);
    return fixed::fixed_lane(graph, format_of(24, 8),
                             {.format = {.bits = 9, .guard_digits = 3},
                              .ranges = {graph.inputs().size(), Range{0, 1}}})
        .error();
  };
  EXPECT_NE(error_of("a - b", "c").message.find("guard digits serve what is multiplied"),
            std::string::npos);
  const Error mixed = error_of("(a - b)^2", "c");
  EXPECT_EQ(mixed.message,
            "guard digits need f and g that are homogeneous of one degree in what is linear in the "
            "operands; f has the degree 2 and g 1: (a - b)^2");
  EXPECT_EQ(mixed.received, "q9g3");
  EXPECT_NE(error_of("within((a - b)^2, 0, 1)", "c^2").message.find("a limit does not grow"),
            std::string::npos);
}

/// In units of 2^-10 radii are below 2^11 units as computed; 2^12 squared is beyond all thresholds
/// of these, and 2^11 squared is not.
TEST(Norms, NeedNoBitsBeyondReach) {
  const Graph graph = graph_of("(a - b)^2", "(c + d)^2");
  const fixed::FixedOptions options{
      .format = {.bits = 13},
      .ranges = {Range{0, 100}, Range{0, 100}, Range{0, mpq_class(1, 2)}, Range{0, 1}}};
  const FixedLane lane = fixed::fixed_lane(graph, format_of(53, 8), options).value();
  const auto reach = std::find_if(lane.nodes.begin(), lane.nodes.end(), fixed::is_reach);
  ASSERT_NE(reach, lane.nodes.end());
  const auto& norm = std::get<NormThresholds>(lane.parts.front().criterion);
  const mpq_class most = lane.nodes[norm.radius].value.high;
  EXPECT_LT(most, 4);
  EXPECT_EQ(reach->value, (Range{-4, 4 - reach->format.unit()})) << most.get_d();
}

TEST(Norms, AreWholeWhereRadiiReachAsFar) {
  const FixedLane lane = lane_of(graph_of(spheres, "(ri + rj)^2"), 13, {0, 100});
  EXPECT_TRUE(std::none_of(lane.nodes.begin(), lane.nodes.end(), fixed::is_reach));
}

/// The golden model computes what is beyond reach and finds it greater, too.
TEST(Norms, BeyondReachAreGreaterAsComputed) {
  const Graph graph = graph_of("(a - b)^2", "c^2");
  const fixed::FixedOptions options{.format = {.bits = 6},
                                    .ranges = {Range{0, 31}, Range{0, 31}, Range{0, 3}}};
  const FixedLane lane = fixed::fixed_lane(graph, format_of(24, 8), options).value();
  const auto reach = std::find_if(lane.nodes.begin(), lane.nodes.end(), fixed::is_reach);
  ASSERT_NE(reach, lane.nodes.end());
  const auto decided = [&](const mpq_class& a) {
    std::vector<Bits> inputs;
    for (const mpq_class& operand : {a, mpq_class(0), mpq_class(63, 16)}) {
      inputs.push_back(golden::from_rational(lane.input_format, operand));
    }
    return golden::evaluate_lane(lane, inputs);
  };
  const mpq_class beyond = reach->value.high + reach->format.unit();
  EXPECT_TRUE(decided(beyond).decided);
  EXPECT_EQ(decided(beyond).verdict, Verdict::greater);
  EXPECT_FALSE(decided(beyond / 2).decided) << "with half the reach it would not be";
}

/// In units of 2^18 a and c are 1, b and d are 0, though they are less than a unit apart. Within
/// reach the difference drops fewer bits than without: thresholds in its units are larger.
TEST(Norms, HaveThresholdsOfTheDifferenceWithinReach) {
  const Graph graph = graph_of("(a - b)^2 + (c - d)^2", "s^2");
  const fixed::FixedOptions options{.format = {.bits = 2},
                                    .ranges = {Range{0, 1000000}, Range{0, 1000000},
                                               Range{0, 1000000}, Range{0, 1000000}, Range{0, 1}}};
  const FixedLane lane = fixed::fixed_lane(graph, format_of(24, 8), options).value();
  std::vector<Bits> inputs;
  for (const char* operand : {"262144", "262143.984375", "262144", "262143.984375", "0.9"}) {
    inputs.push_back(from_text(lane.input_format, operand).value());
  }
  EXPECT_FALSE(golden::evaluate_lane(lane, inputs).decided) << "less, in truth";
}

/// All that a + 30 can be is beyond the reach of 2^m.
TEST(Norms, HaveNoReachThatNothingIsWithin) {
  const Graph graph = graph_of("(a + 30)^2", "b^2");
  for (const Range& range : {Range{0, 3}, Range{-3, 0}}) {
    const fixed::FixedOptions options{.format = {.bits = 6}, .ranges = {range, Range{0, 1}}};
    const FixedLane lane = fixed::fixed_lane(graph, format_of(24, 8), options).value();
    for (const FixedNode& node : lane.nodes) EXPECT_LE(node.value.low, node.value.high);
  }
}

/// A radius counts 2^-11, differences 2^-6: 2 sqrt(3) leaves room below the slope 4 for errors of a
/// quarter of their unit, not for one of half.
TEST(Norms, KeepNoDigitsThatTheirSlopesDoNotNeed) {
  const Graph graph = graph_of(spheres, "(ri + rj)^2");
  std::vector<std::optional<Range>> ranges(graph.inputs().size(), Range{-100, 100});
  for (std::size_t input = 0; input < ranges.size(); ++input) {
    if (graph.inputs()[input].front() == 'r') ranges[input] = Range{0, 3};
  }
  const FixedLane lane =
      fixed::fixed_lane(graph, format_of(53, 8), {.format = {.bits = 13}, .ranges = ranges})
          .value();
  const auto& norm = std::get<NormThresholds>(lane.parts.front().criterion);
  EXPECT_EQ(lane.nodes[norm.radius].format.unit_exponent, -9);
}

TEST(FixedLane, DividesByConstants) {
  const FixedLane lane = lane_of(graph_of("a / 3", "b"), 6, {0, 4});
  const auto constant =
      std::find_if(lane.nodes.begin(), lane.nodes.end(),
                   [](const FixedNode& node) { return node.operation == Operation::constant; });
  ASSERT_NE(constant, lane.nodes.end());
  EXPECT_EQ(constant->constant, 43);  // of 2^-7
  EXPECT_EQ(constant->error.low, mpq_class(43, 128) - mpq_class(1, 3));
}

TEST(FixedLane, MistakesNameWhatIsMissing) {
  const Graph graph = graph_of("a", "b");
  const auto open =
      fixed::fixed_lane(graph, format_of(53, 8), {.ranges = {Range{0, 1}, std::nullopt}});
  ASSERT_FALSE(open.ok());
  EXPECT_EQ(open.error().field, "inputs.b.range");
  const Graph quotient = graph_of("a / b", "1");
  const auto none =
      fixed::fixed_lane(quotient, format_of(53, 8), {.ranges = {Range{0, 1}, Range{1, 2}}});
  ASSERT_FALSE(none.ok());
  EXPECT_EQ(none.error().message, "fixed point divides by constants alone: a / b");
  const auto negative = fixed::fixed_lane(graph_of("sqrt(a - b)", "1"), format_of(53, 8),
                                          {.ranges = {Range{0, 1}, Range{0, 1}}});
  ASSERT_FALSE(negative.ok());
  EXPECT_EQ(negative.error().message, "the radicand of a root may be negative: sqrt(a - b)");
  const auto beyond = fixed::fixed_lane(graph_of("within(a, 20, 30)", "1"), format_of(53, 8),
                                        {.ranges = {Range{0, 10}}});
  ASSERT_FALSE(beyond.ok());
  EXPECT_EQ(beyond.error().message, "the ranges allow no value that is within the limits: a");
  // 0.2 becomes 0.25, and the difference 0 where in truth it is -0.05.
  const auto hidden = fixed::fixed_lane(graph_of("sqrt(a + 0.2 - 0.25)", "1"), format_of(53, 8),
                                        {.format = {1}, .ranges = {Range{0, 1}}});
  ASSERT_FALSE(hidden.ok());
  EXPECT_EQ(hidden.error().message, "the radicand of a root may be negative: sqrt(a + 0.2 - 0.25)");
}

}  // namespace
}  // namespace mixcmp::test::fixed_lane_test
