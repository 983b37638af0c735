#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "model/base/common/result.hpp"
#include "model/base/settings/settings.hpp"
#include "model/cost/devices/area.hpp"

namespace mixcmp::devices {

/// The resources that each cell of a mapped netlist takes. A name that ends in * stands for every
/// name that begins so.
class CellAreas {
public:
  /// The cells that a synthesis command maps to (cells.toml); none if the command is not known
  /// there. `synthesis` may have options: "synth_xilinx -family xc7".
  static CellAreas of(std::string_view synthesis);

  /// Adds the entries of a section: `LUT4 = { luts = 1 }`. A name that is there already gets the
  /// new area.
  Result<Done> add(const settings::Setting& section);

  /// The area of a cell by its whole name, else by the longest name with * that matches.
  std::optional<Area> find(std::string_view cell) const;

  /// Whether any cell is a multiplier.
  bool have_dsps() const;

  /// All names, for an error: "CARRY*, FD*, INV".
  std::string names() const;

private:
  std::map<std::string, Area, std::less<>> areas_;
};

}  // namespace mixcmp::devices
