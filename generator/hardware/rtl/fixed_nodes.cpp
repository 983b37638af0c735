#include "generator/hardware/rtl/fixed_nodes.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <bit>

#include "generator/hardware/datapath/fixed_units.hpp"
#include "model/base/common/check.hpp"
#include "model/base/number/dyadic.hpp"
#include "model/base/number/exact.hpp"
#include "model/comparison/expression/text.hpp"
#include "model/lane/fixed/item_split.hpp"

namespace mixcmp::rtl {

using fixed::FixedNode;

FixedNodes::FixedNodes(DatapathBuilder& datapath, const fixed::FixedLane& lane,
                       const datapath::Schedule& schedule)
    : datapath_(datapath),
      lane_(lane),
      schedule_(schedule),
      names_(name_nodes(lane, datapath.ports(), datapath.pool())) {}

void FixedNodes::build() {
  if (lane_.format.is_block) build_largest_exponent();
  for (NodeId id = 0; id < static_cast<NodeId>(lane_.nodes.size()); ++id) {
    const FixedNode& node = lane_.nodes[id];
    values_.push_back(
        {net(names_[id]), names_[id], node.format.width, schedule_.steps[id].ready_cycle});
    switch (node.operation) {
      case Operation::input: build_input(id); break;
      case Operation::constant: build_constant(id); break;
      case Operation::convert:
        if (fixed::is_floating_code(node)) {
          build_unit(id);
        } else {
          fixed::is_common_cut(node) ? build_common_cut(id) : build_conversion(id);
        }
        break;
      default: build_unit(id); break;
    }
  }
}

void FixedNodes::build_input(NodeId id) {
  if (!lane_.loaded_inputs.empty()) return build_loaded(id);
  if (fixed::is_read_as_it_arrives(lane_, lane_.nodes[id])) return build_arriving(id);
  lane_.format.is_block ? build_aligned_operand(id) : build_operand(id);
}

Signal FixedNodes::out_of_range(NodeId node) {
  std::vector<Signal> flags;
  bool reads_inputs = false;
  for (const NodeId id : fixed::fan_in(lane_, node)) {
    reads_inputs = reads_inputs || lane_.nodes[id].operation == Operation::input;
    const auto misfit = misfits_.find(id);
    if (misfit == misfits_.end() || fixed::is_reach(lane_.nodes[id])) continue;
    const bool known = std::any_of(flags.begin(), flags.end(), [&](const Signal& flag) {
      return flag.name == misfit->second.name;
    });
    if (!known) flags.push_back(misfit->second);
  }
  if (lane_.format.is_block && reads_inputs) flags.insert(flags.begin(), not_finite_);
  return any_of("out_of_range", flags);
}

Signal FixedNodes::beyond_reach(NodeId node) {
  std::vector<Signal> flags;
  for (const NodeId id : fixed::fan_in(lane_, node)) {
    if (fixed::is_reach(lane_.nodes[id])) flags.push_back(misfits_.at(id));
  }
  return any_of("beyond_reach", flags);
}

/// Returns one flag for several. Equal sets of flags share one.
Signal FixedNodes::any_of(const char* name, const std::vector<Signal>& flags) {
  if (flags.size() < 2) return flags.empty() ? Signal{} : flags.front();
  std::vector<std::string> names;
  int cycle = 0;
  for (const Signal& flag : flags) {
    names.push_back(flag.name);
    cycle = std::max(cycle, flag.cycle);
  }
  const auto known = gathered_.find(names);
  if (known != gathered_.end()) return known->second;
  const std::string unique = datapath_.pool().unique(name);
  const Operand any = datapath_.any_at(flags, cycle);
  datapath_.add(Wire{1, unique, any});
  return gathered_[names] = {net(unique), unique, 1, cycle};
}

void FixedNodes::build_largest_exponent() {
  const FloatFormat& format = lane_.input_format;
  const datapath::Step& step = schedule_.largest_exponent;
  std::vector<Operand> exponents;
  for (const int input : fixed::inputs_read(lane_)) {
    exponents.push_back(slice(datapath_.port(input),
                              format.fraction_bits() + format.exponent_bits() - 1,
                              format.fraction_bits()));
  }
  datapath_.describe(step, "the largest exponent of all operands, biased.");
  largest_exponent_ = datapath_.declare(datapath_.pool().unique("largest_exponent"),
                                        format.exponent_bits(), step.ready_cycle);
  not_finite_ = datapath_.declare(datapath_.pool().unique("not_finite"), 1, step.ready_cycle);
  const int count = static_cast<int>(exponents.size());
  datapath_.add_unit(step, "unit_" + largest_exponent_.name,
                     {{"COUNT", count},
                      {"LEVELS", static_cast<int>(step.cuts.size())},
                      {"EXPONENT_BITS", format.exponent_bits()}},
                     {{"exponents", concatenation(std::move(exponents))},
                      {"largest", largest_exponent_.value},
                      {"not_finite", not_finite_.value}});
}

/// An operand without the low bits of its fraction that lie below the unit for every largest
/// exponent. They need no delay.
Signal FixedNodes::leading_bits(int input) {
  const FloatFormat& format = lane_.input_format;
  const std::string& port = datapath_.port(input);
  const int low = format.precision() - lane_.format.operand_bits();
  if (low <= 0) return {net(port), port, format.width(), 0};
  const std::string name = datapath_.pool().unique(port + "_leading");
  const int width = format.width() - low;
  datapath_.add(Wire{width, name, slice(port, format.width() - 1, low)});
  consume_bits(port, low - 1, 0);
  return {net(name), name, width, 0};
}

/// Builds an operand of block floating point.
void FixedNodes::build_aligned_operand(NodeId id) {
  const FixedNode& node = lane_.nodes[id];
  const datapath::Step& step = schedule_.steps[id];
  const FloatFormat& format = lane_.input_format;
  describe(id);
  const Signal operand = leading_bits(node.input);
  declare(id);
  const std::string& port = datapath_.port(node.input);
  datapath_.add_unit(step, "unit_" + names_[id],
                     {{"EXPONENT_BITS", format.exponent_bits()},
                      {"PRECISION", operand.width - format.exponent_bits()},
                      {"WIDTH", lane_.format.operand_bits()},
                      {"SIGNED", node.format.is_signed ? 1 : 0}},
                     {{"x", datapath_.at(operand, step.start_cycle)},
                      {"largest", datapath_.at(largest_exponent_, step.start_cycle)},
                      {"y", net(names_[id])}});
  if (node.format.is_signed) return;
  const std::string negative = datapath_.pool().unique(port + "_out_of_range");
  datapath_.add(Wire{1, negative, bit(port, format.width() - 1)});
  misfits_[id] = {net(negative), negative, 1, 0};
}

void FixedNodes::build_operand(NodeId id) {
  const FixedNode& node = lane_.nodes[id];
  const datapath::Step& step = schedule_.steps[id];
  const FixedFormat& format = node.format;
  const std::string& port = datapath_.port(node.input);
  const int magnitude_bits = format.magnitude_bits();
  describe(id);
  declare(id);
  const Operand misfit = declare_misfit(id, port + "_out_of_range", step);
  datapath_.add_unit(step, "unit_" + names_[id],
                     {{"EXPONENT_BITS", lane_.input_format.exponent_bits()},
                      {"PRECISION", lane_.input_format.precision()},
                      {"TOP", format.unit_exponent + magnitude_bits},
                      {"WIDTH", magnitude_bits},
                      {"SIGNED", format.is_signed ? 1 : 0}},
                     {{"x", net(port)}, {"y", net(names_[id])}, {"out_of_range", misfit}});
}

/// Declares the net of a node.
void FixedNodes::declare(NodeId id) {
  datapath_.declare(names_[id], lane_.nodes[id].format.width, schedule_.steps[id].ready_cycle);
}

/// Declares the flag of an input, a limit or a reach, which `step` finds.
Operand FixedNodes::declare_misfit(NodeId id, const std::string& name, const datapath::Step& step) {
  misfits_[id] = datapath_.declare(datapath_.pool().unique(name), 1, step.ready_cycle);
  return misfits_[id].value;
}

/// Builds a field of an item's word, which is a port. Its flags are also ports, behind all fields.
void FixedNodes::build_loaded(NodeId id) {
  const fixed::LoadedInput& loaded = lane_.loaded_inputs[lane_.nodes[id].input];
  const std::vector<fixed::LoadedFlag> ports = fixed::flags_read(lane_);
  std::vector<Signal> flags;
  for (const std::size_t flag : loaded.flags) {
    const auto port =
        std::find(ports.begin(), ports.end(), fixed::LoadedFlag{.role = loaded.role, .flag = flag});
    const auto index =
        static_cast<int>(lane_.loaded_inputs.size()) + static_cast<int>(port - ports.begin());
    flags.push_back({net(datapath_.port(index)), datapath_.port(index), 1, 0});
  }
  if (!flags.empty()) misfits_[id] = any_of("out_of_range", flags);
}

/// Builds an operand in fixed point, which is a port without the low bits that the lane drops.
void FixedNodes::build_arriving(NodeId id) {
  const FixedNode& node = lane_.nodes[id];
  const std::string& port = datapath_.port(node.input);
  if (node.dropped_bits == 0) {
    values_[id].value = net(port);
    return;
  }
  describe(id);
  datapath_.add(Wire{node.format.width, names_[id],
                     slice(port, node.dropped_bits + node.format.width - 1, node.dropped_bits)});
  consume_bits(port, node.dropped_bits - 1, 0);
}

void FixedNodes::build_constant(NodeId id) {
  const FixedNode& node = lane_.nodes[id];
  const Literal constant = twos_complement(node.format.width, node.constant);
  values_[id].value = literal(constant.width, constant.value);
  values_[id].constant = true;
}

Operand FixedNodes::excess_bits(NodeId id, int kept, int most, int cycle) {
  const FixedFormat& format = lane_.nodes[id].format;
  const Operand value = datapath_.at(values_[id], cycle);
  const std::string& name = std::get<Net>(value->node).name;
  if (kept > 0) datapath_.may_be_read_in_part(values_[id]);
  const int own = std::max(0, format.magnitude_bits() - kept);
  if (format.is_signed && own == most) return slice(name, format.width - 1, kept);
  const Operand sign = format.is_signed ? bit(name, format.width - 1) : literal(1, 0);
  std::vector<Operand> bits(static_cast<std::size_t>(most + 1 - own), sign);
  if (own > 0) bits.push_back(slice(name, format.magnitude_bits() - 1, kept));
  return concatenation(std::move(bits));
}

void FixedNodes::build_common_drop() {
  const datapath::Step& step = schedule_.common_drop;
  const int most = fixed::most_dropped_in_common(lane_);
  const int bits = std::bit_width(static_cast<unsigned>(most));
  std::vector<Operand> excess;
  for (const NodeId id : fixed::cut_in_common(lane_)) {
    excess.push_back(excess_bits(id, lane_.format.bits, most, step.start_cycle));
  }
  datapath_.describe(step, "how many low bits the following cuts drop in common.");
  common_drop_ = datapath_.declare(datapath_.pool().unique("common_drop"), bits, step.ready_cycle);
  const int count = static_cast<int>(excess.size());
  datapath_.add_unit(step, "unit_" + common_drop_.name,
                     {{"COUNT", count}, {"MOST", most}, {"DROP_BITS", bits}},
                     {{"excess", concatenation(std::move(excess))}, {"drop", common_drop_.value}});
}

void FixedNodes::build_common_cut(NodeId id) {
  const FixedNode& node = lane_.nodes[id];
  const datapath::Step& step = schedule_.steps[id];
  if (common_drop_.value == nullptr) build_common_drop();
  describe(id);
  declare(id);
  datapath_.add_unit(step, "unit_" + names_[id],
                     {{"A_WIDTH", datapath::operand_bits(lane_.nodes, node, 0)},
                      {"MOST", node.most_dropped},
                      {"DROP_BITS", common_drop_.width},
                      {"WIDTH", node.format.width}},
                     {{"a", operand(node.operands[0], 0, step.start_cycle)},
                      {"drop", datapath_.at(common_drop_, step.start_cycle)},
                      {"y", net(names_[id])}});
}

/// Builds a conversion, which is wires, and a unit beside it for the check of a limit or a reach.
void FixedNodes::build_conversion(NodeId id) {
  const FixedNode& node = lane_.nodes[id];
  const Signal& whole = values_[node.operands[0]];
  const Operand value = datapath_.at(whole, schedule_.steps[id].start_cycle);
  const int low = node.dropped_bits, high = low + node.format.width - 1;
  MIXCMP_CHECK(high < whole.width);
  describe(id);
  if (node.format.width == whole.width) {
    datapath_.add(Wire{node.format.width, names_[id], value});
  } else {
    const std::string& name = std::get<Net>(value->node).name;
    datapath_.add(Wire{node.format.width, names_[id], slice(name, high, low)});
    if (node.function) datapath_.may_be_read_in_part(whole);
    if (low > 0) consume_bits(name, low - 1, 0);
  }
  if (fixed::is_checked(node)) build_check(id);
}

/// Consumes bits of a net, which may have no other reader.
void FixedNodes::consume_bits(const std::string& name, int high, int low) {
  datapath_.add(Wire{1, datapath_.pool().unique("unused_" + name),
                     all_bits(concatenation({literal(1, 0), slice(name, high, low)}))});
}

void FixedNodes::build_check(NodeId id) {
  const FixedNode& node = lane_.nodes[id];
  const datapath::Step& step = schedule_.checks[checks_built_++];
  const bool is_reach = fixed::is_reach(node);
  const Operand misfit = declare_misfit(
      id, is_reach ? names_[node.operands[0]] + "_far" : names_[id] + "_out_of_range", step);
  datapath_.add_unit(step, "check_" + names_[id], check_parameters(id),
                     {{"a", checked_operand(node, step.start_cycle)},
                      {is_reach ? "overflow" : "out_of_range", misfit}});
}

/// The operand of a check; a limit's without the low bits that it does not need.
Operand FixedNodes::checked_operand(const FixedNode& checked, int cycle) {
  const NodeId whole = checked.operands[0];
  const int low = fixed::is_reach(checked) ? 0 : datapath::unchecked_bits(lane_.nodes, checked);
  if (low == 0) return operand(whole, 0, cycle);
  const FixedFormat& format = lane_.nodes[whole].format;
  const Operand value = datapath_.at(values_[whole], cycle);
  const Operand upper = slice(std::get<Net>(value->node).name, format.width - 1, low);
  return format.is_signed ? upper : concatenation({literal(1, 0), upper});
}

std::vector<Parameter> FixedNodes::check_parameters(NodeId id) const {
  const FixedNode& node = lane_.nodes[id];
  const FixedNode& whole = lane_.nodes[node.operands[0]];
  const int width = datapath::operand_bits(lane_.nodes, node, 0);
  if (fixed::is_reach(node)) {
    return {{"A_WIDTH", width}, {"WIDTH", node.format.width + (node.format.is_signed ? 0 : 1)}};
  }
  const int low = datapath::unchecked_bits(lane_.nodes, node);
  std::vector<Parameter> parameters = {{"A_WIDTH", width - low}};
  const auto in_units = [&](const mpq_class& limit) {
    return twos_complement(width - low,
                           floor_of(scaled(mpq_class(limit / node.format.unit()), -low)));
  };
  if (node.value.low > whole.value.low) parameters.push_back({"LEAST", in_units(node.value.low)});
  if (node.value.high < whole.value.high) {
    parameters.push_back({"GREATEST", in_units(node.value.high)});
  }
  return parameters;
}

void FixedNodes::build_unit(NodeId id) {
  const auto* table = fixed::table_of(schedule_.square_tables, id);
  if (table != nullptr) return build_memory_square(id, *table);
  const datapath::Step& step = schedule_.steps[id];
  std::vector<Connection> connections = operands(id, step.start_cycle);
  connections.push_back({"y", net(names_[id])});
  describe(id);
  declare(id);
  datapath_.add_unit(step, "unit_" + names_[id], parameters(id), std::move(connections));
}

/// Builds a square that is read from a memory. If two squares share the memory, the second builds
/// the unit, once the operands of both are declared. Their cycles may differ.
void FixedNodes::build_memory_square(NodeId id, const fixed::SquareTable& table) {
  const NodeId last = table.squares.back();
  describe(id, id == last ? "" : fmt::format(" It is read beside {}, below.", names_[last]));
  declare(id);
  if (id != last) return;
  const bool alone = table.squares.size() == 1;
  std::vector<Parameter> parameters;
  std::vector<Connection> connections;
  for (std::size_t port = 0; port < table.squares.size(); ++port) {
    const FixedNode& node = lane_.nodes[table.squares[port]];
    const std::string upper = alone ? "" : port == 0 ? "_A" : "_B";
    const std::string lower = alone ? "" : port == 0 ? "_a" : "_b";
    const int start = schedule_.steps[table.squares[port]].start_cycle;
    parameters.push_back(
        {port == 0 ? "A_WIDTH" : "B_WIDTH", datapath::operand_bits(lane_.nodes, node, 0)});
    if (node.dropped_bits > 0) parameters.push_back({"DROPPED" + upper, node.dropped_bits});
    parameters.push_back({"WIDTH" + upper, node.format.width});
    connections.push_back({port == 0 ? "a" : "b", operand(node.operands[0], 0, start)});
    connections.push_back({"y" + lower, net(names_[table.squares[port]])});
  }
  if (table.has_signed_address) parameters.push_back({"SIGNED_ADDRESS", 1});
  datapath_.add_unit(schedule_.steps[id], "unit_" + names_[id], std::move(parameters),
                     std::move(connections));
}

/// The upper bits of a look-up's operand.
Operand FixedNodes::address(const FixedNode& look_up, int cycle) {
  const Signal& whole = values_[look_up.operands[0]];
  const Operand value = datapath_.at(whole, cycle);
  const int low = fixed::piece_bits(lane_.nodes, look_up);
  if (low == 0) return value;
  datapath_.may_be_read_in_part(whole);
  return slice(std::get<Net>(value->node).name, whole.width - 1, low);
}

std::vector<Parameter> FixedNodes::table_parameters(const FixedNode& look_up) const {
  const int width = look_up.format.width;
  Words table{width, {}};
  for (std::size_t address = 0; address < look_up.words.size(); ++address) {
    table.words.push_back(twos_complement(width, look_up.words[address]).value);
  }
  return {{"ADDRESS_BITS", look_up.words.address_bits()},
          {"WIDTH", width},
          {"WORDS", std::move(table)}};
}

/// A node's value in two's complement. A value without a sign gets a zero above it, and a shift
/// adds zeros below.
Operand FixedNodes::operand(NodeId node, int shift, int cycle) {
  std::vector<Operand> parts;
  if (!lane_.nodes[node].format.is_signed) parts.push_back(literal(1, 0));
  parts.push_back(datapath_.at(values_[node], cycle));
  if (shift > 0) parts.push_back(zeros(shift));
  return parts.size() == 1 ? parts.front() : concatenation(std::move(parts));
}

std::vector<Connection> FixedNodes::operands(NodeId id, int cycle) {
  const FixedNode& node = lane_.nodes[id];
  std::vector<Connection> connections;
  const auto connect = [&](const char* port, int k) {
    const int shift = datapath::alignment_bits(lane_.nodes, node, k);
    connections.push_back({port, operand(node.operands[k], shift, cycle)});
  };
  switch (node.operation) {
    case Operation::look_up: connections.push_back({"address", address(node, cycle)}); break;
    case Operation::convert:      // of a number without a sign
    case Operation::square_root:  // never negative
      connections.push_back({"a", datapath_.at(values_[node.operands[0]], cycle)});
      break;
    case Operation::negate:
      connections.push_back({"a", literal(1, 0)});
      connect("b", 0);
      break;
    case Operation::square:
      connect("a", 0);
      connections.push_back({"b", literal(1, 0)});
      break;
    case Operation::multiply: {
      const auto [first, second] = factors(id);
      connect("a", first);
      connect("b", second);
      break;
    }
    case Operation::add:
    case Operation::subtract: {
      const auto [first, second] = addends(id);
      connect("a", first);
      connections.push_back({"b", operand(node.operands[second], 0, cycle)});
      break;
    }
    default:
      connect("a", 0);
      if (arity(node.operation) == 2) connect("b", 1);
      break;
  }
  return connections;
}

std::vector<Parameter> FixedNodes::parameters(NodeId id) const {
  const FixedNode& node = lane_.nodes[id];
  const auto bits = [&](int k) { return datapath::operand_bits(lane_.nodes, node, k); };
  std::vector<Parameter> parameters;
  switch (node.operation) {
    case Operation::negate:
      parameters = {{"A_WIDTH", 1}, {"B_WIDTH", bits(0)}, {"SUBTRACT", 1}};
      break;
    case Operation::add:
    case Operation::subtract: {
      const auto [first, second] = addends(id);
      const int shift = datapath::alignment_bits(lane_.nodes, node, second);
      parameters = {{"A_WIDTH", bits(first)}, {"B_WIDTH", bits(second) - shift}};
      if (shift > 0) parameters.push_back({"SHIFT_B", shift});
      if (node.operation == Operation::subtract) parameters.push_back({"SUBTRACT", 1});
      break;
    }
    case Operation::multiply: {
      const auto [first, second] = factors(id);
      parameters = {{"A_WIDTH", bits(first)}, {"B_WIDTH", bits(second)}};
      break;
    }
    case Operation::square:
      parameters = {{"A_WIDTH", bits(0)}, {"B_WIDTH", 1}, {"SQUARE", 1}};
      break;
    case Operation::square_root: {
      const FixedFormat& radicand = lane_.nodes[node.operands[0]].format;
      const int shift = radicand.unit_exponent - 2 * node.format.unit_exponent;
      parameters = {{"A_WIDTH", radicand.width}, {"SHIFT", shift}};
      break;
    }
    case Operation::convert: {
      const int width = lane_.nodes[node.operands[0]].format.width;
      parameters = {{"A_WIDTH", width},
                    {"EXPONENT_BITS", function::FloatingCode{width}.exponent_bits()}};
      return parameters;
    }
    case Operation::look_up: return table_parameters(node);
    case Operation::absolute: parameters = {{"A_WIDTH", bits(0)}}; break;
    case Operation::minimum:
    case Operation::maximum:
      parameters = {{"A_WIDTH", bits(0)},
                    {"B_WIDTH", bits(1)},
                    {"MAXIMUM", node.operation == Operation::maximum ? 1 : 0}};
      break;
    default: MIXCMP_CHECK(!"an operation that fixed point has no unit for");
  }
  append_positive_factors(id, parameters);
  if (node.dropped_bits > 0) parameters.push_back({"DROPPED", node.dropped_bits});
  parameters.push_back({"WIDTH", node.format.width});
  append_technology_parameters(schedule_.steps[id].unit, parameters);
  return parameters;
}

/// The operands that a sum's unit takes as a and b. It shifts b up. A product that joins the sum in
/// its multiplier is b, since the adder there takes whole products.
std::pair<int, int> FixedNodes::addends(NodeId id) const {
  const FixedNode& node = lane_.nodes[id];
  const auto joined = schedule_.multiplier_sums.find(id);
  const bool adds = node.operation == Operation::add;
  const bool swaps = joined != schedule_.multiplier_sums.end()
                         ? node.operands[0] == joined->second
                         : adds && datapath::alignment_bits(lane_.nodes, node, 0) > 0;
  return swaps ? std::pair(1, 0) : std::pair(0, 1);
}

/// The operands that a product's unit takes as a and b. In logic a's digits make the rows, so it is
/// the narrower factor, unless one is a constant.
std::pair<int, int> FixedNodes::factors(NodeId id) const {
  const FixedNode& node = lane_.nodes[id];
  const auto bits = [&](int k) { return datapath::operand_bits(lane_.nodes, node, k); };
  const auto is_constant = [&](int k) {
    return lane_.nodes[node.operands[k]].operation == Operation::constant;
  };
  const bool swaps = schedule_.steps[id].unit.module == "fixed_logic_product" &&
                     bits(1) < bits(0) && !is_constant(0) && !is_constant(1);
  return swaps ? std::pair(1, 0) : std::pair(0, 1);
}

/// An embedded multiplier has room for one bit more of a factor without a sign.
void FixedNodes::append_positive_factors(NodeId id, std::vector<Parameter>& parameters) const {
  if (schedule_.steps[id].unit.module != "fixed_product") return;
  const FixedNode& node = lane_.nodes[id];
  for (int k = 0; k < arity(node.operation); ++k) {
    if (lane_.nodes[node.operands[k]].format.is_signed) continue;
    parameters.push_back({k == 0 ? "POSITIVE_A" : "POSITIVE_B", 1});
  }
}

Literal twos_complement(int width, const mpz_class& value) {
  const mpz_class bits = value < 0 ? mpz_class(value + shifted_left(1, width)) : value;
  return {width, to_bits(bits)};
}

}  // namespace mixcmp::rtl
