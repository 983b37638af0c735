#pragma once

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "model/base/common/bits.hpp"

/// A structural RTL tree without syntax; emit/verilog.hpp prints it.
namespace mixcmp::rtl {

/// An expression over nets. The functions below build it, and nothing changes it afterwards.
struct Expression;
using Operand = std::shared_ptr<const Expression>;

struct Net {
  std::string name;
};
/// The expression name[variable * width +: width], or name[variable] for width 1. With an offset,
/// the sum of variable and offset stands in place of the variable.
struct IndexedSlice {
  std::string name;
  std::string variable;
  int width;
  int offset;
};
struct Slice {
  std::string name;
  int high;
  int low;
};
struct Literal {
  int width;
  Bits value;
};
/// `width` zero bits; `width` may exceed that of a Literal.
struct Zeros {
  int width;
};
struct Concatenation {
  std::vector<Operand> parts;  ///< most significant first
};
struct Not {
  Operand operand;
};
struct Or {
  std::vector<Operand> operands;
};
/// The AND of all bits of a net. It serves to consume nets that are deliberately unread, for which
/// linters would warn otherwise.
struct AndReduce {
  Operand operand;
};

struct Expression {
  std::variant<Net, IndexedSlice, Slice, Literal, Zeros, Concatenation, Not, Or, AndReduce> node;
};

Operand net(std::string name);
Operand indexed(std::string name, std::string variable, int width, int offset = 0);
Operand slice(std::string name, int high, int low);
Operand bit(std::string name, int index);
Operand literal(int width, Bits value);
Operand zeros(int width);
Operand concatenation(std::vector<Operand> parts);
Operand inverted(Operand operand);
/// The OR of all operands. One operand is returned as it is, and no operand gives 1'b0.
Operand any_of(std::vector<Operand> operands);
Operand all_bits(Operand operand);

enum class Direction { input, output };

struct Port {
  Direction direction;
  int width;
  std::string name;
  bool vector = false;  ///< keep the [0:0] range: the port is indexed even at width 1
};

/// The words of a table.
struct Words {
  int width;
  std::vector<Bits> words;  ///< [address]
};

struct Parameter {
  std::string name;
  std::variant<long long, Literal, Words> value;
};

/// A template with its parameters, unconnected.
struct TemplateInstance {
  std::string module;
  std::vector<Parameter> parameters;
};

struct Connection {
  std::string port;
  Operand value;
};

struct Comment {
  std::string text;
};
struct Wire {
  int width;
  std::string name;
  Operand value;  ///< null: driven by an instance or an assignment
  bool vector = false;
};
struct Assignment {
  Operand target;
  Operand value;
};
struct Instance {
  std::string module;
  std::string name;
  std::vector<Parameter> parameters;
  std::vector<Connection> connections;
};
/// A register that takes `value` at the end of every cycle in which the port "phase" has this
/// value, and otherwise keeps its value.
struct HeldValue {
  int width;
  std::string name;
  Literal phase;
  Operand value;
};
/// The values that registers take at the end of a phase.
struct PhaseCase {
  Literal phase;
  std::string comment;
  std::vector<Operand> values;  ///< one per register
};
/// Registers that take other values in each phase. Phases without a case take those of the last
/// case.
struct PhaseRegisters {
  int width;
  std::vector<std::string> names;
  std::vector<PhaseCase> cases;
};
/// A wire that is 1 in some phases.
struct PhaseFlag {
  std::string name;
  std::vector<Literal> phases;  ///< at least one
};
struct ForGenerate;
using ModuleItem = std::variant<Comment, Wire, Assignment, Instance, HeldValue, PhaseRegisters,
                                PhaseFlag, std::shared_ptr<const ForGenerate>>;

/// A generate loop: `items` repeated for `count` values of `variable`, from `first` on.
struct ForGenerate {
  std::string variable;
  int first;
  int count;
  std::string label;
  std::vector<ModuleItem> items;
};

struct Module {
  std::string name;
  std::vector<Port> ports;
  std::vector<ModuleItem> items;
};

/// All instances in the module, those inside loops included.
std::vector<const Instance*> instances(const Module& module);
/// The names of the modules that `module` instantiates.
std::set<std::string> instantiated_modules(const Module& module);

/// Returns `items` with the module name of every instance, those inside loops included, replaced
/// by new_name(name).
std::vector<ModuleItem> with_modules_renamed(
    std::vector<ModuleItem> items, const std::function<std::string(std::string)>& new_name);

}  // namespace mixcmp::rtl
