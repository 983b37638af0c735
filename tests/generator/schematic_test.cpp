#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "generator/hardware/datapath/delays.hpp"
#include "generator/hardware/datapath/schedule.hpp"
#include "generator/hardware/emit/scheduled_system.hpp"
#include "generator/hardware/emit/system.hpp"
#include "generator/hardware/rtl/item_words.hpp"
#include "generator/hardware/rtl/lane_module.hpp"
#include "generator/hardware/rtl/reference_module.hpp"
#include "generator/present/schematic/datapath_pipeline.hpp"
#include "generator/present/schematic/system_picture.hpp"
#include "model/lane/error/certified_lane.hpp"
#include "tests/support/sphere.hpp"
#include "tests/support/well_formed.hpp"

/// Pictures of lanes, references and systems against the generated RTL.
namespace mixcmp::test::schematic_test {
namespace {

using datapath::Schedule;
using page::Pipeline;
using page::PipelineUnit;

const datapath::DelayTable& delays() {
  static const datapath::DelayTable table = datapath::delays_of("virtex6-lx760").value();
  return table;
}

constexpr double target_mhz = 200;

std::vector<std::optional<Range>> ranges_of(const Graph& graph) {
  return std::vector<std::optional<Range>>(graph.inputs().size(), Range{0, 100});
}

design::Lane float_lane(BoundKind kind) {
  const Graph graph = sphere_graph();
  const Arithmetic reduced = {format("s12e8"), Rounding::nearest_even, Subnormals::flush};
  return error::certified_lane(lane_graph(graph, format("s53e8"), reduced, LaneInputs::exact),
                               {.kind = kind, .bound_digits = 4, .ranges = ranges_of(graph)})
      .value();
}

design::Lane fixed_lane(const FixedPoint& fixed_format) {
  const Graph graph = sphere_graph();
  return fixed::fixed_lane(graph, format("s53e8"),
                           {.format = fixed_format, .bound = {}, .ranges = ranges_of(graph)})
      .value();
}

/// The instances of units with cut points, apart from range checks, which share a box.
int unit_instances(const rtl::Module& module) {
  int count = 0;
  for (const rtl::ModuleItem& item : module.items) {
    const auto* instance = std::get_if<rtl::Instance>(&item);
    if (instance == nullptr || instance->module.find("range") != std::string::npos) continue;
    const auto is_mask = [](const rtl::Parameter& parameter) { return parameter.name == "CUTS"; };
    if (std::any_of(instance->parameters.begin(), instance->parameters.end(), is_mask)) ++count;
  }
  return count;
}

bool takes_cycles(const PipelineUnit& unit) {
  return unit.ready_cycle > unit.start_cycle;
}

int boxes(const Pipeline& pipeline) {
  int count = 0;
  for (const PipelineUnit& unit : pipeline.units) {
    if (takes_cycles(unit) && unit.title != "in range?") ++count;
  }
  return count;
}

/// Every box reads only ready values, the last is the decision, and some box reads each value.
void expect_whole(const Pipeline& pipeline) {
  std::vector<bool> is_read(pipeline.units.size(), false);
  for (const PipelineUnit& unit : pipeline.units) {
    for (const int operand : unit.operands) {
      is_read[operand] = true;
      EXPECT_LE(pipeline.units[operand].ready_cycle, unit.start_cycle)
          << pipeline.units[operand].title << " before " << unit.title;
    }
    EXPECT_EQ(unit.operands.empty(), unit.role == page::UnitRole::input) << unit.title;
  }
  const PipelineUnit& last = pipeline.units.back();
  EXPECT_EQ(last.role, page::UnitRole::decision);
  EXPECT_EQ(last.ready_cycle, pipeline.cycles);
  is_read.pop_back();
  EXPECT_EQ(std::count(is_read.begin(), is_read.end(), false), 0);
  EXPECT_EQ(fault_of_markup(draw(pipeline).to_text()), "");
}

TEST(Schematic, ALaneHasABoxForEachUnitOfItsModule) {
  const std::vector<design::Lane> lanes = {
      float_lane(BoundKind::relative),
      float_lane(BoundKind::running),
      float_lane(BoundKind::constant),
      fixed_lane({.bits = 13}),
      fixed_lane({.bits = 13, .is_block = true}),
  };
  for (const design::Lane& lane : lanes) {
    const Schedule schedule =
        datapath::schedule_lane(lane, scene::Multipliers::embedded, delays(), target_mhz);
    const Pipeline pipeline = schematic::lane_pipeline(lane, schedule);
    SCOPED_TRACE(design::describe_criterion(lane));
    EXPECT_EQ(boxes(pipeline),
              unit_instances(rtl::lane_module("lane", sphere_graph().inputs(), lane, schedule)));
    EXPECT_EQ(pipeline.cycles, schedule.latency_cycles);
    expect_whole(pipeline);
  }
}

TEST(Schematic, AReferenceHasABoxForEachUnitOfItsModule) {
  const TypedGraph reference = reference_graph(sphere_graph(), {format("s53e8")});
  const Schedule schedule = datapath::schedule_reference(reference, {}, delays(), target_mhz);
  const Pipeline pipeline = schematic::reference_pipeline(reference, schedule);
  EXPECT_EQ(boxes(pipeline), unit_instances(rtl::reference_module(
                                 "reference", sphere_graph().inputs(), reference, schedule)));
  expect_whole(pipeline);
}

/// Spheres in q13, each pair of which is made on the chip: 5 lanes in groups of 2.
design::Design pairwise_design() {
  design::Design design = sphere_design(format("s17e8"), format("s53e8"), 5, 2);
  design.lanes[0].lane = fixed_lane({.bits = 13});
  design.system = with_engine(design.system, {.kind = scene::EngineKind::pairwise,
                                              .capacity = 1000,
                                              .report = {Verdict::less},
                                              .report_streams = 3,
                                              .lanes_per_group = 2});
  return design;
}

TEST(Schematic, APairwiseEnginesConversionAndLanesHaveABoxForEachUnit) {
  const emit::ScheduledSystem scheduled = emit::schedule_system(pairwise_design()).value();
  const rtl::ItemWords& words = scheduled.pairwise->words;
  const Pipeline conversion =
      schematic::item_pipeline(words.loader_of(data::Item::first), words.items.schedule);
  EXPECT_EQ(boxes(conversion),
            unit_instances(rtl::item_word_module(words, data::Item::first, *scheduled.engine)));
  EXPECT_EQ(conversion.cycles, words.latency_cycles());
  EXPECT_EQ(conversion.units.front().title, "cx");
  const Schedule& schedule = scheduled.shape.lane_groups[0].schedule;
  fixed::FixedLane lane = std::get<fixed::FixedLane>(words.lanes[0].lane);
  for (const rtl::LanePort& port : words.lanes[0].ports) lane.input_names.push_back(port.name);
  const Pipeline pipeline = schematic::lane_pipeline(lane, schedule);
  EXPECT_EQ(boxes(pipeline),
            unit_instances(rtl::word_lane_module("lane", words.lanes[0], schedule)));
  EXPECT_EQ(pipeline.units.front().title, "cx_i");
  expect_whole(pipeline);
}

TEST(Schematic, APairwiseEngineIsDrawnWithItsStreamsAndReferences) {
  const emit::Signature signature = emit::generate_system(pairwise_design(), "")->signature;
  const std::string picture = schematic::system_picture(signature).to_text();
  for (const char* words : {"5 lanes, q13", "2 in lock step", "up to 1000", "3 streams",
                            "2 references in s53e8", "reads both items of a pair"}) {
    EXPECT_NE(picture.find(words), std::string::npos) << words;
  }
  EXPECT_EQ(picture.find("crossbar"), std::string::npos);
  EXPECT_EQ(fault_of_markup(picture), "");
}

TEST(Schematic, LanesInLockStepAreDrawnInGroups) {
  design::Design design = sphere_design(format("s17e8"), format("s53e8"), 6, 2);
  design.system.lanes_per_group = 3;
  const emit::Signature signature = emit::generate_system(design, "")->signature;
  const std::string picture = schematic::system_picture(signature).to_text();
  for (const std::string& words :
       {std::string("6 lanes in 2 groups of 3 in lock step, each group with:"),
        std::string("2 to 2"), fmt::format("3 x {} bytes", signature.tdata_bytes)}) {
    EXPECT_NE(picture.find(words), std::string::npos) << words;
  }
  EXPECT_EQ(fault_of_markup(picture), "");
}

TEST(Schematic, ASystemShowsItsOwnNumbers) {
  const design::Design design = sphere_design(format("s17e8"), format("s53e8"), 5, 2);
  const emit::Signature signature = emit::generate_system(design, "")->signature;
  const std::string picture = schematic::system_picture(signature).to_text();
  for (const std::string& words :
       {std::string("5 lanes, each with:"), std::string("2 references in s53e8"),
        std::string("5 to 2"), std::string("lane, s17e8"),
        std::to_string(signature.lane_groups[0].latency_cycles) + " cycles",
        std::to_string(signature.slots) + " slots"}) {
    EXPECT_NE(picture.find(words), std::string::npos) << words;
  }
  EXPECT_EQ(fault_of_markup(picture), "");
}

}  // namespace
}  // namespace mixcmp::test::schematic_test
