#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/common/result.hpp"
#include "model/devices/area.hpp"

namespace mixcmp::model {

/// Rough delays of one device family, in nanoseconds, routing included. They only steer where
/// registers go; an estimate made from them is never called a clock.
struct DelayTable {
  double lut_ns = 0.7;             ///< one LUT and the wire to it
  double carry_start_ns = 0.8;     ///< onto and off a carry chain
  double carry_ns_per_bit = 0.02;  ///< along it
  double multiplier_ns = 3.0;      ///< one embedded multiplier, unregistered
  double multiplier_add_ns = 1.0;  ///< per level of adding partial products
  double register_ns = 0.6;        ///< clock-to-output plus set-up
};

/// Where a device's clocks come from.
enum class TimingTool {
  none,
  yosys_sta,      ///< `sta` after -abc9: an estimate before routing
  nextpnr_ice40,  ///< placed and routed
  nextpnr_ecp5,   ///< placed and routed
};

std::string_view to_string(TimingTool tool);

/// One device as model/devices/NAME.toml describes it.
struct Device {
  std::string name;         ///< "virtex6-lx760"
  std::string vendor_name;  ///< "XC6VLX760"
  int technology_nm = 0;
  Area available;         ///< luts, registers, dsps, memories
  std::string synthesis;  ///< Yosys command without -top: "synth_xilinx -family xc6v ..."
  TimingTool timing = TimingTool::none;
  std::string timing_synthesis;               ///< as `synthesis`, for the timing run; may be empty
  std::vector<std::string> timing_arguments;  ///< of nextpnr: "--hx8k", "--package", "ct256"
  DelayTable delays;
  std::vector<std::string> sources;  ///< of the figures, for a report
};

/// By name, or by the path of a .toml of the same form. Errors name field `system.device` and the
/// devices known, or the file, line and field of a device file.
Result<Device> find_device(std::string_view name);

/// The names that come with the program.
std::vector<std::string> device_names();

}  // namespace mixcmp::model
