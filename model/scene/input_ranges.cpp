#include "model/scene/input_ranges.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "model/base/common/nearest.hpp"
#include "model/base/number/dyadic.hpp"
#include "model/base/number/exact.hpp"
#include "model/base/settings/section.hpp"
#include "model/comparison/expression/name.hpp"
#include "model/comparison/expression/text.hpp"

namespace mixcmp::scene {
namespace {

bool is_pattern(const std::string& key) {
  return key.find('*') != std::string::npos;
}

struct InputDeclaration {
  std::optional<Range> range;  ///< none: from the data, or undeclared beside a format
  std::optional<mpq_class> grid;
  std::optional<OperandFormat> format = {};
  bool is_from_data = false;
};

Result<OperandFormat> read_format(settings::Section& section) {
  const settings::Setting& setting = *section.find("format");
  const auto* word = std::get_if<std::string>(&setting.value);
  Result<OperandFormat> format = OperandFormat::parse(word == nullptr ? "" : *word);
  if (format.ok()) return format;
  return section.mistake("format", format.error().message, setting.shown(),
                         format.error().accepted);
}

/// Reads the rest of an input in fixed point. Its range and its grid are those of the format.
Result<InputDeclaration> read_fixed(settings::Section& section, const OperandFormat& format) {
  for (const char* key : {"range", "grid"}) {
    const settings::Setting* other = section.find(key);
    if (other == nullptr) continue;
    return section.mistake(key, "it follows from the input's format", other->shown(),
                           "no such key beside format");
  }
  if (const auto error = section.finish()) return *error;
  const FixedFormat& fixed = *format.fixed();
  return InputDeclaration{.range = Range{.low = fixed.smallest() * fixed.unit(),
                                         .high = fixed.largest() * fixed.unit()},
                          .grid = fixed.unit(),
                          .format = format};
}

/// Whether some finite number of the format lies between the ends.
bool has_number_in(FloatFormat format, const mpq_class& low, const mpq_class& high) {
  if (low <= 0 && high >= 0) return true;
  const Bits least = from_rational_up(format, low > 0 ? low : mpq_class(-high));
  return format.is_finite(least) &&
         to_rational(format, least) <= (low > 0 ? high : mpq_class(-low));
}

/// Reads the range of an input, which may lack one if it has a format, and its grid.
Result<InputDeclaration> read_range(settings::Section& section,
                                    const std::optional<OperandFormat>& format) {
  if (!format) section.require("range");
  const settings::Setting* range = section.find("range");
  std::optional<mpq_class> grid;
  section.exact("grid", grid);
  if (grid && !is_power_of_two(*grid)) {
    section.fail("grid", "not a power of two", to_text(*grid), "1, 0.25, \"0x1p-10\", ...");
  }
  if (grid && range == nullptr) {
    section.fail("grid", "a grid without a range", to_text(*grid), "a range beside it");
  }
  if (const auto error = section.finish()) return *error;
  if (range == nullptr) {
    return InputDeclaration{.range = std::nullopt, .grid = std::nullopt, .format = format};
  }
  if (const auto* word = std::get_if<std::string>(&range->value); word && *word == "data") {
    return InputDeclaration{
        .range = std::nullopt, .grid = grid, .format = format, .is_from_data = true};
  }
  const std::string ranges = "[low, high], low <= high, or \"data\"";
  const auto wrong = [&](std::string message, std::string received) {
    return section.mistake("range", std::move(message), std::move(received), ranges);
  };
  const auto* bounds = std::get_if<settings::Setting::Array>(&range->value);
  if (bounds == nullptr || bounds->size() != 2) return wrong("not a range", range->shown());
  const auto low = settings::exact_value((*bounds)[0]);
  const auto high = settings::exact_value((*bounds)[1]);
  if (!low || !high) {
    const settings::Setting& end = !low ? bounds->front() : bounds->back();
    return section.mistake(
        "range", fmt::format("the {} end {}", !low ? "low" : "high", settings::exact_problem(end)),
        end.shown(), fmt::format("{}; ends are {}", ranges, settings::accepted_exact_values()));
  }
  if (*low > *high) {
    return wrong("the range is empty", fmt::format("[{}, {}]", to_text(*low), to_text(*high)));
  }
  if (format && !has_number_in(*format->floating(), *low, *high)) {
    return wrong(fmt::format("{} has no number in the range", format->name()),
                 fmt::format("[{}, {}]", to_text(*low), to_text(*high)));
  }
  if (grid && floor_of(*high / *grid) < ceiling_of(*low / *grid)) {
    return section.mistake(
        "grid", "the range has no multiple of it", to_text(*grid),
        fmt::format("a power of two with a multiple in [{}, {}]", to_text(*low), to_text(*high)));
  }
  return InputDeclaration{
      .range = Range{.low = *low, .high = *high}, .grid = grid, .format = format};
}

Result<InputDeclaration> read_input(const settings::Setting& entry) {
  const std::string field = "inputs." + entry.key;
  const std::string accepted =
      "{ range = [low, high] }, low <= high, or { range = \"data\" }, and a grid beside it; or { "
      "format = \"uint10\" }, or { format = \"bfloat16\" } with or without a range";
  if (!std::holds_alternative<settings::Setting::Table>(entry.value)) {
    return settings::mistake_at(entry, field, "wrong type", entry.shown(), accepted);
  }
  settings::Section section(field, entry);
  if (section.find("format") == nullptr) return read_range(section, std::nullopt);
  MIXCMP_TRY(format, read_format(section));
  return format.fixed() != nullptr ? read_fixed(section, format) : read_range(section, format);
}

/// Checks that keys have well-formed subscripts and that no two keys spell the same name. TOML
/// accepts any text as a key and treats "p[2]" and p_2 as different keys.
Result<Done> check_spellings(std::span<const settings::Setting> entries) {
  std::map<std::string, const settings::Setting*> known;
  for (const settings::Setting& entry : entries) {
    const std::string problem = subscript_problem(entry.key);
    if (!problem.empty()) {
      return settings::mistake_at(entry, "inputs." + entry.key, problem,
                                  fmt::format("\"{}\"", entry.key),
                                  std::string(accepted_subscripts()));
    }
    const auto [other, is_new] = known.try_emplace(name_spelling(entry.key), &entry);
    if (is_new) continue;
    return settings::mistake_at(entry, "inputs." + entry.key,
                                fmt::format("the same inputs as \"{}\"", other->second->key),
                                fmt::format("\"{}\"", entry.key), "one key for p[2] and p_2");
  }
  return Done{};
}

/// The entry that declares `input`, if any.
Result<const settings::Setting*> entry_for(std::span<const settings::Setting> entries,
                                           const std::string& input) {
  const settings::Setting* pattern = nullptr;
  for (const settings::Setting& entry : entries) {
    if (name_spelling(entry.key) == input) return &entry;
  }
  for (const settings::Setting& entry : entries) {
    if (!is_pattern(entry.key) || !matches(name_spelling(entry.key), input)) continue;
    if (pattern != nullptr) {
      return settings::mistake_at(entry, "inputs." + entry.key,
                                  fmt::format("two patterns match the input {}", input),
                                  fmt::format("\"{}\" and \"{}\"", pattern->key, entry.key),
                                  fmt::format("one pattern, or the exact key {}", input));
    }
    pattern = &entry;
  }
  return pattern;
}

}  // namespace

bool matches(std::string_view pattern, std::string_view name) {
  std::size_t p = 0, n = 0;
  std::size_t star = std::string_view::npos, resume = 0;
  while (n < name.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      resume = n;
    } else if (p < pattern.size() && pattern[p] == name[n]) {
      ++p, ++n;
    } else if (star != std::string_view::npos) {
      p = star + 1;  // let the last star swallow one more
      n = ++resume;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

Result<InputDeclarations> read_inputs(const settings::Settings& settings,
                                      const std::vector<std::string>& inputs) {
  const settings::Section section(settings, "inputs");
  if (settings.root.find("inputs") != nullptr && !section.present()) return *section.finish();
  MIXCMP_DO(check_spellings(section.entries()));
  for (const settings::Setting& entry : section.entries()) {
    const std::string pattern = name_spelling(entry.key);
    const auto match = [&](const std::string& input) { return matches(pattern, input); };
    if (std::none_of(inputs.begin(), inputs.end(), match)) {
      return settings::mistake_at(entry, "inputs." + entry.key, "matches no input of f and g",
                                  fmt::format("\"{}\"", entry.key),
                                  list_with_nearest(entry.key, inputs));
    }
  }
  InputDeclarations declared;
  std::set<const settings::Setting*> deciding;
  for (const std::string& input : inputs) {
    MIXCMP_TRY(entry, entry_for(section.entries(), input));
    deciding.insert(entry);
    declared.ranges.emplace_back();
    declared.grids.emplace_back();
    declared.formats.emplace_back();
    declared.from_data.push_back(nullptr);
    if (entry == nullptr) continue;
    MIXCMP_TRY(declaration, read_input(*entry));
    declared.ranges.back() = declaration.range;
    declared.grids.back() = declaration.grid;
    declared.formats.back() = declaration.format;
    if (declaration.is_from_data) declared.from_data.back() = entry;
  }
  for (const settings::Setting& entry : section.entries()) {
    if (deciding.contains(&entry)) continue;
    return settings::mistake_at(entry, "inputs." + entry.key,
                                "every input that it matches has a key of its own",
                                fmt::format("\"{}\"", entry.key),
                                "a pattern that decides for some input, or the inputs' own keys");
  }
  return declared;
}

}  // namespace mixcmp::scene
