#pragma once

#include "verilator_tb/build.hpp"
#include "verilator_tb/verify.hpp"

namespace mixcmp::tb {

/// `verify` for a system with an arg-min engine: short loads and one too long, then the scene's
/// candidates and all its rows, loaded once more midway, and before them as many such runs as there
/// are resets, each broken off.
model::Result<VerifyReport> verify_arg_min(const System& system, const model::Design& design,
                                           const model::Comparisons& comparisons,
                                           const VerifyOptions& options);

}  // namespace mixcmp::tb
