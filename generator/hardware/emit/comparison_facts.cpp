#include "generator/hardware/emit/comparison_facts.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace mixcmp::emit {
namespace {

constexpr std::size_t fact_length = 97;  // characters of a fact behind "// "

/// Puts the items, with commas between them, on as few indented lines as possible.
std::vector<std::string> in_lines(const std::vector<std::string>& items) {
  const std::string indent = "  ";
  std::vector<std::string> lines = {indent};
  for (std::size_t k = 0; k < items.size(); ++k) {
    const std::string item = items[k] + (k + 1 < items.size() ? "," : "");
    if (lines.back().size() + 1 + item.size() > fact_length) lines.push_back(indent);
    lines.back() += (lines.back() == indent ? "" : " ") + item;
  }
  return lines;
}

/// The words for the question of a comparison: "the sign of f - g", or others for several parts.
std::string verdict_of(const design::Design& design) {
  if (design.parts.size() == 1) return "the sign of f - g";
  return fmt::format("that of {} of {} parts, the signs of f[k] - g[k]",
                     to_string(design.reference.combination), design.parts.size());
}

std::string meaning_of(const OperandFormat& kind) {
  if (const FixedFormat* fixed = kind.fixed()) {
    const std::string unit =
        fixed->unit_exponent == 0 ? "" : fmt::format(" times 2^{}", fixed->unit_exponent);
    return fmt::format("an integer from {} to {}{}{}", fixed->smallest().get_str(),
                       fixed->largest().get_str(), unit,
                       fixed->is_signed ? ", in two's complement" : "");
  }
  const FloatFormat& format = *kind.floating();
  const std::string_view special = format.has_infinities() ? "" : "; all ones below the sign: NaN";
  return fmt::format("sign [{}], exponent + {} [{}:{}], fraction [{}:0]{}", format.width() - 1,
                     format.bias(), format.width() - 2, format.fraction_bits(),
                     format.fraction_bits() - 1, special);
}

}  // namespace

std::vector<std::string> formula_facts(const design::Design& design,
                                       const std::string& introduction) {
  if (design.parts.empty()) return {};
  std::vector<std::string> facts = {introduction + verdict_of(design) + ":"};
  for (std::size_t k = 0; k < design.parts.size(); ++k) {
    const std::string index = design.parts.size() == 1 ? "" : fmt::format("[{}]", k);
    facts.push_back(fmt::format("  f{} = {}", index, design.parts[k].f));
    facts.push_back(fmt::format("  g{} = {}", index, design.parts[k].g));
  }
  for (const LetDefinition& let : design.lets) {
    facts.push_back(fmt::format("  let {} = {}", let.name, let.text));
  }
  return facts;
}

std::vector<std::string> layout_facts(const std::vector<std::string>& names,
                                      std::span<const OperandFormat> formats) {
  std::vector<OperandFormat> kinds;
  for (const OperandFormat& format : formats) {
    if (std::find(kinds.begin(), kinds.end(), format) == kinds.end()) kinds.push_back(format);
  }
  std::vector<std::string> fields;
  int low = 0;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const int width = formats[k].width();
    const std::string kind = kinds.size() > 1 ? " " + formats[k].name() : "";
    fields.push_back(fmt::format("{} [{}:{}]{}", names[k], low + width - 1, low, kind));
    low += width;
  }
  std::vector<std::string> facts = in_lines(fields);
  for (const OperandFormat& kind : kinds) {
    facts.push_back(fmt::format("  {}{}: {}.", kinds.size() == 1 ? "each in " : "", kind.name(),
                                meaning_of(kind)));
  }
  return facts;
}

std::string widths_text(std::span<const OperandFormat> formats) {
  const auto narrower = [](const OperandFormat& a, const OperandFormat& b) {
    return a.width() < b.width();
  };
  const auto [least, most] = std::minmax_element(formats.begin(), formats.end(), narrower);
  return least->width() == most->width()
             ? fmt::format("{} bits each", least->width())
             : fmt::format("{} to {} bits each", least->width(), most->width());
}

}  // namespace mixcmp::emit
