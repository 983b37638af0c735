#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "verilator_tb/build.hpp"
#include "verilator_tb/engine_judge.hpp"

/// What `verify` does alike for every engine.
namespace mixcmp::tb {

/// Refuses what no engine can: another simulator, a selection. `compares`: "every pair of its
/// items".
model::Result<model::Done> check_engine_options(const VerifyOptions& options,
                                                const std::string& compares);

/// Rows of a table as they stand on a tdata of so many bytes; beyond its last from the first on
/// again. Padding is zeros and ones by turns.
std::vector<std::uint8_t> row_bytes(const model::Table& table,
                                    const std::vector<std::string>& columns, int bytes_of_one,
                                    std::uint64_t first, std::uint64_t count);

/// Builds the simulator, lets `trials` run, and gives the judge's report, waves saved.
model::Result<VerifyReport> run_engine(
    const System& system, const VerifyOptions& options, EngineJudge& judge,
    const std::function<model::Result<model::Done>(const Executable&)>& trials);

}  // namespace mixcmp::tb
