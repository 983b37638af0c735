#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "model/base/number/double.hpp"
#include "model/judge/emulator/emulator.hpp"
#include "model/judge/emulator/fixed_code.hpp"
#include "model/judge/emulator/wide_lane.hpp"
#include "model/judge/golden/fixed_evaluate.hpp"
#include "tests/model/judge/emulator/against_golden.hpp"
#include "tests/support/bounded_comparisons.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/function_comparisons.hpp"
#include "tests/support/graphs.hpp"
#include "tests/support/sphere.hpp"

namespace mixcmp::test::fixed_test {
namespace {

using emulator::Emulator;
using fixed::FixedLane;
using Columns = std::vector<std::vector<double>>;
using Random = std::mt19937_64;

std::vector<const double*> pointers(const Columns& columns) {
  std::vector<const double*> pointers;
  for (const auto& column : columns) pointers.push_back(column.data());
  return pointers;
}

/// An operand at which truncation, checks or thresholds may change. Half of the operands lie
/// anywhere in the range. The others are steps of the coarser units and their neighbours, both
/// zeros, the ends of the range, numbers beyond it, infinities and NaNs.
double hard_operand(const Range& range, Random& random) {
  const double low = range.low.get_d(), high = range.high.get_d();
  const double inside = low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
  const double step = std::ldexp(1, std::ilogb(high - low) - static_cast<int>(random() % 24));
  const double stepped = std::nearbyint(inside / step) * step;
  switch (random() % 16) {
    case 0: return std::nextafter(stepped, random() % 2 == 0 ? -1e300 : 1e300);
    case 1:
    case 2:
    case 3: return stepped;
    case 4: return random() % 2 == 0 ? 0.0 : -0.0;
    case 5: return random() % 2 == 0 ? low : high;
    case 6: return 3 * inside;
    case 7: {
      constexpr double infinity = std::numeric_limits<double>::infinity();
      const double specials[] = {infinity, -infinity, std::nan(""), 5e-324, -5e-324, 1e300};
      return specials[random() % 6];
    }
    default: return inside;
  }
}

/// Any number of a format in fixed point.
double operand_of(const FixedFormat& format, Random& random) {
  const mpz_class span = format.largest() - format.smallest() + 1;
  return mpq_class((format.smallest() + mpz_class(random() >> 1) % span) * format.unit()).get_d();
}

/// One column per input. Now and then an operand repeats the one before it, for ties.
Columns hard_columns(const std::vector<std::optional<Range>>& ranges, std::size_t count,
                     Random& random) {
  Columns columns(ranges.size());
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t input = 0; input < ranges.size(); ++input) {
      const bool repeats = input > 0 && random() % 4 == 0;
      columns[input].push_back(repeats ? columns[input - 1][k]
                                       : hard_operand(*ranges[input], random));
    }
  }
  return columns;
}

std::vector<Decision> golden_decisions(const FixedLane& lane, const Columns& columns) {
  std::vector<Decision> decisions;
  for (std::size_t k = 0; k < columns.front().size(); ++k) {
    std::vector<Bits> inputs;
    for (const auto& column : columns) inputs.push_back(from_double(lane.input_format, column[k]));
    const golden::LaneResult result = golden::evaluate_lane(lane, inputs);
    decisions.push_back(result.decided ? decision_of(result.verdict) : Decision::undecided);
  }
  return decisions;
}

/// One failure names the first decision that differs.
void expect_same(const std::string& name, const std::vector<Decision>& got,
                 const std::vector<Decision>& expected) {
  const auto [other, due] = std::mismatch(got.begin(), got.end(), expected.begin());
  if (other == got.end()) return;
  ADD_FAILURE() << name << ", comparison " << other - got.begin() << ": expected "
                << static_cast<int>(*due) << ", got " << static_cast<int>(*other);
}

/// The lane is also computed in integers of 128 bits, wherever these suffice.
void expect_golden(const std::string& name, const FixedLane& lane, const Columns& columns) {
  const std::vector<Decision> expected = golden_decisions(lane, columns);
  const Emulator emulator(lane);
  std::vector<Decision> got(expected.size());
  for_each_instruction_set([&] {
    emulator.decide(pointers(columns), got.size(), got);
    expect_same(std::string(Emulator::instruction_set()) + ", " + name, got, expected);
  });
  const auto wide = emulator::WideLane::make(lane);
  if (!wide) return;
  wide->decide(pointers(columns), got);
  if (lane.is_reference) {  // the emulator does that for all its ways
    std::replace(got.begin(), got.end(), Decision::undecided, Decision::unordered);
  }
  expect_same("128 bits, " + name, got, expected);
}

