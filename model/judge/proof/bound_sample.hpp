#pragma once

#include <cstdint>
#include <vector>

#include "model/comparison/expression/typed_graph.hpp"
#include "model/lane/error/bound_graph_builder.hpp"

namespace mixcmp::proof {

/// Random positive numbers that stand for the node values which bound graphs read. Their sizes
/// differ widely, so that every term of a bound is the largest in some sample. Two bounds that are
/// equal in `sample_count` samples are equal expressions with overwhelming probability.
class BoundSample {
public:
  static constexpr int sample_count = 24;

  BoundSample(const TypedGraph& graph, std::uint64_t seed);

  /// The magnitude |x| of a node. It is random unless the node is a finite constant.
  const mpq_class& magnitude(NodeId id) const { return magnitudes_[id]; }
  const mpq_class& binade(NodeId id) const { return binades_[id]; }
  const mpq_class& reciprocal(NodeId id) const { return reciprocals_[id]; }
  /// The value of a bound at this sample; 0 for no_bound_node.
  mpq_class value(const std::vector<error::BoundNode>& bounds, error::BoundId id) const;

private:
  std::vector<mpq_class> magnitudes_;
  std::vector<mpq_class> binades_;
  std::vector<mpq_class> reciprocals_;
};

}  // namespace mixcmp::proof
