#include "generator/synthesis/components/component_parts.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <variant>

#include "generator/hardware/emit/template_ports.hpp"
#include "generator/synthesis/components/needed_parts.hpp"
#include "model/base/common/cases.hpp"
#include "model/cost/estimated/table_luts.hpp"

namespace mixcmp::components {
namespace {

using namespace rtl;

/// The registers in front of one operand of a multiplier.
constexpr int most_operand_registers = 2;

int number(const Instance& instance, const char* name) {
  return static_cast<int>(emit::template_parameter(instance, name).value_or(0));
}

/// The stages of an instance that end in registers, the last one in the highest bit; null without.
const Literal* cuts_of(const Instance& instance) {
  for (const Parameter& parameter : instance.parameters) {
    if (parameter.name == "CUTS") return std::get_if<Literal>(&parameter.value);
  }
  return nullptr;
}

bool ends_in_register(const Instance& instance) {
  const Literal* const cuts = cuts_of(instance);
  return cuts != nullptr && (cuts->value >> (cuts->width - 1) & 1) != 0;
}

bool has_two_registers(const Instance& instance) {
  const Literal* const cuts = cuts_of(instance);
  return cuts != nullptr && std::popcount(static_cast<std::uint64_t>(cuts->value)) > 1;
}

/// The net that an operand is, but for bits in front of it.
const std::string* net_of(const Operand& operand) {
  if (const auto* net = std::get_if<Net>(&operand->node)) return &net->name;
  const auto* all = std::get_if<Concatenation>(&operand->node);
  return all == nullptr ? nullptr : net_of(all->parts.back());
}

/// Who drives and who reads the nets of one module, as far as instances of templates do.
class Nets {
public:
  explicit Nets(const Module& module) {
    for (const ModuleItem& item : module.items) {
      std::visit(Cases{[this](const Instance& instance) { add(instance); },
                       [this](const Wire& wire) { read(wire.value); },
                       [this](const Assignment& assignment) { read(assignment.value); },
                       [](const auto&) {}},
                 item);
    }
  }

  const Instance* driver(const std::string& net) const {
    const auto found = drivers_.find(net);
    return found == drivers_.end() ? nullptr : found->second;
  }
  /// The only reader of a net; null if there are several, or if a statement reads it.
  const Instance* reader(const std::string& net) const {
    const std::vector<const Instance*> all = readers(net);
    return all.size() == 1 ? all.front() : nullptr;
  }
  /// All readers of a net; null for a statement.
  std::vector<const Instance*> readers(const std::string& net) const {
    const auto found = readers_.find(net);
    return found == readers_.end() ? std::vector<const Instance*>() : found->second;
  }

private:
  void add(const Instance& instance) {
    for (const Connection& connection : instance.connections) {
      const std::string* const net = net_of(connection.value);
      if (net == nullptr) continue;
      const bool is_result = connection.port == "y" || connection.port == "q";
      if (is_result) {
        drivers_[*net] = &instance;
      } else if (readers_[*net].empty() || readers_[*net].back() != &instance) {
        readers_[*net].push_back(&instance);
      }
    }
  }
  void read(const Operand& value) {
    if (value == nullptr) return;
    if (const std::string* const net = net_of(value)) readers_[*net].push_back(nullptr);
    if (const auto* any = std::get_if<Or>(&value->node)) {
      for (const Operand& operand : any->operands) read(operand);
    }
  }

