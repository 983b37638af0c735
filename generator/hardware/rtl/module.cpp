#include "generator/hardware/rtl/module.hpp"

namespace mixcmp::rtl {
namespace {

template <class Node>
Operand make(Node node) {
  return std::make_shared<const Expression>(Expression{std::move(node)});
}

void collect_instances(const std::vector<ModuleItem>& items, std::vector<const Instance*>& found) {
  for (const ModuleItem& item : items) {
    if (const auto* instance = std::get_if<Instance>(&item)) found.push_back(instance);
    if (const auto* loop = std::get_if<std::shared_ptr<const ForGenerate>>(&item)) {
      collect_instances((*loop)->items, found);
    }
  }
}

}  // namespace

Operand net(std::string name) {
  return make(Net{std::move(name)});
}

Operand indexed(std::string name, std::string variable, int width, int offset) {
  return make(IndexedSlice{std::move(name), std::move(variable), width, offset});
}

Operand slice(std::string name, int high, int low) {
  return make(Slice{std::move(name), high, low});
}

Operand bit(std::string name, int index) {
  return slice(std::move(name), index, index);
}

Operand literal(int width, Bits value) {
  return make(Literal{width, value});
}

Operand zeros(int width) {
  return make(Zeros{width});
}

Operand concatenation(std::vector<Operand> parts) {
  return make(Concatenation{std::move(parts)});
}

Operand inverted(Operand operand) {
  return make(Not{std::move(operand)});
}

Operand any_of(std::vector<Operand> operands) {
  if (operands.empty()) return literal(1, 0);
  if (operands.size() == 1) return operands.front();
  return make(Or{std::move(operands)});
}

Operand all_bits(Operand operand) {
  return make(AndReduce{std::move(operand)});
}

std::vector<const Instance*> instances(const Module& module) {
  std::vector<const Instance*> found;
  collect_instances(module.items, found);
  return found;
}

std::set<std::string> instantiated_modules(const Module& module) {
  std::set<std::string> names;
  for (const Instance* instance : instances(module)) names.insert(instance->module);
  return names;
}

std::vector<ModuleItem> with_modules_renamed(
    std::vector<ModuleItem> items, const std::function<std::string(std::string)>& new_name) {
  for (ModuleItem& item : items) {
    if (auto* instance = std::get_if<Instance>(&item)) {
      instance->module = new_name(std::move(instance->module));
    }
    if (auto* loop = std::get_if<std::shared_ptr<const ForGenerate>>(&item)) {
      ForGenerate renamed = **loop;
      renamed.items = with_modules_renamed(std::move(renamed.items), new_name);
      *loop = std::make_shared<const ForGenerate>(std::move(renamed));
    }
  }
  return items;
}

}  // namespace mixcmp::rtl
