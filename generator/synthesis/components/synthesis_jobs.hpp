#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "generator/hardware/rtl/module.hpp"
#include "generator/synthesis/characterise/synthesis.hpp"

namespace mixcmp::components {

/// A job that is made when it is first asked for: to print RTL takes longer than to schedule it,
/// and predictions need no text.
class PreparedJob {
public:
  explicit PreparedJob(std::function<characterise::SynthesisJob()> make) : make_(std::move(make)) {}

  const characterise::SynthesisJob& get() const {
    if (!made_) made_ = make_();
    return *made_;
  }
  operator const characterise::SynthesisJob&() const { return get(); }

private:
  std::function<characterise::SynthesisJob()> make_;
  mutable std::optional<characterise::SynthesisJob> made_;
};

/// The job that synthesises one module with the templates that it instantiates. Its sources have no
/// comments, so that only the hardware decides their hash.
PreparedJob module_job(const rtl::Module& module);

/// The job that synthesises the last of these modules, which instantiates the others, with their
/// templates.
PreparedJob modules_job(const std::vector<rtl::Module>& modules);

/// The job that synthesises one template, with its parameters' defaults replaced by the instance's
/// values.
PreparedJob template_job(const rtl::TemplateInstance& instance);

/// "fp_add EXPONENT_BITS=8 PRECISION=12 CUTS=9'h01f": all that template_job needs.
std::string instance_name(const rtl::TemplateInstance& instance);
/// The template_job of an instance_name; an error where the template or a parameter does not exist.
Result<characterise::SynthesisJob> job_of_instance_name(std::string_view name);

/// Verilog without `//` comments, blanks at line ends and empty lines.
std::string without_comments(std::string_view verilog);

}  // namespace mixcmp::components
