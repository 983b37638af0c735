#include "generator/rtl/least_area.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "generator/datapath/embedded_square.hpp"

namespace mixcmp::rtl {
namespace {

/// The registers inside of a DSP48E1: for operands (30 and 18 bits), product (43) and sum (48).
/// Multipliers of other devices have fewer.
constexpr int registers_inside_multiplier = 30 + 18 + 43 + 48;

/// Tells whether Yosys surely maps a product of these factors to a multiplier. It makes products of
/// fewer than 9 bits, and those with a factor of one bit, of logic. The limits here are higher,
/// since some bits of a product may be known.
bool is_surely_embedded(int a_bits, int b_bits) {
  constexpr int fewest_factor_bits = 3, fewest_product_bits = 12;
  return std::min(a_bits, b_bits) >= fewest_factor_bits && a_bits + b_bits >= fewest_product_bits;
}

/// The multipliers of fp_embedded_product.
int multipliers_of_product(int precision, devices::MultiplierSize size) {
  int count = 0;
  for (int a = precision; a > 0; a -= size.a_bits) {
    for (int b = precision; b > 0; b -= size.b_bits) {
      count += is_surely_embedded(std::min(a, size.a_bits), std::min(b, size.b_bits)) ? 1 : 0;
    }
  }
  return count;
}

/// The multipliers of fp_product for a square.
int multipliers_of_square(int precision, devices::MultiplierSize size) {
  const datapath::EmbeddedSquare square(precision, size);
  return square.is_smaller() ? square.multipliers() : multipliers_of_product(precision, size);
}

/// The parameters of an instance. For those that it leaves out, the caller gives the default.
class Parameters {
public:
  explicit Parameters(const Instance& instance) : instance_(instance) {}

  Bits bits(const std::string& name, Bits otherwise) const {
    for (const Parameter& parameter : instance_.parameters) {
      if (parameter.name != name) continue;
      if (const auto* number = std::get_if<long long>(&parameter.value)) {
        return static_cast<Bits>(*number);
      }
      return std::get<Literal>(parameter.value).value;
    }
    return otherwise;
  }
  int number(const std::string& name, int otherwise) const {
    return static_cast<int>(bits(name, static_cast<Bits>(otherwise)));
  }
  devices::MultiplierSize multiplier() const {
    const devices::MultiplierSize standard;
    return {number("FACTOR_A", standard.a_bits), number("FACTOR_B", standard.b_bits)};
  }

private:
  const Instance& instance_;
};

bool is_one_of(const std::string& module, std::initializer_list<const char*> names) {
  return std::find(names.begin(), names.end(), module) != names.end();
}

/// Counts in one module, and in each module of the tree that it instantiates, once per instance.
class AreaCounter {
public:
  AreaCounter(const Module& module, const std::map<std::string, const Module*>& tree)
      : module_(module), tree_(tree) {}

  devices::Area count() {
    for (const Port& port : module_.ports) widths_[port.name] = port.width;
    add_names(module_.items);
    add_items(module_.items, 1);
    registers_ -= fixed_products_ * registers_inside_multiplier;
    area_.registers += std::max(registers_, 0);
    return area_;
  }

private:
  void add_names(const std::vector<ModuleItem>& items) {
    for (const ModuleItem& item : items) {
      std::visit([&](const auto& each) { add_name(each); }, item);
    }
  }

  void add_name(const Wire& wire) {
    widths_[wire.name] = wire.width;
    if (wire.value == nullptr) return;
    if (!varies(wire.value)) constants_.insert(wire.name);
    if (wire.name.find("unused") != std::string::npos) add_unread(wire.value);
    // A value whose sign is changed shares all other bits with the original.
    const auto* parts = std::get_if<Concatenation>(&wire.value->node);
    const auto* low = parts == nullptr ? nullptr : std::get_if<Slice>(&parts->parts.back()->node);
    if (low != nullptr) origins_[wire.name] = origin(low->name);
  }
  void add_name(const PhaseRegisters& registers) {
    for (std::size_t k = 0; k < registers.names.size(); ++k) {
      widths_[registers.names[k]] = registers.width;
      const bool any = std::any_of(registers.cases.begin(), registers.cases.end(),
                                   [&](const PhaseCase& each) { return varies(each.values[k]); });
      if (!any) constants_.insert(registers.names[k]);
    }
  }
  void add_name(const HeldValue& held) {
    widths_[held.name] = held.width;
    const auto* source = std::get_if<Net>(&held.value->node);
    origins_[held.name] = source == nullptr ? held.name : origin(source->name);
  }
  void add_name(const std::shared_ptr<const ForGenerate>& loop) { add_names(loop->items); }
  void add_name(const Instance& instance) {
    if (instance.module != "delay_line") return;
    const auto* source = std::get_if<Net>(&(*pin(instance, "d"))->node);
    const std::string& delayed = std::get<Net>((*pin(instance, "q"))->node).name;
    if (source != nullptr) origins_[delayed] = origin(source->name);
  }
  void add_name(const Comment&) {}
  void add_name(const Assignment&) {}
  void add_name(const PhaseFlag&) {}

