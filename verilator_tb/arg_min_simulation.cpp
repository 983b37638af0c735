#include "verilator_tb/arg_min_simulation.hpp"

namespace mixcmp::verilator_tb {

Result<ArgMinSimulation> ArgMinSimulation::start(const Executable& executable,
                                                 const SimulationOptions& options) {
  MIXCMP_TRY(process, SimulatorProcess::start(executable, options));
  return ArgMinSimulation(std::move(process));
}

Result<LoadAnswer> ArgMinSimulation::exchange(const CandidateLoad& load, int lanes, int answers) {
  LoadAnswer answer;
  const bool sent = process_.send(std::span(&load.request, 1)) &&
                    process_.send(std::span(load.candidates)) &&
                    process_.send(std::span(load.rows));
  if (sent && receive(answer, static_cast<std::size_t>(lanes), static_cast<std::size_t>(answers)))
    return answer;
  return process_.ended_unexpectedly();
}

bool ArgMinSimulation::receive(LoadAnswer& answer, std::size_t lanes, std::size_t answers) {
  if (!process_.receive(std::span(&answer.response, 1))) return false;
  answer.rows.resize(answer.response.rows);
  answer.violations.resize(answer.response.violations);
  answer.lanes.resize(lanes);
  answer.answers.resize(answers);
  return process_.receive(std::span(answer.rows)) &&
         process_.receive(std::span(answer.violations)) &&
         process_.receive(std::span(answer.lanes)) && process_.receive(std::span(answer.answers));
}

}  // namespace mixcmp::verilator_tb
