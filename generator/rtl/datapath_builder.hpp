#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "generator/datapath/schedule.hpp"
#include "generator/rtl/module.hpp"
#include "generator/rtl/net_names.hpp"

namespace mixcmp::rtl {

/// A net together with the cycle in which it carries its value.
struct Signal {
  Operand value;  ///< null: constantly 0 (a flag that nothing can raise)
  std::string name;
  int width = 1;
  int cycle = 0;
  bool constant = false;  ///< the same in every cycle: never delayed
};

/// The later cycles in which each signal is needed.
using DelayPlan = std::map<std::string, std::set<int>>;

/// How a datapath uses the `exceptional` outputs of its units.
enum class ExceptionalFlags {
  gathered,  ///< a flag travels with each value
  unused,    ///< no flag is read
};

/// Collects the items of one datapath. Delays are shared: a value needed in several later cycles
/// goes through one chain of delay lines with a tap for each of these cycles. The chain is built
/// from its earliest tap on, so all cycles must be known before: a first pass over the datapath,
/// with an empty plan, collects them in the plan for the second.
class DatapathBuilder {
public:
  /// `hazards`: one per node, or empty where nothing is ruled out.
  DatapathBuilder(const std::vector<std::string>& inputs, const TypedGraph& graph,
                  std::vector<error::Hazards> hazards, const datapath::Schedule& schedule,
                  ExceptionalFlags exceptional, DelayPlan plan);

  /// The ports aclk and one per operand.
  std::vector<Port> data_ports() const;

  /// Builds every operation of the graph, with the delays that balance its operands.
  void build_nodes();

  const Signal& value(NodeId node) const { return values_[node]; }
  /// A flag that is set where the node or one before it was exceptional. It is constantly 0 where
  /// flags are not gathered.
  const Signal& flag(NodeId node) const { return flags_[node]; }

  const std::string& port(int input) const { return ports_[input]; }
  const std::string& name(NodeId node) const { return names_[node]; }
  /// One name per node.
  const std::vector<std::string>& names() const { return names_; }
  NamePool& pool() { return pool_; }

  /// `signal` delayed to `cycle`, which must not be earlier than signal.cycle.
  Operand at(const Signal& signal, int cycle);
  /// One flag that is set where any of `signals` is, in `cycle`.
  Operand any_at(const std::vector<Signal>& signals, int cycle);

  void add(ModuleItem item) { items_.push_back(std::move(item)); }
  std::vector<ModuleItem> take() { return std::move(items_); }
  DelayPlan plan() const { return plan_; }

private:
  void declare_unused_flags();
  void build_node(NodeId id);
  void build_sign_change(NodeId id);
  void build_unit(NodeId id);
  Operand flag_output(NodeId id);
  void gather_flags(NodeId id);
  Operand delayed(const Signal& signal, const Operand& source, int from, int to);
  std::string describe(NodeId id) const;
  bool gathers_flag(NodeId id) const;
  std::vector<Parameter> unit_parameters(NodeId id) const;

  std::vector<std::string> ports_;
  const TypedGraph& graph_;
  std::vector<error::Hazards> hazards_;
  const datapath::Schedule& schedule_;
  NamePool pool_;
  std::string unused_name_;  ///< of the wire that takes the flags which nothing reads
  std::vector<std::string> names_;
  ExceptionalFlags exceptional_;
  int unused_flags_ = 0;
  std::vector<Signal> values_;
  std::vector<Signal> flags_;
  DelayPlan plan_;
  std::map<std::string, std::map<int, Operand>> taps_;
  std::vector<ModuleItem> items_;
};

/// The port names that a datapath gives its inputs: an input with a reserved name, such as "aclk",
/// gets "_2" appended.
std::vector<std::string> input_ports(const std::vector<std::string>& inputs);

/// The value of a unit's CUTS parameter.
Literal cut_mask(const datapath::Step& step);

}  // namespace mixcmp::rtl
