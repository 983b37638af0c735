#include "tests/support/hazard_judge.hpp"

#include <fmt/core.h>

#include "model/judge/golden/evaluate.hpp"
#include "model/lane/error/hazards.hpp"

namespace mixcmp::test {
namespace {

using error::Hazards;
using error::Lane;
using golden::Rounded;

bool is_special(FloatFormat format, Bits bits) {
  return format.is_nan(bits) || format.is_infinite(bits);
}

class Judge {
public:
  Judge(const Lane& lane, std::span<const Bits> inputs)
      : lane_(lane), values_(golden::evaluate(lane.graph, inputs)) {}

  std::string run() {
    for (std::size_t id = 0; id < values_.size(); ++id) {
      const bool follows = any_operand(id, [&](std::size_t k) { return doubtful_[k]; });
      const std::string broken = follows ? "" : broken_by(id);
      if (!broken.empty()) return fmt::format("node {}: {}", id, broken);
      doubtful_.push_back(follows || values_[id].exceptional);
    }
    return "";
  }

private:
  const TypedNode& node(std::size_t id) const { return lane_.graph.nodes[id]; }

  template <typename Predicate>
  bool any_operand(std::size_t id, Predicate predicate) const {
    for (int k = 0; k < arity(node(id).operation); ++k) {
      if (predicate(static_cast<std::size_t>(node(id).operands[k]))) return true;
    }
    return false;
  }

  std::string broken_by(std::size_t id) const {
    if (!error::has_unit(node(id).operation)) return "";
    const Hazards& hazards = lane_.hazards[id];
    const FloatFormat format = node(id).format;
    const Bits result = values_[id].bits;
    const bool subnormal_operand = any_operand(
        id, [&](std::size_t k) { return node(k).format.is_subnormal(values_[k].bits); });
    const bool special_operand =
        any_operand(id, [&](std::size_t k) { return is_special(node(k).format, values_[k].bits); });
    if (special_operand && !hazards.special_operand) return "a special operand";
    if (subnormal_operand && !hazards.underflow) return "a subnormal operand";
    if (format.is_subnormal(result) && !hazards.underflow) return "a subnormal result";
    if (!hazards.cancellation && cancels(id)) return "unlike signs";
    const bool is_root = node(id).operation == Operation::square_root;
    const bool none_left = !hazards.special_operand && !hazards.overflow && !hazards.underflow;
    if (values_[id].exceptional && none_left && !is_root) return "an exception";
    const bool too_large = is_special(format, result) && !special_operand && !is_root;
    return too_large && !hazards.overflow ? "an overflow" : "";
  }

  bool cancels(std::size_t id) const {
    const auto a = static_cast<std::size_t>(node(id).operands[0]);
    const auto b = static_cast<std::size_t>(node(id).operands[1]);
    const FloatFormat format = node(id).operand_format;
    if (format.is_zero(values_[a].bits) || format.is_zero(values_[b].bits)) return false;
    const bool subtracts = node(id).operation == Operation::subtract;
    return format.sign(values_[a].bits) != (format.sign(values_[b].bits) != subtracts);
  }

  const Lane& lane_;
  std::vector<Rounded> values_;
  std::vector<bool> doubtful_;
};

}  // namespace

std::string broken_promise(const Lane& lane, std::span<const Bits> inputs) {
  if (lane.hazards.empty()) return "";
  for (const error::RangeCheck& check : lane.checks) {
    const Bits operand = inputs[static_cast<std::size_t>(check.input)];
    if (!golden::passes(check, lane.graph.input_format, operand)) return "";
  }
  return Judge(lane, inputs).run();
}

}  // namespace mixcmp::test
