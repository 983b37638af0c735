#include "verilator_tb/selection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

#include "model/base/common/counter_random.hpp"
#include "model/base/number/exact.hpp"

namespace mixcmp::test::selection_test {
namespace {

TEST(Selection, TakesAllOrTheFirst) {
  EXPECT_EQ(verilator_tb::Selection(10, {}).size(), 10u);
  EXPECT_EQ(verilator_tb::Selection(10, {.limit = 4}).size(), 4u);
  EXPECT_EQ(verilator_tb::Selection(10, {.limit = 4}).index(3), 3u);
  EXPECT_EQ(verilator_tb::Selection(10, {.limit = 40}).size(), 10u);
}

TEST(Selection, TakesOneAlone) {
  const verilator_tb::Selection one(10, {.limit = 4, .only = 7});
  EXPECT_EQ(one.size(), 1u);
  EXPECT_EQ(one.index(0), 7u);
  EXPECT_EQ(verilator_tb::Selection(10, {.only = 10}).size(), 0u);
}

TEST(Selection, RandomOnesRiseWithoutRepetitionAndDependOnTheSeed) {
  constexpr std::uint64_t available = std::uint64_t{1} << 62;
  const verilator_tb::Selection sample(
      available, {.limit = 1000, .sampling = verilator_tb::Sampling::random, .seed = 1});
  const verilator_tb::Selection other(
      available, {.limit = 1000, .sampling = verilator_tb::Sampling::random, .seed = 2});
  int equal = 0;
  for (std::uint64_t k = 0; k < 1000; ++k) {
    if (k > 0) {
      ASSERT_LT(sample.index(k - 1), sample.index(k));
    }
    ASSERT_LT(sample.index(k), available);
    if (sample.index(k) == other.index(k)) ++equal;
  }
  EXPECT_EQ(equal, 0);
}

TEST(Selection, RandomSampleOfAllIsAll) {
  const verilator_tb::Selection sample(100,
                                       {.limit = 100, .sampling = verilator_tb::Sampling::random});
  for (std::uint64_t k = 0; k < 100; ++k) EXPECT_EQ(sample.index(k), k);
}

TEST(Selection, PartsAreTheWholeInOrder) {
  for (const auto sampling : {verilator_tb::Sampling::first, verilator_tb::Sampling::random}) {
    const verilator_tb::Selection whole(1000, {.limit = 103, .sampling = sampling});
    const verilator_tb::Selection middle = whole.part(10, 60), last = middle.part(50, 10);
    ASSERT_EQ(middle.size(), 60u);
    for (std::uint64_t k = 0; k < 60; ++k) EXPECT_EQ(middle.index(k), whole.index(10 + k));
    for (std::uint64_t k = 0; k < 10; ++k) EXPECT_EQ(last.index(k), whole.index(60 + k));
  }
}

/// A floating-point format whose words have `width` bits.
FloatFormat format_of_width(int width) {
  const int exponent_bits =
      std::max(FloatFormat::min_exponent_bits, width - FloatFormat::max_precision);
  return *FloatFormat::make(width - exponent_bits, exponent_bits);
}

void pack(std::span<const Bits> operands, FloatFormat format, bool padding,
          std::vector<std::uint8_t>& tdata) {
  const std::vector<OperandFormat> formats(operands.size(), OperandFormat(format));
  verilator_tb::pack_operands(operands, format, formats, padding, tdata);
}

TEST(PackOperands, PaddingMayBeLong) {
  std::vector<std::uint8_t> tdata(40);
  pack(std::vector<Bits>{0}, format_of_width(8), true, tdata);
  EXPECT_EQ(tdata[0], 0);
  EXPECT_EQ(std::count(tdata.begin(), tdata.end(), 0xff), 39);
}

TEST(PackOperands, PutsOperandKAtBitKTimesWidth) {
  std::vector<std::uint8_t> tdata(5);
  const Bits operands[] = {0x7ff, 0x001, 0x400};
  pack(operands, format_of_width(11), true, tdata);
  EXPECT_EQ(tdata, (std::vector<std::uint8_t>{0xff, 0x0f, 0x00, 0x00, 0xff}));
  pack(operands, format_of_width(11), false, tdata);
  EXPECT_EQ(tdata, (std::vector<std::uint8_t>{0xff, 0x0f, 0x00, 0x00, 0x01}));
}

TEST(PackOperands, PutsFixedPointInFieldsOfItsOwnWidth) {
  const FloatFormat encoding = *FloatFormat::make(24, 8);
  const auto number = [&](const mpq_class& value) { return from_rational(encoding, value); };
  std::vector<OperandFormat> formats;
  for (const char* name : {"uint10", "int4", "q1.2"}) {
    formats.push_back(*OperandFormat::parse(name));
  }
  const Bits operands[] = {number(0x2a5), number(-3), number(mpq_class(-7, 4))};
  std::vector<std::uint8_t> tdata(3);
  verilator_tb::pack_operands(operands, encoding, formats, true, tdata);
  const std::uint32_t word = 0x2a5 | 13U << 10 | 9U << 14 | 0x3fU << 18;
  EXPECT_EQ(tdata[0] | tdata[1] << 8 | tdata[2] << 16, static_cast<int>(word));
}

/// Bit by bit, at every width that a format has.
TEST(PackOperands, AgreesWithBitsPutOneByOne) {
  for (int width = 4; width <= 128; ++width) {
    std::vector<Bits> operands;
    for (std::uint64_t k = 0; k < 10; k += 2) {
      const Bits random = Bits{counter_random(1, k)} << 64 | counter_random(1, k + 1);
      operands.push_back(random & low_mask(width));
    }
    std::vector<std::uint8_t> tdata((operands.size() * static_cast<std::size_t>(width) + 7) / 8);
    pack(operands, format_of_width(width), true, tdata);
    for (std::size_t at = 0; at < 8 * tdata.size(); ++at) {
      const std::size_t operand = at / static_cast<std::size_t>(width);
      const Bits bits = operand < operands.size() ? operands[operand] : low_mask(width);
      const auto expected = static_cast<int>(bits >> at % static_cast<std::size_t>(width) & 1);
      ASSERT_EQ(tdata[at / 8] >> at % 8 & 1, expected) << width << ", bit " << at;
    }
  }
}

}  // namespace
}  // namespace mixcmp::test::selection_test