class FixedEmulation : public testing::TestWithParam<BoundedComparison> {};

TEST_P(FixedEmulation, IsTheGoldenModelsBitForBit) {
  Random random(1);
  const Columns columns = hard_columns(GetParam().ranges(), 301, random);
  const auto lanes =
      fixed_lanes(GetParam(), format("s53e11"), {1, 2, 4, 7, 13, 17, 22, 24, 30, 45, 60});
  for (const auto& [name, lane] : lanes) expect_golden(name, lane, columns);
  for (const auto& [name, lane] : grid_lanes(GetParam(), format("s53e11"), {2, 7, 13, 30})) {
    expect_golden(name, lane, columns);
  }
}

/// Multiplies the operands of each comparison by a power of two. Half of the comparisons then lie
/// at either end of double's range. Afterwards one operand in eight is made smaller, by up to 2^39.
void spread(Columns& columns, Random& random) {
  for (std::size_t k = 0; k < columns.front().size(); ++k) {
    const auto far = static_cast<int>(random() % 4);
    const int scale = far == 0   ? -1074 + static_cast<int>(random() % 60)
                      : far == 1 ? 1015 + static_cast<int>(random() % 9)
                                 : static_cast<int>(random() % 1000) - 500;
    for (auto& column : columns) {
      column[k] = std::ldexp(column[k], scale);
      if (random() % 8 == 0) column[k] = std::ldexp(column[k], -static_cast<int>(random() % 40));
    }
  }
}

TEST_P(FixedEmulation, OfBlocksIsTheGoldenModelsBitForBit) {
  Random random(6);
  Columns columns = hard_columns(GetParam().ranges(), 301, random);
  spread(columns, random);
  const auto lanes = block_lanes(GetParam(), format("s53e11"), {1, 2, 7, 13, 22, 30, 55});
  for (const auto& [name, lane] : lanes) expect_golden(name, lane, columns);
}

TEST_P(FixedEmulation, WithGuardDigitsIsTheGoldenModelsBitForBit) {
  Random random(7);
  Columns columns = hard_columns(GetParam().ranges(), 301, random);
  const auto in_ranges = guarded_lanes(
      GetParam(), format("s53e11"),
      {{1, false, 1}, {4, false, 9}, {13, false, 3}, {17, false, 30}, {40, false, 9}});
  for (const auto& [name, lane] : in_ranges) expect_golden(name, lane, columns);
  spread(columns, random);
  const auto in_blocks = guarded_lanes(GetParam(), format("s53e11"),
                                       {{2, true, 3}, {13, true, 7}, {22, true, 2}, {50, true, 3}});
  for (const auto& [name, lane] : in_blocks) expect_golden(name, lane, columns);
}

INSTANTIATE_TEST_SUITE_P(Comparisons, FixedEmulation, testing::ValuesIn(bounded_comparisons()),
                         [](const auto& parameter) { return parameter.param.name; });

class FunctionEmulation : public testing::TestWithParam<FunctionComparison> {};

TEST_P(FunctionEmulation, IsTheGoldenModelsBitForBit) {
  if (GetParam().ranges.empty()) GTEST_SKIP() << "a comparison without operands has no columns";
  Random random(9);
  const std::vector<OperandFormat> formats = GetParam().operand_formats();
  Columns columns(GetParam().ranges.size());
  for (std::size_t input = 0; input < columns.size(); ++input) {
    for (int k = 0; k < 301; ++k) {
      const double hard = formats.empty() ? test::hard_operand(GetParam().ranges[input], random)
                                          : operand_of(*formats[input].fixed(), random);
      columns[input].push_back(hard);
    }
  }
  int lanes = 0;
  for (const int bits : {1, 2, 4, 7, 10, 13}) {
    for (const bool is_reference : {false, true}) {
      const auto lane = GetParam().lane(format("s53e11"), bits, is_reference);
      if (!lane.ok()) continue;
      ++lanes;
      expect_golden(GetParam().name + ", " + lane->format.name(), *lane, columns);
    }
  }
  EXPECT_GE(lanes, 3);
}

