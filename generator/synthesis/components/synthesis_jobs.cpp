#include "generator/synthesis/components/synthesis_jobs.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <sstream>

#include "generator/hardware/emit/template_ports.hpp"
#include "generator/hardware/emit/templates.hpp"
#include "generator/hardware/emit/verilog.hpp"
#include "generator/synthesis/components/needed_parts.hpp"
#include "model/base/common/quote.hpp"

namespace mixcmp::components {
namespace {

using characterise::SynthesisJob;

/// A parameter's value as Verilog text.
struct ParameterValue {
  std::string name;
  std::string value;
};

std::vector<ParameterValue> values_of(const rtl::TemplateInstance& instance) {
  std::vector<ParameterValue> values;
  for (const rtl::Parameter& parameter : instance.parameters) {
    values.push_back({parameter.name, emit::to_verilog(parameter)});
  }
  return values;
}

void add_templates(SynthesisJob& job, const std::set<std::string>& modules) {
  const std::vector<std::string> templates = emit::template_closure(modules);
  for (const std::string& name : templates) {
    job.sources.push_back({name + ".v", without_comments(emit::template_text(name))});
  }
  for (const emit::TechnologyCell& cell : emit::technology_cells(templates)) {
    job.sources.push_back(
        {cell.module + ".v." + cell.cells, without_comments(cell.text), cell.cells});
  }
}

constexpr const char* blanks = " \t\n";

/// The place of a parameter's default in a module's text: "parameter [RANGE] NAME = DEFAULT".
std::optional<std::size_t> place_of_default(const std::string& text, const std::string& name) {
  constexpr std::string_view keyword = "parameter";
  const auto skip_blanks = [&](std::size_t at) {
    return std::min(text.find_first_not_of(blanks, at), text.size());
  };
  for (std::size_t at = text.find(keyword); at < text.size(); at = text.find(keyword, at)) {
    at = skip_blanks(at + keyword.size());
    if (text[at] == '[') at = skip_blanks(std::min(text.find(']', at), text.size() - 1) + 1);
    if (text.compare(at, name.size(), name) != 0) continue;
    const std::size_t equals = skip_blanks(at + name.size());
    if (equals < text.size() && text[equals] == '=') return skip_blanks(equals + 1);
  }
  return std::nullopt;
}

/// Replaces a parameter's default in a module's text; false where the text declares no such
/// parameter.
bool set_default(std::string& text, const ParameterValue& value) {
  const std::optional<std::size_t> place = place_of_default(text, value.name);
  if (!place) return false;
  const std::size_t end = std::min(text.find_first_of(",\n)", *place), text.size());
  text.replace(*place, end - *place, value.value);
  return true;
}

Error no_unit(std::string_view received) {
  return {.message = "not a template with its parameters",
          .received = in_quotes(received),
          .accepted = "such as \"fp_compare EXPONENT_BITS=8 PRECISION=24 CUTS=2'b11\""};
}

bool is_word(const std::string& text, std::string_view further) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [&](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           further.find(c) != std::string_view::npos;
  });
}

Result<SynthesisJob> job_of(const std::string& module, const std::vector<ParameterValue>& values) {
  SynthesisJob job{.sources = {}, .top = module};
  add_templates(job, {module});
  const auto top = std::find_if(job.sources.begin(), job.sources.end(),
                                [&](const auto& source) { return source.name == module + ".v"; });
  if (top == job.sources.end()) return no_unit(module);
  for (const ParameterValue& value : values) {
    const bool shaped = is_word(value.name, "_") && is_word(value.value, "'-");
    if (!shaped || !set_default(top->text, value)) return no_unit(module + " " + value.name);
  }
  return job;
}

SynthesisJob job_of_modules(const std::vector<rtl::Module>& modules) {
  const std::vector<std::string> texts = emit::to_verilog(emit::checked(modules));
  SynthesisJob job{.sources = {}, .top = modules.back().name, .needed = needed_parts(modules)};
  std::set<std::string> templates;
  for (const rtl::Module& module : modules) templates.merge(instantiated_modules(module));
  for (const rtl::Module& module : modules) templates.erase(module.name);
  add_templates(job, templates);
  for (std::size_t k = 0; k < modules.size(); ++k) {
    job.sources.push_back({modules[k].name + ".v", without_comments(texts[k])});
  }
  return job;
}

}  // namespace

std::string without_comments(std::string_view verilog) {
  std::string text;
  std::istringstream lines{std::string(verilog)};
  for (std::string line; std::getline(lines, line);) {
    line.resize(std::min(line.find("//"), line.size()));
    line.resize(line.find_last_not_of(" \t") + 1);
    if (!line.empty()) text += line + "\n";
  }
  return text;
}

PreparedJob module_job(const rtl::Module& module) {
  return modules_job({module});
}

PreparedJob modules_job(const std::vector<rtl::Module>& modules) {
  return PreparedJob([modules] { return job_of_modules(modules); });
}

PreparedJob template_job(const rtl::TemplateInstance& instance) {
  return PreparedJob([instance] { return job_of(instance.module, values_of(instance)).value(); });
}

std::string instance_name(const rtl::TemplateInstance& instance) {
  std::string name = instance.module;
  for (const ParameterValue& value : values_of(instance)) {
    name += fmt::format(" {}={}", value.name, value.value);
  }
  return name;
}

Result<SynthesisJob> job_of_instance_name(std::string_view name) {
  std::istringstream words{std::string(name)};
  std::string module;
  words >> module;
  std::vector<ParameterValue> values;
  for (std::string word; words >> word;) {
    const std::size_t equals = std::min(word.find('='), word.size());
    values.push_back({word.substr(0, equals), word.substr(std::min(equals + 1, word.size()))});
  }
  return job_of(module, values);
}

}  // namespace mixcmp::components
