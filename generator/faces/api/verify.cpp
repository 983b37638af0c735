#include "generator/tasks/verify.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "generator/faces/api/state.hpp"
#include "generator/present/report/json_text.hpp"

namespace mixcmp::api {
namespace {

verilator_tb::SimulatorKind internal(Simulator simulator) {
  switch (simulator) {
    case Simulator::verilator: return verilator_tb::SimulatorKind::verilator;
    case Simulator::icarus: return verilator_tb::SimulatorKind::icarus;
  }
  MIXCMP_CHECK(false);
}

verilator_tb::TrafficKind internal(Traffic traffic) {
  switch (traffic) {
    case Traffic::full_rate: return verilator_tb::TrafficKind::full_rate;
    case Traffic::stressed: return verilator_tb::TrafficKind::stressed;
  }
  MIXCMP_CHECK(false);
}

std::optional<verilator_tb::TruthScope> internal(Truth truth) {
  switch (truth) {
    case Truth::off: return std::nullopt;
    case Truth::recomputed: return verilator_tb::TruthScope::recomputed;
    case Truth::all: return verilator_tb::TruthScope::all;
  }
  MIXCMP_CHECK(false);
}

/// Refuses numbers that no run can have.
void check_numbers(const VerifyOptions& options) {
  constexpr int most_resets = 1'000'000, most_jobs = 1024;
  const auto check = [](const char* field, int value, int most) {
    if (0 <= value && value <= most) return;
    fail({.field = field,
          .message = "no such number",
          .received = std::to_string(value),
          .accepted = fmt::format("0..{}", most)});
  };
  check("resets", options.resets, most_resets);
  check("jobs", options.jobs, most_jobs);
  const int choices = (options.first ? 1 : 0) + (options.sample ? 1 : 0) + (options.only ? 1 : 0);
  if (choices > 1) {
    fail({.field = "first, sample, only",
          .message = "several selections of comparisons",
          .received = std::to_string(choices),
          .accepted = "one of them, or none for all comparisons"});
  }
  if (options.first.value_or(1) > 0 && options.sample.value_or(1) > 0) return;
  fail({.field = options.first ? "first" : "sample",
        .message = "no comparison to verify",
        .received = "0",
        .accepted = "at least 1"});
}

tasks::VerifyOptions internal_options(const VerifyOptions& options) {
  tasks::VerifyOptions task{.work = options.work,
                            .jobs = options.jobs,
                            .truth = internal(options.truth),
                            .find_counterexample = options.find_counterexample};
  task.run.simulator = internal(options.simulator);
  task.run.traffic = internal(options.traffic);
  task.run.resets = options.resets;
  task.run.progress = options.progress;
  verilator_tb::Selection::Options& selection = task.run.selection;
  selection.limit = std::max(options.first.value_or(0), options.sample.value_or(0));
  if (options.sample) selection.sampling = verilator_tb::Sampling::random;
  selection.seed = options.seed;
  selection.only = options.only;
  return task;
}

}  // namespace

Verification verify(const Scene& scene, const VerifyOptions& options) {
  const SceneState& state = Access::state(scene);
  check_numbers(options);
  data_of(state, "verify needs data to run on");
  auto found = tasks::verify(state.request, state.loaded, internal_options(options));
  if (!found.ok()) {
    mixcmp::Error error = found.error();
    // The members of VerifyOptions have the names of the program's options.
    if (error.field.starts_with("--")) error.field.erase(0, 2);
    fail(error);
  }
  const verilator_tb::VerifyReport& report = found->report;
  return {.passed = report.passed(),
          .comparisons = report.comparisons,
          .recomputations = report.recomputations,
          .undecided = report.undecided,
          .mismatches = report.mismatch_count,
          .violations = report.violation_count,
          .not_done = found->not_done,
          .text = to_text(report),
          .json = report::json_text(to_json(report))};
}

}  // namespace mixcmp::api