INSTANTIATE_TEST_SUITE_P(Comparisons, FunctionEmulation, testing::ValuesIn(function_comparisons()),
                         [](const auto& parameter) { return parameter.param.name; });

FixedLane lane_of(const Graph& graph, int bits, const std::vector<std::optional<Range>>& ranges) {
  return fixed::fixed_lane(graph, format("s53e11"),
                           {.format = {bits}, .bound = {}, .ranges = ranges})
      .value();
}

/// Texts of f and g. They have every kind of term with either sign: by itself, in sums of sums, and
/// shared by two readers.
constexpr std::array<std::pair<const char*, const char*>, 18> sums = {
    {{"a + b", "c"},
     {"-a - b", "c - d"},
     {"-(a - (b - (c + d)))", "0.25"},
     {"a * b", "c * d"},
     {"a - b * c", "d * a + b"},
     {"-(a * b)", "-(c - d * d)"},
     {"(a + b)^2", "(c - d)^2"},
     {"-(a - b)^2", "-(c + d)^2"},
     {"a^2 - (b^2 - (c^2 - d^2))", "a * d"},
     {"(-a - b)^2 + (-c + d)^2", "(b - d)^2"},
     {"b - (a - c / 0x1p30)", "d"},
     {"b - (a^2 - c / 0x1p40)", "d"},
     {"(a - c / 0x1p30)^2 - b", "d"},
     {"(a + b + c)^2 - d", "(a - b - c)^2"},
     {"(a - b)^2 * c", "(a - b)^2 - d"},
     {"within(a - b, -1.3, 1.7)^2", "c"},
     {"(a * b - c)^2", "(a * b)^2 + (c - d)"},
     {"min(a - b, c)^2 - max(a + b, d)", "(a + b) * (c - d)"}}};

TEST(FixedSums, AreTheGoldenModels) {
  Random random(7);
  for (const auto& [f, g] : sums) {
    const Graph graph = graph_of(f, g);
    for (const Range& range : {Range{0, 3}, Range{-3, 3}}) {
      const std::vector ranges(graph.inputs().size(), std::optional(range));
      for (const std::size_t count : {1, 31, 33, 300}) {
        const Columns columns = hard_columns(ranges, count, random);
        for (const int bits : {1, 3, 13, 25, 40}) {
          expect_golden(std::string(f) + " against " + g, lane_of(graph, bits, ranges), columns);
        }
      }
    }
  }
}

/// a + b needs 54 bits, but no node of a + (b - c) - d needs more than 53. So the terms cannot be
/// added one by one.
TEST(FixedSums, OfTermsThatDoubleCannotAddAreAddedNodeByNode) {
  const Graph graph =
      graph_of("within(a, 2040, 2046) + (within(b, 1024, 1025) - within(c, 1024, 1025))",
               "within(d, 2040, 2046)");
  const FixedLane lane = lane_of(graph, 53, std::vector(4, std::optional(Range{1024, 2047})));
  ASSERT_TRUE(emulator::make_fixed_code(lane).has_value());
  Random random(8);
  Columns columns(4);
  const auto fraction = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  for (int k = 0; k < 1000; ++k) {
    const double a = 2042 + 2 * fraction(), b = 1024 + fraction(), c = 1024 + fraction();
    const double d = a + (b - c) + std::ldexp(static_cast<double>(random() % 16) - 8, -42);
    for (const auto& [column, value] : {std::pair{0, a}, {1, b}, {2, c}, {3, d}}) {
      columns[column].push_back(value);
    }
  }
  expect_golden("54 bits", lane, columns);
}

/// Parts that decide by norms and by constants, that share operations, and that say `any`.
TEST(FixedEmulationOfParts, IsTheGoldenModels) {
  const Graph any =
      graph_of({{"abs(a - b)", "c"}, {"(a - b)^2", "c^2"}, {"a", "b + c"}}, Combination::any);
  const Graph all = graph_of({{"abs(a - b)", "c"}, {"(a - b)^2", "c^2"}}, Combination::all);
  Random random(2);
  for (const Graph& graph : {any, all}) {
    const std::vector<std::optional<Range>> ranges(3, Range{-4, 6});
    const Columns columns = hard_columns(ranges, 1000, random);
    for (const int bits : {2, 5, 13, 40}) {
      const auto lane = fixed::fixed_lane(graph, format("s53e11"),
                                          {.format = {bits}, .bound = {}, .ranges = ranges});
      ASSERT_TRUE(lane.ok());
      expect_golden("parts", *lane, columns);
    }
  }
}

