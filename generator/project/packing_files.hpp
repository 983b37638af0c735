#pragma once

#include <string>
#include <vector>

#include "generator/hardware/emit/system.hpp"
#include "model/base/number/operand_format.hpp"

namespace mixcmp::project {

/// Operands that a stream of the module takes side by side in one transfer, the first lowest.
struct PackedRecord {
  std::string name;  ///< "operands", "item", "candidate", "row"
  std::string port;  ///< "s_axis_tdata"
  std::vector<std::string> operands;
  std::vector<OperandFormat> formats;  ///< one per operand
  int bytes = 0;                       ///< the operands padded to whole bytes
};

struct PackingSpec {
  std::string module;
  std::vector<PackedRecord> records;
};

/// The functions that turn numbers into the bytes of each record and back: a header for C and C++,
/// and a Python module for NumPy. `c_head`, `python_head`: comments that say where they come from.
std::vector<emit::GeneratedFile> packing_files(const PackingSpec& spec, const std::string& c_head,
                                               const std::string& python_head);

}  // namespace mixcmp::project
