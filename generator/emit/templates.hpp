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

bool is_template(const std::string& module);

/// The text of a template with `prefix` in front of its own name and of every other template's.
std::string prefixed_template(const std::string& module, const std::string& prefix);

}  // namespace mixcmp::emit
