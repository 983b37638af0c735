#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "verilator_tb/build.hpp"
#include "verilator_tb/engine_judge.hpp"

/// The steps of `verify` that are the same for every engine.
namespace mixcmp::verilator_tb {

/// Refuses a selection of comparisons, which no engine supports. `compares`: the comparisons of the
/// engine for the message, such as "every pair of its items".
Result<Done> check_engine_options(const VerifyOptions& options, const std::string& compares);

/// The bytes of `count` rows of a table from row `first` on, each as a tdata of `bytes_of_one`
/// bytes that holds these columns in these formats; after the table's last row its first follows.
/// Padding bits are zeros in one row and ones in the next.
std::vector<std::uint8_t> row_bytes(const data::Table& table,
                                    const std::vector<std::string>& columns,
                                    const std::vector<OperandFormat>& formats, int bytes_of_one,
                                    std::uint64_t first, std::uint64_t count);

/// The bytes of these rows of a table, as above.
std::vector<std::uint8_t> row_bytes(const data::Table& table,
                                    const std::vector<std::string>& columns,
                                    const std::vector<OperandFormat>& formats, int bytes_of_one,
                                    const std::vector<std::uint64_t>& rows);

/// Builds the simulator, calls `trials` with it, and returns the judge's report. Gives the wave
/// file, if there is one, its GTKWave save file.
Result<VerifyReport> run_engine(const System& system, const VerifyOptions& options,
                                EngineJudge& judge,
                                const std::function<Result<Done>(const Executable&)>& trials);

}  // namespace mixcmp::verilator_tb
