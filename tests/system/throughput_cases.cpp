#include "tests/system/throughput_cases.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <random>

#include "generator/hardware/emit/system.hpp"
#include "model/cost/performance/performance.hpp"
#include "tests/support/sphere.hpp"

namespace mixcmp::test {
namespace {

/// The encoding in s24e8, which is binary32.
Bits bits_of(float value) {
  return std::bit_cast<std::uint32_t>(value);
}

/// One pair of spheres each: undecided ones touch, f = g = 1, the others are far apart, f = 9.
data::Comparisons pairs(const design::Design& design, const std::vector<bool>& undecided) {
  data::Table table{format("s24e8"), design.inputs, {}, {}};
  for (const bool touching : undecided) {
    for (const std::string& input : design.inputs) {
      float value = 1;
      if (input == "cxi") value = touching ? 2 : 4;
      if (input == "ri" || input == "rj") value = 0.5;
      table.values.push_back(bits_of(value));
    }
  }
  return data::Comparisons::rows(std::move(table), design.inputs).value();
}

}  // namespace

void PrintTo(const Shape& shape, std::ostream* stream) {
  *stream << shape.lanes << "x" << shape.references << "N" << shape.initiation_interval;
}

design::Design design_of(const Shape& shape) {
  design::Design design =
      sphere_design(format("s5e8"), format("s24e8"), shape.lanes, shape.references);
  design.system.order = shape.order;
  design.references.front().structure.initiation_interval = shape.initiation_interval;
  return design;
}

std::vector<bool> random_pattern(std::size_t count, double rate, unsigned seed) {
  std::mt19937 engine(seed);
  std::bernoulli_distribution undecided(rate);
  std::vector<bool> pattern(count);
  for (std::size_t k = 0; k < count; ++k) pattern[k] = undecided(engine);
  return pattern;
}

performance::LaneStreams streams_of(const design::Design& design, int reference) {
  const auto system = emit::generate_system(design, "mixcmp generate test.toml");
  EXPECT_TRUE(system.ok()) << system.error().to_string();
  const emit::Signature& signature = system->signature;
  const auto served = performance::lanes_of_references(signature.lanes, signature.references);
  return {
      .order = signature.order,
      .lane_latency_cycles = signature.lane_groups[0].latency_cycles + signature.input_registers,
      .reference_latency_cycles = signature.reference_groups[0].latency_cycles,
      .initiation_interval_cycles = signature.reference_groups[0].initiation_interval_cycles,
      .slots = signature.slots,
      .lanes_served = served[reference]};
}

double predicted_per_cycle(const design::Design& design, double rate) {
  double sum = 0;
  for (int r = 0; r < design.reference_count(); ++r) {
    const performance::LaneStreams streams = streams_of(design, r);
    sum += streams.lanes_served * performance::random_throughput(streams, rate);
  }
  return sum;
}

verilator_tb::VerifyReport run(const design::Design& design, const std::vector<bool>& undecided) {
  const verilator_tb::VerifyReport report = simulate(design, pairs(design, undecided), {});
  EXPECT_TRUE(report.passed()) << to_text(report);
  return report;
}

std::uint64_t stalls_of(const verilator_tb::VerifyReport& report) {
  for (const verilator_tb::CounterTotal& counter : report.counters) {
    if (counter.name == "stalls") return counter.counted;
  }
  ADD_FAILURE() << "the system does not count stalls";
  return 0;
}

}  // namespace mixcmp::test
