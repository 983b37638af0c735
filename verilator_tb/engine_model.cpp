#include "verilator_tb/engine_model.hpp"

#include <algorithm>

#include "generator/hardware/emit/scheduled_system.hpp"

namespace mixcmp::verilator_tb {
namespace {

/// Cycles of the slowest lane, and of the conversion in front of the lanes.
int word_latency_cycles(const emit::ScheduledSystem& scheduled) {
  int slowest = 0;
  for (const rtl::DatapathGroup& lanes : scheduled.shape.lane_groups) {
    slowest = std::max(slowest, lanes.schedule.latency_cycles);
  }
  return scheduled.words()->latency_cycles() + slowest;
}

/// The longest initiation interval of the design's references.
int initiation_interval(const design::Design& design) {
  int slowest = 1;
  for (const design::ReferenceGroup& group : design.references) {
    slowest = std::max(slowest, group.structure.initiation_interval);
  }
  return slowest;
}

}  // namespace

performance::PairwiseSet pairwise_set_of(const design::Design& design, const VerifyReport& report) {
  const emit::ScheduledSystem scheduled = emit::schedule_system(design).value();
  const int segments = scheduled.pairwise->segment_count();
  const int streams = scheduled.pairwise->streams();
  const bool tells_pairs = design.system.engine.report_as != scene::ReportForm::count;
  const std::uint64_t leave =
      report.undecided + report.recomputations + (tells_pairs ? report.engine->reported : 0);
  // Streams share the segments. Where these do not divide evenly, one stream has more than others.
  const int segments_of_one = (segments + streams - 1) / streams;
  const double share = double(segments_of_one) / segments;
  return {.items = report.engine->items - report.engine->others,
          .others = report.engine->others,
          .lanes = scheduled.shape.lanes,
          .segments = segments,
          .lane_latency_cycles = word_latency_cycles(scheduled),
          .exceptions = static_cast<std::uint64_t>(static_cast<double>(leave) * share),
          .recomputations = report.recomputations,
          .references = scheduled.shape.references,
          .initiation_interval = initiation_interval(design)};
}

std::optional<double> expected_pairwise_cycles(const design::Design& design,
                                               const VerifyReport& report) {
  if (design.system.engine.report_as == scene::ReportForm::bitmap) return std::nullopt;
  return performance::pairwise_cycles(pairwise_set_of(design, report));
}

performance::Chain chain_of(const design::Design& design) {
  const emit::ScheduledSystem scheduled = emit::schedule_system(design).value();
  const rtl::SystemShape& shape = scheduled.shape;
  const datapath::Schedule& reference = shape.reference_groups.front().schedule;
  return {.lanes = shape.lanes,
          .streams = {.order = scene::ResultOrder::in_order,
                      .lane_latency_cycles = shape.lane_groups.front().schedule.latency_cycles,
                      .reference_latency_cycles = reference.latency_cycles,
                      .initiation_interval_cycles = reference.initiation_interval,
                      .slots = 1 << shape.slot_bits,
                      .lanes_served = (shape.lanes + shape.references - 1) / shape.references},
          .references = shape.references,
          .word_latency_cycles = scheduled.words()->latency_cycles()};
}

double expected_arg_min_cycles(const design::Design& design, const VerifyReport& report) {
  return performance::random_chain_cycles(chain_of(design), report.arg_min->rows,
                                          report.recomputation_rate());
}

}  // namespace mixcmp::verilator_tb
