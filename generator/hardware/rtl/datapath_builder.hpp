#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "generator/hardware/datapath/schedule.hpp"
#include "generator/hardware/rtl/module.hpp"
#include "generator/hardware/rtl/net_names.hpp"

namespace mixcmp::rtl {

/// A net together with the cycle in which it carries its value.
struct Signal {
  Operand value;  ///< null: constantly 0 (a flag that nothing can raise)
  std::string name;
  int width = 1;
  int cycle = 0;
  bool constant = false;  ///< the same in every cycle: never delayed
  int lasts = 0;          ///< cycles after `cycle` in which the net still carries the value
};

/// The conversion of an operand from the format in which it arrives to the format in which the
/// datapath reads it, which holds all its numbers.
struct Widening {
  OperandFormat from;
  FloatFormat to;
  /// Has no unit if both formats have equally many exponent bits: then it only appends zeros.
  datapath::Step step = {};
};

/// An operand that a datapath takes.
struct InputPort {
  std::string name;
  int width;
  std::optional<Widening> widening = {};  ///< none: the datapath reads it as it arrives
};
/// Operands of a datapath with this schedule, which reads them in `to`. They arrive in the formats
/// `arriving`; if that is empty, all arrive in `to`. Further ports stay as they are.
void widen(std::vector<InputPort>& ports, const std::vector<OperandFormat>& arriving,
           FloatFormat to, const datapath::Schedule& schedule);

/// Operands of one width.
std::vector<InputPort> operands_of_width(const std::vector<std::string>& names, int width);

/// The later cycles in which each signal is needed.
using DelayPlan = std::map<std::string, std::set<int>>;

/// Collects the ports, the names and the items of one datapath, with the delays that balance it.
/// Delays are shared: a value needed in several later cycles goes through one chain of delay lines
/// with a tap for each of these cycles. The chain is built from its earliest tap on, so all cycles
/// must be known before: a first pass over the datapath, with an empty plan, collects them in the
/// plan for the second. In a folded datapath (initiation_interval above 1) values wait in registers
/// instead, each for one interval.
///
/// Operands are ready `entry_cycles` behind the ports. The cycles of signals count from then on.
class DatapathBuilder {
public:
  DatapathBuilder(std::vector<InputPort> inputs, int initiation_interval, DelayPlan plan,
                  int entry_cycles = 0);

  /// The ports: aclk, phase if the datapath is folded, and one per operand.
  std::vector<Port> data_ports() const;

  /// The net that carries an input in cycle 0, in the format in which the datapath reads it. The
  /// first call adds its conversion and its delay.
  const std::string& port(int input);
  /// The net that carries an input in cycle 0 as it arrived.
  const std::string& arrived(int input);
  const std::vector<std::string>& ports() const { return ports_; }
  NamePool& pool() { return pool_; }
  int initiation_interval() const { return initiation_interval_; }
  /// The phase of `cycle` in a folded datapath.
  Literal phase(int cycle) const;

  /// `signal` delayed to `cycle`, which must not be earlier than signal.cycle.
  Operand at(const Signal& signal, int cycle);
  /// One flag that is set in `cycle` if any of `signals` is.
  Operand any_at(const std::vector<Signal>& signals, int cycle);

  void add(ModuleItem item) { items_.push_back(std::move(item)); }
  /// Adds a comment: the cycles of a step, then `text`.
  void describe(const datapath::Step& step, std::string_view text);
  /// Adds a net that something else drives, and that carries its value in `cycle`.
  Signal declare(const std::string& name, int width, int cycle);
  /// Adds the unit of a step. Its clock and the mask of its cuts need not be given. The name of the
  /// instance may change so that it is unique.
  void add_unit(const datapath::Step& step, const std::string& instance,
                std::vector<Parameter> parameters, std::vector<Connection> connections);
  /// Tells that some bits of a signal may have no reader.
  void may_be_read_in_part(const Signal& signal) { read_in_part_[signal.name] = signal.width; }
  const std::map<std::string, int>& read_in_part() const { return read_in_part_; }
  std::vector<ModuleItem> take() { return std::move(items_); }
  const DelayPlan& plan() const { return plan_; }

private:
  std::string entered(const std::string& name, int width, int ready_cycle);
  std::string widened(int input);
  Operand read_by_unit(const std::string& port, const OperandFormat& from);
  Operand as_subnormal(const std::string& port, const FixedFormat& fixed, FloatFormat read);
  Operand delayed(const Signal& signal, const Operand& source, int from, int to);
  Operand held(const Signal& signal, int cycle);

  std::vector<InputPort> inputs_;
  std::vector<std::string> ports_;
  std::map<int, std::string> arrived_;
  std::map<int, std::string> widened_;
  int initiation_interval_;
  int entry_cycles_;
  NamePool pool_;
  DelayPlan plan_;
  std::map<std::string, std::map<int, Operand>> taps_;
  std::vector<ModuleItem> items_;
  std::map<std::string, int> read_in_part_;  ///< net -> its width
};

/// Makes a module that has the ports of a datapath, then `outputs`. `build` adds everything else;
/// it is called twice, the second time with all delays known.
Module datapath_module(std::string name, const std::vector<InputPort>& inputs,
                       const std::vector<Port>& outputs,
                       const std::function<void(DatapathBuilder&)>& build,
                       int initiation_interval = 1, int entry_cycles = 0);

/// Bits of the port "phase" of a folded datapath.
int phase_bits(int initiation_interval);

/// The ports of every lane: verdict[1:0] and decided.
std::vector<Port> lane_outputs();

/// The port names that a datapath gives its inputs: an input with a reserved name, such as "aclk",
/// gets "_2" appended.
std::vector<std::string> input_ports(const std::vector<std::string>& inputs);

/// Appends the parameters for the technology of a unit (multipliers, selections in front of carry
/// chains), each only if it is not the template's default.
void append_technology_parameters(const datapath::Unit& unit, std::vector<Parameter>& parameters);

/// An instance of a step's unit; see DatapathBuilder::add_unit.
Instance unit_instance(const datapath::Step& step, std::string name,
                       std::vector<Parameter> parameters, std::vector<Connection> connections);

}  // namespace mixcmp::rtl
