#include "generator/hardware/rtl/checked_modules.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

#include "model/base/common/check.hpp"
#include "model/comparison/expression/name.hpp"

namespace mixcmp::rtl {
namespace {

/// A net with the drivers and readers of each of its bits.
struct NetState {
  std::string name;
  bool is_indexed;  ///< it has a range, so that its bits can be selected
  std::vector<unsigned char> drivers;
  std::vector<unsigned char> readers;

  int width() const { return static_cast<int>(drivers.size()); }
};

/// "x[7:4], x[0]": the bits of a net for which `is_wrong` holds.
template <class IsWrong>
std::string wrong_bits(const NetState& net, IsWrong is_wrong) {
  std::string text;
  for (int high = net.width() - 1; high >= 0; --high) {
    if (!is_wrong(high)) continue;
    int low = high;
    while (low > 0 && is_wrong(low - 1)) --low;
    if (!text.empty()) text += ", ";
    if (low == 0 && high == net.width() - 1) return net.name;
    text += high == low ? fmt::format("{}[{}]", net.name, high)
                        : fmt::format("{}[{}:{}]", net.name, high, low);
    high = low;
  }
  return text;
}

/// Walks through one module as if its loops were written out.
class ModuleChecker {
public:
  ModuleChecker(const Module& module, const OutsidePorts& ports_of, std::set<std::string>& faults)
      : module_(module), ports_of_(ports_of), faults_(faults) {}

  void check() {
    scopes_.emplace_back();
    declare_name(module_.name);
    for (const Port& port : module_.ports) {
      NetState& net = declare_net(port.name, port.width, port.vector);
      const bool is_input = port.direction == Direction::input;
      std::fill(net.drivers.begin(), net.drivers.end(), is_input ? 1 : 0);
      std::fill(net.readers.begin(), net.readers.end(), is_input ? 0 : 1);
    }
    check_items(module_.items);
    leave_scope();
  }

private:
  /// The names declared in the module itself, or in one round of a loop.
  struct Scope {
    std::set<std::string> names;
    std::map<std::string, NetState> nets;
  };

  template <class... Words>
  void fault(fmt::format_string<Words...> format, Words&&... words) {
    faults_.insert(module_.name + ": " + fmt::format(format, std::forward<Words>(words)...));
  }

  void declare_name(const std::string& name) {
    const std::string problem = identifier_problem(name);
    if (!problem.empty()) fault("{}: {}", name, problem);
    for (const Scope& scope : scopes_) {
      if (scope.names.contains(name)) fault("{} is declared twice", name);
    }
    scopes_.back().names.insert(name);
  }

  NetState& declare_net(const std::string& name, int width, bool vector = false) {
    declare_name(name);
    if (width < 1) fault("{} has {} bits", name, width);
    const std::vector<unsigned char> none(static_cast<std::size_t>(std::max(width, 1)), 0);
    return scopes_.back().nets[name] = {name, width > 1 || vector, none, none};
  }

  void leave_scope() {
    for (const auto& [name, net] : scopes_.back().nets) check_use(net);
    scopes_.pop_back();
  }

  void check_use(const NetState& net) {
    const auto report = [&](const std::string& bits, const char* what) {
      if (!bits.empty()) fault("{} {}", bits, what);
    };
    report(wrong_bits(net, [&](int k) { return net.drivers[k] == 0; }), "is not driven");
    report(wrong_bits(net, [&](int k) { return net.drivers[k] > 1; }), "is driven twice");
    if (net.name.find("unused") != std::string::npos) return;
    report(wrong_bits(net, [&](int k) { return net.readers[k] == 0; }), "is not read");
  }

  NetState* find(const std::string& name) {
    for (auto scope = scopes_.rbegin(); scope != scopes_.rend(); ++scope) {
      const auto found = scope->nets.find(name);
      if (found != scope->nets.end()) return &found->second;
    }
    fault("{} is used before it is declared", name);
    return nullptr;
  }

  enum class Use { driven, read };

  /// Notes the use of `width` bits of a net, and returns `width`.
  int use(const std::string& name, int low, int width, Use how) {
    NetState* const net = find(name);
    if (net == nullptr) return width;
    if (low < 0 || width < 1 || low + width > net->width()) {
      fault("{}[{}:{}] is outside of its {} bits", name, low + width - 1, low, net->width());
      return width;
    }
    std::vector<unsigned char>& bits = how == Use::driven ? net->drivers : net->readers;
    for (int k = low; k < low + width; ++k) {
      if (bits[k] < 2) ++bits[k];
    }
    return width;
  }

