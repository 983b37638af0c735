#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "model/cost/measured/measurement.hpp"
#include "tests/generator/characterise_fixture.hpp"

/// `characterise --import`: reports of Vivado and Quartus, written by hand in their form, become
/// rows of a table.
namespace mixcmp::test::import_command_test {
namespace {

using measured::AreaStage;
using measured::ComponentKind;
using measured::Measurement;

/// One instance in the vendor's report by instance: its depth, name and area.
struct Instance {
  int depth;
  std::string name;
  int luts, lut_memories, shift_registers, registers, blocks_36k, blocks_18k, dsps;
};

const std::string top = "scene_s8e8_2x1";

const std::vector<Instance> instances = {{0, top, 2000, 60, 40, 3000, 2, 1, 6},
                                         {1, "(" + top + ")", 1, 0, 0, 2, 0, 0, 0},
                                         {1, "g_lanes[0].channel", 301, 25, 10, 400, 1, 0, 0},
                                         {2, "lane", 201, 5, 10, 300, 1, 0, 0},
                                         {2, "tracker", 100, 20, 0, 100, 0, 0, 0},
                                         {1, "g_lanes[1].channel", 308, 26, 11, 403, 1, 1, 0},
                                         {2, "(g_lanes[1].channel)", 2, 0, 0, 0, 0, 0, 0},
                                         {2, "lane", 204, 5, 11, 301, 1, 1, 0},
                                         {2, "tracker", 102, 21, 0, 102, 0, 0, 0},
                                         {1, "g_references[0].channel", 900, 4, 9, 1100, 0, 0, 6},
                                         {2, "port", 90, 4, 0, 100, 0, 0, 0},
                                         {2, "reference", 810, 0, 9, 1000, 0, 0, 6},
                                         {1, "recomputation", 77, 0, 0, 88, 0, 0, 0}};

std::string vivado_areas() {
  std::string text =
      "Copyright 1986-2019 Xilinx, Inc. All Rights Reserved.\n"
      "-----------------------------------------------------\n"
      "| Tool Version : Vivado v.2019.2 (lin64) Build 2708876 Wed Nov  6 21:39:14 MST 2019\n"
      "| Date         : Sun Mar 22 17:28:19 2020\n"
      "| Host         : server running 64-bit Ubuntu\n"
      "| Command      : report_utilization -hierarchical -file utilisation_by_instance.rpt\n"
      "| Design       : scene_s8e8_2x1\n"
      "| Device       : 7a200tfbg676-2\n"
      "| Design State : Routed\n"
      "-----------------------------------------------------\n\n"
      "Utilization Design Information\n\n1. Utilization by Hierarchy\n"
      "---------------------------\n\n+------+\n"
      "| Instance | Module | Total LUTs | Logic LUTs | LUTRAMs | SRLs | FFs | RAMB36 | RAMB18 "
      "| DSP48 Blocks |\n+------+\n";
  for (const Instance& each : instances) {
    text += fmt::format("| {}{} | module | {} | {} | {} | {} | {} | {} | {} | {} |\n",
                        std::string(2 * each.depth, ' '), each.name, each.luts,
                        each.luts - each.lut_memories - each.shift_registers, each.lut_memories,
                        each.shift_registers, each.registers, each.blocks_36k, each.blocks_18k,
                        each.dsps);
  }
  return text + "+------+\n";
}

const std::string vivado_timing =
    "Copyright 1986-2019 Xilinx, Inc. All Rights Reserved.\n"
    "-----------------------------------------------------\n"
    "| Tool Version : Vivado v.2019.2 (lin64) Build 2708876 Wed Nov  6 21:39:14 MST 2019\n"
    "| Design       : scene_s8e8_2x1\n"
    "| Device       : 7a200t-fbg676\n"
    "| Speed File   : -2  PRODUCTION 1.23 2018-06-13\n"
    "-----------------------------------------------------\n\n"
    "Timing Summary Report\n\n"
    "| Design Timing Summary\n| ---------------------\n----------\n\n"
    "    WNS(ns)      TNS(ns)  TNS Failing Endpoints\n"
    "    -------      -------  ---------------------\n"
    "     -0.250       -1.000                      9\n\n"
    "| Clock Summary\n| -------------\n----------\n\n"
    "Clock  Waveform(ns)         Period(ns)      Frequency(MHz)\n"
    "-----  ------------         ----------      --------------\n"
    "aclk   {0.000 2.500}        5.000           200.000\n\n"
    "                         net (fo=1074, unset)         0.973     0.973    aclk\n"
    "                         net (fo=3, routed)           1.253     2.742    lane_operands\n";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t place = text.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  return text.replace(place, from.size(), to);
}

class Import : public ProgramTest {
protected:
  Import() {
    write_scene("a", "artix7-200t");
    std::string data = "a,b\n";
    for (int k = 0; k < 60; ++k)
      data += fmt::format("{},{}\n", 1 + 0.37 * k, 1.5 + 0.37 * k * (k % 9 == 0 ? 1 : 2));
    write("data.csv", data);
    fs::create_directories(path("r"));
    write("r/utilisation_by_instance.rpt", vivado_areas());
    write("r/timing.rpt", vivado_timing);
  }

