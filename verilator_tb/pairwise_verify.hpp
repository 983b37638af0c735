#pragma once

#include "verilator_tb/build.hpp"
#include "verilator_tb/verify.hpp"

namespace mixcmp::tb {

/// `verify` for a system with a pairwise engine: a few small sets and the scene's items, one set
/// after the other, and before them as many runs of the scene's items as there are resets, each
/// broken off.
model::Result<VerifyReport> verify_pairwise(const System& system, const model::Design& design,
                                            const model::Comparisons& comparisons,
                                            const VerifyOptions& options);

}  // namespace mixcmp::tb
