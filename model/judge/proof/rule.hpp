#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "model/judge/proof/bound_sample.hpp"
#include "model/lane/error/error_analysis.hpp"

namespace mixcmp::proof {

/// A variable of a script: any number in [low, high].
struct RuleVariable {
  std::string name;
  mpq_class low;   ///< dyadic
  mpq_class high;  ///< dyadic
};

/// A term weight * factor of an operation's absolute error. Weights are positive, and the bound is
/// their sum; factors are expressions in the variables.
struct RuleTerm {
  std::function<mpq_class(const BoundSample&)> weight;
  std::string factor;
};

/// An equation between real numbers, both sides in Gappa's syntax.
struct Identity {
  std::string left;
  std::string right;
};

/// One operation's absolute error as a sum of terms (docs/error_bounds.md, theorem 7).
struct Rule {
  std::vector<RuleVariable> variables;
  std::vector<RuleTerm> terms;
  std::optional<Identity> identity;  ///< why the error is this sum; if none, by hand
};

/// A condition that a rule needs: `bound` <= |value|. It is met if the analysis has a condition on
/// the same node whose bound is at least `bound` in every sample.
struct RuleCondition {
  NodeId value;
  std::function<mpq_class(const BoundSample&)> bound;
};

/// The rules of one node. There are several if the error is one of several sums. They are written
/// from theorem 7, independently of the analysis.
struct NodeRules {
  std::vector<Rule> rules;
  std::vector<RuleCondition> conditions;
  /// The factor before a sum's own rounding, if its operands may cancel.
  std::optional<mpq_class> center;
};
NodeRules rules_of(const TypedGraph& graph, const error::ErrorAnalysis& analysis, NodeId id);

/// A node's inflation as it is proven: a little larger than claimed, see `provable`.
mpq_class provable_inflation(const TypedGraph& graph, const error::ErrorAnalysis& analysis,
                             NodeId id);

/// A script that proves that no factor exceeds `inflation` in magnitude, so that the sum of
/// terms does not exceed `inflation` times the sum of weights. It also states the rule's
/// identity, which Gappa checks by normalising both sides.
std::string rule_script(const Rule& rule, const mpq_class& inflation);

}  // namespace mixcmp::proof
