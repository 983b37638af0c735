#include "model/emulator/emulator.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstring>
#include <optional>

#include "model/common/check.hpp"
#include "model/emulator/code.hpp"
#include "model/emulator/combine_parts.hpp"
#include "model/emulator/execution.hpp"
#include "model/golden/evaluate.hpp"
#include "model/number/double.hpp"

namespace mixcmp::emulator {

/// One part of the comparison: its code, and its graph and lane for the golden model.
class Emulator::Program {
public:
  explicit Program(const error::Lane& lane)
      : graph_(lane.graph), lane_(lane), code_(make_code(graph_, &lane)) {}
  explicit Program(TypedGraph reference)
      : graph_(std::move(reference)), code_(make_code(graph_, nullptr)) {}

  const std::optional<Code>& code() const { return code_; }
  int input_count() const { return graph_.input_count; }

  void decide(OperandColumns operands, std::span<Decision> decisions) const;
  void compare(OperandColumns operands, std::span<Decision> decisions) const;
  struct Values {
    double f, g;
    bool exceptional;
  };
  Values compute(OperandColumns operands, std::size_t index) const;

  std::uint64_t fallbacks() const { return fallbacks_.load(std::memory_order_relaxed); }

private:
  std::vector<Bits> encoded(OperandColumns operands, std::size_t index) const;
  Decision golden_decision(OperandColumns operands, std::size_t index) const;
  Decision golden_order(OperandColumns operands, std::size_t index) const;

