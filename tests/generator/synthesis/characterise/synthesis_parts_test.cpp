#include <fmt/core.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "generator/synthesis/characterise/logic_cells.hpp"
#include "generator/synthesis/characterise/mapped_area.hpp"
#include "generator/synthesis/characterise/register_wrapper.hpp"
#include "generator/synthesis/characterise/router.hpp"
#include "generator/synthesis/characterise/static_timing.hpp"

/// Reading the tools' files, without the tools.
namespace mixcmp::test::synthesis_parts_test {
namespace {

using nlohmann::json;

Result<devices::Area> area_of(std::string_view cell, const std::string& device) {
  return characterise::area_of_cell(cell, devices::find_device(device).value());
}

TEST(MappedArea, ACellNobodyCountedIsAnError) {
  for (const char* cell : {"$add", "$_DFF_P_", "SB_SPRAM256KA", "my_black_box", "SB_LUT40", ""}) {
    const auto area = area_of(cell, "ice40-up5k");
    ASSERT_FALSE(area.ok()) << cell;
    EXPECT_EQ(area.error().received, cell);
    EXPECT_TRUE(area.error().accepted.starts_with("$scopeinfo, SB_CARRY, ")) << cell;
  }
  EXPECT_FALSE(area_of("RAM512X1S", "virtex6-lx760").ok());
  EXPECT_FALSE(area_of("SB_LUT4", "virtex6-lx760").ok()) << "a cell of another family";
}

TEST(MappedArea, MemoryInLutsCountsAsTheVendorsGuidesSay) {
  const std::map<std::string, int> luts = {{"SRL16E", 1},   {"SRLC32E", 1},   {"RAM32X1D", 2},
                                           {"RAM64X1D", 2}, {"RAM128X1D", 4}, {"RAM32M", 4},
                                           {"RAM64M", 4},   {"RAM32M16", 8}};
  for (const auto& [cell, count] : luts) {
    const devices::Area area = area_of(cell, "artix7-200t").value();
    EXPECT_EQ(area, (devices::Area{.luts = count, .shift_luts = count})) << cell;
  }
  EXPECT_EQ(area_of("TRELLIS_DPR16X4", "ecp5-85k").value(),
            (devices::Area{.luts = 6, .shift_luts = 6}));
}

TEST(MappedArea, ABlockOf36KbIsTwoOf18Kb) {
  EXPECT_EQ(area_of("RAMB18E1", "virtex6-lx760")->memories, 1);
  EXPECT_EQ(area_of("RAMB36E1", "virtex6-lx760")->memories, 2);
  EXPECT_EQ(area_of("RAMB36E2", "ultrascale+-vu9p")->memories, 2);
}

TEST(MappedArea, EveryFlipFlopAndMultiplierOfEveryFamilyCounts) {
  const std::multimap<std::string, std::string> registers = {
      {"virtex5-lx330t", "FDRE"}, {"virtex6-lx760", "FDSE"},  {"artix7-200t", "FDRE_1"},
      {"artix7-200t", "FDCE"},    {"ecp5-85k", "TRELLIS_FF"}, {"ice40-hx8k", "SB_DFF"},
      {"ice40-up5k", "SB_DFFESR"}};
  for (const auto& [device, cell] : registers) {
    EXPECT_EQ(area_of(cell, device).value(), devices::Area{.registers = 1}) << cell;
  }
  const std::multimap<std::string, std::string> multipliers = {{"virtex5-lx330t", "DSP48E"},
                                                               {"artix7-200t", "DSP48E1"},
                                                               {"ultrascale+-vu9p", "DSP48E2"},
                                                               {"ecp5-85k", "MULT18X18D"},
                                                               {"ice40-up5k", "SB_MAC16"}};
  for (const auto& [device, cell] : multipliers) {
    EXPECT_EQ(area_of(cell, device).value(), devices::Area{.dsps = 1}) << cell;
  }
}

TEST(MappedArea, StatisticsOfOldAndNewYosysAddUp) {
  const devices::Device device = devices::find_device("artix7-200t").value();
  const json old_form = json::parse(R"({"creator": "Yosys 0.23", "modules": {"\\dut": {}},
      "design": {"num_cells": 88, "num_cells_by_type":
                 {"CARRY4": 4, "FDRE": 48, "LUT2": 16, "SRL16E": 8, "RAM32M": 3, "DSP48E1": 2}}})");
  const devices::Area expected = {
      .luts = 36, .registers = 48, .dsps = 2, .carries = 4, .shift_luts = 20};
  EXPECT_EQ(characterise::area_of_statistics(old_form, device).value(), expected);
  json new_form = old_form;
  new_form["design"]["num_ports"] = 4;
  new_form["design"]["num_cells_by_type"]["$scopeinfo"] = 12;
  EXPECT_EQ(characterise::area_of_statistics(new_form, device).value(), expected);
}

/// A netlist of iCE40 cells, their ports as nets.
class Ice40Cells : public testing::Test {
protected:
  void cell(const std::string& type, std::initializer_list<std::pair<const char*, json>> ports,
            const char* output) {
    json cell = {{"type", type}};
    for (const auto& [port, net] : ports) {
      cell["connections"][port] = json::array({net});
      cell["port_directions"][port] = std::string(port) == output ? "output" : "input";
    }
    module_["cells"]["c" + std::to_string(module_["cells"].size())] = cell;
  }
  void lut(const json& i1, const json& i2, const json& i3, int o) {
    cell("SB_LUT4", {{"I0", "0"}, {"I1", i1}, {"I2", i2}, {"I3", i3}, {"O", o}}, "O");
  }
  void dff(int d, int q) { cell("SB_DFF", {{"C", 2}, {"D", d}, {"Q", q}}, "Q"); }
  void carry(const json& i0, const json& i1, const json& ci, int co) {
    cell("SB_CARRY", {{"I0", i0}, {"I1", i1}, {"CI", ci}, {"CO", co}}, "CO");
  }
  void output(int net) {
    module_["ports"]["y"] = {{"direction", "output"}, {"bits", json::array({net})}};
  }
  int count() { return characterise::ice40_logic_cells({{"modules", {{"dut", module_}}}}, "dut"); }

