#pragma once

#include "verilator_tb/build.hpp"
#include "verilator_tb/verify.hpp"

namespace mixcmp::verilator_tb {

/// Verifies a system with a pairwise engine in a series of sets. First come options.resets sets of
/// all of the scene's items, each broken off by a reset. Then come a few small sets, then all
/// items, whose figures are reported, and last a set of two items.
Result<VerifyReport> verify_pairwise(const System& system, const design::Design& design,
                                     const data::Comparisons& comparisons,
                                     const VerifyOptions& options);

}  // namespace mixcmp::verilator_tb
