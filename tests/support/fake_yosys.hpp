#pragma once

#include <fmt/core.h>

#include <string>

namespace mixcmp::test {

/// Shell commands that write a netlist which has every name in the top's source as a net. Its bits
/// vary, unless FAKE_BITS lists others.
inline constexpr const char* fake_netlist = R"sh(
top=$(sed -n 's/.* -top \([^ ]*\)$/\1/p' "$3" | head -n 1)
nets=$(grep -oE '[a-z_][a-z0-9_]*' "$top.v" | sort -u |
  sed "s/.*/\"&\":{\"bits\":[${FAKE_BITS:-$(seq -s, 2 65)}]}/" | paste -sd,)
echo "{\"modules\":{\"$top\":{\"netnames\":{$nets}}}}" > map.json
)sh";

/// Shell commands that name a LUT, a register and a multiplier of the family that the script maps
/// to.
inline constexpr const char* fake_cells = R"sh(
case $(cat "$3") in
  *synth_ecp5*) lut=LUT4 register=TRELLIS_FF multiplier=MULT18X18D;;
  *synth_ice40*) lut=SB_LUT4 register=SB_DFF multiplier=SB_MAC16;;
  *) lut=LUT6 register=FDRE multiplier=DSP48E1;;
esac
)sh";

/// A shell script that stands in for Yosys. It takes no time and finds 9000 registers, 40
/// multipliers and `luts` LUTs, a number or a variable of the shell. `first`: commands before that.
inline std::string fake_yosys(const std::string& luts, const std::string& first = "") {
  return "case \"$*\" in *-V*) echo 'Yosys 9.9 (fake)'; exit 0;; esac\n" + first + fake_cells +
         fmt::format(
             "echo \"{{\\\"design\\\":{{\\\"num_cells_by_type\\\":{{\\\"$lut\\\":{},"
             "\\\"$register\\\":9000,\\\"$multiplier\\\":40}}}}}}\" > area.json\n",
             luts) +
         fake_netlist;
}

}  // namespace mixcmp::test
