#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "VLines.h"
#include "tests/rtl_templates/stream/random_source.hpp"

namespace mixcmp::test::line_test {
namespace {

struct Lines {
  VerilatedContext context;
  VLines model{&context};

  void settle() {
    model.aclk = 0;
    model.eval();
  }
  void tick() {
    model.aclk = 1;
    model.eval();
  }
};

void reset(Lines& lines) {
  lines.model.aresetn = 0;
  lines.settle();
  lines.tick();
  lines.model.aresetn = 1;
}

TEST(DelayLine, ReturnsTheWordOfLengthCyclesAgo) {
  Lines lines;
  RandomSource random(1);
  std::vector<std::uint16_t> history;
  for (std::size_t cycle = 0; cycle < 2000; ++cycle) {
    history.push_back(static_cast<std::uint16_t>(random.word()));
    lines.model.d = history.back();
    lines.settle();
    const auto ago = [&](std::size_t length) { return history[cycle - length]; };
    EXPECT_EQ(lines.model.q0, ago(0)) << "cycle " << cycle;
    if (cycle >= 1) {
      EXPECT_EQ(lines.model.q1, ago(1)) << "cycle " << cycle;
    }
    if (cycle >= 3) {
      EXPECT_EQ(lines.model.q3, ago(3)) << "cycle " << cycle;
    }
    if (cycle >= 300) {
      EXPECT_EQ(lines.model.q300, ago(300)) << "cycle " << cycle;
    }
    lines.tick();
  }
}

TEST(ValidDelayLine, DelaysAndForgetsOnReset) {
  Lines lines;
  RandomSource random(2);
  std::vector<bool> history;  // the inputs since the last reset
  reset(lines);
  for (int cycle = 0; cycle < 20000; ++cycle) {
    const bool step = random.chance(0.5);
    lines.model.step = step;
    lines.settle();
    history.push_back(step);
    const auto ago = [&](std::size_t length) {
      return history.size() > length && history[history.size() - 1 - length];
    };
    ASSERT_EQ(lines.model.v0, step) << "cycle " << cycle;
    ASSERT_EQ(lines.model.v1, ago(1)) << "cycle " << cycle;
    ASSERT_EQ(lines.model.v3, ago(3)) << "cycle " << cycle;
    ASSERT_EQ(lines.model.v300, ago(300)) << "cycle " << cycle;
    lines.tick();
    if (random.chance(0.001)) {
      reset(lines);
      history.clear();
    }
  }
}

TEST(EventCounter, CountsModuloItsWidthAndClearsOnReset) {
  Lines lines;
  RandomSource random(3);
  std::uint32_t expected = 0;
  reset(lines);
  for (int cycle = 0; cycle < 5000; ++cycle) {
    const bool step = random.chance(0.7);
    lines.model.step = step;
    lines.settle();
    ASSERT_EQ(lines.model.count0, 0);
    ASSERT_EQ(lines.model.count3, expected % 8) << "cycle " << cycle;
    ASSERT_EQ(lines.model.count32, expected) << "cycle " << cycle;
    lines.tick();
    expected += step ? 1 : 0;
    if (random.chance(0.01)) {
      reset(lines);
      expected = 0;
    }
  }
}

TEST(DualPortMemory, ReadsWhatWasWrittenAndHoldsWithoutEnable) {
  Lines lines;
  RandomSource random(4);
  std::map<std::uint32_t, std::uint16_t> written;
  bool known = false;
  std::uint16_t expected = 0;
  for (int cycle = 0; cycle < 20000; ++cycle) {
    const std::uint32_t write_address = random.below(32);
    const std::uint32_t read_address = random.below(32);
    const auto word = static_cast<std::uint16_t>(random.word());
    const bool write = random.chance(0.5);
    // A read of the address that is written in the same cycle is outside the contract.
    const bool read = random.chance(0.5) && !(write && write_address == read_address);
    lines.model.d = word;
    lines.model.write_enable = write;
    lines.model.write_address = static_cast<CData>(write_address);
    lines.model.read_enable = read;
    lines.model.read_address = static_cast<CData>(read_address);
    lines.settle();
    lines.tick();
    if (read) {
      known = written.count(read_address) != 0;
      expected = known ? written[read_address] : std::uint16_t{0};
    }
    if (write) written[write_address] = word;
    if (known) {
      ASSERT_EQ(lines.model.read_data, expected) << "cycle " << cycle;
    }
  }
}

}  // namespace
}  // namespace mixcmp::test::line_test
