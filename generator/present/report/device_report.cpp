#include "generator/present/report/device_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "generator/present/table/table.hpp"

namespace mixcmp::report {
namespace {

using devices::KnownDevice;
using table::Fields;

const Fields<KnownDevice>& fields() {
  const auto count = [](int devices::Area::*amount) {
    return [amount](const KnownDevice& known) { return known.device.available.*amount; };
  };
  static const Fields<KnownDevice> all = {
      {{"device", "device", 16, 0}, [](const KnownDevice& known) { return known.device.name; }},
      {{"family", "family", 18}, [](const KnownDevice& known) { return known.device.family; }},
      {{"luts", "LUTs", 7, 1}, count(&devices::Area::luts)},
      {{"registers", "registers", 9}, count(&devices::Area::registers)},
      {{"dsps", "DSPs", 5, 1}, count(&devices::Area::dsps)},
      {{"memories", "memories", 8, 1}, count(&devices::Area::memories)},
      {{"clock", "clock", 13},
       [](const KnownDevice& known) { return std::string(to_string(known.device.timing)); }},
  };
  return all;
}

}  // namespace

std::string to_text(const std::vector<KnownDevice>& known) {
  const Fields<KnownDevice> names = {{{"other_names", "also"}, [](const KnownDevice& each) {
                                        return fmt::format("{}", fmt::join(each.other_names, " "));
                                      }}};
  return table::to_text(table_of(fields() + names, known));
}

nlohmann::ordered_json to_json(const std::vector<KnownDevice>& known) {
  const Fields<KnownDevice> names = {{{"other_names"}, &KnownDevice::other_names}};
  return {{"devices", table::to_json(table_of(fields() + names, known))}};
}

}  // namespace mixcmp::report
