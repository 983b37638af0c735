#include "generator/hardware/rtl/datapath_builder.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <bit>

#include "generator/hardware/rtl/unread_bits.hpp"
#include "model/base/common/check.hpp"

namespace mixcmp::rtl {
namespace {

/// Names that no input may take: the fixed ports and nets of a datapath.
/// "lane" and "reference" are names of instances one level up, and Verilator warns about a net with
/// the name of one.
const std::set<std::string> reserved_names = {"aclk",     "phase", "verdict",  "decided",
                                              "decision", "lane",  "reference"};

std::set<std::string> taken_names(const std::vector<std::string>& ports) {
  std::set<std::string> taken = reserved_names;
  taken.insert(ports.begin(), ports.end());
  return taken;
}

std::vector<std::string> names_of(const std::vector<InputPort>& inputs) {
  std::vector<std::string> names;
  for (const InputPort& input : inputs) names.push_back(input.name);
  return names;
}

bool reads_phase(const std::vector<ModuleItem>& items) {
  return std::any_of(items.begin(), items.end(), [](const ModuleItem& item) {
    return std::holds_alternative<HeldValue>(item) ||
           std::holds_alternative<PhaseRegisters>(item) || std::holds_alternative<PhaseFlag>(item);
  });
}

}  // namespace

std::vector<InputPort> operands_of_width(const std::vector<std::string>& names, int width) {
  std::vector<InputPort> ports;
  for (const std::string& name : names) ports.push_back({name, width});
  return ports;
}

void widen(std::vector<InputPort>& ports, const std::vector<OperandFormat>& arriving,
           FloatFormat to, const datapath::Schedule& schedule) {
  for (std::size_t k = 0; k < arriving.size(); ++k) {
    if (arriving[k] == OperandFormat(to)) continue;
    ports[k].width = arriving[k].width();
    ports[k].widening = Widening{.from = arriving[k], .to = to};
    if (!schedule.widenings.empty()) ports[k].widening->step = schedule.widenings[k];
  }
}

DatapathBuilder::DatapathBuilder(std::vector<InputPort> inputs, int initiation_interval,
                                 DelayPlan plan, int entry_cycles)
    : inputs_(std::move(inputs)),
      ports_(input_ports(names_of(inputs_))),
      initiation_interval_(initiation_interval),
      entry_cycles_(entry_cycles),
      pool_(taken_names(ports_)),
      plan_(std::move(plan)) {}

std::vector<Port> DatapathBuilder::data_ports() const {
  std::vector<Port> ports = {{Direction::input, 1, "aclk"}};
  if (initiation_interval_ > 1) {
    ports.push_back({Direction::input, phase_bits(initiation_interval_), "phase", true});
  }
  for (std::size_t k = 0; k < ports_.size(); ++k) {
    ports.push_back({Direction::input, inputs_[k].width, ports_[k]});
  }
  return ports;
}

const std::string& DatapathBuilder::arrived(int input) {
  const auto known = arrived_.find(input);
  if (known != arrived_.end()) return known->second;
  const InputPort& port = inputs_[static_cast<std::size_t>(input)];
  return arrived_[input] = entered(ports_[static_cast<std::size_t>(input)], port.width, 0);
}

const std::string& DatapathBuilder::port(int input) {
  if (!inputs_[static_cast<std::size_t>(input)].widening) return arrived(input);
  const auto known = widened_.find(input);
  if (known != widened_.end()) return known->second;
  return widened_[input] = widened(input);
}

/// A net that is ready `ready_cycle` cycles behind the ports, delayed until all operands are.
std::string DatapathBuilder::entered(const std::string& name, int width, int ready_cycle) {
  if (ready_cycle == entry_cycles_) return name;
  std::string waited = pool_.unique(name + "_entered");
  add(Wire{width, waited, nullptr});
  add(Instance{"delay_line",
               pool_.unique("delay_" + waited),
               {{"WIDTH", width}, {"LENGTH", entry_cycles_ - ready_cycle}},
               {{"aclk", net("aclk")}, {"d", net(name)}, {"q", net(waited)}}});
  return waited;
}

/// The sign and the magnitude of a number in fixed point, with zeros between them.
Operand DatapathBuilder::as_subnormal(const std::string& port, const FixedFormat& fixed,
                                      FloatFormat read) {
  Operand sign = zeros(1), magnitude = net(port);
  if (fixed.is_signed) {
    const std::string name = pool_.unique(port + "_magnitude");
    add(Wire{fixed.width, name, nullptr});
    add(Instance{"fixed_absolute",
                 pool_.unique("absolute_" + port),
                 {{"A_WIDTH", fixed.width}, {"WIDTH", fixed.width}},
                 {{"aclk", net("aclk")}, {"a", net(port)}, {"y", net(name)}}});
    sign = bit(port, fixed.width - 1);
    magnitude = net(name);
  }
  return concatenation({sign, zeros(read.width() - 1 - fixed.width), magnitude});
}

/// An operand's word in the format OperandFormat::scaled_float.
Operand DatapathBuilder::read_by_unit(const std::string& port, const OperandFormat& from) {
  if (from.fixed() != nullptr) {
    return as_subnormal(port, *from.fixed(), from.scaled_float().format);
  }
  const FloatFormat& format = *from.floating();
  if (format.has_infinities()) return net(port);
  const int sign = format.width() - 1;
  const Operand magnitude = slice(port, sign - 1, 0);
  return concatenation({bit(port, sign), all_bits(magnitude), magnitude});
}

/// Converts an input. Zeros behind its fraction leave it the same number; if the formats have
/// exponents of different lengths, a unit moves the exponent and normalises subnormal numbers.
std::string DatapathBuilder::widened(int input) {
  const std::string& port = ports_[static_cast<std::size_t>(input)];
  const auto& [from, to, step] = *inputs_[static_cast<std::size_t>(input)].widening;
  const std::string name = pool_.unique(port + "_widened");
  const auto [read, scale] = from.scaled_float();
  const char* const bits =
      from.fixed() != nullptr ? "zeros in front of its magnitude" : "a bit in front, 1 for the NaN";
  add(Comment{fmt::format("{} in {}; it arrives in {}{}.", port, to.name(), from.name(),
                          scale == 0 ? ""
                                     : fmt::format(". With {}, it is 2^{} times a number of {}",
                                                   bits, scale, read.name()))});
  if (step.unit.module.empty()) {
    Operand narrow = net(arrived(input));
    add(Wire{to.width(), name, concatenation({narrow, zeros(to.width() - from.width())})});
    return name;
  }
  const std::string unused = pool_.unique("unused_exceptional_" + port);
  add(Wire{to.width(), name, nullptr});
  add(Wire{1, unused, nullptr});
  std::vector<Parameter> parameters = {{"EXPONENT_BITS", read.exponent_bits()},
                                       {"PRECISION", read.precision()},
                                       {"RESULT_EXPONENT_BITS", to.exponent_bits()},
                                       {"RESULT_PRECISION", to.precision()},
                                       {"GRADUAL", 1}};
  if (scale != 0) parameters.push_back({"SCALE", scale});
  add_unit(step, "widen_" + port, std::move(parameters),
           {{"a", read_by_unit(port, from)}, {"y", net(name)}, {"exceptional", net(unused)}});
  return entered(name, to.width(), step.ready_cycle);
}

Operand DatapathBuilder::at(const Signal& signal, int cycle) {
  MIXCMP_CHECK(cycle >= signal.cycle);
  const bool is_there = signal.constant || cycle <= signal.cycle + signal.lasts;
  if (is_there || signal.value == nullptr) return signal.value;
  if (initiation_interval_ > 1) return held(signal, cycle);
  std::set<int>& needed = plan_[signal.name];
  needed.insert(cycle);
  std::map<int, Operand>& taps = taps_[signal.name];
  Operand source = signal.value;
  int source_cycle = signal.cycle;
  for (auto tap = needed.begin(); tap != needed.end() && *tap <= cycle; ++tap) {
    if (taps.find(*tap) == taps.end()) {
      taps[*tap] = delayed(signal, source, source_cycle, *tap);
    }
    source = taps[*tap];
    source_cycle = *tap;
  }
  return source;
}

Operand DatapathBuilder::any_at(const std::vector<Signal>& signals, int cycle) {
  std::vector<Operand> raised;
  for (const Signal& signal : signals) {
    if (signal.value != nullptr) raised.push_back(at(signal, cycle));
  }
  return any_of(std::move(raised));
}

void DatapathBuilder::describe(const datapath::Step& step, std::string_view text) {
  add(Comment{fmt::format("Cycles {} to {}: {}", entry_cycles_ + step.start_cycle,
                          entry_cycles_ + step.ready_cycle, text)});
}

Signal DatapathBuilder::declare(const std::string& name, int width, int cycle) {
  add(Wire{width, name, nullptr});
  return {net(name), name, width, cycle};
}

void DatapathBuilder::add_unit(const datapath::Step& step, const std::string& instance,
                               std::vector<Parameter> parameters,
                               std::vector<Connection> connections) {
  add(unit_instance(step, pool_.unique(instance), std::move(parameters), std::move(connections)));
}

Operand DatapathBuilder::delayed(const Signal& signal, const Operand& source, int from, int to) {
  const std::string name = pool_.unique(fmt::format("{}_d{}", signal.name, to - signal.cycle));
  add(Wire{signal.width, name, nullptr});
  add(Instance{"delay_line",
               pool_.unique("delay_" + name),
               {{"WIDTH", signal.width}, {"LENGTH", to - from}},
               {{"aclk", net("aclk")}, {"d", source}, {"q", net(name)}}});
  return net(name);
}

Literal DatapathBuilder::phase(int cycle) const {
  return {phase_bits(initiation_interval_), static_cast<Bits>(cycle % initiation_interval_)};
}

/// The value held in registers until `cycle`. A register takes the value in the last cycle in which
/// it is there and keeps it for an interval. If the value is needed for longer, one register hands
/// it to the next.
Operand DatapathBuilder::held(const Signal& signal, int cycle) {
  Operand source = signal.value;
  for (int taken = signal.cycle + signal.lasts; taken < cycle; taken += initiation_interval_) {
    Operand& held = taps_[signal.name][taken];
    if (held == nullptr) {
      const std::string name = pool_.unique(signal.name + "_held");
      add(Comment{fmt::format("Cycles {} to {}: {}.", taken + 1, taken + initiation_interval_,
                              signal.name)});
      add(HeldValue{signal.width, name, phase(taken), source});
      held = net(name);
    }
    source = held;
  }
  return source;
}

Module datapath_module(std::string name, const std::vector<InputPort>& inputs,
                       const std::vector<Port>& outputs,
                       const std::function<void(DatapathBuilder&)>& build, int initiation_interval,
                       int entry_cycles) {
  DatapathBuilder first(inputs, initiation_interval, {}, entry_cycles);
  build(first);
  DatapathBuilder second(inputs, initiation_interval, first.plan(), entry_cycles);
  build(second);
  std::vector<Port> ports = second.data_ports();
  ports.insert(ports.end(), outputs.begin(), outputs.end());
  std::vector<ModuleItem> items = second.take();
  consume_unread_bits(items, second.read_in_part(), second.pool());
  if (initiation_interval > 1 && !reads_phase(items)) {
    items.emplace_back(Comment{"No unit is shared: every phase is alike."});
    items.emplace_back(Wire{1, second.pool().unique("unused_phase"), all_bits(net("phase"))});
  }
  return {std::move(name), std::move(ports), std::move(items)};
}

int phase_bits(int initiation_interval) {
  return std::max(1,
                  static_cast<int>(std::bit_width(static_cast<unsigned>(initiation_interval - 1))));
}

std::vector<Port> lane_outputs() {
  return {{Direction::output, 2, "verdict"}, {Direction::output, 1, "decided"}};
}

std::vector<std::string> input_ports(const std::vector<std::string>& inputs) {
  NamePool pool(reserved_names);
  std::vector<std::string> ports;
  for (const std::string& input : inputs) ports.push_back(pool.unique(input));
  return ports;
}

void append_technology_parameters(const datapath::Unit& unit, std::vector<Parameter>& parameters) {
  if (unit.multipliers == scene::Multipliers::logic) {
    parameters.push_back({"EMBEDDED", 0});
    switch (unit.product_form) {
      case datapath::LogicProduct::Form::plain: break;
      case datapath::LogicProduct::Form::behind_digits:
        parameters.push_back({"DIGIT_STAGE", 1});
        break;
      case datapath::LogicProduct::Form::split: parameters.push_back({"SPLIT", 1}); break;
    }
  } else if (unit.multiplier != devices::MultiplierSize{}) {
    parameters.push_back({"FACTOR_A", unit.multiplier.a_bits});
    parameters.push_back({"FACTOR_B", unit.multiplier.b_bits});
  }
  if (unit.sum_selects != datapath::default_sum_selects) {
    parameters.push_back({"SUM_SELECTS", unit.sum_selects});
  }
}

namespace {

/// The value of a unit's CUTS parameter.
Literal cut_mask(const datapath::Step& step) {
  Literal mask = {static_cast<int>(step.cuts.size()), 0};
  MIXCMP_CHECK(mask.width <= 128);
  for (std::size_t k = 0; k < step.cuts.size(); ++k) {
    if (step.cuts[k]) mask.value |= Bits{1} << k;
  }
  return mask;
}

}  // namespace

Instance unit_instance(const datapath::Step& step, std::string name,
                       std::vector<Parameter> parameters, std::vector<Connection> connections) {
  parameters.push_back({"CUTS", cut_mask(step)});
  connections.insert(connections.begin(), {"aclk", net("aclk")});
  return {step.unit.module, std::move(name), std::move(parameters), std::move(connections)};
}

}  // namespace mixcmp::rtl
