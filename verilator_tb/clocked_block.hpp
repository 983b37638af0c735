#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "generator/hardware/emit/signature.hpp"

namespace mixcmp::verilator_tb {

/// Names and texts of the files that a simulator reads. The build has its own copies in one folder,
/// so that a system generated anew in the meantime does not mix with them.
using SourceFiles = std::vector<std::pair<std::string, std::string>>;

/// A module that is verilated by itself, once for all its instances and for all systems that have
/// it. In the system's simulator a stub takes the module's place and calls it at every rising edge.
/// This is the same hardware where no output depends on an input of the same cycle, which the
/// harness checks in every cycle (harness/clocked_block.hpp).
struct ClockedBlock {
  std::string module;
  std::vector<emit::SignaturePort> ports;  ///< without aclk

  /// The top module of the block's own model: the module between aclk and two vectors, d and q, of
  /// its inputs and its outputs.
  std::string wrapper_name() const { return module + "_block"; }
  std::string wrapper() const;
  /// The module that stands in the system for the block; SystemVerilog.
  std::string stub() const;
  /// The C++ functions that the stub calls.
  std::string binding() const;
};

/// The module of a Verilog text that mixcmp printed; nothing if it has parameters, no aclk, or
/// ports that are written in another way.
std::optional<ClockedBlock> clocked_block(const std::string& module, const std::string& text);

/// The lane channels and reference datapaths of a system that can be blocks. A system of one lane
/// (or group) and at most one reference has none: one model compiles sooner than three.
std::vector<ClockedBlock> clocked_blocks(const emit::Signature& signature,
                                         const SourceFiles& sources);

/// The files of `all` that make `module`, in their order. A file holds one module and has its name.
SourceFiles files_of_module(const std::string& module, const SourceFiles& all);

}  // namespace mixcmp::verilator_tb
