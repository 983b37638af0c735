#include "generator/synthesis/components/synthesis_jobs.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <sstream>

#include "generator/hardware/emit/template_ports.hpp"
#include "generator/hardware/emit/templates.hpp"
#include "generator/hardware/emit/verilog.hpp"
#include "generator/synthesis/components/needed_parts.hpp"
#include "model/base/common/check.hpp"
#include "model/base/common/quote.hpp"

namespace mixcmp::components {
namespace {

using characterise::SynthesisJob;

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

/// Replaces a parameter's default in a module's text, which declares the parameter.
void set_default(std::string& text, const rtl::Parameter& parameter) {
  const std::optional<std::size_t> place = place_of_default(text, parameter.name);
  MIXCMP_CHECK(place.has_value());
  const std::size_t end = std::min(text.find_first_of(",\n)", *place), text.size());
  text.replace(*place, end - *place, emit::to_verilog(parameter));
}

Error no_unit(std::string_view received) {
  return {.message = "not a template with its parameters",
          .received = in_quotes(received),
          .accepted = "such as \"fp_compare EXPONENT_BITS=8 PRECISION=24 CUTS=2'b11\""};
}

/// The bits of digits of base 2 or 16; none if another character is among them.
std::optional<Bits> bits_of(std::string_view digits, char base) {
  const int digit_bits = base == 'b' ? 1 : 4;
  Bits bits = 0;
  for (const char c : digits) {
    unsigned digit = 0;
    const auto [end, failed] = std::from_chars(&c, &c + 1, digit, base == 'b' ? 2 : 16);
    if (failed != std::errc()) return std::nullopt;
    bits = (bits << digit_bits) | digit;
  }
  return digits.empty() ? std::nullopt : std::optional(bits);
}

/// A parameter from its text, such as PRECISION=24 or CUTS=2'b11.
std::optional<rtl::Parameter> parameter_of(std::string_view word) {
  const std::size_t equals = std::min(word.find('='), word.size());
  const std::string_view value = word.substr(std::min(equals + 1, word.size()));
  long long number = 0;
  const auto [end, failed] = std::from_chars(value.data(), value.data() + value.size(), number);
  const std::string_view rest = value.substr(static_cast<std::size_t>(end - value.data()));
  if (failed != std::errc()) return std::nullopt;
  std::string name(word.substr(0, equals));
  if (rest.empty()) return rtl::Parameter{std::move(name), number};
  const bool is_literal = rest.starts_with("'b") || rest.starts_with("'h");
  const std::optional<Bits> bits = is_literal ? bits_of(rest.substr(2), rest[1]) : std::nullopt;
  if (!bits || number < 1 || number > 128) return std::nullopt;
  return rtl::Parameter{std::move(name), rtl::Literal{static_cast<int>(number), *bits}};
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

SynthesisJob module_job(const rtl::Module& module) {
  return modules_job({module});
}

SynthesisJob modules_job(const std::vector<rtl::Module>& modules) {
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

std::vector<characterise::SourceText> template_sources(const std::string& module) {
  SynthesisJob job;
  add_templates(job, {module});
  return job.sources;
}

SynthesisJob template_job(const rtl::TemplateInstance& instance) {
  SynthesisJob job{.sources = template_sources(instance.module), .top = instance.module};
  const auto top = std::find_if(job.sources.begin(), job.sources.end(), [&](const auto& source) {
    return source.name == instance.module + ".v";
  });
  for (const rtl::Parameter& parameter : instance.parameters) set_default(top->text, parameter);
  return job;
}

std::string instance_name(const rtl::TemplateInstance& instance) {
  std::string name = instance.module;
  for (const rtl::Parameter& parameter : instance.parameters) {
    name += fmt::format(" {}={}", parameter.name, emit::to_verilog(parameter));
  }
  return name;
}

Result<rtl::TemplateInstance> instance_of_name(std::string_view name) {
  std::istringstream words{std::string(name)};
  rtl::Instance instance;
  words >> instance.module;
  if (!emit::is_template(instance.module)) return no_unit(name);
  for (std::string word; words >> word;) {
    std::optional<rtl::Parameter> parameter = parameter_of(word);
    if (!parameter || !emit::template_parameter(instance, parameter->name)) return no_unit(name);
    instance.parameters.push_back(std::move(*parameter));
  }
  return rtl::TemplateInstance{instance.module, instance.parameters};
}

}  // namespace mixcmp::components
