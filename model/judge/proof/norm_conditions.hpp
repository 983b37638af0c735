#pragma once

#include <optional>
#include <vector>

#include "model/lane/fixed/fixed_lane.hpp"

namespace mixcmp::proof {

/// The conditions of theorems 4 and 8 of docs/fixed_point.md for the thresholds of a norm, by exact
/// arithmetic and without the functions that made these.
class NormConditions {
public:
  NormConditions(const std::vector<fixed::FixedNode>& nodes, const fixed::FixedNode& difference,
                 const fixed::NormThresholds& thresholds);

  /// Whether the difference is that of theorem 4, and the thresholds are as large as it asks.
  bool hold() const;

  NodeId other_side() const { return difference_.operands[1]; }      ///< s^2 or |y|^2
  const std::vector<NodeId>& elements() const { return elements_; }  ///< the elements of x

  /// An upper limit of G + H of theorem 8.
  mpq_class far_square() const;

private:
  std::optional<std::vector<NodeId>> exact_elements(NodeId sum) const;
  mpq_class squared_errors(const std::vector<NodeId>& elements) const;
  bool is_other_side(NodeId other) const;
  mpq_class largest_radius() const;
  bool suffice_for_radius(const mpq_class& squares) const;
  bool suffice_for_two(const mpq_class& p2, const mpq_class& q2) const;

  const std::vector<fixed::FixedNode>& nodes_;
  const fixed::FixedNode& difference_;
  const fixed::NormThresholds& thresholds_;
  bool has_form_;
  std::vector<NodeId> elements_;
  /// The slopes above and below are 2 a and 2 b.
  mpq_class a_, b_, offset_;
};

}  // namespace mixcmp::proof
