#include "generator/hardware/emit/verilog.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>
#include <utility>

#include "generator/hardware/emit/templates.hpp"
#include "model/base/common/cases.hpp"
#include "model/base/common/check.hpp"

namespace mixcmp::emit {
namespace {

using namespace rtl;

constexpr std::size_t line_length = 100;

std::string print(const Literal& literal) {
  MIXCMP_CHECK((literal.value & ~low_mask(literal.width)) == 0);
  const bool short_binary = literal.width <= 8;
  if (!short_binary) {
    return fmt::format("{}'h{}", literal.width, to_hex(literal.value, literal.width));
  }
  std::string digits;
  for (int k = literal.width - 1; k >= 0; --k) digits += (literal.value >> k & 1) != 0 ? '1' : '0';
  return fmt::format("{}'b{}", literal.width, digits);
}

std::string print(const Operand& operand);

std::string print_all(const std::vector<Operand>& operands, std::string_view separator) {
  std::vector<std::string> texts;
  for (const Operand& operand : operands) texts.push_back(print(operand));
  return fmt::format("{}", fmt::join(texts, separator));
}

std::string print(const Operand& operand) {
  MIXCMP_CHECK(operand != nullptr);
  return std::visit(Cases{
                        [](const Net& n) { return n.name; },
                        [](const IndexedSlice& s) {
                          const std::string sum = fmt::format("{} + {}", s.offset, s.variable);
                          const std::string index = s.offset == 0 ? s.variable : sum;
                          if (s.width == 1) return fmt::format("{}[{}]", s.name, index);
                          return fmt::format("{}[{} * {} +: {}]", s.name,
                                             s.offset == 0 ? index : "(" + index + ")", s.width,
                                             s.width);
                        },
                        [](const Slice& s) {
                          if (s.high == s.low) return fmt::format("{}[{}]", s.name, s.high);
                          return fmt::format("{}[{}:{}]", s.name, s.high, s.low);
                        },
                        [](const Literal& l) { return print(l); },
                        [](const Zeros& z) {
                          return z.width == 1 ? "1'b0" : fmt::format("{{{}{{1'b0}}}}", z.width);
                        },
                        [](const Concatenation& c) { return "{" + print_all(c.parts, ", ") + "}"; },
                        [](const Not& n) { return "~" + print(n.operand); },
                        [](const Or& o) { return print_all(o.operands, " | "); },
                        [](const AndReduce& a) { return "&" + print(a.operand); },
                    },
                    operand->node);
}

std::string range(int width, bool vector) {
  return width == 1 && !vector ? "" : fmt::format("[{}:0]", width - 1);
}

/// One of several lines ".name(value)" whose values stand in one column.
struct Argument {
  std::string name;
  std::string value;
};

std::string argument_list(const std::string& indent, const std::vector<Argument>& arguments) {
  std::size_t name_width = 0;
  for (const Argument& argument : arguments) {
    name_width = std::max(name_width, argument.name.size());
  }
  std::vector<std::string> lines;
  for (const Argument& argument : arguments) {
    lines.push_back(fmt::format(".{:<{}}({})", argument.name, name_width, argument.value));
  }
  return fmt::format("(\n{0}  {1}\n{0})", indent, fmt::join(lines, fmt::format(",\n{}  ", indent)));
}

/// Words in hexadecimal, that of the last address first, on lines of their own.
std::string print(const Words& words, const std::string& next_line) {
  std::string text = "{", line;
  for (std::size_t address = words.words.size(); address-- > 0;) {
    const std::string word =
        fmt::format("{}'h{}", words.width, to_hex(words.words[address], words.width));
    if (next_line.size() + line.size() + word.size() + 3 > line_length) {
      text += next_line + line;
      line.clear();
    }
    line += line.empty() ? word : " " + word;
    if (address > 0) line += ",";
  }
  return text + next_line + line + "}";
}

std::string print(const Parameter& parameter, const std::string& next_line) {
  return std::visit(Cases{[](long long number) { return fmt::format("{}", number); },
                          [](const Literal& literal) { return print(literal); },
                          [&](const Words& words) { return print(words, next_line); }},
                    parameter.value);
}

std::string print(const Instance& instance, const std::string& indent) {
  std::string text = indent + instance.module;
  std::vector<Argument> parameters;
  for (const Parameter& parameter : instance.parameters) {
    parameters.push_back({parameter.name, print(parameter, "\n" + indent + "    ")});
  }
  if (!parameters.empty()) text += " #" + argument_list(indent, parameters);
  std::vector<Argument> connections;
  for (const Connection& connection : instance.connections) {
    connections.push_back({connection.port, print(connection.value)});
  }
  return text + " " + instance.name + " " + argument_list(indent, connections) + ";\n";
}

/// Prints one wire. `range_width`: characters of the longest range among its neighbours, by which
/// their names are aligned.
std::string print(const Wire& wire, std::size_t range_width, const std::string& indent) {
  const std::string declared =
      fmt::format("{}wire {:<{}}{}{}", indent, range(wire.width, wire.vector), range_width,
                  range_width == 0 ? "" : " ", wire.name);
  if (wire.value == nullptr) return declared + ";\n";
  const std::string value = print(wire.value);
  if (declared.size() + value.size() + 4 <= line_length) {
    return fmt::format("{} = {};\n", declared, value);
  }
  const std::string next_line = "\n" + indent + "    ";
  const auto* any = std::get_if<Or>(&wire.value->node);
  const bool fits_alone = next_line.size() + value.size() <= line_length;
  return fmt::format(
      "{} ={}{};\n", declared, next_line,
      any == nullptr || fits_alone ? value : print_all(any->operands, next_line + "| "));
}

/// Prints one assignment. A concatenation that does not fit on the line follows below, with as many
/// parts on each line as fit.
std::string print(const Assignment& assignment, const std::string& indent) {
  const std::string target = fmt::format("{}assign {} =", indent, print(assignment.target));
  const std::string value = print(assignment.value);
  const auto* parts = std::get_if<Concatenation>(&assignment.value->node);
  if (parts == nullptr || target.size() + value.size() + 2 <= line_length) {
    return fmt::format("{} {};\n", target, value);
  }
  const std::string next_line = "\n" + indent + "     ";
  std::string text = target;
  std::string line = next_line.substr(0, next_line.size() - 1) + "{";
  for (std::size_t k = 0; k < parts->parts.size(); ++k) {
    const bool last = k + 1 == parts->parts.size();
    const std::string part = print(parts->parts[k]) + (last ? "};" : ",");
    if (k > 0 && line.size() + part.size() > line_length) {
      text += line;
      line = next_line;
    } else if (k > 0) {
      line += ' ';
    }
    line += part;
  }
  return text + line + "\n";
}

std::string print_phase(const Literal& phase) {
  return fmt::format("{}'d{}", phase.width, static_cast<int>(phase.value));
}

std::string declare_register(int width, const std::string& name, const std::string& indent) {
  return fmt::format("{}reg {}{}{};\n", indent, range(width, false), width == 1 ? "" : " ", name);
}

std::string print(const HeldValue& held, const std::string& indent) {
  return declare_register(held.width, held.name, indent) +
         fmt::format(
             "\n{0}always @(posedge aclk) begin\n{0}  if (phase == {1}) begin\n"
             "{0}    {2} <= {3};\n{0}  end\n{0}end\n",
             indent, print_phase(held.phase), held.name, print(held.value));
}

std::string print(const PhaseRegisters& registers, const std::string& indent) {
  std::string text;
  for (const std::string& name : registers.names) {
    text += declare_register(registers.width, name, indent);
  }
  text += fmt::format("\n{0}always @(posedge aclk) begin\n{0}  case (phase)\n", indent);
  for (const PhaseCase& phase_case : registers.cases) {
    const bool last = &phase_case == &registers.cases.back();
    text += fmt::format(
        "{}    {}: begin  // {}{}\n", indent, last ? "default" : print_phase(phase_case.phase),
        last ? "phase " + std::to_string(static_cast<int>(phase_case.phase.value)) + ": " : "",
        phase_case.comment);
    for (std::size_t k = 0; k < registers.names.size(); ++k) {
      text += fmt::format("{}      {} <= {};\n", indent, registers.names[k],
                          print(phase_case.values[k]));
    }
    text += indent + "    end\n";
  }
  return text + fmt::format("{0}  endcase\n{0}end\n", indent);
}

std::string print(const PhaseFlag& flag, const std::string& indent) {
  std::vector<std::string> phases;
  for (const Literal& phase : flag.phases) {
    phases.push_back(fmt::format("(phase == {})", print_phase(phase)));
  }
  const std::string declared = fmt::format("{}wire {} =", indent, flag.name);
  const std::string line = fmt::format("{} {};\n", declared, fmt::join(phases, " || "));
  if (line.size() <= line_length) return line;
  const std::string next_line = "\n" + indent + "    ";
  return fmt::format("{}{}{};\n", declared, next_line, fmt::join(phases, next_line + "|| "));
}

std::string print_items(const std::vector<ModuleItem>& items, const std::string& indent);

std::string print(const ForGenerate& loop, const std::string& indent) {
  return fmt::format(
      "{0}generate\n"
      "{0}  for ({1} = {2}; {1} < {3}; {1} = {1} + 1) begin : g_{4}\n{5}{0}  end\n{0}endgenerate\n",
      indent, loop.variable, loop.first, loop.first + loop.count, loop.label,
      print_items(loop.items, indent + "    "));
}

const ForGenerate* as_loop(const ModuleItem& item) {
  const auto* loop = std::get_if<std::shared_ptr<const ForGenerate>>(&item);
  return loop == nullptr ? nullptr : loop->get();
}

/// The genvar declaration in front of item `k`, if it is the first loop over its variable.
std::string declaration(const std::vector<ModuleItem>& items, std::size_t k,
                        const std::string& indent) {
  const ForGenerate* loop = as_loop(items[k]);
  if (loop == nullptr) return "";
  const bool declared = std::any_of(items.begin(), items.begin() + static_cast<long>(k),
                                    [&](const ModuleItem& earlier) {
                                      const ForGenerate* other = as_loop(earlier);
                                      return other != nullptr && other->variable == loop->variable;
                                    });
  return declared ? "" : fmt::format("{}genvar {};\n", indent, loop->variable);
}

/// Prints a comment. The text is broken between words if a line would get too long.
std::string print(const Comment& comment, const std::string& indent) {
  const std::string start = "\n" + indent + "//";
  std::string lines, line = start;
  std::istringstream words(comment.text);
  for (std::string word; words >> word;) {
    if (line.size() + word.size() > line_length) {  // the line feed stands for the space
      lines += std::exchange(line, start);
    }
    line += " " + word;
  }
  return lines + line + "\n";
}

std::string print(const ModuleItem& item, std::size_t range_width, const std::string& indent) {
  return std::visit(
      Cases{
          [&](const Comment& c) { return print(c, indent); },
          [&](const Wire& w) { return print(w, range_width, indent); },
          [&](const Assignment& a) { return print(a, indent); },
          [&](const Instance& i) { return "\n" + print(i, indent); },
          [&](const HeldValue& h) { return print(h, indent); },
          [&](const PhaseRegisters& r) { return print(r, indent); },
          [&](const PhaseFlag& f) { return print(f, indent); },
          [&](const std::shared_ptr<const ForGenerate>& loop) { return print(*loop, indent); },
      },
      item);
}

/// Characters of the longest range in the run of wires that starts at `first`; 0 if item `first` is
/// no wire.
std::size_t range_width_of_run(const std::vector<ModuleItem>& items, std::size_t first) {
  std::size_t widest = 0;
  for (std::size_t k = first; k < items.size(); ++k) {
    const auto* wire = std::get_if<Wire>(&items[k]);
    if (wire == nullptr) break;
    widest = std::max(widest, range(wire->width, wire->vector).size());
  }
  return widest;
}

/// Tells whether an item is an instance or a loop, which a blank line separates from the next item.
bool is_block(const ModuleItem& item) {
  return !std::holds_alternative<Wire>(item) && !std::holds_alternative<Comment>(item) &&
         !std::holds_alternative<Assignment>(item);
}

/// Comments and blocks bring their own blank line, which neither the first item of a loop nor a
/// block behind its comment needs.
std::string print_items(const std::vector<ModuleItem>& items, const std::string& indent) {
  std::string text;
  std::size_t range_width = 0;
  for (std::size_t k = 0; k < items.size(); ++k) {
    const bool run_goes_on = k > 0 && std::holds_alternative<Wire>(items[k - 1]);
    if (!run_goes_on) range_width = range_width_of_run(items, k);
    std::string printed = print(items[k], range_width, indent);
    if (as_loop(items[k]) != nullptr) printed = "\n" + declaration(items, k, indent) + printed;
    const bool has_gap = printed.starts_with('\n');
    const bool first_in_loop = k == 0 && indent.size() > 2;
    const bool is_told = k > 0 && std::holds_alternative<Comment>(items[k - 1]) &&
                         !std::holds_alternative<Comment>(items[k]);
    if (!has_gap && k > 0 && is_block(items[k - 1])) text += '\n';
    text += printed.substr((first_in_loop || is_told) && has_gap ? 1 : 0);
  }
  return text;
}

std::string print_ports(const std::vector<Port>& ports) {
  std::size_t range_width = 0;
  for (const Port& port : ports) {
    range_width = std::max(range_width, range(port.width, port.vector).size());
  }
  std::vector<std::string> lines;
  for (const Port& port : ports) {
    lines.push_back(fmt::format(
        "{} wire {:<{}}{}{}", port.direction == Direction::input ? "input " : "output",
        range(port.width, port.vector), range_width, range_width == 0 ? "" : " ", port.name));
  }
  return fmt::format("{}", fmt::join(lines, ",\n  "));
}

std::string print(const std::string& module, const std::vector<Port>& ports,
                  const std::vector<ModuleItem>& items) {
  std::string text = "\n`default_nettype none\n\n";
  text += fmt::format("module {} (\n  {}\n);\n", module, print_ports(ports));
  const std::string body = print_items(items, "  ");
  if (!body.starts_with('\n')) text += '\n';
  return text + body + "\nendmodule\n\n`default_nettype wire\n";
}

}  // namespace

std::string to_verilog(const Parameter& parameter) {
  return print(parameter, " ");
}

std::string to_comment(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line.empty() ? "//\n" : "// " + line + "\n";
  return text;
}

std::vector<std::string> to_verilog(const CheckedModules& modules, const std::string& prefix) {
  const auto new_name = [&](const std::string& name) {
    return is_template(name) ? prefix + name : name;
  };
  std::vector<std::string> texts;
  for (const Module& module : modules.modules()) {
    texts.push_back(
        print(module.name, module.ports,
              prefix.empty() ? module.items : with_modules_renamed(module.items, new_name)));
  }
  return texts;
}

}  // namespace mixcmp::emit
