#include "verilator_tb/engine_model.hpp"

#include <algorithm>
#include <utility>

#include "generator/hardware/emit/scheduled_system.hpp"

namespace mixcmp::verilator_tb {
namespace {

/// Cycles of the slowest lane, without the conversion in front of the lanes.
int lane_latency_cycles(const emit::ScheduledSystem& scheduled) {
  int slowest = 0;
  for (const rtl::DatapathGroup& lanes : scheduled.shape.lane_groups) {
    slowest = std::max(slowest, lanes.schedule.latency_cycles);
  }
  return slowest;
}

/// Cycles of the slowest reference; 0 without references.
int reference_latency_cycles(const emit::ScheduledSystem& scheduled) {
  int slowest = 0;
  for (const rtl::DatapathGroup& references : scheduled.shape.reference_groups) {
    slowest = std::max(slowest, references.schedule.latency_cycles);
  }
  return slowest;
}

/// Recomputations that the design's references can start in a cycle, at most 1.
double recomputations_per_cycle(const design::Design& design) {
  double started = 0;
  for (const design::ReferenceGroup& group : design.references) {
    started += static_cast<double>(group.count) / group.structure.initiation_interval;
  }
  return std::min(1.0, started);
}

}  // namespace

performance::PairwiseEngine pairwise_engine_of(const design::Design& design,
                                               const VerifyReport& report) {
  const emit::ScheduledSystem scheduled = emit::schedule_system(design).value();
  const auto undecided = static_cast<double>(report.undecided + report.recomputations);
  // Kinds of lanes that do not fill their segments have more segments than this.
  const int of_segment = design.system.engine.lanes_per_segment();
  const int segments = (scheduled.shape.lanes + of_segment - 1) / of_segment;
  return {
      .lanes = scheduled.shape.lanes,
      .lanes_per_segment = of_segment,
      .streams = std::min(scheduled.pairwise->streams(), segments),
      .report_as = design.system.engine.report_as,
      .lane_latency_cycles = lane_latency_cycles(scheduled),
      .undecided = undecided / static_cast<double>(std::max<std::uint64_t>(report.comparisons, 1)),
      .recomputations_per_cycle = recomputations_per_cycle(design),
      .reference_latency_cycles = reference_latency_cycles(scheduled)};
}

double expected_pairwise_cycles(const design::Design& design, const VerifyReport& report,
                                std::shared_ptr<const performance::PairwiseData> data) {
  return performance::PairwiseFlow(std::move(data)).cycles(pairwise_engine_of(design, report));
}

performance::Chain chain_of(const design::Design& design) {
  const emit::ScheduledSystem scheduled = emit::schedule_system(design).value();
  const rtl::SystemShape& shape = scheduled.shape;
  performance::Chain chain = {
      .lanes = shape.lanes,
      .streams = {.order = scene::ResultOrder::in_order,
                  .lane_latency_cycles = shape.lane_groups.front().schedule.latency_cycles,
                  .slots = 1 << shape.slot_bits},
      .references = shape.references,
      .word_latency_cycles = scheduled.words()->latency_cycles()};
  if (!shape.recomputes()) return chain;
  const datapath::Schedule& reference = shape.reference_groups.front().schedule;
  chain.streams.reference_latency_cycles = reference.latency_cycles;
  chain.streams.initiation_interval_cycles = reference.initiation_interval;
  chain.streams.lanes_served = (shape.lanes + shape.references - 1) / shape.references;
  return chain;
}

double expected_arg_min_cycles(const design::Design& design, const VerifyReport& report) {
  return performance::random_chain_cycles(chain_of(design), report.arg_min->rows,
                                          report.recomputation_rate());
}

}  // namespace mixcmp::verilator_tb
