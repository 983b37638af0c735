#include "generator/synthesis/components/needed_parts.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <set>

#include "generator/hardware/datapath/embedded_square.hpp"
#include "generator/hardware/emit/template_ports.hpp"

namespace mixcmp::components {
namespace {

using namespace rtl;
using characterise::NeededNet;
using characterise::NeededParts;

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

/// The parameters of an instance; where it gives none, the template's default. A parameter that the
/// template does not have is 0.
class Parameters {
public:
  explicit Parameters(const Instance& instance) : instance_(instance) {}

  Bits bits(const char* name) const {
    return static_cast<Bits>(emit::template_parameter(instance_, name).value_or(0));
  }
  int number(const char* name) const { return static_cast<int>(bits(name)); }
  devices::MultiplierSize multiplier() const { return {number("FACTOR_A"), number("FACTOR_B")}; }

private:
  const Instance& instance_;
};

bool is_one_of(const std::string& module, std::initializer_list<const char*> names) {
  return std::find(names.begin(), names.end(), module) != names.end();
}

/// The bits of a unit's result in which a fault shows, and how many of them must vary.
NeededNet needed_result(const Instance& instance, const std::string& port) {
  const Parameters parameters(instance);
  if (instance.module.starts_with("fp_")) {
    const int operand_fraction = parameters.number("PRECISION") - 1;
    const int result_precision = parameters.number("RESULT_PRECISION");
    const int fraction = result_precision == 0 ? operand_fraction : result_precision - 1;
    return {.low_bits = fraction, .varying_bits = std::min({2, operand_fraction, fraction})};
  }
  const std::vector<Port> ports = emit::template_ports(instance).value();
  const auto result =
      std::find_if(ports.begin(), ports.end(), [&](const Port& each) { return each.name == port; });
  return {.low_bits = result->width};
}

/// Finds the parts of one module, and those of each module of the tree that it instantiates.
class PartsFinder {
public:
  PartsFinder(const Module& module, const std::map<std::string, const Module*>& tree)
      : module_(module), tree_(tree) {}

  NeededParts find() {
    for (std::size_t known = 0;; known = constants_.size()) {
      find_constants(module_.items);  // an item may read nets of later ones
      if (constants_.size() == known) break;
    }
    add_items(module_.items, "");
    return std::move(parts_);
  }

