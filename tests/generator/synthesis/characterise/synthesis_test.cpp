#include "generator/synthesis/characterise/synthesis.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "generator/synthesis/characterise/job_hash.hpp"
#include "tests/generator/synthesis/characterise/synthesis_fixture.hpp"

/// Small modules whose mapping is known, through the real tools.
namespace mixcmp::test::synthesis_test {
namespace {

TEST_F(Synthesis, BrokenVerilogIsAnErrorWithTheEndOfTheLog) {
  SKIP_WITHOUT_YOSYS();
  const auto result = run("module dut (input wire a; endmodule", device("ice40-hx8k"), {});
  ASSERT_FALSE(result.ok());
  EXPECT_TRUE(result.error().file.ends_with("map.log")) << result.error().file;
  EXPECT_NE(result.error().message.find("syntax error"), std::string::npos);
}

TEST_F(Synthesis, AnAbsentTopIsAnError) {
  SKIP_WITHOUT_YOSYS();
  const auto result = characterise::synthesise({.sources = {{"dut.v", adder}}, .top = "dud"},
                                               device("ice40-hx8k"), {}, directory_.path());
  ASSERT_FALSE(result.ok());
  EXPECT_NE(result.error().message.find("dud"), std::string::npos);
}

TEST_F(Synthesis, AToolThatTakesTooLongIsEnded) {
  const auto ran =
      characterise::run_in(directory_.path(), {"sleep", "100"}, "sleep.log", {.seconds = 1});
  EXPECT_FALSE(ran.ok());
}

TEST_F(Synthesis, Virtex6CountsLutsAndWhatTheyServeAs) {
  SKIP_WITHOUT_YOSYS();
  EXPECT_EQ(area(everything, "virtex6-lx760"),
            // 16 of the sum, 8 shift registers of one LUT, 3 RAM32M (6 bits each) of 4, 16 of the
            // XOR that follows; the two DSP48E1 take most of the product's registers.
            (devices::Area{.luts = 16 + 8 + 12 + 16,
                           .registers = 48 + 16 + 17,
                           .dsps = 2,
                           .memories = 1,
                           .carries = 4,
                           .shift_luts = 8 + 12}));
}

TEST_F(Synthesis, RegistersOfOneResetShareItsInverter) {
  SKIP_WITHOUT_YOSYS();
  EXPECT_EQ(area(resets, "virtex6-lx760").luts, 1);
}

TEST_F(Synthesis, ThePapersSmallerDeviceMultipliesInLuts) {
  SKIP_WITHOUT_YOSYS();
  const devices::Area found = area(multiplier, "virtex5-lx330t");
  EXPECT_EQ(found.dsps, 0);
  EXPECT_EQ(found.registers, 96);
  EXPECT_GT(found.luts, 24 * 24 / 2);
}

TEST_F(Synthesis, Ecp5CountsTwoLutsForACarryAndSixForADistributedRam) {
  SKIP_WITHOUT_YOSYS();
  EXPECT_EQ(area(adder, "ecp5-85k"), (devices::Area{.luts = 16, .registers = 48, .carries = 8}));
  const devices::Area found = area(small_memory, "ecp5-85k");
  EXPECT_EQ(found.shift_luts, 6 * 8);  // twice 16 words, in fours of bits
  EXPECT_EQ(area(multiplier, "ecp5-85k").dsps, 4);
  EXPECT_EQ(area(memory, "ecp5-85k").memories, 1);
}

/// The module has eight registers, the cell one.
TEST_F(Synthesis, ACellReplacesItsModuleOnItsOwnFamily) {
  SKIP_WITHOUT_YOSYS();
  const std::string ports =
      "module part (input wire aclk, input wire [7:0] a, output reg [7:0] y);\n";
  const characterise::SynthesisJob job = {
      .sources = {{"part.v", ports + "always @(posedge aclk) y <= a + 1; endmodule\n"},
                  {"part.v.ecp5", ports + "always @(posedge aclk) y <= a[0]; endmodule\n", "ecp5"},
                  {"dut.v",
                   "module dut (input wire aclk, input wire [7:0] a, output wire [7:0] y);\n"
                   "part part (.aclk(aclk), .a(a), .y(y)); endmodule\n"}},
      .top = "dut"};
  const characterise::SynthesisOptions options = {.effort = characterise::TimingEffort::area_only};
  characterise::SynthesisJob without = job;
  without.sources.erase(without.sources.begin() + 1);
  for (const auto& [name, registers] : {std::pair{"ecp5-85k", 1}, {"ice40-hx8k", 8}}) {
    const auto result = characterise::synthesise(job, device(name), options, directory_.path());
    ASSERT_TRUE(result.ok()) << result.error().to_string();
    EXPECT_EQ(result->area.registers, registers) << name;
    const auto hash = [&](const auto& of) { return job_hash(of, device(name), options, "tools"); };
    EXPECT_EQ(hash(job) != hash(without), registers == 1) << name;
  }
}

TEST_F(Synthesis, Ice40CountsLogicCells) {
  SKIP_WITHOUT_YOSYS();
  // The sum's LUTs, carries and flip-flops share 16 cells; 32 operands fill one each.
  EXPECT_EQ(area(adder, "ice40-hx8k"), (devices::Area{.luts = 48, .registers = 48, .carries = 15}));
  EXPECT_EQ(area(delay, "ice40-hx8k").luts, 96);
  EXPECT_EQ(area(memory, "ice40-hx8k").memories, 5);
  EXPECT_EQ(area(ice40_multiplier, "ice40-up5k").dsps, 1);
  EXPECT_EQ(area(multiplier, "ice40-up5k").dsps, 0);
  EXPECT_EQ(area(multiplier, "ice40-hx8k").dsps, 0);
}

/// nextpnr's packer, which nobody here wrote, is the judge of our count. It adds a constant or two
/// and the cells at the ends of a carry chain.
TEST_F(Synthesis, OurLogicCellsAreThoseThatNextpnrPacks) {
  SKIP_WITHOUT_YOSYS();
  SKIP_WITHOUT_ROUTER("ice40-hx8k");
  const devices::Device hx8k = device("ice40-hx8k");
  for (const char* text : {adder, multiplier, delay, memory}) {
    const int ours = area(text, "ice40-hx8k").luts;
    const auto packed =
        characterise::packed_luts(hx8k, directory_.path(), "map.json", {.seconds = 60});
    ASSERT_TRUE(packed.ok()) << packed.error().to_string();
    const int luts = std::get<int>(*packed);
    EXPECT_GE(luts, ours) << text;
    EXPECT_LE(luts, ours + 2 + ours / 20) << text;
  }
}

TEST_F(Synthesis, Ecp5CountsAreThoseThatNextpnrPacks) {
  SKIP_WITHOUT_YOSYS();
  SKIP_WITHOUT_ROUTER("ecp5-85k");
  for (const char* text : {adder, multiplier, small_memory}) {
    const int ours = area(text, "ecp5-85k").luts;
    const auto packed = characterise::packed_luts(device("ecp5-85k"), directory_.path(), "map.json",
                                                  {.seconds = 60});
    ASSERT_TRUE(packed.ok()) << packed.error().to_string();
    EXPECT_GE(std::get<int>(*packed), ours) << text;
    EXPECT_LE(std::get<int>(*packed), ours + 20)
        << text;  // constants, and two for the ends of a carry chain
  }
}

TEST_F(Synthesis, WrappingLosesNoRegister) {
  SKIP_WITHOUT_YOSYS();
  SKIP_WITHOUT_ROUTER("ice40-hx8k");
  const auto result = run(adder, device("ice40-hx8k"), {.seeds = 1});
  ASSERT_TRUE(result.ok()) << result.error().to_string();
  const auto wrapped = characterise::read_json(directory_.path() / "wrapped.json").value();
  int registers = 0;
  for (const auto& [name, cell] :
       wrapped.at("modules").at("mixcmp_wrapper_of_dut").at("cells").items()) {
    registers += cell.at("type").get<std::string>().starts_with("SB_DFF");
  }
  EXPECT_EQ(registers, 48 + 32 + 16 + 4 + 1);  // the adder's; in, out, and two levels of the tree
}

TEST_F(Synthesis, Ice40IsRoutedOverSeeds) {
  SKIP_WITHOUT_YOSYS();
  SKIP_WITHOUT_ROUTER("ice40-hx8k");
  const auto result = run(adder, device("ice40-hx8k"), {.seeds = 3});
  ASSERT_TRUE(result.ok()) << result.error().to_string();
  ASSERT_TRUE(result->clock.has_value()) << result->no_clock;
  const measured::Clock clock = *result->clock;
  EXPECT_EQ(clock.source, measured::ClockSource::routed);
  EXPECT_EQ(clock.seeds, 3);
  EXPECT_LE(clock.low_mhz, clock.mhz);
  EXPECT_LE(clock.mhz, clock.high_mhz);
  // Sixteen carries of 0.126 ns and 2 ns for the rest, by Lattice's data sheet; 254 MHz unwrapped.
  EXPECT_GT(clock.low_mhz, 180);
  EXPECT_LT(clock.high_mhz, 300);
}

/// The wrapper's own paths, a wire and one LUT, must not limit a component's clock.
TEST_F(Synthesis, TheWrapperAloneIsFasterThanAnyComponent) {
  SKIP_WITHOUT_YOSYS();
  SKIP_WITHOUT_ROUTER("ice40-hx8k");
  const auto result = run(wide_register, device("ice40-hx8k"), {.seeds = 1});
  ASSERT_TRUE(result.ok()) << result.error().to_string();
  ASSERT_TRUE(result->clock.has_value()) << result->no_clock;
  EXPECT_GT(result->clock->mhz, 250);
}

TEST_F(Synthesis, WhatDoesNotFitHasAnAreaAndNoClock) {
  SKIP_WITHOUT_YOSYS();
  SKIP_WITHOUT_ROUTER("ice40-hx8k");
  devices::Device small = device("ice40-hx8k");
  small.available.luts = 47;
  const auto result = run(adder, small, {});
  ASSERT_TRUE(result.ok()) << result.error().to_string();
  EXPECT_FALSE(result->clock.has_value());
  EXPECT_GE(result->area.luts, 48);
  EXPECT_TRUE(result->no_clock.starts_with("does not fit: ")) << result->no_clock;
  EXPECT_TRUE(result->no_clock.ends_with(" lut of 47")) << result->no_clock;
}

/// The device file and the router's arguments name different devices: 300 flip-flops and as many
/// around them do not fit an LP384.
TEST_F(Synthesis, WhatTheRouterRefusesHasItsReason) {
  SKIP_WITHOUT_YOSYS();
  SKIP_WITHOUT_ROUTER("ice40-hx8k");
  devices::Device small = device("ice40-hx8k");
  small.timing_arguments = {"--lp384", "--package", "qn32"};
  const auto result = run(wide_register, small, {.seeds = 1});
  ASSERT_TRUE(result.ok()) << result.error().to_string();
  EXPECT_FALSE(result->clock.has_value());
  EXPECT_NE(result->no_clock.find("place"), std::string::npos) << result->no_clock;
}

TEST_F(Synthesis, LogicWithoutRegistersIsTimedBetweenTheWrappers) {
  SKIP_WITHOUT_YOSYS();
  SKIP_WITHOUT_ROUTER("ice40-hx8k");
  const auto result =
      run("module dut (input wire [7:0] a, output wire y); assign y = ^a; endmodule",
          device("ice40-hx8k"), {.seeds = 1});
  ASSERT_TRUE(result.ok()) << result.error().to_string();
  EXPECT_TRUE(result->clock.has_value()) << result->no_clock;
}

TEST_F(Synthesis, AnEstimateBeforeRoutingSeesTheCarryChain) {
  SKIP_WITHOUT_YOSYS();
  const auto result = run(adder, device("artix7-200t"), {});
  ASSERT_TRUE(result.ok()) << result.error().to_string();
  ASSERT_TRUE(result->clock.has_value()) << result->no_clock;
  EXPECT_EQ(result->clock->source, measured::ClockSource::estimate_before_routing);
  // Clock-to-output 303 ps, a LUT 238, onto the chain 400..600, along it 3 x 114, off it 200..340.
  EXPECT_GT(result->clock->mhz, 1e6 / 1900);
  EXPECT_LT(result->clock->mhz, 1e6 / 1400);
}

TEST_F(Synthesis, AnEstimateBeforeRoutingHasARegisterBehindEachShiftRegister) {
  SKIP_WITHOUT_YOSYS();
  // A shift register of 40 registers is a chain of two LUTs, shorter ones are one LUT.
  const auto result = run(delayed_adders, device("artix7-200t"), {});
  ASSERT_TRUE(result.ok()) << result.error().to_string();
  ASSERT_TRUE(result->clock.has_value()) << result->no_clock;
  EXPECT_LT(result->area.registers, 3 * 16 + 32) << "no shift registers were made";
  EXPECT_GT(result->clock->mhz, 1e6 / 1900);
}

/// GateMate's step of Yosys that drops names is left out.
TEST_F(Synthesis, NetlistsOfGateMateKeepTheNamesOfNets) {
  SKIP_WITHOUT_YOSYS();
  EXPECT_EQ(area(delayed_adders, "ccgm1a1").carries, 3 * 16);
  const auto netlist = characterise::read_json(directory_.path() / "map.json").value();
  const auto& names = netlist.at("modules").at("dut").at("netnames");
  EXPECT_TRUE(names.contains("large.y")) << names;
}

/// Units of one run of Yosys have the areas that each has by itself, and share nothing.
TEST(UnitBatch, EachUnitIsMappedAsIfAlone) {
  constexpr const char* counted = R"(
module counted #(parameter WIDTH = 4, parameter EXTRA = 0) (
  input wire aclk, input wire [WIDTH-1:0] a, input wire [WIDTH-1:0] b, output reg [WIDTH-1:0] y);
  always @(posedge aclk) y <= a + b + EXTRA;
endmodule
)";
  const ScratchDirectory folder;
  for (const char* name : {"artix7-200t", "ecp5-85k", "ice40-hx8k"}) {
    const devices::Device device = devices::find_device(name).value();
    const characterise::UnitBatch batch{.sources = {{"counted.v", counted}},
                                        .module = "counted",
                                        .parameters = {".WIDTH(8)", ".WIDTH(16)", ".WIDTH(8)"}};
    const auto areas = characterise::map_units(batch, device, {.seconds = 600}, folder.path());
    ASSERT_TRUE(areas.ok()) << areas.error().to_string();
    ASSERT_EQ(areas->size(), 3u);
    EXPECT_EQ(areas->at(0).registers, 8);
    EXPECT_EQ(areas->at(1).registers, 16);
    EXPECT_EQ(areas->at(0), areas->at(2));
    EXPECT_LT(areas->at(0).luts, areas->at(1).luts);
    std::string alone(counted);
    const std::string width = "WIDTH = 4";
    alone.replace(alone.find(width), width.size(), "WIDTH = 16");
    const auto single =
        characterise::synthesise({.sources = {{"counted.v", alone}}, .top = "counted"}, device,
                                 {.effort = characterise::TimingEffort::area_only}, folder.path());
    ASSERT_TRUE(single.ok()) << single.error().to_string();
    EXPECT_EQ(areas->at(1), single->area) << name;
  }
}

}  // namespace
}  // namespace mixcmp::test::synthesis_test
