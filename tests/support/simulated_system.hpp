#pragma once

#include <filesystem>
#include <string>

#include "model/design/design.hpp"
#include "verilator_tb/verify.hpp"

namespace mixcmp::test {

/// Generates `design` and verifies it on `data`. Builds are kept below the build tree and found
/// again by content; a failure to run is a test failure.
verilator_tb::VerifyReport simulate(const design::Design& design, const data::Comparisons& data,
                                    verilator_tb::VerifyOptions options);

/// A folder of this name for a test's files, below the build tree.
std::filesystem::path test_work_dir(const std::string& name);

/// Writes the design's Verilog to a folder below the build tree, and says where.
std::filesystem::path generate_to(const design::Design& design, const std::string& folder);

}  // namespace mixcmp::test