  /// The multipliers that one instance of a template surely has.
  int multipliers_of(const Instance& instance) const {
    const Parameters parameters(instance);
    if (emit::template_parameter(instance, "EMBEDDED") == 0) return 0;
    const int precision = parameters.number("PRECISION");
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

private:
  void find_constants(const std::vector<ModuleItem>& items) {
    for (const ModuleItem& item : items) {
      std::visit([&](const auto& each) { find_constant(each); }, item);
    }
  }

  void find_constant(const Wire& wire) {
    if (wire.value != nullptr && !varies(wire.value)) constants_.insert(wire.name);
  }
  void find_constant(const PhaseRegisters& registers) {
    for (std::size_t k = 0; k < registers.names.size(); ++k) {
      const bool any = std::any_of(registers.cases.begin(), registers.cases.end(),
                                   [&](const PhaseCase& each) { return varies(each.values[k]); });
      if (!any) constants_.insert(registers.names[k]);
    }
  }
  void find_constant(const HeldValue& held) {
    if (!varies(held.value)) constants_.insert(held.name);
  }
  void find_constant(const Instance& instance) {
    if (tree_.contains(instance.module) || !has_constant_operands(instance)) return;
    for (const Connection& connection : instance.connections) {
      const std::string* const result = result_of(connection);
      if (result != nullptr) constants_.insert(*result);
    }
  }
  void find_constant(const std::shared_ptr<const ForGenerate>& loop) {
    find_constants(loop->items);
  }
  void find_constant(const Comment&) {}
  void find_constant(const Assignment&) {}
  void find_constant(const PhaseFlag&) {}

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
  /// Tells whether a template's result is a constant, since its operands a and b are.
  bool has_constant_operands(const Instance& instance) const {
    const Operand *const a = pin(instance, "a"), *const b = pin(instance, "b");
    return a != nullptr && !varies(*a) && (b == nullptr || !varies(*b));
  }

  /// The net at a pin, if it is the result of a unit: y, or y_a and y_b of two squares.
  static const std::string* result_of(const Connection& connection) {
    const bool is_result = is_one_of(connection.port, {"y", "y_a", "y_b"});
    const auto* net = is_result ? std::get_if<Net>(&connection.value->node) : nullptr;
    return net == nullptr ? nullptr : &net->name;
  }

  /// `scope` is what stands before a name in the flattened netlist: "g_lanes[0].lane.".
  void add_items(const std::vector<ModuleItem>& items, const std::string& scope) {
    for (const ModuleItem& item : items) {
      std::visit([&](const auto& each) { add(each, scope); }, item);
    }
  }
  void add(const HeldValue& held, const std::string& scope) {
    add_net(scope, held.name, {.low_bits = held.width});
  }
  void add(const PhaseRegisters& registers, const std::string& scope) {
    for (const std::string& name : registers.names) {
      add_net(scope, name, {.low_bits = registers.width});
    }
  }
  /// The printer puts "g_" before the label of a loop.
  void add(const std::shared_ptr<const ForGenerate>& loop, const std::string& scope) {
    for (int k = loop->first; k < loop->first + loop->count; ++k) {
      add_items(loop->items, fmt::format("{}g_{}[{}].", scope, loop->label, k));
    }
  }
  void add(const Instance& instance, const std::string& scope) {
    const auto child = tree_.find(instance.module);
    if (child != tree_.end()) return add_child(*child->second, scope + instance.name + ".");
    parts_.dsps += multipliers_of(instance);
    for (const Connection& connection : instance.connections) {
      const std::string* const result = result_of(connection);
      if (result != nullptr) add_net(scope, *result, needed_result(instance, connection.port));
    }
  }
  void add(const Comment&, const std::string&) {}
  void add(const Wire&, const std::string&) {}
  void add(const Assignment&, const std::string&) {}
  void add(const PhaseFlag&, const std::string&) {}

  void add_net(const std::string& scope, const std::string& name, NeededNet net) {
    if (constants_.contains(name)) return;
    net.name = scope + name;
    parts_.nets.push_back(std::move(net));
  }
  void add_child(const Module& module, const std::string& scope) {
    const NeededParts parts = PartsFinder(module, tree_).find();
    parts_.dsps += parts.dsps;
    for (NeededNet net : parts.nets) {
      net.name = scope + net.name;
      parts_.nets.push_back(std::move(net));
    }
  }

  int multipliers_of_terms(const Instance& instance) const {
    const Parameters parameters(instance);
    const int precision = parameters.number("PRECISION");
    const int terms = parameters.number("TERMS");
    const devices::MultiplierSize size = parameters.multiplier();
    const auto term_varies = [&](const char* port, int term) {
      const Operand* const operand = pin(instance, port);
      if (operand == nullptr) return true;
      const auto* all = std::get_if<Concatenation>(&(*operand)->node);
      return all != nullptr && varies(all->parts[static_cast<std::size_t>(terms - 1 - term)]);
    };
    const Bits sums = parameters.bits("SUMS") | parameters.bits("DIFFERENCES");
    const Bits squares = parameters.bits("SQUARES") | sums;
    const Bits plain = parameters.bits("PLAIN");
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
    const bool is_square = parameters.number("SQUARE") != 0;
    const int a_width = parameters.number("A_WIDTH");
    const int b_width = is_square ? a_width : parameters.number("B_WIDTH");
    // Two kinds of bits do not count: a sign that is always 0, and bits that become rows of gates.
    const bool b_positive = parameters.number(is_square ? "POSITIVE_A" : "POSITIVE_B") != 0;
    const int a = a_width - parameters.number("POSITIVE_A");
    const int excess = b_width - 1 - size.b_bits;
    const int b = excess == 1 || excess == 2 ? size.b_bits : b_width - (b_positive ? 1 : 0);
    const bool factors_vary = varies(instance, "a") && (is_square || varies(instance, "b"));
    return factors_vary && a <= size.a_bits && b <= size.b_bits && is_surely_embedded(a, b);
  }

  const Module& module_;
  const std::map<std::string, const Module*>& tree_;
  std::set<std::string> constants_;  ///< nets that do not vary
  NeededParts parts_;
};

}  // namespace

int embedded_products(const rtl::Instance& instance) {
  return PartsFinder({}, {}).multipliers_of(instance);
}

NeededParts needed_parts(const std::vector<Module>& modules) {
  std::map<std::string, const Module*> tree;
  for (const Module& module : modules) tree[module.name] = &module;
  return PartsFinder(*tree.at(modules.back().name), tree).find();
}

}  // namespace mixcmp::components