  std::map<std::string, const Instance*> drivers_;
  std::map<std::string, std::vector<const Instance*>> readers_;
};

const Operand* pin(const Instance& instance, const char* port) {
  for (const Connection& connection : instance.connections) {
    if (connection.port == port) return &connection.value;
  }
  return nullptr;
}

/// The zeros at the end of an operand.
int low_zeros(const Instance& instance, const char* port) {
  const Operand* const operand = pin(instance, port);
  const auto* all = operand == nullptr ? nullptr : std::get_if<Concatenation>(&(*operand)->node);
  const auto* zeros = all == nullptr ? nullptr : std::get_if<Zeros>(&all->parts.back()->node);
  return zeros == nullptr ? 0 : zeros->width;
}

/// The low bits of a sum that are copies of one operand's, because the other has zeros there.
int passing_bits(const Instance& sum) {
  const bool subtracts = number(sum, "SUBTRACT") != 0;
  const int zeros = std::max(subtracts ? 0 : low_zeros(sum, "a"), number(sum, "SHIFT_B"));
  const int dropped = number(sum, "DROPPED"), width = number(sum, "WIDTH");
  return std::min({zeros, number(sum, "A_WIDTH") - 1,
                   number(sum, "B_WIDTH") + number(sum, "SHIFT_B") - 1,
                   dropped > 0 ? dropped : width - 1});
}

/// The sum without its passing bits.
TemplateInstance without_passing_bits(const Instance& sum) {
  TemplateInstance result{sum.module, sum.parameters};
  const int passing = passing_bits(sum), shift = number(sum, "SHIFT_B");
  const char* const last = number(sum, "DROPPED") > 0 ? "DROPPED" : "WIDTH";
  for (Parameter& parameter : result.parameters) {
    const int value = number(sum, parameter.name.c_str());
    if (parameter.name == "A_WIDTH" || parameter.name == last) parameter.value = value - passing;
    if (parameter.name == "B_WIDTH") parameter.value = value - std::max(0, passing - shift);
    if (parameter.name == "SHIFT_B") parameter.value = std::max(0, value - passing);
  }
  return result;
}

/// Finds out which instances of a module multipliers absorb.
class Packing {
public:
  explicit Packing(const Module& module) : nets_(module) {
    for (const Instance* instance : instances(module)) {
      if (instance->module == "fixed_product" && embedded_products(*instance) > 0) pack(*instance);
    }
  }

  Part part(const Instance& instance) const {
    const auto registers = registers_.find(&instance);
    return {.instance = as_synthesised(instance),
            .absorbed_registers = registers == registers_.end() ? 0 : registers->second,
            .is_absorbed = sums_.contains(&instance),
            .kept_registers = kept_registers(instance),
            .passing_registers = passing_registers(instance)};
  }

private:
  static int passing_registers(const Instance& sum) {
    const bool passes = sum.module == "fixed_sum" && number(sum, "DROPPED") == 0;
    return passes && ends_in_register(sum) ? passing_bits(sum) : 0;
  }

  static int kept_registers(const Instance& sum) {
    const bool keeps = sum.module == "fixed_sum" && number(sum, "DROPPED") > 0;
    return keeps && ends_in_register(sum) ? number(sum, "WIDTH") : 0;
  }

  void pack(const Instance& product) {
    pack_operand(product, "a");
    if (number(product, "SQUARE") == 0) pack_operand(product, "b");
    // A second register takes the adder's place; a sum of upper bits is not that of the product.
    if (has_two_registers(product) || number(product, "DROPPED") > 0) return;
    const Operand* const result = pin(product, "y");
    const std::string* const net = result == nullptr ? nullptr : net_of(*result);
    const Instance* const sum = net == nullptr ? nullptr : nets_.reader(*net);
    const bool is_sum =
        sum != nullptr && sum->module == "fixed_sum" && number(*sum, "SUBTRACT") == 0;
    if (is_sum) sums_.insert(sum);
  }

  /// The instance as synthesis reduces it.
  TemplateInstance as_synthesised(const Instance& instance) const {
    if (instance.module == "fixed_sum") return without_passing_bits(instance);
    TemplateInstance result{instance.module, instance.parameters};
    const auto longer = longer_.find(&instance);
    if (longer == longer_.end()) return result;
    for (Parameter& parameter : result.parameters) {
      if (parameter.name == "LENGTH") parameter.value = number(instance, "LENGTH") + longer->second;
    }
    return result;
  }

  void pack_operand(const Instance& product, const char* port) {
    const Instance* reader = &product;
    const Instance* branch = nullptr;
    for (int left = most_operand_registers; left > 0;) {
      const Operand* const operand = pin(*reader, reader == &product ? port : "d");
      const std::string* const net = operand == nullptr ? nullptr : net_of(*operand);
      if (net == nullptr || !may_take_registers(*net, *reader, branch)) return;
      const Instance* const driver = nets_.driver(*net);
      if (driver == nullptr) return;
      const bool is_line = driver->module == "delay_line";
      const int length = is_line ? number(*driver, "LENGTH") : ends_in_register(*driver) ? 1 : 0;
      if (length > left) return;
      registers_[driver] = length * number(*driver, "WIDTH");
      if (branch != nullptr) longer_[branch] += length;
      if (!is_line) return;
      left -= length;
      reader = driver;
    }
  }