FixedLane sphere_lane(int bits) {
  return fixed::fixed_lane(sphere_graph(), format("s53e11"),
                           {.format = {bits},
                            .bound = {},
                            .ranges = std::vector(8, std::optional(Range{0, 100}))})
      .value();
}

/// A part with operands of its own shares the cut: an operand out of range in one part leaves both
/// undecided.
TEST(GuardedParts, AreTheGoldenModelsBitForBit) {
  const Graph graph =
      graph_of({{"(a - b)^2", "(a + b)^2"}, {"c * d", "(c - d)^2"}}, Combination::any);
  const std::vector<std::optional<Range>> ranges(4, Range{-3, 3});
  Random random(8);
  const Columns columns = hard_columns(ranges, 2001, random);
  for (const FixedPoint format :
       {FixedPoint{3, false, 4}, {7, false, 2}, {4, true, 3}, {40, false, 5}}) {
    const auto lane = fixed::fixed_lane(graph, mixcmp::test::format("s53e11"),
                                        {.format = format, .ranges = ranges});
    expect_golden(format.name(), lane.value(), columns);
  }
}

/// The squares, their sum and the radius of spheres are computed where the decision reads them.
TEST(FixedCode, OfSpheresStoresOnlyTheOperands) {
  const auto code = emulator::make_fixed_code(sphere_lane(24));
  ASSERT_TRUE(code.has_value());
  EXPECT_EQ(code->instructions.size(), 8u);
  for (const emulator::FixedInstruction& each : code->instructions) {
    EXPECT_EQ(each.kernel, emulator::FixedKernel::convert_unsigned);
  }
  EXPECT_EQ(code->criteria.front().difference.size(), 4u);
  EXPECT_EQ(code->criteria.front().radius.size(), 2u);
}

TEST(WideFixedLanes, OfTooManyBitsFallBackToTheGoldenModel) {
  Random random(4);
  const Columns columns = hard_columns(std::vector(8, std::optional(Range{0, 100})), 10, random);
  std::vector<Decision> decisions(10);
  EXPECT_TRUE(emulator::make_fixed_code(sphere_lane(25)).has_value());
  EXPECT_FALSE(emulator::make_fixed_code(sphere_lane(26)).has_value());
  for (const auto& [bits, fallbacks] : {std::pair{26, 0u}, {60, 0u}, {63, 10u}}) {
    const Emulator emulator(sphere_lane(bits));
    emulator.decide(pointers(columns), 10, decisions);
    EXPECT_EQ(emulator.fallbacks(), fallbacks) << bits;
    EXPECT_EQ(emulator.is_emulated(), fallbacks == 0) << bits;
  }
  const std::vector ranges(4, std::optional(Range{0, 100}));
  EXPECT_TRUE(emulator::WideLane::make(lane_of(graph_of("a * b", "c * d"), 62, ranges)));
  EXPECT_FALSE(emulator::WideLane::make(lane_of(graph_of("a * b", "c * d"), 63, ranges)));
}

/// Operands of both parts are divided by one power of two.
TEST(BlocksOfParts, AreUndecidedWhereAnyOperandIsInfinite) {
  const Graph graph = graph_of({{"a", "b"}, {"c", "d"}}, Combination::any);
  const auto lane = fixed::fixed_lane(
      graph, format("s53e11"),
      {.format = {5, true}, .bound = {}, .ranges = std::vector<std::optional<Range>>(4)});
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Columns columns = {{1, 1, 1}, {3, 3, 3}, {2, infinity, std::nan("")}, {1, 1, 1}};
  EXPECT_EQ(golden_decisions(lane.value(), columns),
            (std::vector{Decision::less, Decision::undecided, Decision::undecided}));
  expect_golden("blocks", lane.value(), columns);
}

TEST(FixedBatches, WriteNothingBeyondThem) {
  Random random(5);
  const Columns columns = hard_columns(std::vector(8, std::optional(Range{0, 100})), 45, random);
  std::vector<Decision> decisions(100, Decision::unordered);
  Emulator(sphere_lane(17)).decide(pointers(columns), 45, decisions);
  EXPECT_NE(decisions[44], Decision::unordered);
  for (std::size_t k = 45; k < 100; ++k) EXPECT_EQ(decisions[k], Decision::unordered);
}

}  // namespace
}  // namespace mixcmp::test::fixed_test
