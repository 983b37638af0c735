#include <benchmark/benchmark.h>
#include <hwy/aligned_allocator.h>
#include <hwy/highway.h>
#include <mpfr.h>

#include <random>
#include <string>
#include <vector>

#include "model/base/common/vector_clones.hpp"
#include "model/judge/emulator/emulator.hpp"
#include "model/lane/error/certified_lane.hpp"
#include "tests/support/sphere.hpp"

/// The sphere comparison, decided by MPFR, by the emulator on each instruction set, and by native
/// double arithmetic that compares only signs. Items are comparisons, on one core.
namespace mixcmp {
namespace {

using emulator::Emulator;

/// As many as a caller gathers at once; operands fit the second-level cache.
constexpr std::size_t pair_count = 2048;
constexpr std::size_t operand_count = 8;

/// Uniform in a cube of side 100, radii in [0, 25]; all 53 digits. Aligned to lines of the cache.
struct Pairs {
  std::vector<hwy::AlignedFreeUniquePtr<double[]>> columns;
  std::vector<const double*> pointers;

  Pairs() {
    std::mt19937_64 random(1);
    for (std::size_t operand = 0; operand < operand_count; ++operand) {
      const double side = operand < 6 ? 100 : 25;
      double* const values = columns.emplace_back(hwy::AllocateAligned<double>(pair_count)).get();
      for (std::size_t k = 0; k < pair_count; ++k) {
        values[k] = side * static_cast<double>(random() >> 11) * 0x1p-53;
      }
      pointers.push_back(values);
    }
  }
};

void count_comparisons(benchmark::State& state) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(pair_count));
}

/// mpfr_t cannot be copied as a value: an array that is cleared at the end.
class Numbers {
public:
  Numbers(std::size_t count, mpfr_prec_t precision) : values_(count) {
    for (auto& value : values_) mpfr_init2(&value, precision);
  }
  ~Numbers() {
    for (auto& value : values_) mpfr_clear(&value);
  }
  Numbers(const Numbers&) = delete;
  Numbers& operator=(const Numbers&) = delete;
  mpfr_ptr operator[](std::size_t index) { return &values_[index]; }

private:
  std::vector<__mpfr_struct> values_;
};

/// Operands converted beforehand; eleven rounded operations, f - g the last.
void by_mpfr(benchmark::State& state, LaneInputs inputs) {
  const auto precision = static_cast<mpfr_prec_t>(state.range(0));
  const Pairs pairs;
  Numbers operands(operand_count * pair_count, inputs == LaneInputs::exact ? 53 : precision);
  for (std::size_t k = 0; k < pair_count; ++k) {
    for (std::size_t operand = 0; operand < operand_count; ++operand) {
      mpfr_set_d(operands[operand_count * k + operand], pairs.columns[operand][k], MPFR_RNDN);
    }
  }
  Numbers scratch(3, precision);
  const mpfr_ptr f = scratch[0], g = scratch[1], term = scratch[2];
  for (auto unused : state) {
    long balance = 0;
    for (std::size_t first = 0; first < operand_count * pair_count; first += operand_count) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const mpfr_ptr difference = axis == 0 ? f : term;
        mpfr_sub(difference, operands[first + 2 * axis], operands[first + 2 * axis + 1], MPFR_RNDN);
        mpfr_sqr(difference, difference, MPFR_RNDN);
        if (axis > 0) mpfr_add(f, f, term, MPFR_RNDN);
      }
      mpfr_add(g, operands[first + 6], operands[first + 7], MPFR_RNDN);
      mpfr_sqr(g, g, MPFR_RNDN);
      mpfr_sub(term, f, g, MPFR_RNDN);
      balance += mpfr_sgn(term);
    }
    benchmark::DoNotOptimize(balance);
  }
  count_comparisons(state);
}