  void write_scene(const std::string& f, const std::string& device) {
    write("scene.toml", fmt::format("[comparison]\nname = \"scene\"\nf = \"{}\"\ng = \"b\"\n"
                                    "[reference]\nformat = \"binary32\"\n"
                                    "[reduced]\nformat = \"s8e8\"\ninputs = \"rounded\"\n"
                                    "[system]\nlanes = 2\nreferences = 1\ndevice = \"{}\"\n"
                                    "[data]\nfile = \"data.csv\"\n",
                                    f, device));
  }

  /// Leaves the signature beside the reports, as the vendor's script does.
  void leave_signature() {
    const Outcome run = mixcmp("generate scene.toml --no-prove -o rtl");
    ASSERT_EQ(run.exit_code, 0) << run.output;
    fs::copy_file(path("rtl/" + top + ".json"), path("r/" + top + ".json"),
                  fs::copy_options::overwrite_existing);
  }

  Outcome import(const std::string& reports = "r/utilisation_by_instance.rpt r/timing.rpt",
                 const std::string& options = "") {
    return mixcmp("characterise scene.toml -o t.csv " + options + " --import " + reports);
  }

  Measurement row(ComponentKind kind) {
    const auto table = measured::read_characterisation(path("t.csv"));
    EXPECT_TRUE(table.ok()) << table.error().to_string();
    for (const Measurement& each : table->rows) {
      if (kind_of(each.key) == kind) return each;
    }
    ADD_FAILURE() << "no row of a " << to_string(kind) << "\n" << read("t.csv");
    return {};
  }