  /// As `use`, for bits that are selected by their numbers: the net must have a range.
  int select(const std::string& name, int low, int width, Use how) {
    const NetState* const net = find(name);
    if (net != nullptr && !net->is_indexed) fault("{} has no range", name);
    return use(name, low, width, how);
  }

  int use(const Operand& operand, Use how) {
    if (operand == nullptr) {
      fault("an operand is missing");
      return 0;
    }
    return std::visit([&](const auto& node) { return use(node, how); }, operand->node);
  }

  int use(const Net& net, Use how) {
    const NetState* const state = find(net.name);
    return state == nullptr ? 0 : use(net.name, 0, state->width(), how);
  }

  int use(const Slice& slice, Use how) {
    return select(slice.name, slice.low, slice.high - slice.low + 1, how);
  }

  int use(const IndexedSlice& slice, Use how) {
    const auto variable = variables_.find(slice.variable);
    if (variable == variables_.end()) {
      fault("{} is used outside of its loop", slice.variable);
      return slice.width;
    }
    return select(slice.name, (variable->second + slice.offset) * slice.width, slice.width, how);
  }

  int use(const Literal& literal, Use how) {
    if ((literal.value & ~low_mask(literal.width)) != 0) {
      fault("a literal has more than {} bits", literal.width);
    }
    return constant(literal.width, how);
  }

  int use(const Zeros& zeros, Use how) { return constant(zeros.width, how); }

  int constant(int width, Use how) {
    if (how == Use::driven) fault("a constant is driven");
    return width;
  }

  int use(const Concatenation& concatenation, Use how) {
    int width = 0;
    for (const Operand& part : concatenation.parts) width += use(part, how);
    return width;
  }

  int use(const Not& node, Use how) { return use(node.operand, only_read(how)); }

  int use(const Or& node, Use how) {
    std::set<int> widths;
    for (const Operand& operand : node.operands) {
      widths.insert(use(operand, only_read(how)));
    }
    if (widths.size() != 1) fault("an OR has operands of {} bits", fmt::join(widths, " and "));
    return widths.empty() ? 0 : *widths.rbegin();
  }

  int use(const AndReduce& node, Use how) {
    use(node.operand, only_read(how));
    return 1;
  }

  Use only_read(Use how) {
    if (how == Use::driven) fault("the result of an operation is driven");
    return Use::read;
  }

  void check_width(const std::string& what, int width, int expected) {
    if (width != expected) fault("{} has {} bits, and gets {}", what, expected, width);
  }

  void check_items(const std::vector<ModuleItem>& items) {
    for (const ModuleItem& item : items) {
      std::visit([&](const auto& each) { check_item(each); }, item);
    }
  }

  void check_item(const Comment&) {}

  void check_item(const Wire& wire) {
    if (wire.value != nullptr) check_width(wire.name, use(wire.value, Use::read), wire.width);
    NetState& net = declare_net(wire.name, wire.width, wire.vector);
    if (wire.value != nullptr) std::fill(net.drivers.begin(), net.drivers.end(), 1);
  }

  void check_item(const Assignment& assignment) {
    const int value = use(assignment.value, Use::read);
    check_width("an assignment", value, use(assignment.target, Use::driven));
  }

  void check_item(const HeldValue& held) {
    check_phase(held.phase);
    declare_register(held.name, held.width);
    check_width(held.name, use(held.value, Use::read), held.width);
  }

  void check_item(const PhaseRegisters& registers) {
    for (const std::string& name : registers.names) declare_register(name, registers.width);
    std::set<Bits> phases;
    for (const PhaseCase& each : registers.cases) {
      check_phase(each.phase);
      const std::string where = fmt::format("{} in phase {}", fmt::join(registers.names, ", "),
                                            static_cast<int>(each.phase.value));
      if (!phases.insert(each.phase.value).second) fault("{} has two cases", where);
      if (each.values.size() != registers.names.size()) {
        fault("{} takes {} values", where, each.values.size());
      }
      for (const Operand& value : each.values) {
        check_width(where, use(value, Use::read), registers.width);
      }
    }
    if (phases.empty()) fault("{} takes no value", fmt::join(registers.names, ", "));
  }

