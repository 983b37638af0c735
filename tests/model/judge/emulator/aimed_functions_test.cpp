#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "model/base/number/double.hpp"
#include "model/judge/emulator/emulator.hpp"
#include "model/judge/golden/evaluate.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/graphs.hpp"

/// Tests lanes with functions on millions of comparisons whose f - g lies within the thresholds, or
/// just beyond. Every decided verdict must be the order of f and g in double, or by MPFR where
/// double does not tell.
namespace mixcmp::test::aimed_functions_test {
namespace {

using emulator::Emulator;
using Random = std::mt19937_64;
using Operands = std::vector<float>;

constexpr std::size_t block = 4096;

/// Differences beyond this are far above the rounding errors of double.
constexpr double told_by_double = 1e-9;

double between(Random& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
}

/// A comparison, and how to draw operands for which f - g is about `aimed`.
struct Formula {
  std::string name, f, g;
  std::vector<std::pair<std::string, Range>> inputs;           ///< in the order of Operands
  std::function<bool(Random&, double aimed, Operands&)> draw;  ///< false: draw again
  std::function<double(const Operands&)> difference;           ///< f - g
};

double distance(const Operands& at, std::size_t a, std::size_t b) {
  const double x = static_cast<double>(at[a]) - at[b];
  const double y = static_cast<double>(at[a + 1]) - at[b + 1];
  return std::sqrt(x * x + y * y);
}

/// Points a to d at 0, 2, 4 and 6; the temperature at 8, u at 9.
double longer_by(const Operands& at) {
  return distance(at, 0, 4) + distance(at, 2, 6) - distance(at, 0, 2) - distance(at, 4, 6);
}

/// examples/functions/metropolis.toml.
Formula metropolis() {
  const std::string root = "sqrt(({0}x - {1}x)^2 + ({0}y - {1}y)^2)";
  const auto edge = [&](const char* a, const char* b) {
    return fmt::format(fmt::runtime(root), a, b);
  };
  std::vector<std::pair<std::string, Range>> inputs;
  for (const char* const point : {"a", "b", "c", "d"}) {
    inputs.emplace_back(std::string(point) + "x", Range{1, 8});
    inputs.emplace_back(std::string(point) + "y", Range{32, 128});
  }
  inputs.emplace_back("temperature", Range{0, 16});
  inputs.emplace_back("u", Range{mpq_class(1, 8192), 1});
  const auto difference = [](const Operands& at) {
    return longer_by(at) + static_cast<double>(at[8]) * std::log(static_cast<double>(at[9]));
  };
  const auto draw = [](Random& random, double aimed, Operands& at) {
    for (std::size_t k = 0; k < 8; k += 2) {
      at[k] = static_cast<float>(between(random, 1, 8));
      at[k + 1] = static_cast<float>(between(random, 32, 128));
    }
    if (longer_by(at) < aimed) {  // the opposite move
      std::swap(at[2], at[4]);
      std::swap(at[3], at[5]);
    }
    const double less = longer_by(at) - aimed;
    if (less < 0 || less > 144) return false;
    at[8] = static_cast<float>(between(random, std::max(0.25, less / 9), 16));
    at[9] = static_cast<float>(std::exp(-less / at[8]));
    return at[9] >= 0x1p-13F;
  };
  return {"Metropolis",
          fmt::format("({} + {}) - ({} + {})", edge("a", "c"), edge("b", "d"), edge("a", "b"),
                      edge("c", "d")),
          "-temperature * log(u)",
          std::move(inputs),
          draw,
          difference};
}

/// u < exp(-d b).
Formula acceptance() {
  const auto difference = [](const Operands& at) {
    return static_cast<double>(at[0]) - std::exp(-static_cast<double>(at[1]) * at[2]);
  };
  const auto draw = [](Random& random, double aimed, Operands& at) {
    at[1] = static_cast<float>(between(random, 0, 8));
    at[2] = static_cast<float>(between(random, 0, 2));
    at[0] = static_cast<float>(std::exp(-static_cast<double>(at[1]) * at[2]) + aimed);
    return at[0] >= 0 && at[0] <= 1;
  };
  return {"Acceptance", "u",       "exp(-d * b)", {{"u", {0, 1}}, {"d", {0, 8}}, {"b", {0, 2}}},
          draw,         difference};
}

/// Blocks of comparisons in the order of a graph's inputs.
class Blocks {
public:
  Blocks(Formula formula, const Graph& graph, unsigned seed)
      : formula_(std::move(formula)),
        graph_(graph),
        random_(seed),
        columns_(graph.inputs().size(), std::vector<double>(block)) {
    for (const std::string& input : graph.inputs()) {
      const auto at = std::find_if(formula_.inputs.begin(), formula_.inputs.end(),
                                   [&](const auto& each) { return each.first == input; });
      places_.push_back(static_cast<std::size_t>(at - formula_.inputs.begin()));
      ranges_.emplace_back(at->second);
    }
    for (const auto& column : columns_) pointers_.push_back(column.data());
  }

