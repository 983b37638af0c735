#include "generator/hardware/emit/template_ports.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include "generator/hardware/emit/templates.hpp"
#include "model/base/common/cases.hpp"
#include "model/base/common/check.hpp"
#include "model/base/common/memo.hpp"

namespace mixcmp::emit {
namespace {

/// A declaration of a parameter or a port.
struct Declaration {
  Token name;
  Tokens high;   ///< the first end of a range [high:0]; empty: no range
  Tokens value;  ///< a parameter's default
  rtl::Direction direction = rtl::Direction::input;
};

struct Head {
  std::vector<Declaration> parameters;
  std::vector<Declaration> ports;
};

Tokens take_range(Cursor& cursor) {
  if (!cursor.take_if("[")) return {};
  Tokens high = cursor.take_until({":"});
  cursor.expect(":");
  cursor.expect("0");
  cursor.expect("]");
  return high;
}

Declaration take_parameter(Cursor& cursor) {
  cursor.expect("parameter");
  Declaration parameter;
  parameter.high = take_range(cursor);
  parameter.name = cursor.take();
  cursor.expect("=");
  parameter.value = cursor.take_until({",", ")"});
  return parameter;
}

Declaration take_port(Cursor& cursor) {
  Declaration port;
  const Token direction = cursor.take();
  MIXCMP_CHECK(direction == "input" || direction == "output");
  port.direction = direction == "input" ? rtl::Direction::input : rtl::Direction::output;
  if (!cursor.take_if("wire")) cursor.expect("reg");
  port.high = take_range(cursor);
  port.name = cursor.take();
  return port;
}

Head read_head(std::string_view text) {
  Cursor cursor(tokens_of(text, ";"));
  Head head;
  cursor.expect("module");
  cursor.take();
  if (cursor.take_if("#")) {
    cursor.expect("(");
    do head.parameters.push_back(take_parameter(cursor));
    while (cursor.take_if(","));
    cursor.expect(")");
  }
  cursor.expect("(");
  do head.ports.push_back(take_port(cursor));
  while (cursor.take_if(","));
  cursor.expect(")");
  return head;
}

/// The head of a template, cached: area prediction asks for it thousands of times.
const Head& head_of(const std::string& module) {
  static Memo<std::string, Head> known;
  return *known.of(module, [&] { return read_head(template_text(module)); });
}

/// The parameters of a template, with the values of an instance.
Constants constants_of(const Head& head, const std::vector<rtl::Parameter>& given) {
  Constants constants;
  for (const Declaration& each : head.parameters) constants.define(each.name, each.value);
  set_integers(constants, given);
  return constants;
}

/// The declaration of a parameter; null if there is none.
const Declaration* find_parameter(const Head& head, const std::string& name) {
  const auto found = std::find_if(head.parameters.begin(), head.parameters.end(),
                                  [&](const Declaration& each) { return each.name == name; });
  return found == head.parameters.end() ? nullptr : &*found;
}

/// The fault of a parameter that an instance gives; empty if there is none.
std::string fault_of(const rtl::Parameter& given, const Head& head, const Constants& constants) {
  const Declaration* const declared = find_parameter(head, given.name);
  if (declared == nullptr) return "there is no parameter " + given.name;
  if (std::holds_alternative<long long>(given.value) || declared->high.empty()) return "";
  const long long width = constants.value(declared->high) + 1;
  const long long given_width = std::visit(
      Cases{[](long long) { return 0LL; },
            [](const rtl::Literal& literal) { return static_cast<long long>(literal.width); },
            [](const rtl::Words& words) {
              return static_cast<long long>(words.words.size()) * words.width;
            }},
      given.value);
  if (width == given_width) return "";
  return fmt::format("parameter {} has {} bits, and gets {}", given.name, width, given_width);
}

}  // namespace

void set_integers(Constants& constants, const std::vector<rtl::Parameter>& parameters) {
  for (const rtl::Parameter& each : parameters) {
    if (!std::holds_alternative<rtl::Words>(each.value)) constants.set(each.name, integer_of(each));
  }
}

long long integer_of(const rtl::Parameter& parameter) {
  const auto* literal = std::get_if<rtl::Literal>(&parameter.value);
  return literal == nullptr ? std::get<long long>(parameter.value)
                            : static_cast<long long>(literal->value);
}

Result<std::vector<rtl::Port>> template_ports(const rtl::Instance& instance) {
  if (!is_template(instance.module)) return Error{.message = "there is no such module"};
  const Head& head = head_of(instance.module);
  const Constants constants = constants_of(head, instance.parameters);
  for (const rtl::Parameter& given : instance.parameters) {
    const std::string fault = fault_of(given, head, constants);
    if (!fault.empty()) return Error{.message = fault};
  }
  std::vector<rtl::Port> ports;
  for (const Declaration& port : head.ports) {
    const long long width = port.high.empty() ? 1 : constants.value(port.high) + 1;
    ports.push_back(
        {port.direction, static_cast<int>(width), std::string(port.name), !port.high.empty()});
  }
  return ports;
}

std::optional<long long> template_parameter(const rtl::Instance& instance,
                                            const std::string& name) {
  if (!is_template(instance.module)) return std::nullopt;
  const Head& head = head_of(instance.module);
  if (find_parameter(head, name) == nullptr) return std::nullopt;
  return constants_of(head, instance.parameters).value_of(name);
}

std::vector<rtl::Parameter> template_parameters(const rtl::TemplateInstance& instance) {
  const Head& head = head_of(instance.module);
  const Constants constants = constants_of(head, instance.parameters);
  std::vector<rtl::Parameter> parameters;
  for (const Declaration& declared : head.parameters) {
    const auto given =
        std::find_if(instance.parameters.begin(), instance.parameters.end(),
                     [&](const rtl::Parameter& each) { return each.name == declared.name; });
    if (given != instance.parameters.end()) {
      parameters.push_back(*given);
    } else if (declared.high.empty()) {
      parameters.push_back({std::string(declared.name), constants.value_of(declared.name)});
    } else {
      const int width = static_cast<int>(constants.value(declared.high)) + 1;
      const auto bits = static_cast<Bits>(constants.value_of(declared.name));
      parameters.push_back({std::string(declared.name), rtl::Literal{width, bits}});
    }
  }
  return parameters;
}

rtl::CheckedModules checked(std::vector<rtl::Module> modules) {
  return {std::move(modules), template_ports};
}

}  // namespace mixcmp::emit
