#include "model/judge/emulator/emulator.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstring>
#include <optional>

#include "model/base/common/check.hpp"
#include "model/base/number/double.hpp"
#include "model/judge/emulator/code.hpp"
#include "model/judge/emulator/combine_parts.hpp"
#include "model/judge/emulator/execution.hpp"
#include "model/judge/emulator/fixed_code.hpp"
#include "model/judge/emulator/wide_lane.hpp"
#include "model/judge/golden/evaluate.hpp"
#include "model/judge/golden/fixed_evaluate.hpp"

namespace mixcmp::emulator {

/// Parts of the comparison that are computed together.
class Emulator::Program {
public:
  Program(FloatFormat input_format, std::size_t inputs)
      : input_format_(input_format), inputs_(inputs) {}
  virtual ~Program() = default;

  virtual void decide(OperandColumns operands, std::span<Decision> decisions) const = 0;
  virtual void compare(OperandColumns operands, std::span<Decision> decisions) const = 0;
  virtual void compute(OperandColumns operands, std::span<double> f, std::span<double> g,
                       std::span<std::uint8_t> exceptional) const = 0;
  virtual bool is_emulated() const = 0;

  std::size_t inputs() const { return inputs_; }
  std::uint64_t fallbacks() const { return fallbacks_.load(std::memory_order_relaxed); }

protected:
  /// The operands of a comparison that falls back to the golden model.
  std::vector<Bits> encoded(OperandColumns operands, std::size_t index) const {
    fallbacks_.fetch_add(1, std::memory_order_relaxed);
    std::vector<Bits> inputs;
    inputs.reserve(operands.size());
    for (const double* column : operands) {
      inputs.push_back(from_double(input_format_, column[index]));
    }
    return inputs;
  }

private:
  FloatFormat input_format_;
  std::size_t inputs_;
  mutable std::atomic<std::uint64_t> fallbacks_ = 0;
};

namespace {

Decision lane_decision(const golden::LaneResult& result) {
  return result.decided ? decision_of(result.verdict) : Decision::undecided;
}

/// Runs the code and decides; `doubtful` decides the comparisons for which double cannot be
/// trusted.
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

/// The decisions on one block. Its last vectors may be padded.
void decide_block(const FixedCode& code, Combination combination, const Block& block,
                  std::span<Decision> decisions) {
  static_assert(sizeof(Decision) == sizeof(std::uint8_t));
  execute(code.instructions, block);
  std::array<Decision, max_block_size> of_part;
  for (std::size_t part = 0; part < code.criteria.size(); ++part) {
    const bool in_place = part == 0 && decisions.size() == block.size;
    Decision* const target = in_place ? decisions.data() : of_part.data();
    decide(code.criteria[part], block, reinterpret_cast<std::uint8_t*>(target));
    if (in_place) continue;
    if (part == 0) {
      std::copy_n(of_part.begin(), decisions.size(), decisions.begin());
    } else {
      combine_parts(combination, decisions, std::span(of_part).first(decisions.size()));
    }
  }
}

}  // namespace

/// One part in floating point: its code, and its graph and lane for the golden model.
class Emulator::FloatProgram : public Emulator::Program {
public:
  explicit FloatProgram(TypedGraph graph, std::optional<error::Lane> lane = {})
      : Program(graph.input_format, static_cast<std::size_t>(graph.input_count)),
        graph_(std::move(graph)),
        lane_(std::move(lane)),
        code_(make_code(graph_, lane_ ? &*lane_ : nullptr)) {}

  bool is_emulated() const override { return code_.has_value(); }
  void decide(OperandColumns operands, std::span<Decision> decisions) const override;
  void compare(OperandColumns operands, std::span<Decision> decisions) const override;
  void compute(OperandColumns operands, std::span<double> f, std::span<double> g,
               std::span<std::uint8_t> exceptional) const override;

private:
  TypedGraph graph_;
  std::optional<error::Lane> lane_;
  std::optional<Code> code_;
};

void Emulator::FloatProgram::decide(OperandColumns operands, std::span<Decision> decisions) const {
  const auto golden = [&](std::size_t k) {
    const std::vector<Bits> inputs = encoded(operands, k);
    return lane_ ? lane_decision(golden::evaluate_lane(*lane_, inputs))
                 : decision_of(golden::evaluate_reference(graph_, inputs));
  };
  if (!code_) {
    for (std::size_t k = 0; k < decisions.size(); ++k) decisions[k] = golden(k);
    return;
  }
  run(*code_, code_->criterion, Execution::Scope::decision, operands, decisions,
      [&](std::size_t k) {
        return code_->doubtful_is_undecided ? Decision::undecided : golden(k);
      });
}

void Emulator::FloatProgram::compare(OperandColumns operands, std::span<Decision> decisions) const {
  const auto golden = [&](std::size_t k) {
    return decision_of(golden::evaluate_reference(graph_, encoded(operands, k)));
  };
  if (!code_) {
    for (std::size_t k = 0; k < decisions.size(); ++k) decisions[k] = golden(k);
    return;
  }
  const FloatCriterion order = {
      .kind = CriterionKind::order, .first = code_->f, .second = code_->g};
  run(*code_, order, Execution::Scope::values, operands, decisions, golden);
}

void Emulator::FloatProgram::compute(OperandColumns operands, std::span<double> f,
                                     std::span<double> g,
                                     std::span<std::uint8_t> exceptional) const {
  const auto golden = [&](std::size_t k) {
    const std::vector<golden::Rounded> values = golden::evaluate(graph_, encoded(operands, k));
    const auto value = [&](NodeId id) {
      return to_double(graph_.nodes[id].format, values[id].bits);
    };
    f[k] = value(graph_.f());
    g[k] = value(graph_.g());
    exceptional[k] = std::any_of(values.begin(), values.end(),
                                 [](const golden::Rounded& node) { return node.exceptional; });
  };
  if (!code_) {
    for (std::size_t k = 0; k < f.size(); ++k) golden(k);
    return;
  }
  Execution execution(*code_, operands, f.size(), Execution::Scope::values);
  while (execution.next()) {
    const std::size_t first = execution.first(), size = execution.size();
    std::copy_n(execution.block().columns[code_->f], size, f.data() + first);
    std::copy_n(execution.block().columns[code_->g], size, g.data() + first);
    std::fill_n(exceptional.data() + first, size, std::uint8_t{0});
    for (std::size_t k = 0; execution.any_doubt() && k < size; ++k) {
      if (execution.doubtful(k)) golden(first + k);
    }
  }
}

/// All parts of a lane in fixed point.
class Emulator::FixedProgram : public Emulator::Program {
public:
  explicit FixedProgram(fixed::FixedLane lane)
      : Program(lane.input_format, lane.input_names.size()),
        lane_(std::move(lane)),
        code_(make_fixed_code(lane_)) {
    if (!code_) wide_ = WideLane::make(lane_);
  }