void choose_instruction_set(std::int64_t target) {
  hwy::SetSupportedTargetsForTest(target);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

enum class Task { decide, compare, compute };

void run(const Emulator& emulator, Task task, const Pairs& pairs, std::span<Decision> decisions,
         std::span<double> f, std::span<double> g, std::span<std::uint8_t> exceptional) {
  switch (task) {
    case Task::decide: return emulator.decide(pairs.pointers, pair_count, decisions);
    case Task::compare: return emulator.compare(pairs.pointers, pair_count, decisions);
    case Task::compute: return emulator.compute(pairs.pointers, pair_count, f, g, exceptional);
  }
}

/// `operands`: how many columns of a pair the comparison reads.
void time(benchmark::State& state, const Emulator& emulator, Task task, std::int64_t target,
          std::size_t operands = operand_count) {
  choose_instruction_set(target);
  Pairs pairs;
  pairs.pointers.resize(operands);
  std::vector<Decision> decisions(pair_count);
  std::vector<double> f(pair_count), g(pair_count);
  std::vector<std::uint8_t> exceptional(pair_count);
  for (auto unused : state) {
    run(emulator, task, pairs, decisions, f, g, exceptional);
    benchmark::ClobberMemory();
  }
  count_comparisons(state);
  choose_instruction_set(0);
}

/// A certified lane.
void by_emulator(benchmark::State& state, std::int64_t target, LaneInputs inputs, Task task) {
  const auto lane_format = FloatFormat::make(static_cast<int>(state.range(0)), 8).value();
  const Arithmetic reduced = {lane_format, Rounding::nearest_even, Subnormals::flush};
  TypedGraph graph = lane_graph(test::sphere_graph(), test::format("s53e8"), reduced, inputs);
  const error::Lane lane = error::certified_lane(graph, {}).value();
  time(state, Emulator(lane), task, target);
}

void by_fixed_lane(benchmark::State& state, std::int64_t target) {
  const std::vector<std::optional<Range>> ranges(operand_count, Range{0, 100});
  const Emulator emulator(
      fixed::fixed_lane(
          test::sphere_graph(), test::format("s53e8"),
          {.format = {static_cast<int>(state.range(0))}, .bound = {}, .ranges = ranges})
          .value());
  time(state, emulator, Task::decide, target);
}

/// Function values: f(x) against another operand.
void by_function(benchmark::State& state, std::int64_t target, Function function) {
  Graph graph;
  const NodeId value = graph.apply(function, graph.input("x"));
  graph.compare({{value, graph.input("y")}}, Combination::all);
  const std::vector<std::optional<Range>> ranges = {Range{1, 100}, Range{0, 100}};
  const Emulator emulator(
      fixed::fixed_lane(
          graph, test::format("s53e8"),
          {.format = {static_cast<int>(state.range(0))}, .bound = {}, .ranges = ranges})
          .value());
  time(state, emulator, Task::decide, target, 2);
}

void by_reference(benchmark::State& state, std::int64_t target) {
  const Emulator emulator(reference_graph(
      test::sphere_graph(), {test::format("s53e8"), Rounding::nearest_even, Subnormals::flush}));
  time(state, emulator, Task::decide, target);
}

/// How many pairs collide, as the compiler vectorises it.
MIXCMP_VECTOR_CLONES std::int64_t collisions(const double* const* x) {
  std::int64_t count = 0;
  for (std::size_t k = 0; k < pair_count; ++k) {
    const double dx = x[0][k] - x[1][k], dy = x[2][k] - x[3][k], dz = x[4][k] - x[5][k];
    const double radii = x[6][k] + x[7][k];
    count += dx * dx + dy * dy + dz * dz < radii * radii ? 1 : 0;
  }
  return count;
}

void by_native_double(benchmark::State& state) {
  const Pairs pairs;
  for (auto unused : state) benchmark::DoNotOptimize(collisions(pairs.pointers.data()));
  count_comparisons(state);
}

void register_emulator(std::int64_t target) {
  const std::string set = hwy::TargetName(target);
  for (const LaneInputs inputs : {LaneInputs::exact, LaneInputs::rounded}) {
    const std::string kind = inputs == LaneInputs::exact ? "exact" : "rounded";
    for (const auto& [task, name] : {std::pair{Task::decide, "decide"},
                                     {Task::compare, "compare"},
                                     {Task::compute, "compute"}}) {
      benchmark::RegisterBenchmark(("emulator/" + set + "/" + kind + "/" + name).c_str(),
                                   by_emulator, target, inputs, task)
          ->Arg(8)
          ->Arg(17)
          ->Arg(25)
          ->Arg(40)
          ->Arg(52);
    }
  }
  benchmark::RegisterBenchmark(("emulator/" + set + "/fixed").c_str(), by_fixed_lane, target)
      ->Arg(8)
      ->Arg(13)
      ->Arg(17)
      ->Arg(24);
  for (const Function function : {Function::sin, Function::log}) {
    const std::string name = "emulator/" + set + "/" + std::string(to_string(function));
    benchmark::RegisterBenchmark(name.c_str(), by_function, target, function)
        ->Arg(8)
        ->Arg(13)
        ->Arg(17)
        ->Arg(24);
  }
  benchmark::RegisterBenchmark(("emulator/" + set + "/reference").c_str(), by_reference, target);
}

const bool registered = [] {
  const auto precisions = [](benchmark::internal::Benchmark* bench) {
    for (const int precision : {8, 17, 25, 40, 52}) bench->Arg(precision);
  };
  benchmark::RegisterBenchmark("mpfr/exact", by_mpfr, LaneInputs::exact)->Apply(precisions);
  benchmark::RegisterBenchmark("mpfr/rounded", by_mpfr, LaneInputs::rounded)->Apply(precisions);
  const std::int64_t supported = hwy::SupportedTargets();
  for (const std::int64_t target : {std::int64_t{HWY_AVX3}, std::int64_t{HWY_AVX2}}) {
    if ((supported & target) != 0) register_emulator(target);
  }
  register_emulator(HWY_STATIC_TARGET);
  benchmark::RegisterBenchmark("native_double", by_native_double);
  return true;
}();

}  // namespace
}  // namespace mixcmp
