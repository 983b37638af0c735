#pragma once

#include <array>
#include <string_view>

#include "model/base/settings/bound_name.hpp"
#include "model/cost/measured/measurement.hpp"

namespace mixcmp::measured {

/// A column that helps to identify the component of a row.
struct KeyColumn {
  std::string_view name;
  std::string (*get)(const ComponentKey& key);
  Result<Done> (*set)(ComponentKey& key, const std::string& text);
};

template <std::string ComponentKey::*field>
KeyColumn text_column(std::string_view name) {
  return {name, [](const ComponentKey& key) { return key.*field; },
          [](ComponentKey& key, const std::string& text) -> Result<Done> {
            key.*field = text;
            return Done{};
          }};
}

/// The unusual properties of a reference, as words: "fused at_600_mhz".
std::string traits_of_reference(const ComponentKey& key);
Result<Done> set_traits_of_reference(ComponentKey& key, const std::string& words);

/// The name of a unit, or the traits of a reference.
inline KeyColumn name_column() {
  return {"name",
          [](const ComponentKey& key) {
            return depends_on_reference(key.kind) ? traits_of_reference(key) : key.name;
          },
          [](ComponentKey& key, const std::string& text) -> Result<Done> {
            if (depends_on_reference(key.kind)) return set_traits_of_reference(key, text);
            key.name = text;
            return Done{};
          }};
}

inline KeyColumn inputs_column() {
  return {"inputs", [](const ComponentKey& key) { return to_string(key.inputs); },
          [](ComponentKey& key, const std::string& text) -> Result<Done> {
            if (text.empty()) return Done{};
            MIXCMP_TRY(inputs, LaneInputs::parse(text, FloatFormat::min_precision,
                                                 FloatFormat::max_precision));
            key.inputs = inputs;
            return Done{};
          }};
}

inline KeyColumn bound_column() {
  return {"bound", [](const ComponentKey& key) { return to_string(key.bound); },
          [](ComponentKey& key, const std::string& text) -> Result<Done> {
            if (text.empty()) return Done{};
            MIXCMP_TRY(choice, settings::parse_bound(text));
            key.bound = choice;
            return Done{};
          }};
}

inline const std::array<KeyColumn, 5> key_columns = {{
    name_column(),
    text_column<&ComponentKey::format>("format"),
    inputs_column(),
    bound_column(),
    text_column<&ComponentKey::multipliers>("multipliers"),
}};

/// A column with one resource of an area.
struct AreaColumn {
  std::string_view name;
  int devices::Area::*field;
};

inline constexpr std::array<AreaColumn, 6> area_columns = {{
    {"luts", &devices::Area::luts},
    {"registers", &devices::Area::registers},
    {"dsps", &devices::Area::dsps},
    {"memories", &devices::Area::memories},
    {"carries", &devices::Area::carries},
    {"shift_luts", &devices::Area::shift_luts},
}};

/// The first record of a table without imported rows, all of which are mapped.
inline constexpr std::string_view mapped_table_header =
    "kind,name,format,inputs,bound,multipliers,initiation_interval,ports,latency_cycles,luts,"
    "registers,dsps,memories,"
    "carries,shift_luts,mhz,low_mhz,high_mhz,seeds,clock_source,timing_seeds,hash,tools";
inline constexpr int mapped_table_columns = 23;

/// The first record of a table with imported rows: its last column is the stage of each area.
inline const std::string staged_table_header = std::string(mapped_table_header) + ",area_stage";

}  // namespace mixcmp::measured
