#include "generator/project/vhdl.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>

namespace mixcmp::project {
namespace {

std::string type_of(const VhdlPort& port) {
  return port.is_vector ? fmt::format("std_logic_vector({} downto 0)", port.width - 1)
                        : "std_logic";
}

/// Letters, digits and single underscores between them, with a letter first.
bool is_basic_identifier(const std::string& name) {
  const auto is_letter_or_digit = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0;
  };
  if (name.empty() || std::isalpha(static_cast<unsigned char>(name.front())) == 0) return false;
  if (name.back() == '_' || name.find("__") != std::string::npos) return false;
  return std::all_of(name.begin(), name.end(),
                     [&](char c) { return c == '_' || is_letter_or_digit(c); });
}

}  // namespace

std::string vhdl_name(const std::string& name) {
  return is_basic_identifier(name) ? name : "\\" + name + "\\";
}

std::string vhdl_component(const std::string& module, const std::vector<VhdlPort>& ports) {
  std::size_t longest = 0;
  for (const VhdlPort& port : ports) longest = std::max(longest, vhdl_name(port.name).size());
  std::string text = fmt::format("  component {} is\n    port (\n", vhdl_name(module));
  for (const VhdlPort& port : ports) {
    text +=
        fmt::format("      {:<{}} : {:<3} {}{}\n", vhdl_name(port.name), longest,
                    port.is_input ? "in" : "out", type_of(port), &port == &ports.back() ? "" : ";");
  }
  return text + "    );\n  end component;\n";
}

}  // namespace mixcmp::project
