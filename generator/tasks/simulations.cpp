#include "generator/tasks/simulations.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "model/base/common/cache_folder.hpp"
#include "model/base/common/file.hpp"
#include "model/base/common/output_file.hpp"

namespace mixcmp::tasks {
namespace {

namespace fs = std::filesystem;
using emit::SignatureSimulation;

/// The file of the record for `simulator`; empty where there is no folder for it.
fs::path record_of(const std::string& spec_hash, std::string simulator) {
  const std::optional<fs::path> cache = cache_folder();
  if (!cache) return {};
  std::replace(simulator.begin(), simulator.end(), ' ', '_');
  return *cache / "simulations" / fmt::format("{}-{}.json", spec_hash, simulator);
}

std::optional<SignatureSimulation> read_record(const fs::path& path) {
  if (path.empty() || !path_exists(path)) return std::nullopt;
  const auto text = read_file(path);
  if (!text.ok()) return std::nullopt;
  return emit::simulation_in(nlohmann::json::parse(*text, nullptr, false));
}

Result<Done> write_record(const fs::path& path, const SignatureSimulation& run) {
  std::error_code failed;
  fs::create_directories(path.parent_path(), failed);
  if (failed) return cannot_write(path, failed.value());
  return write_kept_file(path, emit::to_json(run).dump() + "\n");
}

}  // namespace

Result<Done> keep_simulation(const std::string& spec_hash,
                             const verilator_tb::VerifyReport& report) {
  const SignatureSimulation run = {.simulator = report.simulator,
                                   .comparisons = report.comparisons,
                                   .recomputations = report.recomputations,
                                   .passed = report.passed()};
  const fs::path path = record_of(spec_hash, run.simulator);
  if (path.empty()) return Done{};
  const std::optional<SignatureSimulation> kept = read_record(path);
  if (kept && run.passed && kept->comparisons > run.comparisons) return Done{};
  return write_record(path, run);
}

std::vector<SignatureSimulation> simulations_of(const std::string& spec_hash) {
  std::vector<SignatureSimulation> runs;
  for (const char* simulator : {verilator_tb::verilator_name, verilator_tb::icarus_name}) {
    if (auto run = read_record(record_of(spec_hash, simulator))) runs.push_back(std::move(*run));
  }
  return runs;
}

}  // namespace mixcmp::tasks
