#include <gtest/gtest.h>

#include <set>
#include <string>

#include "model/base/number/double.hpp"
#include "tests/model/judge/emulator/against_golden.hpp"
#include "tests/model/judge/emulator/random_lanes.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/graphs.hpp"
#include "tests/support/sphere.hpp"

namespace mixcmp::test::batches_test {
namespace {

using emulator::Emulator;
using error::Lane;

Lane sphere_lane(Arithmetic reduced) {
  TypedGraph graph = lane_graph(sphere_graph(), format("s53e8"), reduced, LaneInputs::exact);
  return error::certified_lane(graph, {}).value();
}

std::vector<std::vector<double>> plain_columns(std::size_t count, Random& random) {
  std::vector<std::vector<double>> columns(8);
  for (auto& column : columns) {
    for (std::size_t k = 0; k < count; ++k) {
      column.push_back(1 + static_cast<double>(random() >> 11) * 0x1p-47);
    }
  }
  return columns;
}

std::vector<const double*> pointers(const std::vector<std::vector<double>>& columns,
                                    std::size_t offset) {
  std::vector<const double*> result;
  for (const auto& column : columns) result.push_back(column.data() + offset);
  return result;
}

TEST(Batches, AnySplitGivesTheSameDecisions) {
  constexpr std::size_t count = 1500;
  Random random(1);
  auto columns = plain_columns(count, random);
  for (std::size_t k = 0; k < count; k += 97) columns[k % 8][k] = k % 2 == 0 ? 0 : 1e-41;
  const Emulator emulator(
      sphere_lane({format("s17e8"), Rounding::nearest_even, Subnormals::flush}));
  std::vector<Decision> whole(count);
  emulator.decide(pointers(columns, 0), count, whole);
  for (const std::size_t size : {std::size_t{1}, std::size_t{31}, std::size_t{33}, std::size_t{256},
                                 std::size_t{257}, std::size_t{1000}}) {
    std::vector<Decision> parts(count, Decision::unordered);
    for (std::size_t first = 0; first < count; first += size) {
      const std::size_t part = std::min(size, count - first);
      emulator.decide(pointers(columns, first), part, std::span(parts).subspan(first, part));
    }
    EXPECT_EQ(whole, parts) << size;
  }
}

TEST(Batches, NothingIsWrittenBeyondThem) {
  Random random(2);
  const auto columns = plain_columns(45, random);
  const Emulator emulator(
      sphere_lane({format("s17e8"), Rounding::nearest_even, Subnormals::flush}));
  std::vector<Decision> decisions(100, Decision::unordered);
  std::vector<double> f(100, -1), g(100, -1);
  std::vector<std::uint8_t> exceptional(100, 7);
  emulator.decide(pointers(columns, 0), 45, decisions);
  emulator.compute(pointers(columns, 0), 45, f, g, exceptional);
  for (std::size_t k = 45; k < 100; ++k) {
    EXPECT_EQ(decisions[k], Decision::unordered);
    EXPECT_EQ(f[k], -1);
    EXPECT_EQ(g[k], -1);
    EXPECT_EQ(exceptional[k], 7);
  }
  EXPECT_NE(decisions[44], Decision::unordered);
  EXPECT_EQ(exceptional[44], 0);
}

TEST(Batches, AnEmptyOneDoesNothing) {
  const Emulator emulator(
      sphere_lane({format("s17e8"), Rounding::nearest_even, Subnormals::flush}));
  const std::vector<const double*> none(8, nullptr);
  emulator.decide(none, 0, {});
  EXPECT_EQ(emulator.fallbacks(), 0u);
}

/// Finite numbers of ordinary size never need the golden model.
TEST(Fallbacks, AreNoneForOrdinaryData) {
  Random random(3);
  auto columns = plain_columns(2000, random);
  for (std::size_t k = 0; k < 2000; k += 50) columns[0][k] = columns[1][k];  // the difference is 0
  for (std::size_t k = 0; k < 2000; k += 70) columns[5][k] = 0;
  for (const int digits : {4, 17, 25, 40, 52}) {
    for (const Arithmetic& reduced : every_arithmetic(format_of(digits, 8))) {
      const Emulator emulator(sphere_lane(reduced));
      std::vector<Decision> decisions(2000);
      emulator.decide(pointers(columns, 0), 2000, decisions);
      emulator.compare(pointers(columns, 0), 2000, decisions);
      EXPECT_EQ(emulator.fallbacks(), 0u) << digits;
    }
  }
}

TEST(Fallbacks, AreCountedOneAComparison) {
  Random random(4);
  auto columns = plain_columns(300, random);
  columns[2][7] = std::numeric_limits<double>::infinity();
  columns[0][250] = 0x1p100;  // its square overflows
  const Emulator emulator(
      sphere_lane({format("s17e8"), Rounding::nearest_even, Subnormals::flush}));
  std::vector<Decision> decisions(300);
  emulator.compare(pointers(columns, 0), 300, decisions);
  EXPECT_EQ(emulator.fallbacks(), 2u);
  // A flushing lane is known to be undecided there.
  emulator.decide(pointers(columns, 0), 300, decisions);
  EXPECT_EQ(emulator.fallbacks(), 2u);
  EXPECT_EQ(decisions[7], Decision::undecided);
  EXPECT_EQ(decisions[250], Decision::undecided);
}

TEST(Fallbacks, AreAllWhereDoubleDoesNotHoldTheFormat) {
  const Emulator emulator(reference_graph(graph_of("a * b", "a + b"), {format("s64e15")}));
  const std::vector<double> a = {1, 2, 3}, b = {3, 2, 1.4};
  const std::vector<const double*> operands = {a.data(), b.data()};
  std::vector<Decision> decisions(3);
  emulator.decide(operands, 3, decisions);
  EXPECT_EQ(emulator.fallbacks(), 3u);
  EXPECT_EQ(decisions, (std::vector{Decision::less, Decision::equal, Decision::less}));
}

TEST(OperandsDeathTest, ANumberThatTheFormatDoesNotHaveIsABrokenInvariant) {
  const Emulator emulator(reference_graph(graph_of("a * b", "a + b"), {format("s24e8")}));
  const std::vector<double> a = {1 + 0x1p-30}, b = {3};
  const std::vector<const double*> operands = {a.data(), b.data()};
  std::vector<Decision> decisions(1);
  EXPECT_DEATH(emulator.decide(operands, 1, decisions), "broken invariant");
}

TEST(Operands, SurviveTheWayToDoublesAndBack) {
  for (const char* name : {"s4e4", "s24e8", "s53e8", "s53e11", "s2e2", "s17e5"}) {
    const FloatFormat number_format = format(name);
    for (const Bits bits : special_encodings(number_format)) {
      const double value = to_double(number_format, bits);
      const Bits expected = number_format.is_nan(bits) ? number_format.quiet_nan() : bits;
      EXPECT_EQ(to_hex(from_double(number_format, value), 64), to_hex(expected, 64)) << name;
    }
  }
}

TEST(InstructionSets, AreAllRun) {
  std::set<std::string> names;
  for_each_instruction_set([&] { names.insert(Emulator::instruction_set()); });
  EXPECT_TRUE(names.contains(Emulator::instruction_set()));
#if defined(__x86_64__)
  EXPECT_EQ(names.contains("AVX2"), __builtin_cpu_supports("avx2") != 0);
  EXPECT_EQ(names.contains("AVX3"), __builtin_cpu_supports("avx512vl") != 0);
  EXPECT_GE(names.size(), 1u + names.contains("AVX2") + names.contains("AVX3"));
#endif
}

}  // namespace
}  // namespace mixcmp::test::batches_test
