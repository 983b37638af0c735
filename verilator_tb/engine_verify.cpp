#include "verilator_tb/engine_verify.hpp"

#include <algorithm>
#include <chrono>
#include <optional>

#include "verilator_tb/icarus.hpp"
#include "verilator_tb/waves.hpp"

namespace mixcmp::verilator_tb {

namespace {

std::string save_file(const emit::SignatureEngine& engine, const VerifyOptions& options) {
  return gtkwave_save_file(
      engine, {.waves = options.waves,
               .scope = options.simulator == SimulatorKind::icarus ? "testbench.system"
                                                                   : "TOP." + engine.top,
               .time_per_cycle = 2,
               .marked = {}});
}

/// The places of these columns in a table. A table of "cross" lacks those that nothing reads of its
/// items.
std::vector<std::optional<std::size_t>> places_of(const data::Table& table,
                                                  const std::vector<std::string>& columns) {
  std::vector<std::optional<std::size_t>> places;
  for (const std::string& name : columns) {
    const auto found = std::find(table.columns.begin(), table.columns.end(), name);
    places.push_back(found == table.columns.end()
                         ? std::nullopt
                         : std::optional<std::size_t>(found - table.columns.begin()));
  }
  return places;
}

}  // namespace

Result<Done> check_engine_options(const VerifyOptions& options, const std::string& compares) {
  if (options.selection.limit == 0 && !options.selection.only) return Done{};
  return Error{.field = "--first, --sample, --only",
               .message = "an engine compares " + compares,
               .received = "a selection of comparisons",
               .accepted = "none; or --set engine.kind=none for the system inside"};
}

std::vector<std::uint8_t> row_bytes(const data::Table& table,
                                    const std::vector<std::string>& columns,
                                    const std::vector<OperandFormat>& formats, int bytes_of_one,
                                    std::uint64_t first, std::uint64_t count) {
  std::vector<std::uint64_t> rows(count);
  for (std::uint64_t k = 0; k < count; ++k) rows[k] = (first + k) % table.rows();
  return row_bytes(table, columns, formats, bytes_of_one, rows);
}

std::vector<std::uint8_t> row_bytes(const data::Table& table,
                                    const std::vector<std::string>& columns,
                                    const std::vector<OperandFormat>& formats, int bytes_of_one,
                                    const std::vector<std::uint64_t>& rows) {
  const std::vector<std::optional<std::size_t>> places = places_of(table, columns);
  const auto size = static_cast<std::size_t>(bytes_of_one);
  std::vector<std::uint8_t> bytes(size * rows.size());
  std::vector<Bits> values(places.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    for (std::size_t c = 0; c < places.size(); ++c) {
      values[c] = places[c] ? table.at(rows[k], *places[c]) : Bits{0};
    }
    pack_operands(values, table.format, formats, k % 2 != 0,
                  std::span(bytes).subspan(size * k, size));
  }
  return bytes;
}

Result<VerifyReport> run_engine(const System& system, const VerifyOptions& options,
                                EngineJudge& judge,
                                const std::function<Result<Done>(const Executable&)>& trials) {
  MIXCMP_TRY(executable, build_executable(system, options));
  judge.report().build_seconds = executable.build_seconds;
  judge.report().simulator =
      options.simulator == SimulatorKind::icarus ? icarus_name : verilator_name;
  const auto start = std::chrono::steady_clock::now();
  MIXCMP_DO(trials(executable));
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  judge.report().run_seconds = taken.count();
  if (options.wave_file != nullptr) {
    options.wave_file->set_save_file(save_file(*system.signature.engine, options));
  }
  return std::move(judge.report());
}

}  // namespace mixcmp::verilator_tb
