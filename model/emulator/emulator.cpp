#include "model/emulator/emulator.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstring>
#include <optional>

#include "model/common/check.hpp"
#include "model/emulator/execution.hpp"
#include "model/emulator/operand.hpp"
#include "model/emulator/plan.hpp"
#include "model/golden/evaluate.hpp"

namespace mixcmp::model {

using emulator::Execution;
using emulator::Plan;

/// What to run, and the golden model of the same.
class Emulator::Program {
public:
  explicit Program(const Lane& lane)
      : graph_(lane.graph), lane_(lane), plan_(emulator::make_plan(graph_, &lane)) {}
  explicit Program(const TypedGraph& reference)
      : graph_(reference), plan_(emulator::make_plan(graph_, nullptr)) {}

  const std::optional<Plan>& plan() const { return plan_; }
  int input_count() const { return graph_.input_count; }

  Decision decide(OperandColumns operands, std::size_t index) const;
  Decision compare(OperandColumns operands, std::size_t index) const;
  struct Values {
    double f, g;
    bool exceptional;
  };
  Values compute(OperandColumns operands, std::size_t index) const;

  std::uint64_t fallbacks() const { return fallbacks_.load(std::memory_order_relaxed); }

private:
  std::vector<Bits> encoded(OperandColumns operands, std::size_t index) const;

  TypedGraph graph_;
  std::optional<Lane> lane_;
  std::optional<Plan> plan_;
  mutable std::atomic<std::uint64_t> fallbacks_ = 0;
};

std::vector<Bits> Emulator::Program::encoded(OperandColumns operands, std::size_t index) const {
  fallbacks_.fetch_add(1, std::memory_order_relaxed);
  std::vector<Bits> inputs;
  inputs.reserve(operands.size());
  for (const double* column : operands) {
    inputs.push_back(emulator::encode(graph_.input_format, column[index]));
  }
  return inputs;
}

Decision Emulator::Program::decide(OperandColumns operands, std::size_t index) const {
  const std::vector<Bits> inputs = encoded(operands, index);
  if (!lane_) return static_cast<Decision>(golden::evaluate_reference(graph_, inputs));
  const golden::LaneResult result = golden::evaluate_lane(*lane_, inputs);
  return result.decided ? static_cast<Decision>(result.verdict) : Decision::undecided;
}

Decision Emulator::Program::compare(OperandColumns operands, std::size_t index) const {
  return static_cast<Decision>(golden::evaluate_reference(graph_, encoded(operands, index)));
}

Emulator::Program::Values Emulator::Program::compute(OperandColumns operands,
                                                     std::size_t index) const {
  const std::vector<golden::Rounded> values = golden::evaluate(graph_, encoded(operands, index));
  const auto value = [&](NodeId id) {
    return emulator::decode(graph_.nodes[id].format, values[id].bits);
  };
  const auto exceptional = [](const golden::Rounded& node) { return node.exceptional; };
  return {value(graph_.f), value(graph_.g), std::any_of(values.begin(), values.end(), exceptional)};
}

namespace {

/// Decisions of a plan; `doubtful` answers where double cannot be trusted.
template <class Doubtful>
void run(const Plan& plan, const emulator::Judgement& judgement, Execution::Scope scope,
         OperandColumns operands, std::span<Decision> decisions, Doubtful doubtful) {
  static_assert(sizeof(Decision) == sizeof(std::uint8_t));
  std::array<std::uint8_t, emulator::max_block_size> last_codes;
  Execution execution(plan, operands, decisions.size(), scope);
  while (execution.next()) {
    Decision* const results = decisions.data() + execution.first();
    if (execution.size() == execution.block().size) {
      emulator::judge(judgement, execution.block(), reinterpret_cast<std::uint8_t*>(results));
    } else {
      emulator::judge(judgement, execution.block(), last_codes.data());
      std::memcpy(results, last_codes.data(), execution.size());
    }
    for (std::size_t k = 0; execution.any_doubt() && k < execution.size(); ++k) {
      if (execution.doubtful(k)) results[k] = doubtful(execution.first() + k);
    }
  }
}

}  // namespace

Emulator::Emulator(const Lane& lane) : program_(std::make_unique<const Program>(lane)) {}
Emulator::Emulator(const TypedGraph& reference)
    : program_(std::make_unique<const Program>(reference)) {}
Emulator::~Emulator() = default;
Emulator::Emulator(Emulator&&) noexcept = default;
Emulator& Emulator::operator=(Emulator&&) noexcept = default;

void Emulator::decide(OperandColumns operands, std::size_t count,
                      std::span<Decision> decisions) const {
  MIXCMP_CHECK(decisions.size() >= count);
  MIXCMP_CHECK(static_cast<int>(operands.size()) == program_->input_count());
  const auto& plan = program_->plan();
  const auto golden = [&](std::size_t k) { return program_->decide(operands, k); };
  if (!plan) {
    for (std::size_t k = 0; k < count; ++k) decisions[k] = golden(k);
    return;
  }
  run(*plan, plan->decision, Execution::Scope::decision, operands, decisions.first(count),
      [&](std::size_t k) { return plan->doubtful_is_undecided ? Decision::undecided : golden(k); });
}

void Emulator::compare(OperandColumns operands, std::size_t count,
                       std::span<Decision> decisions) const {
  MIXCMP_CHECK(decisions.size() >= count);
  MIXCMP_CHECK(static_cast<int>(operands.size()) == program_->input_count());
  const auto& plan = program_->plan();
  const auto golden = [&](std::size_t k) { return program_->compare(operands, k); };
  if (!plan) {
    for (std::size_t k = 0; k < count; ++k) decisions[k] = golden(k);
    return;
  }
  const emulator::Judgement order = {
      .rule = emulator::Rule::order, .first = plan->f, .second = plan->g};
  run(*plan, order, Execution::Scope::values, operands, decisions.first(count), golden);
}

void Emulator::compute(OperandColumns operands, std::size_t count, std::span<double> f,
                       std::span<double> g, std::span<std::uint8_t> exceptional) const {
  MIXCMP_CHECK(f.size() >= count && g.size() >= count && exceptional.size() >= count);
  MIXCMP_CHECK(static_cast<int>(operands.size()) == program_->input_count());
  const auto golden = [&](std::size_t k) {
    const Program::Values values = program_->compute(operands, k);
    f[k] = values.f;
    g[k] = values.g;
    exceptional[k] = values.exceptional ? 1 : 0;
  };
  const auto& plan = program_->plan();
  if (!plan) {
    for (std::size_t k = 0; k < count; ++k) golden(k);
    return;
  }
  Execution execution(*plan, operands, count, Execution::Scope::values);
  while (execution.next()) {
    const std::size_t first = execution.first(), size = execution.size();
    std::copy_n(execution.block().columns[plan->f], size, f.data() + first);
    std::copy_n(execution.block().columns[plan->g], size, g.data() + first);
    std::fill_n(exceptional.data() + first, size, std::uint8_t{0});
    for (std::size_t k = 0; execution.any_doubt() && k < size; ++k) {
      if (execution.doubtful(k)) golden(first + k);
    }
  }
}

std::uint64_t Emulator::fallbacks() const {
  return program_->fallbacks();
}

const char* Emulator::instruction_set() {
  return emulator::instruction_set();
}

}  // namespace mixcmp::model