  std::string origin(const std::string& name) const {
    const auto found = origins_.find(name);
    return found == origins_.end() ? name : found->second;
  }

  /// Notes the bits that a wire with "unused" in its name reads.
  void add_unread(const Operand& operand) {
    if (const auto* slice = std::get_if<Slice>(&operand->node)) {
      unread_[origin(slice->name)] += slice->high - slice->low + 1;
    }
    if (const auto* all = std::get_if<AndReduce>(&operand->node)) add_unread(all->operand);
    if (const auto* parts = std::get_if<Concatenation>(&operand->node)) {
      for (const Operand& part : parts->parts) add_unread(part);
    }
  }

  /// The number of a net's `width` bits that registers surely hold: without the bits that nothing
  /// reads, and without one that may be known, such as the sign of a square.
  int registered_bits(const std::string& name, int width) const {
    const auto unread = unread_.find(name);
    return std::max(0, width - 1 - (unread == unread_.end() ? 0 : unread->second));
  }

  bool varies(const Operand& operand) const {
    return std::visit([&](const auto& node) { return varies(node); }, operand->node);
  }
  bool varies(const Net& net) const { return !constants_.contains(net.name); }
  bool varies(const IndexedSlice& slice) const { return !constants_.contains(slice.name); }
  bool varies(const Slice& slice) const { return !constants_.contains(slice.name); }
  bool varies(const Literal&) const { return false; }
  bool varies(const Zeros&) const { return false; }
  bool varies(const Concatenation& node) const { return any_varies(node.parts); }
  bool varies(const Not& node) const { return varies(node.operand); }
  bool varies(const Or& node) const { return any_varies(node.operands); }
  bool varies(const AndReduce& node) const { return varies(node.operand); }
  bool any_varies(const std::vector<Operand>& operands) const {
    return std::any_of(operands.begin(), operands.end(),
                       [&](const Operand& operand) { return varies(operand); });
  }

  static const Operand* pin(const Instance& instance, const std::string& port) {
    const auto found =
        std::find_if(instance.connections.begin(), instance.connections.end(),
                     [&](const Connection& connection) { return connection.port == port; });
    return found == instance.connections.end() ? nullptr : &found->value;
  }
  /// Tells whether the value at a pin may vary. A pin that is not connected is a fault, not a
  /// constant, so its unit still counts.
  bool varies(const Instance& instance, const std::string& port) const {
    const Operand* const operand = pin(instance, port);
    return operand == nullptr || varies(*operand);
  }

  void add_items(const std::vector<ModuleItem>& items, int times) {
    for (const ModuleItem& item : items) {
      std::visit([&](const auto& each) { add(each, times); }, item);
    }
  }
  void add(const HeldValue& held, int times) {
    const std::string value = origin(held.name);
    if (held_.insert(value).second) registers_ += times * registered_bits(value, held.width);
  }
  void add(const PhaseRegisters& registers, int times) {
    for (const std::string& name : registers.names) {
      if (constants_.contains(name)) continue;
      registers_ += times * registered_bits(name, registers.width);
    }
  }
  void add(const std::shared_ptr<const ForGenerate>& loop, int times) {
    add_items(loop->items, times * loop->count);
  }
  void add(const Instance& instance, int times) {
    const auto child = tree_.find(instance.module);
    if (child != tree_.end()) {
      area_ += times * AreaCounter(*child->second, tree_).count();
      return;
    }
    const int multipliers = multipliers_of(instance);
    area_.dsps += times * multipliers;
    if (instance.module == "fixed_product") fixed_products_ += times;
    registers_ += times * result_bits(instance);
  }
  void add(const Comment&, int) {}
  void add(const Wire&, int) {}
  void add(const Assignment&, int) {}
  void add(const PhaseFlag&, int) {}