  TypedGraph graph_;
  std::optional<error::Lane> lane_;
  std::optional<Code> code_;
  mutable std::atomic<std::uint64_t> fallbacks_ = 0;
};

std::vector<Bits> Emulator::Program::encoded(OperandColumns operands, std::size_t index) const {
  fallbacks_.fetch_add(1, std::memory_order_relaxed);
  std::vector<Bits> inputs;
  inputs.reserve(operands.size());
  for (const double* column : operands) {
    inputs.push_back(from_double(graph_.input_format, column[index]));
  }
  return inputs;
}

Decision Emulator::Program::golden_decision(OperandColumns operands, std::size_t index) const {
  const std::vector<Bits> inputs = encoded(operands, index);
  if (!lane_) return decision_of(golden::evaluate_reference(graph_, inputs));
  const golden::LaneResult result = golden::evaluate_lane(*lane_, inputs);
  return result.decided ? decision_of(result.verdict) : Decision::undecided;
}

Decision Emulator::Program::golden_order(OperandColumns operands, std::size_t index) const {
  return decision_of(golden::evaluate_reference(graph_, encoded(operands, index)));
}

Emulator::Program::Values Emulator::Program::compute(OperandColumns operands,
                                                     std::size_t index) const {
  const std::vector<golden::Rounded> values = golden::evaluate(graph_, encoded(operands, index));
  const auto value = [&](NodeId id) { return to_double(graph_.nodes[id].format, values[id].bits); };
  const auto exceptional = [](const golden::Rounded& node) { return node.exceptional; };
  return {value(graph_.f()), value(graph_.g()),
          std::any_of(values.begin(), values.end(), exceptional)};
}

namespace {

/// Runs the code and decides; `doubtful` decides those for which double cannot be trusted.
template <class Doubtful>
void run(const Code& code, const FloatCriterion& criterion, Execution::Scope scope,
         OperandColumns operands, std::span<Decision> decisions, Doubtful doubtful) {
  static_assert(sizeof(Decision) == sizeof(std::uint8_t));
  std::array<std::uint8_t, max_block_size> last_codes;
  Execution execution(code, operands, decisions.size(), scope);
  while (execution.next()) {
    Decision* const results = decisions.data() + execution.first();
    if (execution.size() == execution.block().size) {
      decide(criterion, execution.block(), reinterpret_cast<std::uint8_t*>(results));
    } else {
      decide(criterion, execution.block(), last_codes.data());
      std::memcpy(results, last_codes.data(), execution.size());
    }
    for (std::size_t k = 0; execution.any_doubt() && k < execution.size(); ++k) {
      if (execution.doubtful(k)) results[k] = doubtful(execution.first() + k);
    }
  }
}

}  // namespace

void Emulator::Program::decide(OperandColumns operands, std::span<Decision> decisions) const {
  const auto golden = [&](std::size_t k) { return golden_decision(operands, k); };
  if (!code_) {
    for (std::size_t k = 0; k < decisions.size(); ++k) decisions[k] = golden(k);
    return;
  }
  run(*code_, code_->criterion, Execution::Scope::decision, operands, decisions,
      [&](std::size_t k) {
        return code_->doubtful_is_undecided ? Decision::undecided : golden(k);
      });
}

void Emulator::Program::compare(OperandColumns operands, std::span<Decision> decisions) const {
  const auto golden = [&](std::size_t k) { return golden_order(operands, k); };
  if (!code_) {
    for (std::size_t k = 0; k < decisions.size(); ++k) decisions[k] = golden(k);
    return;
  }
  const FloatCriterion order = {
      .kind = CriterionKind::order, .first = code_->f, .second = code_->g};
  run(*code_, order, Execution::Scope::values, operands, decisions, golden);
}

Emulator::Emulator(const error::Lane& lane) : combination_(lane.graph.combination) {
  for (std::size_t part = 0; part < lane.parts.size(); ++part) {
    parts_.push_back(std::make_unique<const Program>(part_of(lane, part)));
  }
}
Emulator::Emulator(const TypedGraph& reference) : combination_(reference.combination) {
  for (std::size_t part = 0; part < reference.parts.size(); ++part) {
    parts_.push_back(std::make_unique<const Program>(part_of(reference, part).graph));
  }
}
Emulator::~Emulator() = default;
Emulator::Emulator(Emulator&&) noexcept = default;
Emulator& Emulator::operator=(Emulator&&) noexcept = default;

template <class Answer>
void Emulator::combine(std::size_t count, std::span<Decision> decisions, Answer answer) const {
  MIXCMP_CHECK(decisions.size() >= count);
  answer(*parts_.front(), decisions.first(count));
  if (parts_.size() == 1) return;
  std::vector<Decision> part(count);
  for (std::size_t index = 1; index < parts_.size(); ++index) {
    answer(*parts_[index], std::span(part));
    combine_parts(combination_, decisions.first(count), part);
  }
}

void Emulator::decide(OperandColumns operands, std::size_t count,
                      std::span<Decision> decisions) const {
  MIXCMP_CHECK(static_cast<int>(operands.size()) == parts_.front()->input_count());
  combine(count, decisions, [&](const Program& part, std::span<Decision> of_part) {
    part.decide(operands, of_part);
  });
}

void Emulator::compare(OperandColumns operands, std::size_t count,
                       std::span<Decision> decisions) const {
  MIXCMP_CHECK(static_cast<int>(operands.size()) == parts_.front()->input_count());
  combine(count, decisions, [&](const Program& part, std::span<Decision> of_part) {
    part.compare(operands, of_part);
  });
}

void Emulator::compute(OperandColumns operands, std::size_t count, std::span<double> f,
                       std::span<double> g, std::span<std::uint8_t> exceptional) const {
  MIXCMP_CHECK(f.size() >= count && g.size() >= count && exceptional.size() >= count);
  MIXCMP_CHECK(parts_.size() == 1);
  const Program& program = *parts_.front();
  MIXCMP_CHECK(static_cast<int>(operands.size()) == program.input_count());
  const auto golden = [&](std::size_t k) {
    const Program::Values values = program.compute(operands, k);
    f[k] = values.f;
    g[k] = values.g;
    exceptional[k] = values.exceptional ? 1 : 0;
  };
  const auto& code = program.code();
  if (!code) {
    for (std::size_t k = 0; k < count; ++k) golden(k);
    return;
  }
  Execution execution(*code, operands, count, Execution::Scope::values);
  while (execution.next()) {
    const std::size_t first = execution.first(), size = execution.size();
    std::copy_n(execution.block().columns[code->f], size, f.data() + first);
    std::copy_n(execution.block().columns[code->g], size, g.data() + first);
    std::fill_n(exceptional.data() + first, size, std::uint8_t{0});
    for (std::size_t k = 0; execution.any_doubt() && k < size; ++k) {
      if (execution.doubtful(k)) golden(first + k);
    }
  }
}

std::uint64_t Emulator::fallbacks() const {
  std::uint64_t count = 0;
  for (const auto& part : parts_) count += part->fallbacks();
  return count;
}

const char* Emulator::instruction_set() {
  return emulator::instruction_set();
}

}  // namespace mixcmp::emulator
