#include "model/cost/measured/component_cells.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <charconv>
#include <sstream>
#include <utility>
#include <vector>

#include "model/base/common/quote.hpp"
#include "model/base/settings/bound_name.hpp"
#include "model/base/settings/limits.hpp"

namespace mixcmp::measured {
namespace {

using scene::Multipliers;

constexpr std::string_view target_before = "at_", target_behind = "_mhz";

/// The unusual properties of a reference, as words: "fused at_600_mhz".
std::string traits_of(const Reference& reference) {
  std::vector<std::string> words;
  if (reference.sums == Sums::fused) words.emplace_back(to_string(Sums::fused));
  if (reference.target_mhz) {
    words.push_back(fmt::format("{}{}{}", target_before, *reference.target_mhz, target_behind));
  }
  return fmt::format("{}", fmt::join(words, " "));
}

void write(KeyCells& cells, const Lane& lane) {
  cells.format = lane.format.name();
  cells.inputs = to_string(lane.inputs);
  cells.bound = to_string(lane.bound);
  cells.multipliers = to_string(lane.multipliers);
}

void write(KeyCells& cells, const Reference& reference) {
  cells.name = traits_of(reference);
  cells.format = reference.format.name();
  cells.multipliers = to_string(reference.multipliers);
  cells.initiation_interval = std::to_string(reference.initiation_interval);
}

Error wrong(std::string_view column, std::string message, std::string_view received,
            std::string accepted) {
  return {.field = std::string(column),
          .message = std::move(message),
          .received = in_quotes(received),
          .accepted = std::move(accepted)};
}

/// The error of a parser that does not know the column.
Error wrong(std::string_view column, std::string_view received, const Error& error) {
  return wrong(column, error.message, received, error.accepted);
}

std::optional<int> number_in(std::string_view text) {
  int number = 0;
  const auto [stop, failed] = std::from_chars(text.begin(), text.end(), number);
  const bool is_whole = failed == std::errc() && stop == text.end();
  return is_whole ? std::optional(number) : std::nullopt;
}

Result<int> number(std::string_view column, const std::string& text) {
  const std::optional<int> found = number_in(text);
  if (found && *found >= 0 && *found <= 1'000'000'000) return *found;
  return wrong(column, "not a number", text, "a whole number of at least 0");
}

/// The number in "at_600_mhz".
std::optional<int> target_in(std::string_view word) {
  if (!word.starts_with(target_before) || !word.ends_with(target_behind)) return std::nullopt;
  if (word.size() < target_before.size() + target_behind.size()) return std::nullopt;
  word.remove_prefix(target_before.size());
  word.remove_suffix(target_behind.size());
  const std::optional<int> mhz = number_in(word);
  return mhz && settings::limits::target_mhz.allow(*mhz) ? mhz : std::nullopt;
}

Result<Done> set_traits(Reference& reference, const std::string& words) {
  std::istringstream text(words);
  for (std::string word; text >> word;) {
    const std::optional<int> target = target_in(word);
    if (word == to_string(Sums::fused)) {
      reference.sums = Sums::fused;
    } else if (target) {
      reference.target_mhz = target;
    } else {
      return wrong("name", "not a kind of reference", words,
                   "fused, a target as at_600_mhz, both or nothing");
    }
  }
  return Done{};
}

Result<LaneFormat> format_in(const KeyCells& cells) {
  Result<LaneFormat> format = LaneFormat::parse(cells.format);
  if (format.ok()) return format;
  return wrong("format", cells.format, format.error());
}

/// A number of digits must be above the lane's own; fixed point has no such choice.
Result<std::optional<LaneInputs>> inputs_in(const KeyCells& cells, const LaneFormat& format) {
  const std::string& text = cells.inputs;
  if (!format.floating) {
    if (text.empty()) return std::optional<LaneInputs>();
    return wrong("inputs", "not a choice", text, "");
  }
  const int own = format.precision();
  constexpr int most = FloatFormat::max_precision;
  if (!text.empty()) {
    const auto inputs = LaneInputs::parse(text, FloatFormat::min_precision, most);
    if (!inputs.ok()) return wrong("inputs", text, inputs.error());
    if (inputs->in_lane(own, most) == *inputs) return std::optional(*inputs);
  }
  return wrong("inputs", "not a choice", text,
               fmt::format("exact, rounded, or a number of digits above {}", own));
}

std::string bound_words(const LaneFormat& format) {
  if (format.floating) return "a bound in floating point";
  std::vector<std::string> names;
  for (const Bound& bound : bounds_of(*format.fixed_point)) names.push_back(to_string(bound));
  return fmt::format("{}", fmt::join(names, ", "));
}

Result<Bound> bound_in(const KeyCells& cells, const LaneFormat& format) {
  if (!cells.bound.empty()) {
    Result<Bound> bound = settings::parse_bound(cells.bound);
    if (!bound.ok()) return wrong("bound", cells.bound, bound.error());
    if (bound->is_for(format)) return bound;
  }
  return wrong("bound", "not a bound of such lanes", cells.bound, bound_words(format));
}

Result<std::optional<Multipliers>> multipliers_in(const KeyCells& cells) {
  if (cells.multipliers.empty()) return std::optional<Multipliers>();
  for (const Multipliers each : scene::all_multipliers) {
    if (cells.multipliers == to_string(each)) return std::optional(each);
  }
  return wrong("multipliers", "not a choice", cells.multipliers, "embedded, logic, memory, ");
}

Result<Lane> lane_in(const KeyCells& cells) {
  MIXCMP_TRY(format, format_in(cells));
  MIXCMP_TRY(inputs, inputs_in(cells, format));
  MIXCMP_TRY(bound, bound_in(cells, format));
  MIXCMP_TRY(multipliers, multipliers_in(cells));
  return Lane{.format = format, .inputs = inputs, .bound = bound, .multipliers = multipliers};
}

Result<Reference> reference_in(const KeyCells& cells) {
  MIXCMP_TRY(format, format_in(cells));
  const std::optional<FixedPoint>& fixed_point = format.fixed_point;
  if (fixed_point && !fixed_point->is_plain()) {
    return wrong("format", "not a format of references", cells.format,
                 "s53e8 or q13, for instance");
  }
  Reference reference{.format = format, .multipliers = {}, .target_mhz = {}};
  MIXCMP_DO(set_traits(reference, cells.name));
  if (fixed_point && reference.sums == Sums::fused) {
    return wrong("name", "an exact reference rounds no sum", cells.name, "no \"fused\"");
  }
  MIXCMP_TRY(multipliers, multipliers_in(cells));
  reference.multipliers = multipliers;
  MIXCMP_TRY(interval, number("initiation_interval", cells.initiation_interval));
  reference.initiation_interval = interval;
  constexpr settings::Limits limits = settings::limits::initiation_interval;
  if (limits.allow(interval)) return reference;
  return wrong("initiation_interval", "not an initiation interval", cells.initiation_interval,
               to_string(limits));
}

template <class Component>
Result<ComponentKey> counted(const KeyCells& cells, Component component) {
  if constexpr (Counted<Component>) {
    MIXCMP_TRY(count, number("ports", cells.ports));
    component.*Component::count = count;
  }
  return ComponentKey(std::move(component));
}

template <class Component>
Result<ComponentKey> on_lane(const KeyCells& cells) {
  MIXCMP_TRY(lane, lane_in(cells));
  return counted(cells, Component{lane});
}

template <class Component>
Result<ComponentKey> on_reference(const KeyCells& cells) {
  MIXCMP_TRY(reference, reference_in(cells));
  return ComponentKey(Component{reference});
}

Result<ComponentKey> component_in(ComponentKind kind, const KeyCells& cells) {
  switch (kind) {
    case ComponentKind::unit: return ComponentKey(Unit{cells.name});
    case ComponentKind::lane: return on_lane<Lane>(cells);
    case ComponentKind::reference: return on_reference<Reference>(cells);
    case ComponentKind::fifo: return counted(cells, Fifo{});
    case ComponentKind::crossbar: return counted(cells, Crossbar{});
    case ComponentKind::reference_port: return on_reference<ReferencePort>(cells);
    case ComponentKind::second_lane: return on_lane<SecondLane>(cells);
    case ComponentKind::segment: return on_lane<Segment>(cells);
    case ComponentKind::conversion: return on_lane<Conversion>(cells);
    case ComponentKind::engine: return on_lane<Engine>(cells);
    case ComponentKind::operand_memory: return counted(cells, OperandMemory{});
  }
  MIXCMP_CHECK(false);
}

/// Refuses a value in a cell that does not apply, which `cells_of` leaves as it is by default.
Result<Done> check_other_cells(const KeyCells& cells, const ComponentKey& key) {
  const KeyCells written = cells_of(key), empty;
  for (const KeyColumn& column : key_columns) {
    const std::string& nothing = empty.*column.cell;
    if (written.*column.cell != nothing || cells.*column.cell == nothing) continue;
    return wrong(column.name, fmt::format("a {} has no such property", cells.kind),
                 cells.*column.cell, nothing.empty() ? "an empty field" : nothing);
  }
  return Done{};
}

}  // namespace

KeyCells cells_of(const ComponentKey& key) {
  KeyCells cells;
  cells.kind = to_string(kind_of(key));
  if (const auto* unit = std::get_if<Unit>(&key)) cells.name = unit->name;
  if (const Lane* lane = lane_of(key)) write(cells, *lane);
  if (const Reference* reference = reference_of(key)) write(cells, *reference);
  if (const std::optional<int> count = count_of(key)) cells.ports = std::to_string(*count);
  return cells;
}

Result<ComponentKey> key_of(const KeyCells& cells) {
  std::string accepted;
  for (const ComponentKind kind : component_kinds) {
    if (cells.kind == to_string(kind)) {
      MIXCMP_TRY(key, component_in(kind, cells));
      MIXCMP_DO(check_other_cells(cells, key));
      return key;
    }
    accepted += (accepted.empty() ? "" : ", ") + std::string(to_string(kind));
  }
  return wrong("kind", "not a choice", cells.kind, accepted);
}

}  // namespace mixcmp::measured
