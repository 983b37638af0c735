#include "tests/model/judge/emulator/against_golden.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>
#include <hwy/highway.h>

#include <bit>
#include <cmath>
#include <cstdint>

#include "model/base/number/double.hpp"
#include "model/comparison/expression/text.hpp"
#include "model/judge/golden/evaluate.hpp"

namespace mixcmp::test {
namespace {

using emulator::Emulator;

/// The emulator's answers for one comparison.
struct Answer {
  Decision decision;
  Decision order;
  std::uint64_t f, g;  ///< bits of doubles; all NaNs are the same
  bool exceptional;
  friend bool operator==(const Answer&, const Answer&) = default;
};

std::uint64_t bits_of(double value) {
  return std::isnan(value) ? ~std::uint64_t{0} : std::bit_cast<std::uint64_t>(value);
}

std::string describe(const Answer& answer) {
  return fmt::format("decision {}, order {}, f {:a} ({:016x}), g {:a} ({:016x}), exceptional {}",
                     static_cast<int>(answer.decision), static_cast<int>(answer.order),
                     std::bit_cast<double>(answer.f), answer.f, std::bit_cast<double>(answer.g),
                     answer.g, answer.exceptional);
}

std::vector<Bits> row(const Operands& operands, std::size_t index) {
  std::vector<Bits> inputs;
  for (const std::vector<Bits>& column : operands) inputs.push_back(column[index]);
  return inputs;
}

Answer golden_values(const TypedGraph& graph, const std::vector<Bits>& inputs) {
  const auto values = golden::evaluate(graph, inputs);
  const auto value = [&](NodeId id) {
    return bits_of(to_double(graph.nodes[id].format, values[id].bits));
  };
  Answer answer{.f = value(graph.f()), .g = value(graph.g())};
  for (const auto& node : values) answer.exceptional |= node.exceptional;
  answer.order = decision_of(golden::compare(graph.arithmetic.format, graph.arithmetic.subnormals,
                                             values[graph.f()].bits, values[graph.g()].bits));
  return answer;
}

std::vector<Answer> emulate(const Emulator& emulator, const OperandBatch& batch) {
  const std::size_t count = batch.count();
  std::vector<Decision> decisions(count), orders(count);
  std::vector<double> f(count), g(count);
  std::vector<std::uint8_t> exceptional(count);
  emulator.decide(batch.columns(), count, decisions);
  emulator.compare(batch.columns(), count, orders);
  emulator.compute(batch.columns(), count, f, g, exceptional);
  std::vector<Answer> answers;
  for (std::size_t k = 0; k < count; ++k) {
    answers.push_back({decisions[k], orders[k], bits_of(f[k]), bits_of(g[k]), exceptional[k] != 0});
  }
  return answers;
}

std::string describe(const TypedGraph& graph, const std::vector<Bits>& inputs) {
  const auto text = [&](NodeId id) { return to_text(graph.nodes, graph.input_names, id, 200); };
  std::string description =
      fmt::format("{} against {}, inputs {}, in {} {} {}:", text(graph.f()), text(graph.g()),
                  graph.input_format.name(), graph.arithmetic.format.name(),
                  to_string(graph.arithmetic.rounding), to_string(graph.arithmetic.subnormals));
  for (const Bits bits : inputs) {
    description += fmt::format(" {} ({:a})", to_hex(bits, graph.input_format.width()),
                               to_double(graph.input_format, bits));
  }
  return description;
}

std::uint64_t judge(const Emulator& emulator, const TypedGraph& graph, const Operands& operands,
                    const std::vector<Answer>& expected, const std::string& decision) {
  const OperandBatch batch(graph.input_format, operands);
  std::uint64_t fallbacks = 0;
  for_each_instruction_set([&] {
    if (testing::Test::HasFailure()) return;
    const std::uint64_t before = emulator.fallbacks();
    const std::vector<Answer> got = emulate(emulator, batch);
    fallbacks = emulator.fallbacks() - before;
    for (std::size_t k = 0; k < expected.size(); ++k) {
      if (got[k] == expected[k]) continue;
      ADD_FAILURE() << Emulator::instruction_set() << ", comparison " << k << ": "
                    << describe(graph, row(operands, k)) << "\n"
                    << decision << "\nexpected " << describe(expected[k]) << "\ngot      "
                    << describe(got[k]);
      return;
    }
  });
  return fallbacks;
}

template <class Golden>
void expect_decisions(const Emulator& emulator, FloatFormat format, const Operands& operands,
                      Golden golden) {
  const OperandBatch batch(format, operands);
  for_each_instruction_set([&] {
    std::vector<Decision> got(batch.count());
    emulator.decide(batch.columns(), batch.count(), got);
    for (std::size_t k = 0; k < got.size(); ++k) {
      const Decision expected = golden(row(operands, k));
      if (got[k] == expected) continue;
      ADD_FAILURE() << Emulator::instruction_set() << ", comparison " << k << ": expected "
                    << static_cast<int>(expected) << ", got " << static_cast<int>(got[k]);
      return;
    }
  });
}

}  // namespace

OperandBatch::OperandBatch(FloatFormat format, const Operands& operands) {
  for (const std::vector<Bits>& column : operands) {
    std::vector<double>& values = columns_.emplace_back();
    for (const Bits bits : column) values.push_back(to_double(format, bits));
  }
  for (const std::vector<double>& column : columns_) pointers_.push_back(column.data());
}

void for_each_instruction_set(const std::function<void()>& test) {
  const std::int64_t usable = hwy::SupportedTargets() & HWY_TARGETS;
  const std::int64_t preferred = usable & -usable;  // newer Highways prefer AVX-512's extensions
  const auto choose = [](std::int64_t targets) {
    hwy::SetSupportedTargetsForTest(targets);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  };
  const std::int64_t targets = preferred | (usable & (HWY_AVX3 | HWY_AVX2)) | HWY_STATIC_TARGET;
  for (std::int64_t left = targets; left != 0; left &= left - 1) {
    choose(left & -left);
    test();
  }
  choose(0);
}

void expect_golden_decisions(const error::Lane& lane, const Operands& operands) {
  expect_decisions(Emulator(lane), lane.graph.input_format, operands,
                   [&](std::span<const Bits> row) {
                     const golden::LaneResult result = golden::evaluate_lane(lane, row);
                     return result.decided ? decision_of(result.verdict) : Decision::undecided;
                   });
}

void expect_golden_decisions(const TypedGraph& reference, const Operands& operands) {
  expect_decisions(Emulator(reference), reference.input_format, operands,
                   [&](std::span<const Bits> row) {
                     return decision_of(golden::evaluate_reference(reference, row));
                   });
}

std::uint64_t expect_golden(const error::Lane& lane, const Operands& operands) {
  std::vector<Answer> expected;
  for (std::size_t k = 0; k < operands.front().size(); ++k) {
    const std::vector<Bits> inputs = row(operands, k);
    const golden::LaneResult result = golden::evaluate_lane(lane, inputs);
    Answer answer = golden_values(lane.graph, inputs);
    answer.decision = result.decided ? decision_of(result.verdict) : Decision::undecided;
    expected.push_back(answer);
  }
  return judge(Emulator(lane), lane.graph, operands, expected, describe_criterion(lane));
}

std::uint64_t expect_golden(const TypedGraph& reference, const Operands& operands) {
  std::vector<Answer> expected;
  for (std::size_t k = 0; k < operands.front().size(); ++k) {
    Answer answer = golden_values(reference, row(operands, k));
    answer.decision = answer.order;
    expected.push_back(answer);
  }
  return judge(Emulator(reference), reference, operands, expected, "a reference");
}

}  // namespace mixcmp::test
