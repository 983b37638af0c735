#include "model/judge/proof/choice_lemmas.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "model/base/common/check.hpp"
#include "model/judge/proof/cone.hpp"
#include "model/judge/proof/script.hpp"

namespace mixcmp::proof {
namespace {

/// Larger than the ratio of any two numbers of any format.
constexpr const char* huge = "1b40000";

/// how its magnitude compares with the other operand's
enum class ComputedIs { smaller, larger };

/// s is true / computed for the operand that is chosen, t is the same for the other one.
std::string choice_script(ComputedIs computed, const error::RelativeBound& s,
                          const error::RelativeBound& t, const error::RelativeBound& result) {
  const bool smaller = computed == ComputedIs::smaller;
  Script script;
  script.comment("Computed a, true b t: q = b / a, a s and b t the true operands.");
  script.assume_within("q", smaller ? "1" : "0", smaller ? huge : "1");
  script.assume_within("s", dyadic(s.low), dyadic(s.high));
  script.assume_within("t", dyadic(t.low), dyadic(t.high));
  script.assume(smaller ? "q * t - s <= 0" : "q * t - s >= 0");
  for (const char* factor : {"q * t", "s"}) {
    script.conclude(fmt::format("{} in [{}, {}]", factor, dyadic(result.low), dyadic(result.high)));
  }
  script.hint("q * t", "s + (q * t - s)");
  return script.text();
}

std::string absolute_script(const char* sign, const error::RelativeBound& operand,
                            const error::RelativeBound& result) {
  Script script;
  script.comment("The absolute of a number of known sign.");
  script.assume_within("|c|", "1b-40000", huge);
  script.assume_relative("t", "c", operand);
  script.conclude_relative(fmt::format("({}t)", sign), fmt::format("({}c)", sign), result);
  return script.text();
}

}  // namespace

std::vector<std::string> choice_scripts(const TypedGraph& graph,
                                        const std::vector<NodeClaim>& claims, NodeId id) {
  const TypedNode& node = graph.nodes[id];
  const auto bound = [&](NodeId of) { return provable(*claims[of].relative, depth_of(graph, of)); };
  const error::RelativeBound a = bound(node.operands[0]), result = bound(id);
  if (node.operation == Operation::absolute) {
    return {absolute_script("", a, result), absolute_script("-", a, result)};
  }
  const error::RelativeBound b = bound(node.operands[1]);
  std::vector<std::string> scripts;
  for (const ComputedIs computed : {ComputedIs::smaller, ComputedIs::larger}) {
    scripts.push_back(choice_script(computed, a, b, result));
    scripts.push_back(choice_script(computed, b, a, result));
  }
  std::sort(scripts.begin(), scripts.end());
  scripts.erase(std::unique(scripts.begin(), scripts.end()), scripts.end());
  return scripts;
}

bool signs_follow(const TypedGraph& graph, const std::vector<NodeClaim>& claims, NodeId id) {
  const TypedNode& node = graph.nodes[id];
  const NodeClaim& claim = claims[id];
  const NodeClaim& a = claims[node.operands[0]];
  if (node.operation == Operation::absolute) return !claim.nonpositive;
  const NodeClaim& b = claims[node.operands[1]];
  const bool minimum = node.operation == Operation::minimum;
  MIXCMP_CHECK(minimum || node.operation == Operation::maximum);
  const auto follows = [](bool claimed, bool first, bool second, bool both) {
    return !claimed || (both ? first && second : first || second);
  };
  return follows(claim.nonnegative, a.nonnegative, b.nonnegative, minimum) &&
         follows(claim.nonpositive, a.nonpositive, b.nonpositive, !minimum);
}

}  // namespace mixcmp::proof
