#include "generator/faces/cli/lane_traffic.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <numeric>

#include "generator/faces/cli/exit.hpp"
#include "generator/hardware/emit/system.hpp"
#include "model/base/common/scratch_folder.hpp"
#include "model/base/number/double.hpp"
#include "verilator_tb/expected_words.hpp"
#include "verilator_tb/verify.hpp"

namespace mixcmp::cli {
namespace {

/// How many comparisons are simulated, and how many of them come before the one that is followed.
constexpr std::uint64_t simulated = 120, before = 3;
/// How many comparisons are looked through for one that a lane leaves undecided.
constexpr std::uint64_t looked_through = 1 << 22;

/// The design with one of its lanes and one reference, as a system without an engine. A lane treats
/// a comparison there in the same way.
design::Design small_system(design::Design design) {
  design.lanes.erase(design.lanes.begin() + 1, design.lanes.end());
  design.lanes.front().count = 1;
  design.system.lanes_per_group = 1;
  if (!design.references.empty()) {
    design.references.resize(1);
    design.references.front().count = std::min(1, design.references.front().count);
  }
  design.second_tier.reset();
  design.system.engine = {};
  return design;
}

/// Describes the system that is simulated in the place of `design`.
std::string describe(const design::Design& design) {
  const bool has_engine = design.system.engine.kind != scene::EngineKind::none;
  return fmt::format(
      "one lane in {} and {} reference{}", design::format_name(design.lanes.front().lane),
      design.reference_count() == 0 ? "no" : "one", has_engine ? ", without the engine" : "");
}

/// The index of the first comparison that the emulated lane leaves undecided; 0 where there is none
/// among those that are looked through, or where the lane cannot be emulated.
std::uint64_t find_undecided(const design::Design& design, const data::Comparisons& data) {
  if (!fits_double(data.format())) return 0;
  const verilator_tb::ExpectedWords words(design, data);
  if (!words.emulates(0)) return 0;
  constexpr std::uint64_t step = 1 << 16;
  const std::uint64_t all = std::min(data.size(), looked_through);
  for (std::uint64_t first = 0; first < all; first += step) {
    std::vector<std::uint64_t> indices(std::min(step, all - first));
    std::iota(indices.begin(), indices.end(), first);
    const std::vector<ResultWord> found = words.find(0, indices);
    const auto at = std::find_if(found.begin(), found.end(),
                                 [](const ResultWord& word) { return !word.is_decided_by_lane(); });
    if (at != found.end()) return first + static_cast<std::uint64_t>(at - found.begin());
  }
  return 0;
}

Result<verilator_tb::VerifyReport> simulate(const design::Design& design,
                                            const data::Comparisons& data,
                                            const verilator_tb::System& system,
                                            verilator_tb::VerifyOptions options) {
  options.simulator = verilator_tb::SimulatorKind::icarus;
  auto report = verilator_tb::verify(design, data, system, options);
  if (report.ok() || report.error().kind != ErrorKind::missing_tool) return report;
  options.simulator = verilator_tb::SimulatorKind::verilator;
  return verilator_tb::verify(design, data, system, options);
}

}  // namespace

Result<report::LaneTraffic> lane_traffic(const design::Design& design,
                                         const data::Comparisons& data) {
  const design::Design small = small_system(design);
  MIXCMP_TRY(generated, emit::generate_system(small, ""));
  MIXCMP_TRY(scratch, ScratchFolder::make());
  const verilator_tb::System system{scratch.path() / "rtl", generated.signature};
  MIXCMP_DO(emit::write_system(generated, system.directory));
  report::LaneTraffic traffic{.system = describe(design), .simulator = {}, .transfers = {}};
  verilator_tb::VerifyOptions options{.work_dir = scratch.path() / "build"};
  const std::uint64_t followed = find_undecided(small, data);
  options.selection.limit = simulated;
  options.selection.start = followed - std::min(followed, before);
  options.progress = show_progress;
  options.on_result = [&traffic](const verilator_tb::VerifiedResult& result) {
    if (!result.transfer || result.transfer->lane != 0) return;
    traffic.transfers.push_back({.index = result.index,
                                 .cycle_accepted = result.transfer->cycle_accepted,
                                 .cycle_left = result.transfer->cycle_left,
                                 .result = result.word});
  };
  const auto report = simulate(small, data, system, options);
  show_progress("");
  if (!report.ok()) {
    scratch.keep_for(report.error());
    return report.error();
  }
  if (!report->passed()) {
    return Error{.message = "the simulated system and its model differ: see mixcmp verify",
                 .kind = ErrorKind::refuted};
  }
  traffic.simulator = report->simulator;
  return traffic;
}

}  // namespace mixcmp::cli
