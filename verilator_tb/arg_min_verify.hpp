#pragma once

#include "verilator_tb/build.hpp"
#include "verilator_tb/verify.hpp"

namespace mixcmp::verilator_tb {

/// Verifies a system with an arg-min engine in a series of loads. First come options.resets loads
/// of all candidates and rows, each broken off by a reset. Then come short loads and one of a
/// candidate too many, with at most 8 rows each; then all candidates and rows, whose figures are
/// reported; and last the same once more, with the candidates loaded again after half of the rows.
Result<VerifyReport> verify_arg_min(const System& system, const design::Design& design,
                                    const data::Comparisons& comparisons,
                                    const VerifyOptions& options);

}  // namespace mixcmp::verilator_tb
