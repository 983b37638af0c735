#pragma once

#include <string>
#include <vector>

#include "generator/hardware/datapath/schedule.hpp"
#include "generator/hardware/rtl/datapath_builder.hpp"
#include "generator/hardware/rtl/selecting_units.hpp"
#include "model/lane/error/lane.hpp"

namespace mixcmp::rtl {

/// The parameters EXPONENT_BITS and PRECISION of a format.
std::vector<Parameter> format_parameters(FloatFormat format);

/// How a datapath uses the `exceptional` outputs of its units.
enum class ExceptionalFlags {
  gathered,  ///< a flag travels with each value
  unused,    ///< no flag is read
};

/// Adds the operations of a graph in floating point to a datapath.
class FloatNodes {
public:
  /// Reserves the names. `hazards`: one per node, or empty if nothing is ruled out.
  FloatNodes(DatapathBuilder& datapath, const TypedGraph& graph,
             std::vector<error::Hazards> hazards, const datapath::Schedule& schedule,
             ExceptionalFlags exceptional);

  /// Builds every operation, with the delays that balance its operands.
  void build();

  const Signal& value(NodeId node) const { return values_[node]; }
  /// A flag that is set if the node or one before it was exceptional. It is constantly 0 if flags
  /// are not gathered.
  const Signal& flag(NodeId node) const { return flags_[node]; }
  /// One name per node.
  const std::vector<std::string>& names() const { return names_; }

  /// The operands a and b of a unit that adds up the terms of a fused sum, as it reads them in
  /// `cycle`; the first term is in the lowest bits.
  std::vector<Operand> term_operands(const TypedNode& node, int cycle);
  /// The parameters that describe the terms.
  std::vector<Parameter> term_parameters(const TypedNode& node) const;

private:
  void declare_unused_flags();
  void build_node(NodeId id);
  void build_sign_change(NodeId id);
  void build_unit(NodeId id);
  void build_squared_sum(NodeId id);
  void declare_selecting_units();
  void build_selecting_units();
  Operand build_start(const std::string& unit, std::vector<Literal> phases);
  std::vector<Literal> start_phases(const SelectingUnits::Unit& unit, bool selects) const;
  void build_selecting_unit(const SelectingUnits::Unit& unit, std::size_t index);
  std::vector<Operand> unit_operands(NodeId id);
  Operand negated(NodeId id, const Operand& operand);
  Operand flag_output(NodeId id);
  void gather_flags(NodeId id);
  std::string description(NodeId id) const;
  bool is_inside_its_square(NodeId id) const;
  bool squares_a_sum(const FusedTerm& term) const;
  void name_sums_inside_squares();
  bool gathers_flag(NodeId id) const;
  error::Hazards hazards_of(NodeId id) const;
  std::vector<Parameter> unit_parameters(const TypedNode& node, const error::Hazards& hazards,
                                         const datapath::Unit& unit) const;

  DatapathBuilder& datapath_;
  const TypedGraph& graph_;
  std::vector<error::Hazards> hazards_;
  const datapath::Schedule& schedule_;
  ExceptionalFlags exceptional_;
  std::string unused_name_;  ///< the name of the wire that takes unread flags
  std::vector<std::string> names_;
  int unused_flags_ = 0;
  SelectingUnits selecting_;  ///< units of a folded datapath
  std::vector<Signal> values_;
  std::vector<Signal> flags_;
};

}  // namespace mixcmp::rtl
