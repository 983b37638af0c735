#include <fmt/core.h>

#include <set>

#include "model/base/number/exact.hpp"
#include "model/judge/proof/absolute_proof.hpp"
#include "model/judge/proof/cone.hpp"
#include "model/judge/proof/node_ranges.hpp"
#include "model/judge/proof/script.hpp"

namespace mixcmp::proof {
namespace {

/// Writes every node as computed (c) and in exact arithmetic (t), from inputs in their ranges.
class RangeWriter {
public:
  explicit RangeWriter(const error::Lane& lane)
      : graph_(lane.graph), ranges_(enforced_ranges(lane)) {}

  RangeScript run(NodeId f, NodeId g, const mpq_class& bound) &&;

private:
  void visit(NodeId id);
  void add_input(NodeId id);
  void add_constant(NodeId id);
  std::string rounded(const std::string& expression, int precision);
  std::string expression(const TypedNode& node, char kind) const;
  static std::string name(char kind, NodeId id) { return fmt::format("{}{}", kind, id); }

  const TypedGraph& graph_;
  std::vector<std::optional<Range>> ranges_;
  std::vector<bool> seen_;
  std::set<int> rounded_to_;
  Script script_;
  std::string obstacle_;
};

RangeScript RangeWriter::run(NodeId f, NodeId g, const mpq_class& bound) && {
  seen_.resize(graph_.nodes.size(), false);
  script_.comment(
      "c: as computed, every operation rounded; t: truly; from the ranges of the inputs.");
  visit(f);
  visit(g);
  if (!obstacle_.empty()) return {std::nullopt, obstacle_};
  const std::string most = dyadic(bound);
  script_.conclude(fmt::format("(t{0} - t{1}) - (c{0} - c{1}) in [-{2}, {2}]", f, g, most));
  return {script_.text(), ""};
}

void RangeWriter::visit(NodeId id) {
  if (seen_[id] || !obstacle_.empty()) return;
  seen_[id] = true;
  const TypedNode& node = graph_.nodes[id];
  for (int k = 0; k < arity(node.operation); ++k) visit(node.operands[k]);
  if (!obstacle_.empty()) return;
  if (node.operation == Operation::input) return add_input(id);
  if (node.operation == Operation::constant) return add_constant(id);
  if (is_choice(node.operation)) {
    obstacle_ = fmt::format("{} is no word of Gappa's", to_string(node.operation));
    return;
  }
  const bool rounds = own_rounding(graph_, node) == OwnRounding::rounds;
  const std::string computed = expression(node, 'c');
  script_.define(name('c', id), rounds ? rounded(computed, node.format.precision()) : computed);
  script_.define(name('t', id), expression(node, 't'));
}

/// The expression rounded to `precision` digits. The first use of a rounding operator also defines
/// it.
std::string RangeWriter::rounded(const std::string& expression, int precision) {
  const std::string rounding = fmt::format("rnd{}", precision);
  if (rounded_to_.insert(precision).second) {
    script_.define_operator(rounding, rounding_operator(precision, graph_.arithmetic.rounding));
  }
  return fmt::format("{}({})", rounding, expression);
}

/// An input is exact by definition, so both names stand for one number.
void RangeWriter::add_input(NodeId id) {
  const int input = graph_.nodes[id].input;
  const std::optional<Range>& range = ranges_[input];
  if (!range) {
    obstacle_ = fmt::format("{} has no range", graph_.input_names[input]);
    return;
  }
  script_.define(name('c', id), fmt::format("x{}", input));
  script_.define(name('t', id), fmt::format("x{}", input));
  script_.assume_within(fmt::format("x{}", input), dyadic(range->low), dyadic(range->high));
}

void RangeWriter::add_constant(NodeId id) {
  const TypedNode& node = graph_.nodes[id];
  script_.define(name('c', id), dyadic(to_rational(node.format, node.constant)));
  const mpq_class& v = node.value;
  script_.define(name('t', id), v.get_den() == 1 ? v.get_num().get_str()
                                                 : fmt::format("({} / {})", v.get_num().get_str(),
                                                               v.get_den().get_str()));
}

std::string RangeWriter::expression(const TypedNode& node, char kind) const {
  return result_text(node, name(kind, node.operands[0]), name(kind, node.operands[1]));
}

}  // namespace

RangeScript range_script(const error::Lane& lane, NodeId f, NodeId g, const mpq_class& bound) {
  return RangeWriter(lane).run(f, g, bound);
}

}  // namespace mixcmp::proof
