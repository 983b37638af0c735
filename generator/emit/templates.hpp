#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace mixcmp::gen {

/// The Verilog of a hand-written module of rtl_templates/; the module must exist.
std::string_view template_text(const std::string& module);

/// `modules` and every template they instantiate, directly or not, in alphabetical order. Names
/// that are no templates are left out.
std::vector<std::string> template_closure(const std::set<std::string>& modules);

}  // namespace mixcmp::gen