  /// The bits of a unit's result, which the last of its cuts registers. 0 where these registers may
  /// be inside of a multiplier (products) or of a memory (squares that are read from a table).
  int result_bits(const Instance& instance) const {
    const Operand* const result = pin(instance, "y");
    const bool is_inside = is_one_of(instance.module, {"fixed_product", "fixed_memory_square"});
    if (result == nullptr || is_inside || Parameters(instance).bits("CUTS", 0) == 0) return 0;
    const auto* net = std::get_if<Net>(&(*result)->node);
    return net == nullptr ? 0 : registered_bits(net->name, widths_.at(net->name));
  }

  int multipliers_of(const Instance& instance) const {
    const Parameters parameters(instance);
    if (parameters.number("EMBEDDED", 1) == 0) return 0;
    const int precision = parameters.number("PRECISION", 0);
    const devices::MultiplierSize size = parameters.multiplier();
    const bool a = varies(instance, "a"), b = varies(instance, "b");
    if (instance.module == "fp_multiply") {
      return a && b ? multipliers_of_product(precision, size) : 0;
    }
    if (instance.module == "fp_square") return a ? multipliers_of_square(precision, size) : 0;
    if (instance.module == "fp_squared_sum") {
      return a || b ? multipliers_of_square(precision, size) : 0;
    }
    if (is_one_of(instance.module, {"fp_fused_sum", "fp_fused_comparison"})) {
      return multipliers_of_terms(instance);
    }
    if (instance.module == "fixed_product") return is_fixed_product_embedded(instance) ? 1 : 0;
    return 0;
  }

  int multipliers_of_terms(const Instance& instance) const {
    const Parameters parameters(instance);
    const int precision = parameters.number("PRECISION", 0);
    const int terms = parameters.number("TERMS", 0);
    const devices::MultiplierSize size = parameters.multiplier();
    const auto term_varies = [&](const char* port, int term) {
      const auto* all = std::get_if<Concatenation>(&(*pin(instance, port))->node);
      return all != nullptr && varies(all->parts[static_cast<std::size_t>(terms - 1 - term)]);
    };
    const Bits sums = parameters.bits("SUMS", 0) | parameters.bits("DIFFERENCES", 0);
    const Bits squares = parameters.bits("SQUARES", 0) | sums;
    const Bits plain = parameters.bits("PLAIN", 0);
    int count = 0;
    for (int term = 0; term < terms; ++term) {
      const auto is_in = [&](Bits mask) { return ((mask >> term) & 1) != 0; };
      if (is_in(plain)) continue;
      const bool a = term_varies("a", term), b = term_varies("b", term);
      if (is_in(squares)) {
        count += a || (is_in(sums) && b) ? multipliers_of_square(precision, size) : 0;
      } else {
        count += a && b ? multipliers_of_product(precision, size) : 0;
      }
    }
    return count;
  }

  bool is_fixed_product_embedded(const Instance& instance) const {
    const Parameters parameters(instance);
    const devices::MultiplierSize size = parameters.multiplier();
    const bool is_square = parameters.number("SQUARE", 0) != 0;
    const int a_width = parameters.number("A_WIDTH", 0);
    const int b_width = is_square ? a_width : parameters.number("B_WIDTH", 0);
    // Two kinds of bits do not count: a sign that is always 0, and bits that become rows of gates.
    const bool b_positive = parameters.number(is_square ? "POSITIVE_A" : "POSITIVE_B", 0) != 0;
    const int a = a_width - parameters.number("POSITIVE_A", 0);
    const int excess = b_width - 1 - size.b_bits;
    const int b = excess == 1 || excess == 2 ? size.b_bits : b_width - (b_positive ? 1 : 0);
    const bool factors_vary = varies(instance, "a") && (is_square || varies(instance, "b"));
    return factors_vary && a <= size.a_bits && b <= size.b_bits && is_surely_embedded(a, b);
  }

  const Module& module_;
  const std::map<std::string, const Module*>& tree_;
  std::map<std::string, int> widths_;
  std::set<std::string> constants_;             ///< nets that do not vary
  std::map<std::string, std::string> origins_;  ///< net -> the net whose bits it repeats
  std::map<std::string, int> unread_;           ///< origin -> its bits that nothing reads
  std::set<std::string> held_;                  ///< origins of values that wait in registers
  int registers_ = 0;                           ///< of this module, without its instances
  int fixed_products_ = 0;                      ///< of this module, without its instances
  devices::Area area_;
};

}  // namespace

devices::Area least_area(const std::vector<Module>& modules) {
  std::map<std::string, const Module*> tree;
  for (const Module& module : modules) tree[module.name] = &module;
  return AreaCounter(modules.back(), tree).count();
}

}  // namespace mixcmp::rtl
