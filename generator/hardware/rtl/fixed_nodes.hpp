#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "generator/hardware/datapath/schedule.hpp"
#include "generator/hardware/rtl/datapath_builder.hpp"
#include "model/lane/fixed/fixed_lane.hpp"

namespace mixcmp::rtl {

/// An integer as a literal of `width` bits in two's complement.
Literal twos_complement(int width, const mpz_class& value);

/// Adds the operations of a lane in fixed point to a datapath.
class FixedNodes {
public:
  /// Reserves the names.
  FixedNodes(DatapathBuilder& datapath, const fixed::FixedLane& lane,
             const datapath::Schedule& schedule);

  /// Builds every operation, with the delays that balance its operands.
  void build();

  const Signal& value(NodeId node) const { return values_[node]; }
  /// The `most` bits of an integer above the `kept` low ones, and its sign, in `cycle`.
  Operand excess_bits(NodeId id, int kept, int most, int cycle);
  /// A node's value in `cycle`, in two's complement whatever its format.
  Operand signed_value(NodeId node, int cycle) { return operand(node, 0, cycle); }
  /// A flag that is set if an operand or a limited value that the node depends on does not fit.
  Signal out_of_range(NodeId node);
  /// A flag that is set if a number that the node is computed from is beyond its reach.
  Signal beyond_reach(NodeId node);

private:
  void build_largest_exponent();
  void build_input(NodeId id);
  void build_operand(NodeId id);
  void build_loaded(NodeId id);
  void build_arriving(NodeId id);
  void build_aligned_operand(NodeId id);
  Signal leading_bits(int input);
  void build_constant(NodeId id);
  void build_common_drop();
  void build_common_cut(NodeId id);
  void build_conversion(NodeId id);
  void consume_bits(const std::string& name, int high, int low);
  void build_check(NodeId id);
  Operand checked_operand(const fixed::FixedNode& checked, int cycle);
  std::vector<Parameter> check_parameters(NodeId id) const;
  Signal any_of(const char* name, const std::vector<Signal>& flags);
  void build_unit(NodeId id);
  void build_memory_square(NodeId id, const fixed::SquareTable& table);
  std::string multiple(NodeId id) const;
  Operand operand(NodeId node, int shift, int cycle);
  std::vector<Connection> operands(NodeId id, int cycle);
  Operand address(const fixed::FixedNode& look_up, int cycle);
  std::pair<int, int> addends(NodeId id) const;
  std::pair<int, int> factors(NodeId id) const;
  std::vector<Parameter> table_parameters(const fixed::FixedNode& look_up) const;
  std::vector<Parameter> parameters(NodeId id) const;
  void append_positive_factors(NodeId id, std::vector<Parameter>& parameters) const;
  void describe(NodeId id, const std::string& more = {});
  bool describe_encoding(NodeId id);
  std::string describe_words(NodeId id, const std::string& format) const;
  void declare(NodeId id);
  Operand declare_misfit(NodeId id, const std::string& name, const datapath::Step& step);

  DatapathBuilder& datapath_;
  const fixed::FixedLane& lane_;
  const datapath::Schedule& schedule_;
  std::vector<std::string> names_;
  std::vector<Signal> values_;
  /// [input, limit or reach]: set if its number does not fit. No entry if every number fits.
  std::map<NodeId, Signal> misfits_;
  Signal largest_exponent_;  ///< in block floating point
  Signal not_finite_;        ///< in block floating point: some operand is infinite or a NaN
  Signal common_drop_;       ///< bits that common cuts drop
  std::size_t checks_built_ = 0;
  std::map<std::vector<std::string>, Signal> gathered_;  ///< [names of flags]: any of them
};

}  // namespace mixcmp::rtl
