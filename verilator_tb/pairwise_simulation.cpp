#include "verilator_tb/pairwise_simulation.hpp"

namespace mixcmp::verilator_tb {

Result<PairwiseSimulation> PairwiseSimulation::start(const Executable& executable,
                                                     const SimulationOptions& options) {
  MIXCMP_TRY(process, SimulatorProcess::start(executable, options));
  return PairwiseSimulation(std::move(process));
}

Result<SetAnswer> PairwiseSimulation::exchange(const ItemSet& set, int streams, int answers) {
  SetAnswer answer;
  if (send(set) &&
      receive(answer, static_cast<std::size_t>(streams), static_cast<std::size_t>(answers)))
    return answer;
  return process_.ended_unexpectedly();
}

bool PairwiseSimulation::send(const ItemSet& set) {
  const harness::wire::SetRequest request{set.items, set.targets, set.reset_after,
                                          set.last ? 1u : 0u};
  return process_.send(std::span(&request, 1)) && process_.send(std::span(set.bytes));
}

bool PairwiseSimulation::receive(SetAnswer& answer, std::size_t streams, std::size_t answers) {
  if (!process_.receive(std::span(&answer.response, 1))) return false;
  answer.reports.resize(answer.response.reports);
  answer.violations.resize(answer.response.violations);
  answer.streams.resize(streams);
  answer.answers.resize(answers);
  return process_.receive(std::span(answer.reports)) &&
         process_.receive(std::span(answer.violations)) &&
         process_.receive(std::span(answer.streams)) && process_.receive(std::span(answer.answers));
}

}  // namespace mixcmp::verilator_tb