  const std::vector<std::optional<Range>>& ranges() const { return ranges_; }
  void reach(double reach) { reach_ = reach; }

  void next() {
    Operands at(formula_.inputs.size());
    for (std::size_t k = 0; k < block; ++k) {
      while (!formula_.draw(random_, between(random_, -reach_, reach_), at)) continue;
      for (std::size_t input = 0; input < places_.size(); ++input) {
        columns_[input][k] = at[places_[input]];
      }
      const double difference = formula_.difference(at);
      truth_[k] = difference < 0 ? Decision::less : Decision::greater;
      if (std::abs(difference) < told_by_double) truth_[k] = by_intervals(k);
    }
  }

  emulator::OperandColumns operands() const { return pointers_; }
  Decision truth(std::size_t k) const { return truth_[k]; }

private:
  Decision by_intervals(std::size_t k) const {
    std::vector<Bits> bits;
    for (const auto& column : columns_) bits.push_back(from_double(format_of(24, 8), column[k]));
    return decision_of(golden::true_verdict(graph_, format_of(24, 8), bits));
  }

  Formula formula_;
  const Graph& graph_;
  double reach_ = 1;  ///< of f - g
  Random random_;
  std::vector<std::size_t> places_;  ///< [input]: in Operands
  std::vector<std::optional<Range>> ranges_;
  std::vector<std::vector<double>> columns_;
  std::vector<const double*> pointers_;
  std::array<Decision, block> truth_ = {};
};

struct Counts {
  std::uint64_t all = 0, undecided = 0, wrong = 0, fallbacks = 0;
};

Counts count_of(const fixed::FixedLane& made, Blocks& blocks, std::uint64_t comparisons) {
  const Emulator lane(made);
  std::vector<Decision> decisions(block);
  Counts counts;
  for (; counts.all < comparisons; counts.all += block) {
    blocks.next();
    lane.decide(blocks.operands(), block, decisions);
    for (std::size_t k = 0; k < block; ++k) {
      const bool is_open = decisions[k] == Decision::undecided;
      counts.undecided += is_open ? 1 : 0;
      counts.wrong += !is_open && decisions[k] != blocks.truth(k) ? 1 : 0;
    }
  }
  counts.fallbacks = lane.fallbacks();
  return counts;
}

class AimedAtFunctions : public testing::TestWithParam<std::tuple<Formula (*)(), int>> {
protected:
  AimedAtFunctions()
      : formula_(std::get<0>(GetParam())()),
        graph_(graph_of(formula_.f, formula_.g)),
        blocks_(formula_, graph_, static_cast<unsigned>(std::get<1>(GetParam()))),
        lane_(fixed::fixed_lane(graph_, format_of(24, 8),
                                {.format = {std::get<1>(GetParam())},
                                 .bound = BoundKind::constant,
                                 .ranges = blocks_.ranges()})
                  .value()) {
    const mpz_class most = std::max<mpz_class>(thresholds().greater_from, -thresholds().less_to);
    const double unit = lane_.nodes[lane_.parts[0].difference].format.unit().get_d();
    blocks_.reach(1.25 * most.get_d() * unit);
  }

  fixed::ConstantThresholds& thresholds() {
    return std::get<fixed::ConstantThresholds>(lane_.parts[0].criterion);
  }

  Formula formula_;
  Graph graph_;
  Blocks blocks_;
  fixed::FixedLane lane_;
};

TEST_P(AimedAtFunctions, NoVerdictIsWrong) {
  const Counts counts = count_of(lane_, blocks_, MIXCMP_AIMED_COMPARISONS);
  EXPECT_EQ(counts.wrong, 0U);
  EXPECT_EQ(counts.fallbacks, 0U);
  EXPECT_GT(counts.undecided, counts.all / 20);
  EXPECT_LT(counts.undecided, counts.all - counts.all / 100);
}

/// The aim is good: with thresholds an eighth as large, verdicts are wrong.
TEST_P(AimedAtFunctions, SomeAreWrongIfThresholdsAreTooClose) {
  thresholds().greater_from = thresholds().greater_from / 8 + 1;
  thresholds().less_to = thresholds().less_to / 8 - 1;
  EXPECT_GT(count_of(lane_, blocks_, 200000).wrong, 0U);
}

INSTANTIATE_TEST_SUITE_P(Formulas, AimedAtFunctions,
                         testing::Combine(testing::Values(metropolis, acceptance),
                                          testing::Values(13, 17)),
                         [](const auto& tested) {
                           return fmt::format("{}_{}", std::get<0>(tested.param)().name,
                                              std::get<1>(tested.param));
                         });

}  // namespace
}  // namespace mixcmp::test::aimed_functions_test
