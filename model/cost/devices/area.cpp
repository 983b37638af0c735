#include "model/cost/devices/area.hpp"

namespace mixcmp::devices {

Area& Area::operator+=(const Area& other) {
  luts += other.luts;
  registers += other.registers;
  dsps += other.dsps;
  memories += other.memories;
  carries += other.carries;
  shift_luts += other.shift_luts;
  return *this;
}

Area operator*(int count, const Area& area) {
  return {.luts = count * area.luts,
          .registers = count * area.registers,
          .dsps = count * area.dsps,
          .memories = count * area.memories,
          .carries = count * area.carries,
          .shift_luts = count * area.shift_luts};
}

}  // namespace mixcmp::devices
