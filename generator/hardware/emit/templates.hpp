#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace mixcmp::emit {

/// The Verilog of a hand-written module of rtl_templates/; the module must exist.
std::string_view template_text(const std::string& module);

/// The templates among `modules` and every template that they instantiate, directly or indirectly,
/// in alphabetical order.
std::vector<std::string> template_closure(const std::set<std::string>& modules);

/// Devices of the family `cells` take `text` in place of the template `module`.
struct TechnologyCell {
  std::string module;
  std::string cells;
  std::string text;
};

/// The cells for templates among `modules`, of all families (rtl_templates/technology).
std::vector<TechnologyCell> technology_cells(const std::vector<std::string>& modules);

bool is_template(const std::string& module);

/// The text of a template or a cell with `prefix` in front of the names of all templates.
std::string with_prefix(std::string_view text, const std::string& prefix);

}  // namespace mixcmp::emit
