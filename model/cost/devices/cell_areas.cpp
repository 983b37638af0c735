#include "model/cost/devices/cell_areas.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <vector>

#include "embedded/cell_files.hpp"
#include "model/base/common/check.hpp"
#include "model/base/settings/section.hpp"

namespace mixcmp::devices {
namespace {

constexpr int most_of_a_cell = 1000;

Result<Area> area_in(const settings::Setting& entry) {
  if (!std::holds_alternative<settings::Setting::Table>(entry.value)) {
    return settings::mistake_at(entry, "areas." + entry.key, "wrong type", entry.shown(),
                                "a table of resources: { luts = 1 }");
  }
  settings::Section section("areas." + entry.key, entry);
  struct Amount {
    const char* key;
    int Area::*amount;
  };
  constexpr std::array<Amount, 6> amounts = {{{"luts", &Area::luts},
                                              {"registers", &Area::registers},
                                              {"dsps", &Area::dsps},
                                              {"memories", &Area::memories},
                                              {"carries", &Area::carries},
                                              {"shift_luts", &Area::shift_luts}}};
  Area area;
  for (const Amount& each : amounts) {
    section.integer(each.key, area.*each.amount, 0, most_of_a_cell);
  }
  if (const auto error = section.finish()) return *error;
  return area;
}

settings::Settings known_cells() {
  const EmbeddedFile& file = cell_files().front();
  return settings::parse_settings(std::string(file.text), file.name).value();
}

}  // namespace

CellAreas CellAreas::of(std::string_view synthesis) {
  const settings::Settings known = known_cells();
  CellAreas areas;
  const std::string command(synthesis.substr(0, synthesis.find_first_of(" \t")));
  for (const std::string& name : {std::string("any"), command}) {
    const settings::Setting* section = known.root.find(name);
    if (section != nullptr) MIXCMP_CHECK(areas.add(*section).ok());
  }
  return areas;
}

Result<Done> CellAreas::add(const settings::Setting& section) {
  for (const settings::Setting& entry : std::get<settings::Setting::Table>(section.value).entries) {
    MIXCMP_TRY(area, area_in(entry));
    areas_[entry.key] = area;
  }
  return Done{};
}

std::optional<Area> CellAreas::find(std::string_view cell) const {
  if (const auto whole = areas_.find(cell); whole != areas_.end()) return whole->second;
  for (std::size_t letters = cell.size() + 1; letters-- > 0;) {
    const auto start = areas_.find(std::string(cell.substr(0, letters)) + "*");
    if (start != areas_.end()) return start->second;
  }
  return std::nullopt;
}

bool CellAreas::have_dsps() const {
  return std::any_of(areas_.begin(), areas_.end(),
                     [](const auto& entry) { return entry.second.dsps > 0; });
}

std::string CellAreas::names() const {
  std::vector<std::string_view> names;
  for (const auto& [name, area] : areas_) names.push_back(name);
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace mixcmp::devices