  /// Whether registers that drive a net may go into the multiplier: nothing else reads it, or one
  /// delay line does, `branch`, which then begins with registers of its own in their place.
  bool may_take_registers(const std::string& net, const Instance& reader,
                          const Instance*& branch) const {
    std::vector<const Instance*> others = nets_.readers(net);
    std::erase(others, &reader);
    if (others.empty()) return true;
    if (branch != nullptr || others.size() > 1) return false;
    branch = others.front();
    return branch != nullptr && branch->module == "delay_line";
  }

  Nets nets_;
  std::map<const Instance*, int> registers_;
  std::map<const Instance*, int> longer_;  ///< delay lines, by so many cycles
  std::set<const Instance*> sums_;
};

class PartsOfTree {
public:
  explicit PartsOfTree(const std::vector<Module>& modules) {
    for (const Module& module : modules) tree_[module.name] = &module;
  }

  ComponentParts of(const Module& module) {
    add(module);
    return std::move(parts_);
  }

private:
  void add(const Module& module) { add(module.items, Packing(module)); }
  void add(const std::vector<ModuleItem>& items, const Packing& packing) {
    for (const ModuleItem& item : items) {
      std::visit([&](const auto& each) { add(each, packing); }, item);
    }
  }
  void add(const Instance& instance, const Packing& packing) {
    const auto child = tree_.find(instance.module);
    if (child != tree_.end()) return add(*child->second);
    parts_.instances.push_back(packing.part(instance));
  }
  void add(const std::shared_ptr<const ForGenerate>& loop, const Packing& packing) {
    for (int k = 0; k < loop->count; ++k) add(loop->items, packing);
  }
  void add(const HeldValue& held, const Packing&) { parts_.statements.registers += held.width; }
  void add(const PhaseRegisters& registers, const Packing&) {
    const int bits = registers.width * static_cast<int>(registers.names.size());
    parts_.statements.registers += bits;
    // A LUT of six inputs chooses among four bits; each further LUT adds three.
    const int choices = static_cast<int>(registers.cases.size());
    parts_.statements.luts += bits * ((choices + 1) / 3);
  }
  void add(const PhaseFlag&, const Packing&) { parts_.statements.luts += 1; }
  void add(const Comment&, const Packing&) {}
  void add(const Wire&, const Packing&) {}
  void add(const Assignment&, const Packing&) {}

  std::map<std::string, const Module*> tree_;
  ComponentParts parts_;
};

}  // namespace

ComponentParts parts_of(const std::vector<Module>& modules) {
  return PartsOfTree(modules).of(modules.back());
}

units::Unit unit_of(const TemplateInstance& instance) {
  units::Unit unit{.module = instance.module, .parameters = {}};
  for (const Parameter& parameter : emit::template_parameters(instance)) {
    if (const auto* literal = std::get_if<Literal>(&parameter.value)) {
      unit.parameters.push_back({parameter.name, literal->width, literal->value});
    } else if (const auto* number = std::get_if<long long>(&parameter.value)) {
      unit.parameters.push_back(units::integer(parameter.name, *number));
    } else {
      const auto& table = std::get<Words>(parameter.value);
      unit.parameters.push_back(units::integer(std::string(units::table_luts),
                                               estimated::table_luts(table.words, table.width)));
    }
  }
  const Instance alone{instance.module, "unit", instance.parameters, {}};
  unit.parameters.push_back(
      units::integer(std::string(units::embedded_products), embedded_products(alone)));
  return unit;
}

rtl::TemplateInstance instance_of(const units::Unit& unit) {
  rtl::TemplateInstance instance{unit.module, {}};
  for (const units::Parameter& parameter : unit.parameters) {
    if (parameter.name == units::embedded_products) continue;
    if (parameter.is_literal()) {
      const Literal value{parameter.literal_bits, parameter.bits};
      instance.parameters.push_back({parameter.name, value});
    } else {
      instance.parameters.push_back({parameter.name, static_cast<long long>(parameter.bits)});
    }
  }
  return instance;
}

}  // namespace mixcmp::components
