#pragma once

#include <string>
#include <vector>

#include "generator/hardware/rtl/float_nodes.hpp"
#include "model/lane/error/lane.hpp"

namespace mixcmp::rtl {

/// Adds a part's absolute error bound to its datapath, once the nodes are built: one unit for each
/// operation of the bound graph. The datapath's shared delays balance the units' operands.
class BoundUnitBuilder {
public:
  BoundUnitBuilder(DatapathBuilder& datapath, const FloatNodes& nodes, const error::Lane& lane,
                   const error::AbsoluteBoundCriterion& criterion,
                   const datapath::PartSchedule& schedule, const std::string& suffix);

  void build();

  /// The bound that the difference must exceed.
  const Signal& bound() const { return bounds_.back(); }
  /// One flag per condition; it is set if the condition does not hold.
  const std::vector<Signal>& failures() const { return failures_; }

private:
  void build_node(int id);
  void build_condition(const error::BoundCondition& condition, const datapath::Step& step);
  std::vector<Connection> operands(const error::BoundNode& node, int cycle);
  std::vector<Parameter> parameters(const error::BoundNode& node) const;
  bool may_be_subnormal(NodeId value) const;
  FloatFormat format_of(NodeId value) const;
  void check_exponents(NodeId value) const;
  std::string description(int id) const;

  DatapathBuilder& datapath_;
  const FloatNodes& nodes_;
  const error::Lane& lane_;
  const error::AbsoluteBoundCriterion& criterion_;
  const datapath::PartSchedule& schedule_;
  std::vector<std::string> names_;
  std::vector<Signal> bounds_;
  std::vector<Signal> failures_;
};

}  // namespace mixcmp::rtl
