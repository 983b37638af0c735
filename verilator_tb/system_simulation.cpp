#include "verilator_tb/system_simulation.hpp"

#include <fmt/core.h>

namespace mixcmp::verilator_tb {

namespace {

constexpr const char* log_name = "simulation.log";

}  // namespace

Result<SimulatorProcess> SimulatorProcess::start(const Executable& executable,
                                                 const SimulationOptions& options) {
  Command command = {
      executable.path.string(),
      options.traffic == TrafficKind::stressed ? "traffic=stressed" : "traffic=full_rate",
      fmt::format("seed={}", options.seed), fmt::format("hang_cycles={}", options.hang_cycles)};
  if (!options.waves.empty()) command.push_back("trace=" + options.waves.string());
  for (const std::string& plusarg : options.plusargs) command.push_back("+" + plusarg);
  MIXCMP_TRY(folder, ScratchFolder::make_in(executable.path.parent_path().parent_path(), "run"));
  MIXCMP_TRY(child, Child::spawn(command, folder.path() / log_name));
  return SimulatorProcess(std::move(folder), std::move(child));
}

Result<Done> SimulatorProcess::finish() {
  if (child_.finish()) return Done{};
  return ended_unexpectedly();
}

Error SimulatorProcess::ended_unexpectedly() {
  folder_.keep();
  // The simulator itself may be at fault: the next run builds it anew.
  std::error_code ignored;
  std::filesystem::remove(folder_.path().parent_path() / build_stamp, ignored);
  const auto log = folder_.path() / log_name;
  return {.file = log.string(),
          .message = "the simulator ended unexpectedly; its last words\n" + last_lines(log, 20)};
}

Result<SystemSimulation> SystemSimulation::start(const Executable& executable,
                                                 const SimulationOptions& options) {
  MIXCMP_TRY(process, SimulatorProcess::start(executable, options));
  return SystemSimulation(std::move(process));
}

Result<Answer> SystemSimulation::exchange(const Block& block, int groups, int answers) {
  Answer answer;
  const bool received = send(block) && receive(answer, static_cast<std::size_t>(groups),
                                               static_cast<std::size_t>(answers));
  if (received) return answer;
  return process_.ended_unexpectedly();
}

bool SystemSimulation::send(const Block& block) {
  const harness::wire::Request request{block.comparisons, block.resets.size(),
                                       block.last ? 1u : 0u};
  return process_.send(std::span(&request, 1)) && process_.send(std::span(block.resets)) &&
         process_.send(std::span(block.operands));
}

bool SystemSimulation::receive(Answer& answer, std::size_t groups, std::size_t answers) {
  harness::wire::Response response;
  if (!process_.receive(std::span(&response, 1))) return false;
  answer.results.resize(response.results);
  answer.violations.resize(response.violations);
  if (response.state == harness::wire::State::drained) {
    answer.groups.resize(groups);
    answer.answers.resize(answers);
  }
  answer.cycles = response.cycles;
  answer.state = response.state;
  return process_.receive(std::span(answer.results)) &&
         process_.receive(std::span(answer.violations)) &&
         process_.receive(std::span(answer.groups)) && process_.receive(std::span(answer.answers));
}

}  // namespace mixcmp::verilator_tb
