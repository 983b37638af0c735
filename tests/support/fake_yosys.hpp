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

/// A shell script that stands in for Yosys. It takes no time and finds 9000 registers, 40
/// multipliers and `luts` LUTs, a number or a variable of the shell. `first`: commands before that.
inline std::string fake_yosys(const std::string& luts, const std::string& first = "") {
  return "case \"$*\" in *-V*) echo 'Yosys 9.9 (fake)'; exit 0;; esac\n" + first +
         fmt::format(
             "echo \"{{\\\"design\\\":{{\\\"num_cells_by_type\\\":{{\\\"LUT6\\\":{},"
             "\\\"FDRE\\\":9000,\\\"DSP48E1\\\":40}}}}}}\" > area.json\n",
             luts) +
         fake_netlist;
}

}  // namespace mixcmp::test
