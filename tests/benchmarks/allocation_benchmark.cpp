#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "model/plan/optimise/allocation.hpp"

/// One step of Algorithm 1: twenty kinds of lanes of one precision, two of references, a crossbar
/// of 512 ports, on a device the size of a VU9P. It should take well below 0.3 s.
namespace mixcmp {
namespace {

using devices::Area;

/// Areas and clocks as rows of a characterisation are spread; half of the kinds take DSPs.
optimise::AllocationProblem problem_of(int precision) {
  std::mt19937 engine(static_cast<unsigned>(precision));
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(engine);
  };
  optimise::AllocationProblem problem;
  for (int k = 0; k < 20; ++k) {
    const bool embedded = k % 2 != 0;
    const double luts =
        (200 + precision * (30 + 2 * precision) * between(0.3, 1)) * (embedded ? 0.5 : 1);
    const double rate = std::ldexp(between(10, 300), -precision);
    problem.lanes.push_back({.name = "lane",
                             .clock_hz = 1e6 * std::round(between(300, 420) - 2 * precision),
                             .recomputation_rate = std::min(1.0, rate),
                             .area = {.luts = static_cast<int>(luts),
                                      .registers = static_cast<int>(luts * between(0.8, 1.6)),
                                      .dsps = embedded ? precision * precision / 60 : 0}});
  }
  problem.references = {
      {"embedded", 285e6, 1, {.luts = 7350, .registers = 9000, .dsps = 40}},
      {"logic", 223e6, 1, {.luts = 17198, .registers = 20000}},
  };
  for (int k = 0; k <= 512; ++k) {
    problem.communication.crossbar.push_back(
        {.luts = 90 * k + static_cast<int>(between(0, 30)), .registers = 130 * k});
  }
  problem.available = {.luts = 1'182'240, .registers = 2'364'480, .dsps = 6'840, .memories = 2'160};
  return problem;
}

void allocate_at_precision(benchmark::State& state) {
  const optimise::AllocationProblem problem = problem_of(static_cast<int>(state.range(0)));
  for (auto unused : state) benchmark::DoNotOptimize(optimise::allocate(problem));
}
BENCHMARK(allocate_at_precision)->Unit(benchmark::kMillisecond)->DenseRange(4, 52, 8);

}  // namespace
}  // namespace mixcmp
