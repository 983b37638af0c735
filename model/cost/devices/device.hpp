#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/common/result.hpp"
#include "model/cost/devices/area.hpp"
#include "model/cost/devices/cell_areas.hpp"

namespace mixcmp::devices {

/// The widest unsigned factors of one embedded multiplier.
struct MultiplierSize {
  int a_bits = 24;
  int b_bits = 17;

  friend bool operator==(const MultiplierSize&, const MultiplierSize&) = default;
};

/// One block of memory.
struct MemoryBlock {
  int bits = 18432;
  int read_ports = 2;  ///< ports that can read, each with its own address: 1 or 2

  friend bool operator==(const MemoryBlock&, const MemoryBlock&) = default;
};

/// Rough delays of one device family, in nanoseconds, routing included, and the sizes of its
/// multipliers and memory blocks. They are used only to place registers. An estimate made from them
/// is never called a clock.
struct DelayTable {
  double lut_ns = 0.7;              ///< one LUT and the wire to it
  double carry_start_ns = 0.8;      ///< getting onto and off a carry chain
  double carry_ns_per_bit = 0.02;   ///< along a carry chain
  double multiplier_input_ns = 0;   ///< the wire from logic to a multiplier's input registers
  double multiplier_ns = 2.0;       ///< one embedded multiplier, to the register behind it
  double multiplier_output_ns = 0;  ///< from that register through its adder, if any
  double multiplier_add_ns = 1.0;   ///< adding its product to another's
  double memory_ns = 2.0;           ///< from a memory block's clock to the word that it has read
  double register_ns = 0.6;         ///< clock-to-output plus set-up
  double target_mhz = 200;          ///< for placing registers where a scene names no clock
  int lut_inputs = 6;
  /// Whether a look-up table has more than four inputs.
  bool has_wide_tables() const { return lut_inputs >= 5; }
  /// How many bits may select an operand inside the look-up tables of a carry chain.
  int sum_selects = 2;
  MultiplierSize multiplier_size;
  /// Whether a multiplier adds its product to another number, without look-up tables.
  bool multiplier_sums = false;
  MemoryBlock memory_block;

  friend bool operator==(const DelayTable&, const DelayTable&) = default;
};

/// The tool that measures a device's clocks.
enum class TimingTool {
  none,
  yosys_sta,      ///< `sta` after -abc9: an estimate before routing
  nextpnr_ice40,  ///< placed and routed, as are the rest
  nextpnr_ecp5,
  nextpnr_nexus,
  nextpnr_gowin,
  nextpnr_gatemate,
  nextpnr_machxo2,
};

std::string_view to_string(TimingTool tool);

/// One device as a device file describes it (docs/devices.md).
struct Device {
  std::string name;          ///< "virtex6-lx760"
  std::string family;        ///< "virtex6": the file of families/ that it follows; may be empty
  std::string vendor_name;   ///< "XC6VLX760"
  std::string vivado_part;   ///< Vivado's name, "xc7a200tfbg676-2"; empty: Vivado has none
  std::string quartus_part;  ///< Quartus' name, "5CEBA4F23C7"; empty: Quartus has none
  int technology_nm = 0;
  Area available;            ///< luts, registers, dsps, memories
  std::string synthesis;     ///< Yosys command without -top: "synth_xilinx -family xc6v ..."
  std::string no_synthesis;  ///< the reason why `synthesis` is empty
  CellAreas cell_areas;      ///< of the cells that `synthesis` maps to
  std::string cells;  ///< rtl_templates/technology/CELLS has modules for its Yosys; may be empty
  TimingTool timing = TimingTool::none;
  std::string timing_synthesis;               ///< `synthesis` for the timing run; may be empty
  std::vector<std::string> timing_arguments;  ///< for nextpnr: "--hx8k", "--package", "ct256"
  DelayTable delays;
  std::vector<std::string> sources;  ///< sources of the figures, for a report
};

/// Finds a device by its name, by a part number ("xc7a100t", "XC7A100TCSG324-1"), by a board
/// ("arty-a7-100"), or by the path of a device file. Errors name field `system.device` and the
/// nearest names, or the file, line and field of a device file.
Result<Device> find_device(std::string_view name);

/// The names of the devices that have a device file of their own in the program.
std::vector<std::string> device_names();

/// A device that comes with the program, and its other names: the part and its boards.
struct KnownDevice {
  Device device;
  std::vector<std::string> other_names;
};
std::vector<KnownDevice> known_devices();

}  // namespace mixcmp::devices
