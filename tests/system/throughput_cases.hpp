#pragma once

#include <cstdint>
#include <ostream>
#include <vector>

#include "model/cost/performance/streams.hpp"
#include "tests/support/simulated_system.hpp"

/// Sphere systems in simulation at full rate, with comparisons that are undecided by plan.
namespace mixcmp::test {

/// The model and the hardware agree within this part of the model's figure.
inline constexpr double throughput_tolerance = 0.05;

struct Shape {
  int lanes;
  int references;
  scene::ResultOrder order;
  int initiation_interval = 1;  ///< of the references
};
void PrintTo(const Shape& shape, std::ostream* stream);

/// A certified sphere system: lanes in s5e8, references in s24e8.
design::Design design_of(const Shape& shape);

std::vector<bool> random_pattern(std::size_t count, double rate, unsigned seed);

/// The generator's description of the lanes that a reference serves.
performance::LaneStreams streams_of(const design::Design& design, int reference);

/// Comparisons per cycle of all lanes where this part is undecided at random.
double predicted_per_cycle(const design::Design& design, double rate);

/// One comparison each, undecided where marked, through the generated system.
verilator_tb::VerifyReport run(const design::Design& design, const std::vector<bool>& undecided);

std::uint64_t stalls_of(const verilator_tb::VerifyReport& report);

}  // namespace mixcmp::test
