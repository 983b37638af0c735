#include "model/emulator/emulator.hpp"

#include <algorithm>
#include <atomic>
#include <optional>

#include "model/common/check.hpp"
#include "model/emulator/operand.hpp"
#include "model/golden/evaluate.hpp"

namespace mixcmp::model {

class Emulator::Program {
public:
  explicit Program(const Lane& lane) : graph_(lane.graph), lane_(lane) {}
  explicit Program(const TypedGraph& reference) : graph_(reference) {}

  std::vector<Bits> encode(OperandColumns operands, std::size_t index) const {
    fallbacks_.fetch_add(1, std::memory_order_relaxed);
    std::vector<Bits> inputs;
    for (const double* column : operands) {
      inputs.push_back(emulator::encode(graph_.input_format, column[index]));
    }
    return inputs;
  }

  Decision decide(OperandColumns operands, std::size_t index) const {
    const std::vector<Bits> inputs = encode(operands, index);
    if (!lane_) return static_cast<Decision>(golden::evaluate_reference(graph_, inputs));
    const golden::LaneResult result = golden::evaluate_lane(*lane_, inputs);
    return result.decided ? static_cast<Decision>(result.verdict) : Decision::undecided;
  }

  Decision compare(OperandColumns operands, std::size_t index) const {
    return static_cast<Decision>(golden::evaluate_reference(graph_, encode(operands, index)));
  }

  struct Values {
    double f, g;
    bool exceptional;
  };
  Values compute(OperandColumns operands, std::size_t index) const {
    const std::vector<golden::Rounded> values = golden::evaluate(graph_, encode(operands, index));
    const auto value = [&](NodeId id) {
      return emulator::decode(graph_.nodes[id].format, values[id].bits);
    };
    const bool exceptional = std::any_of(values.begin(), values.end(),
                                         [](const auto& node) { return node.exceptional; });
    return {value(graph_.f), value(graph_.g), exceptional};
  }

  std::uint64_t fallbacks() const { return fallbacks_.load(std::memory_order_relaxed); }

private:
  TypedGraph graph_;
  std::optional<Lane> lane_;
  mutable std::atomic<std::uint64_t> fallbacks_ = 0;
};

Emulator::Emulator(const Lane& lane) : program_(std::make_unique<const Program>(lane)) {}
Emulator::Emulator(const TypedGraph& reference)
    : program_(std::make_unique<const Program>(reference)) {}
Emulator::~Emulator() = default;
Emulator::Emulator(Emulator&&) noexcept = default;
Emulator& Emulator::operator=(Emulator&&) noexcept = default;

void Emulator::decide(OperandColumns operands, std::size_t count,
                      std::span<Decision> decisions) const {
  MIXCMP_CHECK(decisions.size() >= count);
  for (std::size_t k = 0; k < count; ++k) decisions[k] = program_->decide(operands, k);
}

void Emulator::compare(OperandColumns operands, std::size_t count,
                       std::span<Decision> decisions) const {
  MIXCMP_CHECK(decisions.size() >= count);
  for (std::size_t k = 0; k < count; ++k) decisions[k] = program_->compare(operands, k);
}

void Emulator::compute(OperandColumns operands, std::size_t count, std::span<double> f,
                       std::span<double> g, std::span<std::uint8_t> exceptional) const {
  MIXCMP_CHECK(f.size() >= count && g.size() >= count && exceptional.size() >= count);
  for (std::size_t k = 0; k < count; ++k) {
    const Program::Values values = program_->compute(operands, k);
    f[k] = values.f;
    g[k] = values.g;
    exceptional[k] = values.exceptional ? 1 : 0;
  }
}

std::uint64_t Emulator::fallbacks() const {
  return program_->fallbacks();
}

const char* Emulator::instruction_set() {
  return "none";
}

}  // namespace mixcmp::model