  void check_item(const PhaseFlag& flag) {
    for (const Literal& phase : flag.phases) check_phase(phase);
    if (flag.phases.empty()) fault("{} is 1 in no phase", flag.name);
    NetState& net = declare_net(flag.name, 1);
    net.drivers = {1};
  }

  void check_phase(const Literal& phase) {
    check_width("phase", use(literal(phase.width, phase.value), Use::read),
                use(Net{"phase"}, Use::read));
  }

  void declare_register(const std::string& name, int width) {
    use(Net{"aclk"}, Use::read);
    if (scopes_.front().nets.contains("aresetn")) fault("{} is not reset", name);
    NetState& net = declare_net(name, width);
    std::fill(net.drivers.begin(), net.drivers.end(), 1);
  }

  void check_item(const Instance& instance) {
    declare_name(instance.name);
    const std::string which = fmt::format("{} ({})", instance.name, instance.module);
    const std::vector<Port>* const ports = ports_of(instance, which);
    if (ports == nullptr) return;
    std::set<std::string> connected;
    for (const Connection& connection : instance.connections) {
      const std::string pin = fmt::format("pin {} of {}", connection.port, which);
      if (!connected.insert(connection.port).second) fault("{} is connected twice", pin);
      const auto port = std::find_if(ports->begin(), ports->end(), [&](const Port& each) {
        return each.name == connection.port;
      });
      if (port == ports->end()) {
        fault("{} does not exist", pin);
        continue;
      }
      const Use direction = port->direction == Direction::input ? Use::read : Use::driven;
      check_width(pin, use(connection.value, direction), port->width);
    }
    for (const Port& port : *ports) {
      if (!connected.contains(port.name)) fault("pin {} of {} is not connected", port.name, which);
    }
  }

  /// The ports of an instance's module; null, and a fault, if there is no such module.
  const std::vector<Port>* ports_of(const Instance& instance, const std::string& which) {
    const auto known = ports_.find(&instance);
    if (known != ports_.end()) return &known->second;
    auto ports = ports_of_(instance);
    if (!ports.ok()) {
      fault("{}: {}", which, ports.error().to_string());
      return nullptr;
    }
    return &(ports_[&instance] = *ports);
  }

  void check_item(const std::shared_ptr<const ForGenerate>& loop) {
    // Loops beside each other may share a variable, loops inside each other may not.
    if (variables_.contains(loop->variable)) fault("{} runs in two loops", loop->variable);
    if (loop_variables_.insert(loop->variable).second) declare_name(loop->variable);
    declare_name("g_" + loop->label);
    for (int k = loop->first; k < loop->first + loop->count; ++k) {
      variables_[loop->variable] = k;
      scopes_.emplace_back();
      check_items(loop->items);
      leave_scope();
    }
    variables_.erase(loop->variable);
  }

  const Module& module_;
  const OutsidePorts& ports_of_;
  std::set<std::string>& faults_;
  std::vector<Scope> scopes_;  ///< the innermost last
  std::set<std::string> loop_variables_;
  std::map<std::string, int> variables_;  ///< variables of the loops around, and their values
  std::map<const Instance*, std::vector<Port>> ports_;
};

}  // namespace

std::vector<std::string> faults_of(const std::vector<Module>& modules,
                                   const OutsidePorts& outside) {
  std::set<std::string> faults;
  std::map<std::string, const Module*> by_name;
  for (const Module& module : modules) {
    if (!by_name.emplace(module.name, &module).second) {
      faults.insert(module.name + ": two modules of this name");
    }
  }
  const OutsidePorts ports_of = [&](const Instance& instance) -> Result<std::vector<Port>> {
    const auto found = by_name.find(instance.module);
    if (found == by_name.end()) return outside(instance);
    if (instance.parameters.empty()) return found->second->ports;
    return Error{.message = "the instance sets parameters of a module without any"};
  };
  for (const Module& module : modules) ModuleChecker(module, ports_of, faults).check();
  return {faults.begin(), faults.end()};
}

CheckedModules::CheckedModules(std::vector<Module> modules, const OutsidePorts& outside)
    : modules_(std::move(modules)) {
  const std::vector<std::string> faults = faults_of(modules_, outside);
  if (faults.empty()) return;
  fail_check(fmt::format("{}", fmt::join(faults, "\n")).c_str(), __FILE__, __LINE__);
}

}  // namespace mixcmp::rtl
