#pragma once

namespace mixcmp::devices {

/// The resources of a device that a design uses, or that the device has.
struct Area {
  int luts = 0;        ///< look-up tables, those that serve as shift registers or memory included
  int registers = 0;   ///< flip-flops
  int dsps = 0;        ///< embedded multipliers
  int memories = 0;    ///< memory blocks
  int carries = 0;     ///< carry primitives (CARRY4, CCU2C, SB_CARRY); only reported
  int shift_luts = 0;  ///< the part of `luts` that are shift registers or memory; only reported

  Area& operator+=(const Area& other);
  friend Area operator+(Area a, const Area& b) { return a += b; }
  friend Area operator*(int count, const Area& area);
  friend bool operator==(const Area&, const Area&) = default;
};

/// A resource that limits a plan (equation 11 holds for each), with its name in files.
struct Resource {
  const char* name;  ///< "lut", "ff", "dsp", "memory"
  int Area::*amount;
};
inline constexpr Resource bounded_resources[] = {{"lut", &Area::luts},
                                                 {"ff", &Area::registers},
                                                 {"dsp", &Area::dsps},
                                                 {"memory", &Area::memories}};

}  // namespace mixcmp::devices
