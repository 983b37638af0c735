#pragma once

#include <array>
#include <string_view>

#include "model/characterise/measurement.hpp"

namespace mixcmp::model {

/// A column of a table of measurements that is text or a whole number.
template <class Value>
struct KeyColumn {
  std::string_view name;
  Value ComponentKey::*field;
};
template <class Value>
struct AreaColumn {
  std::string_view name;
  Value Area::*field;
};

inline constexpr std::array<KeyColumn<std::string>, 5> key_columns = {{
    {"name", &ComponentKey::name},
    {"format", &ComponentKey::format},
    {"inputs", &ComponentKey::inputs},
    {"bound", &ComponentKey::bound},
    {"multipliers", &ComponentKey::multipliers},
}};

inline constexpr std::array<AreaColumn<int>, 6> area_columns = {{
    {"luts", &Area::luts},
    {"registers", &Area::registers},
    {"dsps", &Area::dsps},
    {"memories", &Area::memories},
    {"carries", &Area::carries},
    {"shift_luts", &Area::shift_luts},
}};

/// The first record of every table.
inline constexpr std::string_view table_header =
    "kind,name,format,inputs,bound,multipliers,ports,latency_cycles,luts,registers,dsps,memories,"
    "carries,shift_luts,mhz,low_mhz,high_mhz,seeds,clock_source,timing_seeds,hash,tools";

}  // namespace mixcmp::model
