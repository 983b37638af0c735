#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/hardware/emit/constants.hpp"
#include "generator/hardware/rtl/checked_modules.hpp"
#include "model/base/common/result.hpp"

namespace mixcmp::emit {

/// The ports of the template that `instance` names, with the widths that the instance's parameters
/// give them. They are read from the head of the template's Verilog. It is an error if the template
/// or a parameter does not exist, or if a parameter's literal has another width than its
/// declaration.
Result<std::vector<rtl::Port>> template_ports(const rtl::Instance& instance);

/// The value of a parameter of the template that `instance` names: the instance's, or else the
/// default in the head of the template's Verilog. Nullopt if the template does not have the
/// parameter.
///
///     template_parameter({"fp_multiply", "product", {{"PRECISION", 53}}, {}}, "EMBEDDED")  // 1
std::optional<long long> template_parameter(const rtl::Instance& instance, const std::string& name);

/// All parameters of a template, in its order, with the instance's values or else their defaults.
/// The template must exist.
std::vector<rtl::Parameter> template_parameters(const rtl::TemplateInstance& instance);

/// The value of a parameter, that of a literal as well.
long long integer_of(const rtl::Parameter& parameter);
/// Sets all parameters but the words of tables, on which no width depends.
void set_integers(Constants& constants, const std::vector<rtl::Parameter>& parameters);

/// Checks a tree of modules that instantiate each other and templates.
rtl::CheckedModules checked(std::vector<rtl::Module> modules);

}  // namespace mixcmp::emit