  /// Imports with one change of a report: nothing is written, and the error says this.
  void expect_error(const std::string& file, const std::string& from, const std::string& to,
                    const std::string& message) {
    const std::string before = read("r/" + file);
    write("r/" + file, replaced(before, from, to));
    const Outcome run = import();
    EXPECT_EQ(run.exit_code, 1) << from << "\n" << run.output;
    EXPECT_NE(run.output.find(message), std::string::npos) << message << "\n" << run.output;
    EXPECT_FALSE(fs::exists(path("t.csv")));
    write("r/" + file, before);
  }
};

devices::Area area(int luts, int registers, int dsps, int memories, int shift_luts) {
  return {.luts = luts,
          .registers = registers,
          .dsps = dsps,
          .memories = memories,
          .shift_luts = shift_luts};
}

TEST_F(Import, VivadosInstancesBecomeRowsOfTheirMeans) {
  leave_signature();
  const Outcome run = import();
  ASSERT_EQ(run.exit_code, 0) << run.output;
  EXPECT_NE(run.output.find("Vivado v.2019.2 Build 2708876 on xc7a200tfbg676-2, placed and routed, "
                            "190.5 MHz\n"),
            std::string::npos)
      << run.output;
  const Measurement lane = row(ComponentKind::lane);
  EXPECT_EQ(lane_of(lane.key)->format.name(), "s8e8");
  EXPECT_EQ(lane_of(lane.key)->inputs, LaneInputs::rounded);
  EXPECT_EQ(lane.area, area(203, 301, 0, 3, 16));  // of 201 and 204, ..., 2 and 3, 15 and 16
  EXPECT_EQ(row(ComponentKind::fifo).area, area(101, 101, 0, 0, 21));
  EXPECT_EQ(row(ComponentKind::reference).area, area(810, 1000, 6, 0, 9));
  EXPECT_EQ(row(ComponentKind::crossbar).area, area(77, 88, 0, 0, 0));
  EXPECT_EQ(count_of(row(ComponentKind::crossbar).key), 2);
  ASSERT_TRUE(lane.clock.has_value());
  EXPECT_NEAR(lane.clock->mhz, 1000 / 5.25, 0.01);
  EXPECT_EQ(lane.clock->source, measured::ClockSource::routed);
  EXPECT_EQ(lane.stage, AreaStage::routed);
  EXPECT_EQ(lane.tools, "Vivado v.2019.2 Build 2708876, xc7a200tfbg676-2");
}

TEST_F(Import, LanesInLockStepAreInALoopOfTheirChannel) {
  write("scene.toml",
        replaced(read("scene.toml"), "lanes = 2\n", "lanes = 2\nlanes_per_group = 2\n"));
  leave_signature();
  const std::string whole = replaced(vivado_areas(), "    lane |", "    g_lanes[0].lane |");
  const std::size_t lane = whole.find("|     lane |");
  const std::string second = whole.substr(lane, whole.find('\n', lane) + 1 - lane);
  const std::size_t begin = whole.find("|   g_lanes[1].channel");
  std::string text = whole;
  text.replace(begin, whole.find("|   g_references[0]") - begin,
               replaced(second, "    lane |", "    g_lanes[1].lane |"));
  write("r/utilisation_by_instance.rpt", text);
  const Outcome run = import();
  ASSERT_EQ(run.exit_code, 0) << run.output;
  EXPECT_EQ(row(ComponentKind::lane).area, area(203, 301, 0, 3, 16));  // of 201 and 204, as above
  EXPECT_EQ(row(ComponentKind::fifo).area, area(100, 100, 0, 0, 20));
  EXPECT_EQ(row(ComponentKind::crossbar).area, area(77, 88, 0, 0, 0));
  EXPECT_EQ(count_of(row(ComponentKind::crossbar).key), 1);
}

TEST_F(Import, ACrossbarsShareIsThatOfTheLanesItServes) {
  write("scene.toml", replaced(read("scene.toml"), "references = 1", "references = 2"));
  const Outcome made = mixcmp("generate scene.toml --no-prove -o rtl");
  ASSERT_EQ(made.exit_code, 0) << made.output;
  fs::copy_file(path("rtl/scene_s8e8_2x2.json"), path("r/scene_s8e8_2x2.json"));
  std::string text =
      replaced(vivado_areas(), "Design       : " + top, "Design       : scene_s8e8_2x2");
  const std::size_t first = text.find("|   g_references[0]");
  const std::size_t last = text.find("|   recomputation");
  text.insert(last, replaced(text.substr(first, last - first), "[0]", "[1]"));
  write("r/utilisation_by_instance.rpt", text);
  const Outcome run = import("r/utilisation_by_instance.rpt");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  EXPECT_EQ(count_of(row(ComponentKind::crossbar).key), 1);
  EXPECT_EQ(row(ComponentKind::crossbar).area, area(39, 44, 0, 0, 0));  // a half of 77 and 88
  EXPECT_FALSE(row(ComponentKind::lane).clock.has_value());
}

TEST_F(Import, AnArgMinEngineHasNoRows) {
  write("centres.csv", "c\n0\n2\n4\n");
  write("scene.toml", replaced(replaced(replaced(read("scene.toml"), "\"a\"", "\"(a - ci)^2\""),
                                        "\"b\"", "\"(a - cj)^2\""),
                               "[data]\n",
                               "[engine]\nkind = \"arg_min\"\n"
                               "[data]\nwith = \"centres.csv\"\npairs = \"arg_min\"\n"));
  leave_signature();
  write("r/utilisation_by_instance.rpt",
        replaced(vivado_areas(), "Design       : " + top, "Design       : " + top + "_arg_min"));
  const Outcome run = import("r/utilisation_by_instance.rpt");
  EXPECT_EQ(run.exit_code, 1) << run.output;
  EXPECT_NE(run.output.find("engine.kind: the lanes of an engine read words of its items"),
            std::string::npos)
      << run.output;
}

TEST_F(Import, APairwiseEngineHasNoRows) {
  write("scene.toml",
        replaced(
            replaced(replaced(read("scene.toml"), "\"a\"", "\"ai - aj\""), "\"b\"", "\"bi - bj\""),
            "[data]\n", "[engine]\nkind = \"pairwise\"\n[data]\npairs = \"all\"\n"));
  leave_signature();
  write("r/utilisation_by_instance.rpt",
        replaced(vivado_areas(), "Design       : " + top, "Design       : " + top + "_pairwise"));
  const Outcome run = import("r/utilisation_by_instance.rpt");
  EXPECT_EQ(run.exit_code, 1) << run.output;
  EXPECT_NE(run.output.find("engine.kind: the lanes of an engine read words of its items"),
            std::string::npos)
      << run.output;
}

TEST_F(Import, OptimisePlansWithTheImportedAreas) {
  leave_signature();
  const auto luts_of_a_lane = [this] {
    EXPECT_EQ(import().exit_code, 0);
    const auto plan =
        nlohmann::json::parse(mixcmp("optimise scene.toml --table t.csv --json").output);
    EXPECT_EQ(plan["clock_basis"], "placed and routed");
    return plan["plans"][0]["kinds"][0]["area"]["lut"].get<int>();
  };
  EXPECT_EQ(luts_of_a_lane(), 203 + 101);  // with its scoreboard
  write("r/utilisation_by_instance.rpt",
        replaced(replaced(vivado_areas(), "| 201 |", "| 2010 |"), "| 204 |", "| 2040 |"));
  EXPECT_EQ(luts_of_a_lane(), 2025 + 101);
}

TEST_F(Import, ALaterRunKeepsImportedRowsOfTheSameRtlAlone) {
  leave_signature();
  ASSERT_EQ(import().exit_code, 0);
  write_script("yosys", yosys_script);
  const std::string again =
      "characterise scene.toml -o t.csv --store s.sqlite --area-only --precisions 8 "
      "--components lane,unit --exponents reference";
  const std::string fake =
      fmt::format("FAKE='{0}' PATH='{0}':\"$PATH\"", directory_.path().string());
  const Outcome same = mixcmp(again, fake);
  EXPECT_EQ(same.exit_code, 0) << same.output;
  EXPECT_NE(same.output.find("1 imported ones not measured anew"), std::string::npos)
      << same.output;
  EXPECT_NE(same.output.find("3 of them kept from before"), std::string::npos) << same.output;
  EXPECT_EQ(row(ComponentKind::reference).stage, AreaStage::routed);
  EXPECT_EQ(row(ComponentKind::unit).stage, AreaStage::mapped);
  write_scene("a + b", "artix7-200t");
  const Outcome other = mixcmp(again, fake);
  EXPECT_EQ(other.exit_code, 0) << other.output;
  EXPECT_EQ(row(ComponentKind::lane).stage, AreaStage::mapped);
  EXPECT_EQ(row(ComponentKind::fifo).stage, AreaStage::routed);  // whose RTL is the same
}

TEST_F(Import, ASynthesisIsNotCalledPlacedAndHasNoClock) {
  leave_signature();
  write("r/utilisation_by_instance.rpt", replaced(vivado_areas(), "Routed", "Synthesized"));
  const Outcome both = import();
  EXPECT_EQ(both.exit_code, 1);
  EXPECT_NE(both.output.find("the timing is of a routed design, and these areas are not"),
            std::string::npos)
      << both.output;
  const Outcome run = import("r/utilisation_by_instance.rpt");
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_NE(run.output.find("after synthesis, before placement, no clock"), std::string::npos)
      << run.output;
  EXPECT_EQ(row(ComponentKind::lane).stage, AreaStage::synthesised);
  EXPECT_FALSE(row(ComponentKind::lane).clock.has_value());
}

TEST_F(Import, ErrorsNameFileAndLine) {
  leave_signature();
  const std::string areas = "utilisation_by_instance.rpt";
  expect_error(areas, "7a200tfbg676-2", "7k325tffg900-2",
               areas +
                   ":8: a report of another device: received 7k325tffg900-2; accepted "
                   "xc7a200tfbg676-2, the scene's artix7-200t");
  expect_error(areas, "Design       : scene", "Design       : other",
               areas + ":7: a report of another design: received other_s8e8_2x1");
  expect_error(areas, "Design State : Routed", "Design State : Sketched",
               areas + ":9: not a known state of a design");
  expect_error(areas, "g_lanes[1]", "g_line[1]",
               "the table of instances lacks one of the system's: received 11 instances without "
               "g_lanes[1].channel/lane");
  expect_error(areas, "| 810 |", "| many |", areas + ":31: Total LUTs is no number");
  expect_error(areas, "| module | 810 |", "| 810 |",
               areas + ":31: a record of the table is not whole");
  expect_error(areas, "| FFs", "| Flops", areas + ":18: a column is missing");
  expect_error(areas, "| Instance", "| Thing", "Utilization by Hierarchy");
  expect_error(areas, "| Tool Version", "| Author",
               areas + ":1: not a report of Vivado or Quartus");
  expect_error("timing.rpt", "v.2019.2", "v.2020.1", "the two reports are of different tools");
  expect_error("timing.rpt", "(fo=3, routed)", "(fo=3, estimated)",
               "timing.rpt:28: a timing before routing is no clock");
  expect_error("timing.rpt", "net (fo=3, routed)", "nothing", "a path whose wires are routed");
  expect_error("timing.rpt", "| Speed File", "| Design State : Fully Placed\n| Speed File",
               "timing.rpt:6: a timing before routing is no clock");
  expect_error("timing.rpt", "| Clock Summary", "| Clocks", "the section \"Clock Summary\"");
  expect_error("timing.rpt", "-0.250", "    NA", "timing.rpt:17: no slack");
  expect_error("timing.rpt", "-fbg676", "-fbg484", "timing.rpt:5: a report of another device");
  expect_error(top + ".json", "\"spec_hash\": \"", "\"spec_hash\": \"0",
               "the reports are of other RTL than what the scene generates today");
}

TEST_F(Import, ReportsThatMakeNoRowAreRefused) {
  const Outcome alone = import();
  EXPECT_NE(alone.output.find("the signature of the compiled system is not beside its report"),
            std::string::npos)
      << alone.output;
  leave_signature();
  const auto refused = [this](const std::string& reports, const std::string& message,
                              const std::string& options = "") {
    const Outcome run = import(reports, options);
    EXPECT_NE(run.exit_code, 0) << run.output;
    EXPECT_NE(run.output.find(message), std::string::npos) << message << "\n" << run.output;
  };
  refused("r/timing.rpt", "a clock without areas makes no row");
  refused("r/timing.rpt r/timing.rpt", "a second report of the same kind");
  refused("r/none.rpt", "r/none.rpt");
  refused("r/utilisation_by_instance.rpt", "--quick excludes --import", "--quick");
  write("r/fit.summary", "Fitter Status : Successful - Sun Mar 22 17:41:32 2020\n");
  refused("r/fit.summary", "fit.summary:1: Quartus' fit summary has no areas by instance");
  write("r/sta.summary", "-----\nTiming Analyzer Summary\n-----\n");
  refused("r/sta.summary", "sta.summary:2: Quartus' timing summary names no tool and no device");
  write_scene("a", "virtex6-lx760");
  leave_signature();
  refused("r/utilisation_by_instance.rpt", "the scene's device virtex6-lx760 is none of Vivado's");
  EXPECT_FALSE(fs::exists(path("t.csv")));
}

/// The fitter's report of Quartus Standard, or of Quartus Pro, which names no entities in paths.
std::string quartus_fit(bool is_pro) {
  const auto line = [](const std::string& path, const char* alms, int registers, int blocks,
                       int dsps) {
    return fmt::format(
        "; node ; {0} ({0}) ; 0.0 (0.0) ; 4.5 (4.5) ; 9 (9) ; {1} (1) ; 1024 ; {2} "
        "; {3} ; {4} ;\n",
        alms, registers, blocks, dsps, path);
  };
  const auto name = [is_pro](const std::string& loop, const std::string& part) {
    const std::string standard = "|" + top + "|" + loop + "_channel:g_" + loop;
    return is_pro ? "g_" + loop + ".channel" + (part.empty() ? "" : "|" + part)
                  : standard + ".channel" + (part.empty() ? "" : "|m_" + part + ":" + part);
  };
  return "Fitter report for " + top +
         "\nSun Mar 22 17:41:32 2020\nQuartus Prime Version 18.1.0 Build 625 09/12/2018\n\n"
         "  2. Fitter Summary\n\n+--+\n; Fitter Summary   ;\n+--+\n"
         "; Fitter Status         ; Successful - Sun Mar 22 17:41:32 2020       ;\n"
         "; Quartus Prime Version ; 18.1.0 Build 625 09/12/2018 SJ Lite Edition ;\n"
         "; Top-level Entity Name ; " +
         top +
         " ;\n; Device                ; 5CSEBA6U23I7 ;\n+--+\n\n+--+\n"
         "; Fitter Resource Utilization by Entity ;\n+--+\n"
         "; Compilation Hierarchy Node ; ALMs needed [=A-B+C] ; [A] ALMs ; ALMs used for memory ; "
         "Combinational ALUTs ; Dedicated Logic Registers ; Block Memory Bits ; M10Ks ; DSP Blocks "
         "; Full Hierarchy Name ;\n+--+\n" +
         line(is_pro ? "|" : "|" + top, "999.0", 2000, 4, 3) +
         line(name("lanes[0]", "lane"), "100.2", 300, 1, 0) +
         line(name("lanes[0]", "tracker"), "50.0", 100, 0, 0) +
         line(name("lanes[1]", "lane"), "103.0", 301, 2, 0) +
         line(name("lanes[1]", "tracker"), "52.0", 101, 0, 0) +
         line(name("references[0]", "reference"), "410.5", 1000, 0, 3) +
         line(is_pro ? "recomputation" : "|" + top + "|mixcmp_stream_crossbar:recomputation",
              "33.3", 44, 0, 0) +
         "+--+\n";
}

const std::string quartus_timing =
    "Timing Analyzer report for scene_s8e8_2x1\nSun Mar 22 17:42:33 2020\n\n+--+\n"
    "; Timing Analyzer Summary ;\n+--+\n"
    "; Quartus Prime Version ; Version 18.1.0 Build 625 09/12/2018 SJ Lite Edition ;\n"
    "; Revision Name ; scene_s8e8_2x1 ;\n; Device Name ; 5CSEBA6U23I7 ;\n+--+\n\n"
    "; Slow 1100mV 100C Model Fmax Summary ;\n+--+\n"
    "; Fmax ; Restricted Fmax ; Clock Name ; Note ;\n+--+\n"
    "; 269.65 MHz ; 250.0 MHz ; aclk ; ;\n+--+\n"
    "; Slow 1100mV -40C Model Fmax Summary ;\n+--+\n"
    "; Fmax ; Restricted Fmax ; Clock Name ; Note ;\n+--+\n"
    "; 240.54 MHz ; 240.54 MHz ; aclk ; ;\n+--+\n";

TEST_F(Import, QuartusReportsBecomeRowsInBothFormsOfPaths) {
  std::ostringstream device;
  device << std::ifstream(std::string(MIXCMP_DEVICES) + "/artix7-200t.toml").rdbuf();
  write("cyclone.toml", replaced(replaced(device.str(), "artix7-200t", "cyclone5"), "vivado_part",
                                 "quartus_part = \"5CSEBA6U23I7\"\nvivado_part"));
  write_scene("a", "cyclone.toml");
  leave_signature();
  write("r/t.sta.rpt", quartus_timing);
  for (const bool is_pro : {false, true}) {
    write("r/t.fit.rpt", quartus_fit(is_pro));
    fs::remove(path("t.csv"));
    const Outcome run = import("r/t.sta.rpt r/t.fit.rpt");
    ASSERT_EQ(run.exit_code, 0) << run.output;
    const Measurement lane = row(ComponentKind::lane);
    EXPECT_EQ(lane.area, area(102, 301, 0, 2, 5));  // of 101 and 103 ALMs
    EXPECT_EQ(row(ComponentKind::reference).area, area(411, 1000, 3, 0, 5));
    EXPECT_EQ(row(ComponentKind::crossbar).area, area(34, 44, 0, 0, 5));
    ASSERT_TRUE(lane.clock.has_value());
    EXPECT_DOUBLE_EQ(lane.clock->mhz, 240.54);
    EXPECT_EQ(lane.tools, "Quartus 18.1.0 Build 625, 5CSEBA6U23I7");
  }
  write("r/t.sta.rpt",
        replaced(quartus_timing, "; Device Name", "; Snapshot ; placed ;\n; Device Name"));
  const Outcome early = import("r/t.sta.rpt r/t.fit.rpt");
  EXPECT_NE(early.output.find("t.sta.rpt:9: a timing before routing is no clock"),
            std::string::npos)
      << early.output;
  write("r/t.fit.rpt", replaced(quartus_fit(false), "Successful", "Failed"));
  const Outcome failed = import("r/t.fit.rpt");
  EXPECT_NE(failed.output.find("t.fit.rpt:10: the fitter did not succeed"), std::string::npos)
      << failed.output;
}

}  // namespace
}  // namespace mixcmp::test::import_command_test
