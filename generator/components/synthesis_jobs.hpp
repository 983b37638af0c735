#pragma once

#include <string>
#include <string_view>

#include "generator/rtl/system_modules.hpp"
#include "model/characterise/synthesis.hpp"

namespace mixcmp::gen {

/// A module alone with the templates under it. Sources come without comments, so that nothing but
/// hardware is in a hash of them.
model::SynthesisJob module_job(const rtl::Module& module);

/// A template alone: its parameters' defaults are replaced by the instance's values.
model::SynthesisJob template_job(const TemplateInstance& instance);

/// "fp_add EXPONENT_BITS=8 PRECISION=12 CUTS=9'h01f": all that template_job needs.
std::string instance_name(const TemplateInstance& instance);
/// The reverse; an error where the template or a parameter does not exist.
model::Result<model::SynthesisJob> job_of_instance_name(std::string_view name);

/// Verilog without `//` comments, blanks at line ends and empty lines.
std::string without_comments(std::string_view verilog);

}  // namespace mixcmp::gen
