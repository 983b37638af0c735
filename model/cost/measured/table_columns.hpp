#pragma once

#include <array>
#include <string>
#include <string_view>

#include "model/cost/devices/device.hpp"

namespace mixcmp::measured {

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
