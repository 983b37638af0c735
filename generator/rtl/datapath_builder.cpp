#include "generator/rtl/datapath_builder.hpp"

#include <fmt/core.h>

#include "model/common/check.hpp"

namespace mixcmp::rtl {
namespace {

/// Names that no input may take: the fixed ports and nets of a datapath.
/// "lane" and "reference" are the instances' names, one level up, which Verilator warns of.
const std::set<std::string> reserved_names = {"aclk",     "verdict", "decided",
                                              "decision", "lane",    "reference"};

std::set<std::string> taken_names(const std::vector<std::string>& ports) {
  std::set<std::string> taken = reserved_names;
  taken.insert(ports.begin(), ports.end());
  return taken;
}

}  // namespace

DatapathBuilder::DatapathBuilder(const std::vector<std::string>& inputs, int operand_width,
                                 DelayPlan plan)
    : ports_(input_ports(inputs)),
      operand_width_(operand_width),
      pool_(taken_names(ports_)),
      plan_(std::move(plan)) {}

std::vector<Port> DatapathBuilder::data_ports() const {
  std::vector<Port> ports = {{Direction::input, 1, "aclk"}};
  for (const std::string& port : ports_) {
    ports.push_back({Direction::input, operand_width_, port});
  }
  return ports;
}

Operand DatapathBuilder::at(const Signal& signal, int cycle) {
  MIXCMP_CHECK(cycle >= signal.cycle);
  if (signal.constant || signal.value == nullptr || cycle == signal.cycle) return signal.value;
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

Operand DatapathBuilder::delayed(const Signal& signal, const Operand& source, int from, int to) {
  const std::string name = pool_.unique(fmt::format("{}_d{}", signal.name, to - signal.cycle));
  add(Wire{signal.width, name, nullptr});
  add(Instance{"delay_line",
               pool_.unique("delay_" + name),
               {{"WIDTH", signal.width}, {"LENGTH", to - from}},
               {{"aclk", net("aclk")}, {"d", source}, {"q", net(name)}}});
  return net(name);
}

Module datapath_module(std::string name, const std::vector<std::string>& inputs, int operand_width,
                       const std::vector<Port>& outputs,
                       const std::function<void(DatapathBuilder&)>& build) {
  DatapathBuilder first(inputs, operand_width, {});
  build(first);
  DatapathBuilder second(inputs, operand_width, first.plan());
  build(second);
  std::vector<Port> ports = second.data_ports();
  ports.insert(ports.end(), outputs.begin(), outputs.end());
  return {std::move(name), {}, std::move(ports), second.take()};
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

void append_multiplier_parameters(const datapath::Unit& unit, std::vector<Parameter>& parameters) {
  if (unit.multipliers == scene::Multipliers::logic) {
    parameters.push_back({"EMBEDDED", 0});
  } else if (unit.multiplier != devices::MultiplierSize{}) {
    parameters.push_back({"FACTOR_A", unit.multiplier.a_bits});
    parameters.push_back({"FACTOR_B", unit.multiplier.b_bits});
  }
}

Literal cut_mask(const datapath::Step& step) {
  Literal mask = {static_cast<int>(step.cuts.size()), 0};
  MIXCMP_CHECK(mask.width <= 128);
  for (std::size_t k = 0; k < step.cuts.size(); ++k) {
    if (step.cuts[k]) mask.value |= Bits{1} << k;
  }
  return mask;
}

}  // namespace mixcmp::rtl
