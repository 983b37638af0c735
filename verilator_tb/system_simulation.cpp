#include "verilator_tb/system_simulation.hpp"

#include <fmt/core.h>

namespace mixcmp::tb {

model::Result<SystemSimulation> SystemSimulation::start(const Executable& executable,
                                                        const SimulationOptions& options) {
  Command command = {
      executable.path.string(),
      options.traffic == TrafficKind::stressed ? "traffic=stressed" : "traffic=full_rate",
      fmt::format("seed={}", options.seed), fmt::format("hang_cycles={}", options.hang_cycles)};
  if (!options.waves.empty()) command.push_back("trace=" + options.waves.string());
  for (const std::string& plusarg : options.plusargs) command.push_back("+" + plusarg);
  const auto log = executable.path.parent_path().parent_path() / "simulation.log";
  MIXCMP_TRY(child, Child::spawn(command, log));
  return SystemSimulation(std::move(child), log);
}

model::Result<Answer> SystemSimulation::exchange(const Block& block, int lanes) {
  Answer answer;
  if (send(block) && receive(answer, static_cast<std::size_t>(lanes))) return answer;
  return model::Error{
      .file = log_.string(),
      .message = "the simulator ended unexpectedly; its last words\n" + last_lines(log_, 20)};
}

bool SystemSimulation::send(const Block& block) {
  const wire::Request request{block.comparisons, block.resets.size(), block.last ? 1u : 0u};
  return child_.send(std::as_bytes(std::span(&request, 1))) &&
         child_.send(std::as_bytes(std::span(block.resets))) &&
         child_.send(std::as_bytes(std::span(block.operands)));
}

bool SystemSimulation::receive(Answer& answer, std::size_t lanes) {
  wire::Response response;
  if (!child_.receive(std::as_writable_bytes(std::span(&response, 1)))) return false;
  answer.results.resize(response.results);
  answer.violations.resize(response.violations);
  if (response.state == wire::State::drained) answer.lanes.resize(lanes);
  answer.cycles = response.cycles;
  answer.state = response.state;
  return child_.receive(std::as_writable_bytes(std::span(answer.results))) &&
         child_.receive(std::as_writable_bytes(std::span(answer.violations))) &&
         child_.receive(std::as_writable_bytes(std::span(answer.lanes)));
}

}  // namespace mixcmp::tb
