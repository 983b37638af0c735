#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <regex>

#include "generator/hardware/emit/system.hpp"
#include "generator/synthesis/characterise/job_hash.hpp"
#include "generator/synthesis/components/characterise.hpp"
#include "generator/synthesis/components/component_list.hpp"
#include "generator/synthesis/components/synthesis_jobs.hpp"
#include "model/base/number/lane_format.hpp"
#include "model/base/settings/bound_name.hpp"
#include "model/cost/devices/device.hpp"
#include "model/cost/measured/component_cells.hpp"
#include "model/design/slots.hpp"
#include "model/judge/workload/load_comparisons.hpp"
#include "model/plan/profile/profiled_error.hpp"
#include "model/scene/lane_bound.hpp"
#include "tests/generator/components_fixture.hpp"

namespace mixcmp::test::components_test {
namespace {

/// The file of a generated system whose name contains `part`, without its comments.
std::string generated(const emit::GeneratedSystem& system, const std::string& part) {
  for (const emit::GeneratedFile& file : system.files) {
    const bool is_channel = file.name.find("channel") != std::string::npos;
    if (file.name.find(part) != std::string::npos && !is_channel)
      return components::without_comments(file.text);
  }
  return "";
}

std::string from_ports(const std::string& verilog) {
  return verilog.substr(std::min(verilog.find('('), verilog.size()));
}

TEST_F(Components, AreWhatGenerateWrites) {
  const scene::Scene spheres_scene = scene(one_system);
  const auto system =
      emit::generate_system(design::make_design(spheres_scene, nullptr).value(), "");
  ASSERT_TRUE(system.ok());
  components::ComponentQuery query = lanes({12}, {"relative"});
  query.kinds = {measured::ComponentKind::lane, measured::ComponentKind::reference,
                 measured::ComponentKind::fifo, measured::ComponentKind::crossbar};
  query.crossbars = {1};
  const Found found = find(spheres_scene, query);
  ASSERT_EQ(found.components.size(), 4u);
  for (const auto& [key, component] : found.components) {
    if (kind_of(key) == measured::ComponentKind::lane) {
      EXPECT_EQ(component.latency_cycles, system->signature.lane_groups[0].latency_cycles);
      EXPECT_EQ(from_ports(source(component, "lane.v")), from_ports(generated(*system, "_lane_")));
    }
    if (kind_of(key) == measured::ComponentKind::reference) {
      EXPECT_EQ(component.latency_cycles, system->signature.reference_groups[0].latency_cycles);
      EXPECT_EQ(from_ports(source(component, "reference.v")),
                from_ports(generated(*system, "_reference_")));
    }
    if (kind_of(key) == measured::ComponentKind::fifo) {
      EXPECT_EQ(count_of(key), system->signature.slots);
    }
  }
}

TEST_F(Components, ReferencesArePlacedForTheirOwnTargets) {
  const auto generated_for = [&](const std::vector<std::string>& overrides) {
    std::ofstream(directory_.path() / "scene.toml") << spheres << one_system;
    const auto loaded = scene::load_scene(directory_.path() / "scene.toml", overrides);
    const auto system = emit::generate_system(design::make_design(*loaded, nullptr).value(), "");
    return std::pair(from_ports(generated(*system, "_lane_")),
                     from_ports(generated(*system, "_reference_")));
  };
  const auto usual = generated_for({});
  const auto fast = generated_for({"reference.target_mhz=400"});
  EXPECT_EQ(fast.first, usual.first);
  EXPECT_NE(fast.second, usual.second);
  EXPECT_EQ(fast.second, generated_for({"system.target_mhz=400"}).second);
  components::ComponentQuery query;
  query.kinds = {measured::ComponentKind::reference};
  query.multipliers = {scene::Multipliers::embedded};
  query.reference_targets = {200, 400};
  const Found found = find(scene(one_system), query);
  ASSERT_EQ(found.components.size(), 2u);
  for (const auto& [key, component] : found.components) {
    const std::optional<int> own = std::get<measured::Reference>(key).target_mhz;
    EXPECT_TRUE(!own || *own == 400) << "200 is the system's";
    EXPECT_EQ(from_ports(source(component, "reference.v")), own ? fast.second : usual.second);
  }
}

const std::string one_engine =
    "[reduced]\nformat = \"q12\"\n[system]\nlanes = 24\nreferences = 1\nprefix = \"\"\n"
    "[engine]\nkind = \"pairwise\"\nreport_streams = 2\n";

TEST_F(Components, OfAnEngineAreWhatGenerateWrites) {
  const scene::Scene engine_scene = scene(one_engine);
  const auto system = emit::generate_system(design::make_design(engine_scene, nullptr).value(), "");
  ASSERT_TRUE(system.ok());
  components::ComponentQuery query = lanes({12}, {"fixed_norm"});
  query.kinds = {measured::ComponentKind::lane, measured::ComponentKind::segment,
                 measured::ComponentKind::conversion, measured::ComponentKind::engine,
                 measured::ComponentKind::reference_port};
  const Found found = find(engine_scene, query);
  EXPECT_EQ(found.count(measured::ComponentKind::lane), 1);
  EXPECT_EQ(found.count(measured::ComponentKind::segment), 1);
  EXPECT_EQ(found.count(measured::ComponentKind::conversion), 1);
  EXPECT_EQ(found.count(measured::ComponentKind::reference_port), 1);
  EXPECT_EQ(found.count(measured::ComponentKind::engine), 2);
  const auto written_of = [](const components::Component& component) {
    return from_ports(source(component, component.job().top + ".v"));
  };
  for (const auto& [key, component] : found.components) {
    if (kind_of(key) == measured::ComponentKind::lane) {
      EXPECT_EQ(written_of(component), from_ports(generated(*system, "_pair_lane_q12_l5")));
    }
    if (kind_of(key) == measured::ComponentKind::segment) {
      EXPECT_EQ(count_of(key), 8);
      const std::regex lane("engine_pair_lane");  // components have no scene's name
      EXPECT_EQ(std::regex_replace(written_of(component), lane, "spheres_pair_lane"),
                from_ports(generated(*system, "_segment_of_8")));
    }
    if (kind_of(key) == measured::ComponentKind::conversion) {
      EXPECT_EQ(written_of(component), from_ports(generated(*system, "_item_l")));
    }
    if (kind_of(key) == measured::ComponentKind::engine) {
      const std::string parameter = fmt::format("parameter SEGMENTS = {},", *count_of(key));
      EXPECT_NE(source(component, "pairwise_engine.v").find(parameter), std::string::npos);
      EXPECT_NE(source(component, "pairwise_engine.v").find("parameter STREAMS = 2,"),
                std::string::npos);
    }
  }
}

constexpr const char* nearest =
    "[comparison]\nname = \"nearest\"\n"
    "f = \"(x - cxi)^2 + (y - cyi)^2\"\ng = \"(x - cxj)^2 + (y - cyj)^2\"\n"
    "[inputs]\n\"*\" = { range = [0, 100] }\n"
    "[reference]\nformat = \"s24e8\"\n";

const std::string one_chain =
    "[reduced]\nformat = \"q9\"\n[system]\nlanes = 6\nreferences = 1\nprefix = \"\"\n"
    "[engine]\nkind = \"arg_min\"\n";

components::ComponentQuery parts_of_a_chain() {
  return {.kinds = {measured::ComponentKind::lane, measured::ComponentKind::segment,
                    measured::ComponentKind::conversion, measured::ComponentKind::engine,
                    measured::ComponentKind::operand_memory, measured::ComponentKind::crossbar,
                    measured::ComponentKind::reference, measured::ComponentKind::reference_port},
          .precisions = {9},
          .bounds = {settings::parse_bound("fixed_norm").value()},
          .multipliers = {scene::Multipliers::embedded},
          .crossbars = {1, 6}};
}

TEST_F(Components, OfAChainAreWhatGenerateWrites) {
  const scene::Scene chain = scene(one_chain, nearest);
  const auto system = emit::generate_system(design::make_design(chain, nullptr).value(), "");
  ASSERT_TRUE(system.ok());
  const Found found = find(chain, parts_of_a_chain());
  const auto written_of = [](const components::Component& component) {
    const std::regex scene_name("engine_(pair_lane|item)");  // components have no scene's name
    return std::regex_replace(from_ports(source(component, component.job().top + ".v")), scene_name,
                              "nearest_$1");
  };
  std::map<measured::ComponentKind, std::vector<int>> ports;
  for (const auto& [key, component] : found.components) {
    ports[kind_of(key)].push_back(count_of(key).value_or(0));
    if (kind_of(key) == measured::ComponentKind::lane) {
      EXPECT_EQ(written_of(component), from_ports(generated(*system, "_pair_lane_q9")));
    }
    if (kind_of(key) == measured::ComponentKind::segment) {
      const auto channel = std::find_if(
          system->files.begin(), system->files.end(), [](const emit::GeneratedFile& file) {
            return file.name.find("_pair_lane_q9") != std::string::npos &&
                   file.name.find("channel") != std::string::npos;
          });
      ASSERT_NE(channel, system->files.end());
      EXPECT_EQ(written_of(component), from_ports(components::without_comments(channel->text)));
    }
    if (kind_of(key) == measured::ComponentKind::engine) {
      const std::string parameter = fmt::format("parameter CANDIDATES = {},", *count_of(key) + 1);
      EXPECT_NE(source(component, "arg_min_engine.v").find(parameter), std::string::npos);
    }
    if (kind_of(key) == measured::ComponentKind::conversion) {
      EXPECT_NE(source(component, component.job().top + ".v").find("row_conversion"),
                std::string::npos);
    }
  }
  EXPECT_EQ(ports[measured::ComponentKind::segment], std::vector<int>{1});
  EXPECT_EQ(ports[measured::ComponentKind::engine], (std::vector<int>{1, 6}));
  EXPECT_EQ(ports[measured::ComponentKind::operand_memory], (std::vector<int>{1, 4}));
  EXPECT_EQ(ports[measured::ComponentKind::crossbar], (std::vector<int>{1, 6}));
  EXPECT_EQ(ports[measured::ComponentKind::conversion].size(), 1u);
  EXPECT_EQ(ports[measured::ComponentKind::reference_port].size(), 1u);
}

TEST_F(Components, OfAChainNeedItsNumberOfLanes) {
  const std::string unknown = std::regex_replace(one_chain, std::regex("lanes = 6\n"), "");
  components::ComponentMaker maker(scene(unknown, nearest), nullptr);
  const auto missing = for_each_component(maker, parts_of_a_chain(), [](const auto&) {});
  ASSERT_FALSE(missing.ok());
  EXPECT_EQ(missing.error().field, "system.lanes");
}

TEST_F(Components, TheLaneOfASecondTierIsOne) {
  components::ComponentQuery query = lanes({12}, {"fixed_norm"});
  query.kinds = {measured::ComponentKind::lane};
  const Found found = find(scene(one_engine + "[second_tier]\nformat = \"q15\"\n"), query);
  EXPECT_EQ(found.formats("fixed_norm"), (std::vector<std::string>{"q12", "q15"}));
}

TEST_F(Components, LanesInFloatingPointHaveNoConversion) {
  components::ComponentQuery query = lanes({12}, {"relative"});
  query.kinds = {measured::ComponentKind::segment, measured::ComponentKind::conversion};
  const Found found = find(scene("[system]\nlanes = 8\n[engine]\nkind = \"pairwise\"\n"), query);
  EXPECT_EQ(found.count(measured::ComponentKind::segment), 1);
  EXPECT_EQ(found.count(measured::ComponentKind::conversion), 0);
}

TEST_F(Components, ExponentBitsFollowTheScene) {
  const components::ComponentQuery query = lanes({8, 12}, {"relative"});
  const auto formats = [&](const std::string& rest,
                           std::optional<components::LaneExponents> exponents) {
    components::ComponentQuery asked = query;
    asked.exponents = exponents;
    return find(scene(rest), asked).formats("relative");
  };
  using Names = std::vector<std::string>;
  const std::string fixed = "[reduced]\nformat = \"s10e7\"\n";
  const std::string ranged = "[reduced]\nformat = \"s10\"\n";
  EXPECT_EQ(formats("[reduced]\nformat = \"auto\"\n", {}), (Names{"s12e8", "s8e8"}));
  EXPECT_EQ(formats(fixed, {}), (Names{"s12e7", "s8e7"}));
  const Names fewest = formats(ranged, {});
  EXPECT_EQ(fewest.size(), 2u);
  EXPECT_NE(fewest, (Names{"s12e8", "s8e8"}));
  EXPECT_EQ(formats(fixed, components::LaneExponents::ranges), fewest);
  EXPECT_EQ(formats(ranged, components::LaneExponents::reference), (Names{"s12e8", "s8e8"}));
}

TEST_F(Components, LanesInFixedPointAreWhatGenerateWritesOnceForAllInputs) {
  const scene::Scene ranged =
      scene("[reduced]\nformat = \"q12\"\n[system]\nlanes = 1\nreferences = 1\nprefix = \"\"\n");
  const auto system = emit::generate_system(design::make_design(ranged, nullptr).value(), "");
  ASSERT_TRUE(system.ok());
  components::ComponentQuery query = lanes({12, 50}, {"fixed_norm"});
  query.inputs = {LaneInputs::exact, LaneInputs::rounded};
  query.multipliers = {scene::Multipliers::embedded, scene::Multipliers::logic};
  const Found found = find(ranged, query);
  ASSERT_EQ(found.components.size(), 2u);  // none of 50 bits
  for (const auto& [key, component] : found.components) {
    const auto& lane = std::get<measured::Lane>(key);
    EXPECT_EQ(lane.format.name(), "q12");
    EXPECT_FALSE(lane.inputs.has_value());
    const bool same =
        from_ports(source(component, "lane.v")) == from_ports(generated(*system, "_lane_"));
    EXPECT_EQ(same, lane.multipliers == scene::Multipliers::embedded);
  }
  EXPECT_TRUE(found.missing.empty());
}

TEST_F(Components, OnlyLanesInFixedPointHaveMemoriesOfSquares) {
  components::ComponentQuery query = lanes({12, 16}, {"running_4", "fixed_norm"});
  query.kinds.insert(measured::ComponentKind::reference);
  query.multipliers = {scene::Multipliers::memory};
  const Found found = find(scene("[reduced]\nformat = \"auto\"\n"), query);
  ASSERT_EQ(found.components.size(), 2u);
  for (const auto& [key, component] : found.components) {
    const bool lane = kind_of(key) == measured::ComponentKind::lane;
    const measured::KeyCells cells = cells_of(key);
    EXPECT_EQ(cells.format, lane ? "q12" : "s24e8");
    EXPECT_EQ(cells.multipliers, lane ? "memory" : "embedded");
  }
  ASSERT_EQ(found.missing.size(), 1u);
  EXPECT_EQ(found.missing[0].key.format.name(), "q16");
  EXPECT_EQ(found.missing[0].reason.field, "reduced.multipliers");
}

/// A lane of as many digits as its inputs is a lane of rounded inputs.
TEST_F(Components, InputsOfSoManyDigitsAreThoseOfLanesWithFewer) {
  components::ComponentQuery query = lanes({11, 12, 13}, {"running_4"});
  query.inputs = {LaneInputs::of_digits(12), LaneInputs::rounded};
  const Found found = find(scene("[reduced]\nformat = \"auto\"\n"), query);
  std::vector<std::string> names;
  for (const auto& [key, component] : found.components) {
    const auto& lane = std::get<measured::Lane>(key);
    names.push_back(lane.format.name() + " " + to_string(lane.inputs));
  }
  EXPECT_EQ(names, (std::vector<std::string>{"s11e8 12", "s11e8 rounded", "s12e8 rounded",
                                             "s13e8 rounded"}));
}

TEST_F(Components, LanesThatDoNotExistAreToldWithTheirReason) {
  components::ComponentQuery query = lanes({4, 12}, {"relative", "running_4", "constant"});
  query.inputs = {LaneInputs::exact, LaneInputs::rounded};
  const Found found = find(scene("[reduced]\nformat = \"auto\"\n"), query);
  EXPECT_FALSE(found.missing.empty());
  for (const components::MissingLane& lane : found.missing)
    EXPECT_FALSE(lane.reason.message.empty());
  EXPECT_EQ(found.components.size() + found.missing.size(), 12u);
  const auto is_rounded_relative = [](const components::MissingLane& lane) {
    return to_string(lane.key.bound) == "relative" && lane.key.inputs == LaneInputs::rounded;
  };
  EXPECT_EQ(std::count_if(found.missing.begin(), found.missing.end(), is_rounded_relative), 2)
      << "differences of rounded operands have no relative bound";
}

TEST_F(Components, ProfiledLanesTakeTheirConstantsFromTheSceneOrItsData) {
  const components::ComponentQuery query = lanes({12}, {"profiled"});
  const Found none = find(scene("[reduced]\nformat = \"auto\"\n"), query);
  ASSERT_EQ(none.missing.size(), 1u);
  EXPECT_NE(none.missing[0].reason.field.find("relative_error"), std::string::npos);
  const Found given = find(scene("[reduced]\nformat = \"auto\"\nbound = \"profiled\"\n"
                                 "relative_error_f = 0.001\nrelative_error_g = 0.001\n"),
                           query);
  ASSERT_EQ(given.components.size(), 1u);
  const scene::Scene with_data = scene("[data]\nfile = \"rows.csv\"\n");
  std::ofstream(directory_.path() / "rows.csv")
      << "xi,xj,yi,yj,ri,rj\n0.1,3.7,2.2,9.1,1.3,4.4\n5.1,3.3,8.7,0.9,2.3,3.1\n";
  const auto data = workload::load_comparisons(with_data);
  ASSERT_TRUE(data.ok()) << data.error().to_string();
  components::ComponentMaker maker(with_data, &*data);
  const auto measured = maker.make(given.components.begin()->first);
  ASSERT_TRUE(measured.ok()) << measured.error().to_string();
  EXPECT_NE(source(*measured, "lane.v"), source(given.components.begin()->second, "lane.v"));
  // The lane that `generate` makes measures the same two comparisons.
  scene::ReducedSpec reduced = with_bound(with_data.reduced, {.kind = BoundKind::profiled});
  reduced.format = FloatFormat::parse("s12e8").value();
  const auto lane = design::design_lane(with_data, reduced, &*data, profile::profile_error);
  ASSERT_TRUE(lane.ok()) << lane.error().to_string();
  const auto rtl = components::lane_rtl(with_data.graph.inputs(), design::float_lane(*lane),
                                        reduced.multipliers, with_data.system);
  EXPECT_EQ(source(*measured, "lane.v"), components::module_job(rtl->module).sources.back().text);
}

TEST_F(Components, WithoutProductsThereIsOneKindOfMultipliers) {
  const std::string sums =
      "[comparison]\nname = \"sums\"\nf = \"a + b\"\ng = \"c\"\n"
      "[reference]\nformat = \"s24e8\"\n[reduced]\nformat = \"auto\"\n";
  components::ComponentQuery query = lanes({12}, {"running_4"});
  query.kinds.insert(measured::ComponentKind::reference);
  query.multipliers = {scene::Multipliers::embedded, scene::Multipliers::logic};
  const Found found = find(scene("", sums), query);
  EXPECT_EQ(found.components.size(), 2u);
  for (const auto& [key, component] : found.components) EXPECT_EQ(cells_of(key).multipliers, "");
  EXPECT_EQ(find(scene(one_system), query).count(measured::ComponentKind::reference), 2);
}

TEST_F(Components, FifosHaveTheSlotsThatTheLanesNeed) {
  components::ComponentQuery query = lanes({6, 23}, {"relative"});
  std::set<int> needed;
  for (const auto& [key, lane] : find(scene(one_system), query).components) {
    needed.insert(design::slots_for(lane.latency_cycles, true));
  }
  query.kinds = {measured::ComponentKind::fifo};
  std::set<int> built;
  for (const auto& [key, fifo] : find(scene(one_system), query).components) {
    built.insert(std::get<measured::Fifo>(key).slots);
    EXPECT_EQ(fifo.job().top, "lane_scoreboard");
  }
  EXPECT_EQ(built, needed);
  const std::string in_order = one_system + "order = \"in_order\"\n";
  for (const auto& [key, fifo] : find(scene(in_order), query).components) {
    EXPECT_EQ(fifo.job().top, "lane_reorder");
  }
}

TEST_F(Components, CrossbarsTakeTheirPortsAndThePayload) {
  components::ComponentQuery query{.kinds = {measured::ComponentKind::crossbar},
                                   .crossbars = {1, 5, 17}};
  const Found carried = find(scene(one_system), query);
  ASSERT_EQ(carried.components.size(), 3u);
  const components::Component& five = carried.components.at(measured::Crossbar{5});
  EXPECT_NE(source(five, "stream_crossbar.v").find("parameter LANES = 5,"), std::string::npos);
  EXPECT_NE(source(five, "stream_crossbar.v").find("parameter PAYLOAD_BITS = 192,"),
            std::string::npos)
      << "six operands of 32 bits";
  EXPECT_EQ(five.latency_cycles, 4);
  const Found in_beats = find(scene(one_system + "request_beats = 4\n"), query);
  const components::Component& narrow = in_beats.components.at(measured::Crossbar{5});
  EXPECT_NE(source(narrow, "stream_crossbar.v").find("parameter PAYLOAD_BITS = 48,"),
            std::string::npos);
  EXPECT_NE(source(narrow, "stream_crossbar.v").find("parameter BEAT_BITS = 2\n"),
            std::string::npos);
  EXPECT_EQ(narrow.latency_cycles, 6);
  const Found refetched = find(scene(one_system + "operands = \"refetched\"\n"), query);
  const components::Component& tags = refetched.components.at(measured::Crossbar{5});
  EXPECT_NE(source(tags, "stream_crossbar.v").find("parameter PAYLOAD_BITS = 32,"),
            std::string::npos);
}

TEST_F(Components, SourcesHoldNothingButHardware) {
  const Found found = find(scene(one_system), lanes({12}, {"relative"}));
  for (const characterise::SourceText& text : found.components.begin()->second.job().sources) {
    EXPECT_EQ(text.text.find("//"), std::string::npos);
    EXPECT_EQ(text.text.find("\n\n"), std::string::npos);
  }
  EXPECT_EQ(components::without_comments("// a\n\nwire b;  // c\n  wire d; \n"),
            "wire b;\n  wire d;\n");
}

TEST_F(Components, ATableIsCurrentUntilTheSceneChanges) {
  const scene::Scene before = scene(one_system);
  const devices::Device device = devices::find_device("ice40-hx8k").value();
  components::ComponentQuery query = lanes({8, 12}, {"relative"});
  query.kinds = {measured::ComponentKind::lane, measured::ComponentKind::reference,
                 measured::ComponentKind::crossbar};
  query.crossbars = {2};
  measured::Characterisation table;
  for (const auto& [key, component] : find(before, query).components) {
    measured::Measurement row{.key = key, .hash = "", .tools = "Yosys of another machine"};
    row.timing_seeds = kind_of(key) == measured::ComponentKind::lane ? 3 : 0;
    const characterise::SynthesisOptions options =
        row.timing_seeds == 0
            ? characterise::SynthesisOptions{.effort = characterise::TimingEffort::area_only}
            : characterise::SynthesisOptions{.seeds = 3};
    row.hash = job_hash(component.job(), device, options, row.tools);
    table.rows.push_back(row);
  }
  ASSERT_GE(table.rows.size(), 4u);
  const int rows = static_cast<int>(table.rows.size());
  EXPECT_EQ(components::count_rows(table, before, nullptr, device).outdated, 0);
  EXPECT_EQ(components::count_rows(table, before, nullptr, device).all, rows);

  const scene::Scene refetching = scene(one_system + "operands = \"refetched\"\n");
  EXPECT_EQ(components::count_rows(table, refetching, nullptr, device).outdated, 1)
      << "the crossbar";
  const scene::Scene other = scene(one_system + "target_mhz = 50\n");
  EXPECT_GE(components::count_rows(table, other, nullptr, device).outdated, 3)
      << "lanes and references";
  devices::Device remapped = device;
  remapped.synthesis += " -abc2";
  EXPECT_EQ(components::count_rows(table, before, nullptr, remapped).outdated, rows);

  table.rows[0].timing_seeds = 5;
  EXPECT_EQ(components::count_rows(table, before, nullptr, device).outdated, 1);
  lane_of(table.rows[0].key)->format = LaneFormat::parse("s9e8").value();
  EXPECT_EQ(components::count_rows(table, before, nullptr, device).outdated, 1);
}

}  // namespace
}  // namespace mixcmp::test::components_test