  bool is_emulated() const override { return code_ || wide_; }

  void decide(OperandColumns operands, std::span<Decision> decisions) const override {
    decide_as_lane(operands, decisions);
    if (!lane_.is_reference) return;
    std::replace(decisions.begin(), decisions.end(), Decision::undecided, Decision::unordered);
  }

  void decide_as_lane(OperandColumns operands, std::span<Decision> decisions) const {
    if (wide_) return wide_->decide(operands, decisions);
    if (!code_) {
      for (std::size_t k = 0; k < decisions.size(); ++k) {
        decisions[k] = lane_decision(golden::evaluate_lane(lane_, encoded(operands, k)));
      }
      return;
    }
    ColumnBlocks blocks(code_->layout, operands, decisions.size());
    while (blocks.next()) {
      decide_block(*code_, lane_.combination, blocks.block(),
                   decisions.subspan(blocks.first(), blocks.size()));
    }
  }

  void compare(OperandColumns, std::span<Decision>) const override {
    MIXCMP_CHECK(!"a lane in fixed point has no order without its thresholds");
  }

  void compute(OperandColumns, std::span<double>, std::span<double>,
               std::span<std::uint8_t>) const override {
    MIXCMP_CHECK(!"a lane in fixed point computes neither f nor g");
  }

private:
  fixed::FixedLane lane_;
  std::optional<FixedCode> code_;
  std::optional<WideLane> wide_;  ///< if there is no code
};

Emulator::Emulator(const error::Lane& lane) : combination_(lane.graph.combination) {
  for (std::size_t part = 0; part < lane.parts.size(); ++part) {
    error::Lane alone = part_of(lane, part);
    parts_.push_back(std::make_unique<const FloatProgram>(alone.graph, alone));
  }
}
Emulator::Emulator(fixed::FixedLane lane) {
  parts_.push_back(std::make_unique<const FixedProgram>(std::move(lane)));
}
Emulator::Emulator(const TypedGraph& reference) : combination_(reference.combination) {
  for (std::size_t part = 0; part < reference.parts.size(); ++part) {
    parts_.push_back(std::make_unique<const FloatProgram>(part_of(reference, part).graph));
  }
}
Emulator::Emulator(const fixed::ReferenceDatapath& reference)
    : Emulator(std::visit([](const auto& made) { return Emulator(made); }, reference)) {}
Emulator::~Emulator() = default;
Emulator::Emulator(Emulator&&) noexcept = default;
Emulator& Emulator::operator=(Emulator&&) noexcept = default;

template <class Answer>
void Emulator::combine(OperandColumns operands, std::span<Decision> decisions,
                       Answer answer) const {
  MIXCMP_CHECK(operands.size() == parts_.front()->inputs());
  answer(*parts_.front(), decisions);
  if (parts_.size() == 1) return;
  std::vector<Decision> part(decisions.size());
  for (std::size_t index = 1; index < parts_.size(); ++index) {
    answer(*parts_[index], std::span(part));
    combine_parts(combination_, decisions, part);
  }
}

void Emulator::decide(OperandColumns operands, std::size_t count,
                      std::span<Decision> decisions) const {
  MIXCMP_CHECK(decisions.size() >= count);
  combine(operands, decisions.first(count), [&](const Program& part, std::span<Decision> of_part) {
    part.decide(operands, of_part);
  });
}

void Emulator::compare(OperandColumns operands, std::size_t count,
                       std::span<Decision> decisions) const {
  MIXCMP_CHECK(decisions.size() >= count);
  combine(operands, decisions.first(count), [&](const Program& part, std::span<Decision> of_part) {
    part.compare(operands, of_part);
  });
}

void Emulator::compute(OperandColumns operands, std::size_t count, std::span<double> f,
                       std::span<double> g, std::span<std::uint8_t> exceptional) const {
  MIXCMP_CHECK(f.size() >= count && g.size() >= count && exceptional.size() >= count);
  MIXCMP_CHECK(parts_.size() == 1 && operands.size() == parts_.front()->inputs());
  parts_.front()->compute(operands, f.first(count), g.first(count), exceptional.first(count));
}

bool Emulator::is_emulated() const {
  return std::all_of(parts_.begin(), parts_.end(),
                     [](const auto& part) { return part->is_emulated(); });
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
