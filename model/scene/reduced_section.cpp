#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "model/base/settings/section.hpp"
#include "model/comparison/expression/text.hpp"
#include "model/scene/sections.hpp"

namespace mixcmp::scene {
namespace {

/// The number in a word that consists of a letter and a number: 17 for "s17".
std::optional<int> number_after(char letter, const std::string& word) {
  const bool shaped = word.size() >= 2 && word.size() <= 4 && word[0] == letter &&
                      word.find_first_not_of("0123456789", 1) == std::string::npos;
  return shaped ? std::optional(std::stoi(word.substr(1))) : std::nullopt;
}

std::string accepted_lane_formats(FloatFormat reference) {
  const settings::Limits precisions = settings::lane_precisions(reference);
  const bool narrowed = precisions.most < settings::limits::lane_precision.most;
  return fmt::format(
      "\"auto\", \"exact\", sP or {}{}; qW or blockW with W {}, likewise W + G of qWgG and "
      "blockWgG",
      FloatFormat::accepted(precisions.least, precisions.most),
      narrowed ? "; P at most the reference's" : "",
      to_string(settings::lane_fixed_bits(reference)));
}

void read_reduced_format(settings::Section& section, FloatFormat reference, ReducedSpec& spec) {
  const settings::Setting* setting = section.find("format");
  if (setting == nullptr) return;
  spec.format.reset();
  spec.fixed_point.reset();
  spec.exponent_bits_from_ranges = false;
  spec.is_exact = false;
  const settings::Limits allowed = settings::lane_precisions(reference);
  const std::string accepted = accepted_lane_formats(reference);
  const auto* word = std::get_if<std::string>(&setting->value);
  if (word != nullptr && *word == "auto") return;
  if (word != nullptr && *word == "exact") {
    spec.is_exact = true;
    return;
  }
  if (word != nullptr) spec.fixed_point = FixedPoint::parse(*word);
  if (spec.fixed_point) {
    if (allow(settings::lane_fixed_bits(reference), *spec.fixed_point)) return;
    spec.fixed_point.reset();
    return section.fail("format", "bits out of range", setting->shown(), accepted);
  }
  const std::optional<int> precision = word == nullptr ? std::nullopt : number_after('s', *word);
  if (!precision) return section.format("format", spec.format, allowed, accepted);
  if (!allowed.allow(*precision)) {
    return section.fail("format", "precision out of range", setting->shown(), accepted);
  }
  spec.format = FloatFormat::make(*precision, reference.exponent_bits()).value();
  spec.exponent_bits_from_ranges = true;
}

void read_relative_error(settings::Section& section, const std::string& key,
                         std::optional<mpq_class>& target) {
  section.exact(key, target);
  if (target && (*target < 0 || *target >= 1)) {
    section.fail(key, "out of range", to_text(*target), "a number of at least 0 and below 1");
  }
}

/// Refuses a memory for squares of significands: these are rounded, and most are too wide for a
/// table.
void check_multipliers(settings::Section& section, const ReducedSpec& spec) {
  if (spec.multipliers != Multipliers::memory || !spec.format) return;
  section.fail("multipliers", "only lanes in fixed point read squares from memories",
               fmt::format("\"memory\" in {}", spec.format_name()),
               "embedded or logic, or a format such as q11 or block11");
}

/// The limits for the digits of a lane's inputs: at least those of the lane or, if the format is
/// "auto", of any possible lane.
settings::Limits input_digits(FloatFormat reference, const ReducedSpec& spec) {
  const int least = spec.format ? spec.format->precision() : settings::limits::lane_precision.least;
  return {least, reference.precision()};
}

/// Reads how operands enter: a word or a number of digits. A number in [reduced] must be valid for
/// each of [[lanes]] that has none of its own. Fixed point ignores it.
void read_lane_inputs(settings::Section& section, FloatFormat reference, ReducedSpec& spec) {
  const settings::Setting* setting = section.find("inputs");
  const settings::Limits digits = input_digits(reference, spec);
  const std::string accepted =
      fmt::format("\"exact\", \"rounded\", or an integer {}{}", to_string(digits),
                  spec.format ? ", from the lane's digits to the reference's" : "");
  if (setting == nullptr) {
    const std::optional<int> inherited = spec.inputs.number();
    if (!inherited || spec.fixed_point || digits.allow(*inherited)) return;
    return section.fail("inputs", "digits out of range", to_string(spec.inputs), accepted);
  }
  if (const auto* number = std::get_if<std::int64_t>(&setting->value)) {
    const bool allowed = digits.least <= *number && *number <= digits.most;
    if (!allowed) return section.fail("inputs", "digits out of range", setting->shown(), accepted);
    spec.inputs = LaneInputs::of_digits(static_cast<int>(*number));
    return;
  }
  const auto* word = std::get_if<std::string>(&setting->value);
  for (const LaneInputs inputs : {LaneInputs::rounded, LaneInputs::exact}) {
    if (word == nullptr || *word != to_string(inputs)) continue;
    spec.inputs = inputs;
    return;
  }
  section.fail("inputs", "not a choice", setting->shown(), accepted);
}

/// Reads the keys of [reduced] except `format`, which `spec` already has. An absent key leaves its
/// value unchanged.
void read_keys_but_format(settings::Section& section, FloatFormat reference, ReducedSpec& spec) {
  section.choice("bound", spec.is_profiled, {{"certified", false}, {"profiled", true}});
  section.choice("error_bound", spec.error_bound,
                 {{"auto", std::nullopt},
                  {"relative", BoundKind::relative},
                  {"running", BoundKind::running},
                  {"constant", BoundKind::constant},
                  {"norm", BoundKind::norm},
                  {"grid", BoundKind::grid}});
  section.integer("bound_digits", spec.bound_digits, settings::limits::bound_digits);
  read_lane_inputs(section, reference, spec);
  section.choice("rounding", spec.rounding, {Rounding::nearest_even, Rounding::toward_zero});
  section.choice("subnormals", spec.subnormals, {Subnormals::flush, Subnormals::gradual});
  section.choice("multipliers", spec.multipliers,
                 {Multipliers::embedded, Multipliers::logic, Multipliers::memory});
  check_multipliers(section, spec);
  read_relative_error(section, "relative_error_f", spec.relative_error_f);
  read_relative_error(section, "relative_error_g", spec.relative_error_g);
}

/// Reads every key of [reduced]. An absent key leaves its value unchanged.
void read_lane_keys(settings::Section& section, FloatFormat reference, ReducedSpec& spec) {
  read_reduced_format(section, reference, spec);
  read_keys_but_format(section, reference, spec);
}

/// Reads the format of a second tier: fixed point, or "none" for no second tier.
void read_second_tier_format(settings::Section& section, FloatFormat reference, ReducedSpec& spec) {
  section.require("format");
  const settings::Setting* setting = section.find("format");
  if (setting == nullptr) return;
  const settings::Limits bits = settings::lane_fixed_bits(reference);
  const auto* word = std::get_if<std::string>(&setting->value);
  if (word != nullptr && *word == "none") return;
  if (word != nullptr) spec.fixed_point = FixedPoint::parse(*word);
  if (spec.fixed_point && !spec.fixed_point->is_block && allow(bits, *spec.fixed_point)) return;
  section.fail("format", "a second tier is a lane in fixed point, or none", setting->shown(),
               fmt::format("\"none\", or qW with W {}, likewise W + G of qWgG", to_string(bits)));
}

/// Reads the number of a second tier's lanes. In an engine, each group of lanes has its own.
void read_second_tier_count(settings::Section& section, EngineKind engine,
                            std::optional<int>& count) {
  const settings::Setting* setting = section.find("count");
  if (engine == EngineKind::none) {
    if (setting != nullptr) return section.integer_or_auto("count", count, settings::limits::lanes);
    return section.fail(
        "count", "missing: how many lanes the second tier has", "no such key",
        to_string(settings::limits::lanes) + ", \"auto\", or second_tier.format = \"none\"");
  }
  if (setting == nullptr) return;
  section.fail("count", "an engine's second tier has a lane for each group", setting->shown(),
               "no such key, or engine.kind = \"none\"");
}

/// The tables of [[name]]; an error if system.name also gives their number.
Result<std::span<const settings::Setting>> read_groups(const settings::Settings& settings,
                                                       const std::string& name) {
  MIXCMP_TRY(groups, tables_of(settings, name, "one table for each kind"));
  if (groups.empty()) return groups;
  settings::Section system(settings, "system");
  if (const settings::Setting* count = system.find(name)) {
    return settings::mistake_at(*count, "system." + name, fmt::format("given beside [[{}]]", name),
                                count->shown(), "one of the two");
  }
  return groups;
}

void read_count(settings::Section& section, std::optional<int>& count, int& total, int most) {
  section.require("count");
  int value = 0;
  section.integer("count", value, 1, most);
  count = value;
  total += value;
  if (total <= most) return;
  section.fail("count", "too many in all", fmt::format("{}", total),
               fmt::format("at most {} in all", most));
}

}  // namespace

Result<ReducedSpec> read_reduced(const settings::Settings& settings, FloatFormat reference) {
  ReducedSpec spec;
  settings::Section section(settings, "reduced");
  read_lane_keys(section, reference, spec);
  if (const auto error = section.finish()) return *error;
  return spec;
}

Result<std::vector<LaneGroupSpec>> read_lane_groups(const settings::Settings& settings,
                                                    FloatFormat reference,
                                                    const ReducedSpec& defaults) {
  MIXCMP_TRY(tables, read_groups(settings, "lanes"));
  std::vector<LaneGroupSpec> groups;
  int total = 0;
  for (const settings::Setting& table : tables) {
    LaneGroupSpec& group = groups.emplace_back(LaneGroupSpec{
        .count = {}, .reduced = defaults, .place = {settings::file_of(table), table.line}});
    settings::Section section("lanes", table);
    read_count(section, group.count, total, lane_limits(settings).most);
    read_lane_keys(section, reference, group.reduced);
    if (const auto error = section.finish()) return *error;
  }
  return groups;
}

Result<SecondTier> read_second_tier(const settings::Settings& settings, FloatFormat reference,
                                    EngineKind engine) {
  settings::Section section(settings, "second_tier");
  if (!section.present()) return SecondTier();
  SecondTier tier;
  ReducedSpec spec;
  read_second_tier_format(section, reference, spec);
  read_keys_but_format(section, reference, spec);
  if (spec.fixed_point || section.find("count") != nullptr) {
    read_second_tier_count(section, engine, tier.count);
  }
  if (const auto error = section.finish()) return *error;
  if (!spec.fixed_point) return SecondTier();
  if (engine == EngineKind::arg_min) {
    return section.mistake("format", "the arg-min engine has lanes of one tier", spec.format_name(),
                           "no [second_tier], or another engine.kind");
  }
  tier.reduced = std::move(spec);
  return tier;
}

Result<std::vector<ReferenceGroupSpec>> read_reference_groups(
    const settings::Settings& settings, const ReferenceStructureSpec& defaults) {
  MIXCMP_TRY(tables, read_groups(settings, "references"));
  std::vector<ReferenceGroupSpec> groups;
  int total = 0;
  for (const settings::Setting& table : tables) {
    ReferenceGroupSpec& group =
        groups.emplace_back(ReferenceGroupSpec{.count = {}, .structure = defaults});
    settings::Section section("references", table);
    read_count(section, group.count, total, max_references);
    read_structure(section, group.structure);
    if (const auto error = section.finish()) return *error;
  }
  return groups;
}

std::vector<std::string> overridden_keys(const settings::Settings& settings) {
  const settings::Setting* lanes = settings.root.find("lanes");
  if (lanes == nullptr) return {};
  const auto& groups = std::get<settings::Setting::Array>(lanes->value);
  const settings::Section reduced(settings, "reduced");
  std::vector<std::string> keys;
  for (const settings::Setting& entry : reduced.entries()) {
    const bool everywhere =
        std::all_of(groups.begin(), groups.end(), [&](const settings::Setting& group) {
          return std::get<settings::Setting::Table>(group.value).find(entry.key) != nullptr;
        });
    if (everywhere) keys.push_back(entry.key);
  }
  return keys;
}

}  // namespace mixcmp::scene
