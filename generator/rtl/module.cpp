#include "generator/rtl/module.hpp"

namespace mixcmp::gen::rtl {
namespace {

template <class Node>
Operand make(Node node) {
  return std::make_shared<const Expression>(Expression{std::move(node)});
}

}  // namespace

Operand net(std::string name) {
  return make(Net{std::move(name)});
}

Operand indexed(std::string name, std::string index_variable, int width) {
  return make(IndexedSlice{std::move(name), std::move(index_variable), width});
}

Operand slice(std::string name, int high, int low) {
  return make(Slice{std::move(name), high, low});
}

Operand bit(std::string name, int index) {
  return slice(std::move(name), index, index);
}

Operand literal(int width, model::Bits value) {
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

}  // namespace mixcmp::gen::rtl