  json module_ = {{"cells", json::object()}, {"ports", json::object()}};
};

TEST_F(Ice40Cells, AFlipFlopSharesTheCellOfTheLutThatFeedsItAlone) {
  lut(3, 4, 5, 10);
  dff(10, 11);
  EXPECT_EQ(count(), 1);
}

TEST_F(Ice40Cells, ALutWithAnotherReaderKeepsItsCellToItself) {
  lut(3, 4, 5, 10);
  dff(10, 11);
  lut(10, 4, 5, 12);
  EXPECT_EQ(count(), 3);
}

TEST_F(Ice40Cells, AnOutputOfTheModuleIsAReader) {
  lut(3, 4, 5, 10);
  dff(10, 11);
  output(10);
  EXPECT_EQ(count(), 2);
}

TEST_F(Ice40Cells, AFlipFlopFedByAFlipFlopFillsACell) {
  dff(3, 10);
  dff(10, 11);
  EXPECT_EQ(count(), 2);
}

TEST_F(Ice40Cells, TwoFlipFlopsOfOneLutDoNotShareIt) {
  lut(3, 4, 5, 10);
  dff(10, 11);
  dff(10, 12);
  EXPECT_EQ(count(), 3);
}

TEST_F(Ice40Cells, ACarrySharesTheCellOfTheLutThatAddsTheSameBits) {
  carry(3, 4, "0", 20);
  lut(3, 4, "0", 10);
  carry(5, 6, 20, 21);
  lut(5, 6, 20, 11);
  EXPECT_EQ(count(), 2);
}

TEST_F(Ice40Cells, ACarryWithoutSuchALutFillsACell) {
  carry(3, 4, "0", 20);
  carry(5, 6, 20, 21);
  lut(5, 7, 20, 11);
  EXPECT_EQ(count(), 3);
}

TEST_F(Ice40Cells, TwoCarriesOfTheSameBitsNeedTwoLuts) {
  carry(3, 4, "0", 20);
  carry(3, 4, "0", 21);
  lut(3, 4, "0", 10);
  EXPECT_EQ(count(), 2);
}

TEST(StaticTiming, TheLatestArrivalIsRead) {
  EXPECT_EQ(characterise::longest_path_ps(
                "7. Executing STA pass.\nLatest arrival time in 'dut' is 1631:\n"
                "    1631 $auto$ff (FDRE.D)\n")
                .value(),
            1631);
}

TEST(StaticTiming, APathThroughACellWithoutDelaysIsNoClock) {
  for (const char* warning : {"Warning: Cell type 'DSP48E2' not recognised! Ignoring.\n",
                              "Warning: Module 'DSP48E2' has no timing arcs!\n"}) {
    const auto path = characterise::longest_path_ps(std::string(warning) +
                                                    "Latest arrival time in 'dut' is 303:\n");
    ASSERT_FALSE(path.ok()) << warning;
    EXPECT_NE(path.error().message.find("DSP48E2"), std::string::npos) << warning;
  }
}

TEST(StaticTiming, NoPathIsNoClock) {
  EXPECT_FALSE(characterise::longest_path_ps("Latest arrival time in 'dut' is 0:\n").ok());
  EXPECT_FALSE(characterise::longest_path_ps("").ok());
}

TEST(Router, TheSlowestClockOfAReportCounts) {
  const json report = {{"fmax",
                        {{"aclk", {{"achieved", 253.5}, {"constraint", 400}}},
                         {"other", {{"achieved", 81.25}, {"constraint", 400}}}}}};
  EXPECT_EQ(characterise::routed_mhz(report).value(), 81.25);
}

TEST(Router, AReportWithoutClocksIsNoClock) {
  EXPECT_FALSE(characterise::routed_mhz(json::parse(R"({"fmax": {}})")).value().has_value());
}

TEST(Router, AReportOfAnotherFormIsAnError) {
  for (const char* text :
       {"{}", "[]", "\"fmax\"", R"({"fmax": null})", R"({"fmax": {"aclk": {}}})",
        R"({"fmax": {"aclk": {"achieved": 0}}})", R"({"fmax": {"aclk": {"achieved": -100}}})",
        R"({"fmax": {"aclk": {"achieved": 1e300}}})", R"({"fmax": {"aclk": {"achieved": "9"}}})"}) {
    EXPECT_FALSE(characterise::routed_mhz(json::parse(text)).ok()) << text;
  }
}

TEST(MappedArea, NumbersOfCellsAreWholeAndWithinReason) {
  const devices::Device device = devices::find_device("artix7-200t").value();
  const auto area = [&](const char* counts) {
    return characterise::area_of_statistics(
        json::parse(fmt::format(R"({{"design": {{"num_cells_by_type": {}}}}})", counts)), device);
  };
  EXPECT_EQ(area(R"({"LUT1": 7})").value().luts, 7);
  for (const char* counts : {"{}", R"({"LUT1": -5})", R"({"LUT1": 99999999999})",
                             R"({"LUT1": 1.5})", R"({"LUT1": "7"})", "null", "[]"}) {
    EXPECT_FALSE(area(counts).ok()) << counts;
  }
  EXPECT_FALSE(characterise::area_of_statistics(json::array(), device).ok());
}

TEST(Router, SeedsGiveMedianAndExtremes) {
  const measured::Clock odd = characterise::clock_over_seeds({90, 70, 80});
  EXPECT_EQ(odd.mhz, 80);
  EXPECT_EQ(odd.low_mhz, 70);
  EXPECT_EQ(odd.high_mhz, 90);
  EXPECT_EQ(odd.seeds, 3);
  EXPECT_EQ(odd.source, measured::ClockSource::routed);
  EXPECT_EQ(characterise::clock_over_seeds({100, 70, 80, 90}).mhz, 80);
}

json module_with(const json& ports) {
  return {{"modules", {{"dut", {{"ports", ports}}}}}};
}

json port(const char* direction, int width) {
  return {{"direction", direction}, {"bits", std::vector<int>(static_cast<std::size_t>(width))}};
}

TEST(RegisterWrapper, APortOfTwoDirectionsIsAnError) {
  const auto wrapper = characterise::register_wrapper(
      module_with(
          {{"aclk", port("input", 1)}, {"pad", port("inout", 1)}, {"y", port("output", 1)}}),
      "dut", "aclk", "w");
  ASSERT_FALSE(wrapper.ok());
  EXPECT_EQ(wrapper.error().received, "pad");
}

TEST(RegisterWrapper, AModuleWithoutOutputsIsAnError) {
  EXPECT_FALSE(
      characterise::register_wrapper(module_with({{"a", port("input", 8)}}), "dut", "aclk", "w")
          .ok());
}

TEST(RegisterWrapper, AModuleWithoutInputsOrClockIsWrapped) {
  const auto wrapper =
      characterise::register_wrapper(module_with({{"y", port("output", 3)}}), "dut", "aclk", "w");
  ASSERT_TRUE(wrapper.ok());
  EXPECT_EQ(wrapper->find("inputs"), std::string::npos);
  EXPECT_NE(wrapper->find(".\\y (outputs[2:0])"), std::string::npos);
}

}  // namespace
}  // namespace mixcmp::test::synthesis_parts_test
