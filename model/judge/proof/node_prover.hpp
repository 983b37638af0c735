#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "model/judge/proof/cone.hpp"
#include "model/judge/proof/lane_proof.hpp"

namespace mixcmp::proof {

/// "s17e8, nearest_even".
std::string describe_arithmetic(const Arithmetic& arithmetic);

/// The outcome that is worse for a claim; from the best to the worst: proven, not_expressible,
/// unchecked, out_of_time, not_proven.
Outcome worse(Outcome a, Outcome b);

/// Proves claims one by one and gathers findings, at most one for a node's claim.
class NodeProver {
public:
  NodeProver(const error::Lane& lane, const std::vector<NodeClaim>& claims, const Prove& prove)
      : lane_(lane), graph_(lane.graph), claims_(claims), prove_(prove) {}

  /// Proves theorem 1 for every precision that the graph rounds to, and that the operations whose
  /// operands have few enough digits round nothing.
  void prove_arithmetic();
  /// Proves the node's claim from those of its operands; checks inputs and constants by exact
  /// arithmetic.
  void prove_node(NodeId id);
  /// Proves all scripts and returns one finding, with the worst outcome.
  Finding run_scripts(std::string what, const std::vector<ConeCase>& cases) const;

  /// Whether the node's claim needs no proof any more.
  bool is_done(NodeId id) const { return done_.contains(id); }
  void mark_done(NodeId id) { done_.insert(id); }
  void add(Finding finding) { findings_.push_back(std::move(finding)); }
  std::vector<Finding> take() && { return std::move(findings_); }
  /// The node's expression as a user would write it.
  std::string text(NodeId id) const;

private:
  void prove_rounding();
  void prove_exactness();
  void check_constant(NodeId id);
  void check_exact_input(NodeId id);
  void prove_choice(NodeId id);

  const error::Lane& lane_;
  const TypedGraph& graph_;
  const std::vector<NodeClaim>& claims_;
  const Prove& prove_;
  std::set<NodeId> done_;
  std::vector<Finding> findings_;
};

}  // namespace mixcmp::proof
