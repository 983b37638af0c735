#pragma once

#include <string>
#include <string_view>

#include "generator/hardware/rtl/module.hpp"
#include "generator/synthesis/characterise/synthesis.hpp"

namespace mixcmp::components {

/// The job that synthesises one module with the templates that it instantiates. Its sources have no
/// comments, so that only the hardware decides their hash.
characterise::SynthesisJob module_job(const rtl::Module& module);

/// The job that synthesises the last of these modules, which instantiates the others, with their
/// templates.
characterise::SynthesisJob modules_job(const std::vector<rtl::Module>& modules);

/// The job that synthesises one template, with its parameters' defaults replaced by the instance's
/// values.
characterise::SynthesisJob template_job(const rtl::TemplateInstance& instance);

/// The template and all that it instantiates, without comments, with the cells of each family.
std::vector<characterise::SourceText> template_sources(const std::string& module);

/// "fp_add EXPONENT_BITS=8 PRECISION=12 CUTS=9'h01f": all that template_job needs.
std::string instance_name(const rtl::TemplateInstance& instance);
/// The instance of an instance_name; an error where the template or a parameter does not exist.
Result<rtl::TemplateInstance> instance_of_name(std::string_view name);

/// Verilog without `//` comments, blanks at line ends and empty lines.
std::string without_comments(std::string_view verilog);

}  // namespace mixcmp::components
