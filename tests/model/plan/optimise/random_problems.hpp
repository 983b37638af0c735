#pragma once

#include <random>

#include "model/plan/optimise/allocation.hpp"

/// Small allocation problems with everything that is odd in large ones.
namespace mixcmp::test {

class RandomProblems {
public:
  explicit RandomProblems(unsigned seed) : engine_(seed) {}

  optimise::AllocationProblem next() {
    optimise::AllocationProblem problem;
    problem.clocks =
        chance(0.5) ? optimise::ClockDomains::single : optimise::ClockDomains::separate;
    problem.sharing =
        chance(0.7) ? optimise::ReferenceSharing::round_robin : optimise::ReferenceSharing::pooled;
    if (chance(0.3)) problem.recomputations_per_cycle = pick({0.1, 0.3, 0.5, 1});
    problem.max_lanes = number(1, 9);
    problem.max_references = number(0, 4);
    problem.slack = pick({0.0, 0.0, 0.1, 0.2, 0.2, 0.9});
    problem.available = {.luts = chance(0.1) ? number(0, 60) : number(100, 700),
                         .registers = chance(0.5) ? number(100, 800) : 1'000'000,
                         .dsps = chance(0.2) ? 0 : number(10, 60),
                         .memories = chance(0.2) ? 0 : number(5, 20)};
    for (int k = number(1, 3); k > 0; --k) problem.lanes.push_back(lane());
    for (int k = chance(0.1) ? 0 : number(1, 2); k > 0; --k) {
      problem.references.push_back(reference());
    }
    problem.communication.fixed = {.luts = chance(0.5) ? 0 : number(0, 40)};
    if (chance(0.6)) add_crossbar(problem.communication);
    return problem;
  }

  /// A problem whose lanes come in groups.
  optimise::AllocationProblem next_of_groups() {
    optimise::AllocationProblem problem = next();
    problem.sharing = optimise::ReferenceSharing::pooled;
    for (optimise::LaneKind& lane : problem.lanes) lane.group = number(1, 4);
    return problem;
  }

  /// A problem whose lanes come in groups of one size, each with a port of the crossbar.
  optimise::AllocationProblem next_of_groups_with_ports() {
    optimise::AllocationProblem problem = next();
    problem.sharing = optimise::ReferenceSharing::round_robin;
    const int group = number(2, 3);
    problem.max_lanes = number(group, 14);
    for (optimise::LaneKind& lane : problem.lanes) lane.group = group;
    return problem;
  }

  /// A problem whose plans have a given number of lanes, or some more.
  optimise::AllocationProblem next_with_least_lanes() {
    optimise::AllocationProblem problem = next();
    problem.min_lanes = chance(0.5) ? problem.max_lanes : number(1, problem.max_lanes);
    return problem;
  }

private:
  int number(int low, int high) { return std::uniform_int_distribution(low, high)(engine_); }
  bool chance(double part) { return std::bernoulli_distribution(part)(engine_); }
  double pick(std::initializer_list<double> values) {
    return *(values.begin() + number(0, static_cast<int>(values.size()) - 1));
  }

  double clock() { return 1e6 * pick({100, 100, 150, 200, 285, 408}); }

  /// Rates at which sums just fill a reference, or miss it in the last digit, are the hard ones.
  double rate() {
    if (chance(0.3)) return pick({0.1, 0.2, 0.25, 0.3, 0.5, 1.0 / 3});
    return pick({0, 0, 1e-12, 1e-9, 1e-6, 0.01, 0.1, 0.3334, 0.50000001, 0.7, 1});
  }

  optimise::LaneKind lane() {
    return {.name = "lane",
            .clock_hz = clock(),
            .initiation_interval = pick({1, 1, 1, 1, 1, 1.0078, 2, 4}),
            .recomputation_rate = rate(),
            .area = {.luts = number(0, 60),
                     .registers = number(0, 90),
                     .dsps = chance(0.6) ? 0 : number(0, 8),
                     .memories = chance(0.7) ? 0 : number(0, 3)}};
  }
  optimise::ReferenceKind reference() {
    return {.name = "reference",
            .clock_hz = clock(),
            .initiation_interval = chance(0.5) ? 1 : number(2, 5),
            .area = {.luts = number(0, 120),
                     .registers = number(0, 90),
                     .dsps = chance(0.4) ? 0 : number(0, 12)}};
  }

  /// Convex, concave, linear or none of it; sometimes short of ports.
  void add_crossbar(optimise::Communication& communication) {
    const int shape = number(0, 3);
    const int ports = chance(0.3) ? number(1, 4) : 9;
    int cost = number(0, 20);
    int step = number(0, 10);
    for (int k = 0; k <= ports; ++k) {
      communication.crossbar.push_back({.luts = cost, .registers = number(0, 5)});
      if (shape == 0) ++step;
      if (shape == 1) step = std::max(0, step - 1);
      cost = shape == 3 ? number(0, 40) : cost + step;
    }
  }

  std::mt19937 engine_;
};

}  // namespace mixcmp::test
