#include <gtest/gtest.h>

#include <cmath>

#include "model/base/number/exact.hpp"
#include "model/comparison/data/operand_source.hpp"
#include "model/comparison/data/uniform_spheres.hpp"
#include "model/judge/golden/evaluate.hpp"
#include "model/plan/profile/node_magnitudes.hpp"
#include "tests/model/plan/profile/profile_cases.hpp"
#include "tests/support/sphere.hpp"

namespace mixcmp::test::parts_test {
namespace {

using data::Comparisons;
using data::OperandBlock;
using data::OperandSource;
using profile::NodeMagnitude;

const FloatFormat binary64 = format_of(53, 11);

void expect_operands(const Comparisons& data, const OperandBlock& block,
                     const std::vector<std::uint64_t>& indices) {
  ASSERT_EQ(block.size(), indices.size());
  std::vector<Bits> operands(data.input_count());
  for (std::size_t k = 0; k < indices.size(); ++k) {
    data.fetch(indices[k], operands);
    for (std::size_t input = 0; input < operands.size(); ++input) {
      EXPECT_EQ(mpq_class(block.column(input)[k]),
                to_rational(data.table().format, operands[input]))
          << "comparison " << indices[k] << ", input " << input;
    }
  }
}

TEST(OperandSource, FetchesWhatTheDataSays) {
  const Graph graph = sphere_graph();
  const data::Table spheres = data::uniform_spheres(
      {.count = 23, .side = 10, .radius_max = 3, .seed = 1}, format_of(24, 8));
  const Comparisons pairs = Comparisons::all_pairs(spheres, graph.inputs()).value();
  const Comparisons rows = Comparisons::rows(spheres, {"r", "cx"}).value();
  for (const Comparisons* data : {&pairs, &rows}) {
    const OperandSource source(*data);
    OperandBlock block(data->input_count(), 64);
    for (const auto& [first, count] :
         {std::pair<std::uint64_t, std::size_t>{0, 23}, {3, 20}, {5, 1}}) {
      source.fetch(first, count, block);
      std::vector<std::uint64_t> indices;
      for (std::size_t k = 0; k < count; ++k) indices.push_back(first + k);
      expect_operands(*data, block, indices);
    }
    source.fetch(std::vector<std::uint64_t>{22, 0, 7, 7}, block);
    expect_operands(*data, block, {22, 0, 7, 7});
  }
  OperandBlock block(pairs.input_count(), 256);
  const OperandSource source(pairs);
  source.fetch(0, pairs.size(), block);
  std::vector<std::uint64_t> all;
  for (std::uint64_t k = 0; k < pairs.size(); ++k) all.push_back(k);
  expect_operands(pairs, block, all);
}

bool is_multiple(const mpq_class& value, int grid) {
  mpq_class steps = value;
  grid < 0 ? mpq_mul_2exp(steps.get_mpq_t(), steps.get_mpq_t(), -grid)
           : mpq_div_2exp(steps.get_mpq_t(), steps.get_mpq_t(), grid);
  return steps.get_den() == 1;
}

/// Holds a value of the node against the known magnitudes. Returns whether the node's grid is
/// known.
bool expect_known(const NodeMagnitude& known, const mpq_class& value) {
  if (std::isfinite(known.largest)) {
    EXPECT_LE(value, mpq_class(known.largest));
  }
  if (known.grid != NodeMagnitude::unknown) {
    EXPECT_TRUE(is_multiple(value, known.grid));
  }
  if (known.least != NodeMagnitude::unknown && value != 0) {
    EXPECT_GE(value, mpq_class(std::ldexp(1.0, std::max(known.least, -1000))));
  }
  return known.grid != NodeMagnitude::unknown;
}

int expect_all_known(const TypedGraph& lane, int precision, const Comparisons& data) {
  const OperandSource source(data);
  std::vector<NodeMagnitude> inputs;
  for (std::size_t k = 0; k < data.input_count(); ++k) {
    inputs.push_back(profile::magnitude_of(source.values(k)));
  }
  const auto magnitudes = profile::node_magnitudes(lane, precision, inputs);
  std::vector<Bits> operands(data.input_count());
  int grids = 0;
  for (std::uint64_t k = 0; k < data.size(); ++k) {
    data.fetch(k, operands);
    const auto values = golden::evaluate(lane, operands);
    for (std::size_t id = 0; id < values.size(); ++id) {
      const FloatFormat format = lane.nodes[id].format;
      if (format.is_nan(values[id].bits) || format.is_infinite(values[id].bits)) continue;
      const mpq_class value = abs(to_rational(format, values[id].bits));
      grids += expect_known(magnitudes[id], value) ? 1 : 0;
    }
  }
  return grids;
}

/// Lanes with all the exponents in the world: nothing is flushed.
TEST(NodeMagnitudes, HoldForEverythingComputed) {
  std::mt19937_64 random(3);
  int grids = 0;
  for (const auto& [f, g] : expressions) {
    for (const Family family : {Family::uniform, Family::small_grid, Family::neighbours}) {
      const int precision = 4 + static_cast<int>(random() % 30);
      const auto arithmetics = every_arithmetic(format_of(precision, 15));
      const Arithmetic arithmetic = arithmetics[random() % arithmetics.size()];
      const scene::Scene scene = scene_of(graph_of(f, g), binary64, arithmetic);
      const Comparisons data = random_rows(scene, family, 40, random);
      for (const auto inputs : {LaneInputs::exact, LaneInputs::rounded}) {
        SCOPED_TRACE(f + " against " + g);
        const auto lane = lane_graph(scene.graph, binary64, arithmetic, inputs);
        grids += expect_all_known(lane, precision, data);
        if (testing::Test::HasFailure()) return;
      }
    }
  }
  EXPECT_GT(grids, 1000);
}

}  // namespace
}  // namespace mixcmp::test::parts_test
