#include "model/cost/devices/device_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>

/// Every mistake in a device file is told with its file, line and field.
namespace mixcmp::test::device_file_test {
namespace {

constexpr std::string_view valid = R"([device]
name = "d"
luts = 10
registers = 20
dsps = 0
memories = 1
[synthesis]
command = "synth_ecp5 -abc9"
[timing]
tool = "nextpnr_ecp5"
arguments = ["--85k", "--speed", "8"]
[delays]
lut_ns = 1
carry_start_ns = 1
carry_ns_per_bit = 0.1
multiplier_ns = 4
multiplier_add_ns = 2
register_ns = 1
[sources]
luts = "a data sheet"
)";

Result<devices::Device> with(std::string_view from, std::string_view to) {
  std::string text(valid);
  const std::size_t at = text.find(from);
  MIXCMP_CHECK(at != std::string::npos);
  return devices::read_device(text.replace(at, from.size(), to), "d.toml");
}

struct Mistake {
  const char* name;
  const char* from;
  const char* to;
  int line;
  const char* field;
  const char* received;
};

void PrintTo(const Mistake& mistake, std::ostream* stream) {
  *stream << mistake.name;
}

class DeviceFile : public testing::TestWithParam<Mistake> {};

TEST_P(DeviceFile, TellsTheMistakesPlace) {
  const Mistake& mistake = GetParam();
  const auto device = with(mistake.from, mistake.to);
  ASSERT_FALSE(device.ok());
  EXPECT_EQ(device.error().file, "d.toml");
  EXPECT_EQ(device.error().line, mistake.line) << device.error().to_string();
  EXPECT_EQ(device.error().field, mistake.field) << device.error().to_string();
  EXPECT_EQ(device.error().received, mistake.received) << device.error().to_string();
  EXPECT_FALSE(device.error().accepted.empty()) << device.error().to_string();
}

INSTANTIATE_TEST_SUITE_P(
    Mistakes, DeviceFile,
    testing::Values(
        Mistake{"NoLuts", "luts = 10\n", "", 1, "device.luts", "nothing"},
        Mistake{"NameOfAFolder", "name = \"d\"", "name = \"../d\"", 2, "device.name", "\"../d\""},
        Mistake{"PartThatIsTcl", "luts = 10\n", "luts = 10\nvivado_part = \"a [exit]\"\n", 4,
                "device.vivado_part", "\"a [exit]\""},
        Mistake{"EmptyName", "name = \"d\"", "name = \"\"", 2, "device.name", "\"\""},
        Mistake{"NoDsps", "dsps = 0\n", "", 1, "device.dsps", "nothing"},
        Mistake{"DspsOfUnknownSize", "dsps = 0", "dsps = 1", 1, "device.multiplier_a_bits",
                "nothing"},
        Mistake{"NegativeDsps", "dsps = 0", "dsps = -1", 5, "device.dsps", "-1"},
        Mistake{"MemoryOfThreeReaders", "dsps = 0", "dsps = 0\nmemory_read_ports = 3", 6,
                "device.memory_read_ports", "3"},
        Mistake{"ThreeSelections", "dsps = 0", "dsps = 0\nsum_selects = 3", 6, "device.sum_selects",
                "3"},
        Mistake{"EmptyMemory", "dsps = 0", "dsps = 0\nmemory_bits = 0", 6, "device.memory_bits",
                "0"},
        Mistake{"ZeroLuts", "luts = 10", "luts = 0", 3, "device.luts", "0"},
        Mistake{"FractionOfALut", "luts = 10", "luts = 1.5", 3, "device.luts", "1.5 (a number)"},
        Mistake{"TooManyRegisters", "registers = 20", "registers = 3000000000", 4,
                "device.registers", "3000000000"},
        Mistake{"UnknownKey", "dsps = 0", "dsp = 0", 5, "device.dsp", "dsp"},
        Mistake{"UnknownSection", "[delays]", "[delay]", 12, "delay", "delay"},
        Mistake{"UnknownFamily", "luts = 10\n", "luts = 10\nfamily = \"artix8\"\n", 4,
                "device.family", "\"artix8\""},
        Mistake{"UnknownPart", "luts = 10\n", "luts = 10\npart = \"xc7a15t\"\n", 4, "device.part",
                "\"xc7a15t\""},
        Mistake{"PartAsANumber", "luts = 10\n", "luts = 10\npart = 7\n", 4, "device.part", "7"},
        Mistake{"PartAndFamily", "luts = 10\n",
                "luts = 10\npart = \"xc7a100t\"\nfamily = \"artix7\"\n", 5, "device.family",
                "\"artix7\""},
        Mistake{"CommandAndTheReasonWhyThereIsNone", "-abc9\"", "-abc9\"\nmissing = \"x\"", 9,
                "synthesis.missing", "\"x\""},
        Mistake{"NoDelay", "lut_ns = 1\n", "", 12, "delays.lut_ns", "nothing"},
        Mistake{"InfiniteDelay", "lut_ns = 1", "lut_ns = inf", 13, "delays.lut_ns", "inf"},
        Mistake{"NoSynthesis", "command = \"synth_ecp5 -abc9\"\n", "", 7, "synthesis.command",
                "nothing"},
        Mistake{"ScriptAsCommand", "synth_ecp5 -abc9", "synth_ecp5; !reboot", 8,
                "synthesis.command", "\"synth_ecp5; !reboot\""},
        Mistake{"OtherCommand", "synth_ecp5 -abc9", "write_verilog x.v", 8, "synthesis.command",
                "\"write_verilog x.v\""},
        Mistake{"UnknownCells", "-abc9\"", "-abc9\"\ncells = \"ice50\"", 9, "synthesis.cells",
                "\"ice50\""},
        Mistake{"CellWithoutResources", "-abc9\"", "-abc9\"\n[areas]\nLUT4 = 1", 10, "areas.LUT4",
                "1"},
        Mistake{"CellOfAnUnknownResource", "-abc9\"", "-abc9\"\n[areas]\nLUT4 = { lut = 1 }", 10,
                "areas.LUT4.lut", "lut"},
        Mistake{"NegativeCell", "-abc9\"", "-abc9\"\n[areas]\nLUT4 = { luts = -1 }", 10,
                "areas.LUT4.luts", "-1"},
        Mistake{"UnknownTool", "nextpnr_ecp5", "nextpnr_ecp6", 10, "timing.tool",
                "\"nextpnr_ecp6\""},
        Mistake{"SynthesisForARouter", "arguments", "synthesis = \"synth_ecp5\"\narguments", 11,
                "timing.synthesis", "\"synth_ecp5\""},
        Mistake{"EstimateWithoutSynthesis", "nextpnr_ecp5", "yosys_sta", 9, "timing.synthesis",
                "nothing"},
        Mistake{"EstimateOfAnotherVendor", "\"nextpnr_ecp5\"",
                "\"yosys_sta\"\nsynthesis = \"synth_ecp5\"", 11, "timing.synthesis",
                "\"synth_ecp5\""},
        Mistake{"ArgumentsAsOneString", "[\"--85k\", \"--speed\", \"8\"]", "\"--85k\"", 11,
                "timing.arguments", "\"--85k\""},
        Mistake{"ArgumentAsANumber", "\"8\"", "8", 11, "timing.arguments", "8"},
        Mistake{"SourceAsANumber", "\"a data sheet\"", "10", 20, "sources.luts",
                "10 (an integer)"}),
    [](const auto& instance) { return instance.param.name; });

TEST(DeviceFile, IsReadAsWritten) {
  const auto device = with("luts", "luts");
  ASSERT_TRUE(device.ok()) << device.error().to_string();
  EXPECT_EQ(device->available,
            (devices::Area{.luts = 10, .registers = 20, .dsps = 0, .memories = 1}));
  EXPECT_EQ(device->synthesis, "synth_ecp5 -abc9");
  EXPECT_EQ(device->timing, devices::TimingTool::nextpnr_ecp5);
  EXPECT_EQ(device->timing_arguments, (std::vector<std::string>{"--85k", "--speed", "8"}));
  EXPECT_EQ(device->delays.carry_ns_per_bit, 0.1);
  EXPECT_EQ(device->sources, std::vector<std::string>{"luts: a data sheet"});
}

/// A device file's own areas come before those of the command's cells.
TEST(DeviceFile, AreasAreThoseOfTheCommandUnlessGiven) {
  const auto plain = with("luts", "luts");
  EXPECT_EQ(plain->cell_areas.find("CCU2C"), (devices::Area{.luts = 2, .carries = 1}));
  EXPECT_EQ(plain->cell_areas.find("SB_LUT4"), std::nullopt) << "a cell of another command";
  const auto own = with("-abc9\"", "-abc9\"\n[areas]\nCCU2C = { luts = 3 }\n\"X*\" = { dsps = 2 }");
  ASSERT_TRUE(own.ok()) << own.error().to_string();
  EXPECT_EQ(own->cell_areas.find("CCU2C"), devices::Area{.luts = 3});
  EXPECT_EQ(own->cell_areas.find("XYZ"), devices::Area{.dsps = 2});
  EXPECT_EQ(own->cell_areas.find("LUT4"), devices::Area{.luts = 1});
  EXPECT_EQ(own->cell_areas.find("LUT44"), std::nullopt) << "only a name with * is a start";
}

/// A table of six inputs has room for two bits that select. A table of four has none, unless the
/// file says so.
TEST(DeviceFile, SelectionsFollowTheTablesInputsUnlessGiven) {
  EXPECT_EQ(with("luts", "luts")->delays.sum_selects, 2);
  EXPECT_EQ(with("dsps = 0", "dsps = 0\nlut_inputs = 4")->delays.sum_selects, 0);
  EXPECT_EQ(with("dsps = 0", "dsps = 0\nsum_selects = 1\nlut_inputs = 4")->delays.sum_selects, 1);
}

/// A file that names a family needs only what differs.
TEST(DeviceFile, LeavesTheRestToItsFamily) {
  const auto device = devices::read_device(
      "[device]\nname = \"d\"\nfamily = \"ecp5\"\nluts = 10\nregisters = 20\ndsps = 1\nmemories = "
      "3\n[timing]\narguments = [\"--25k\"]\n[delays]\nlut_ns = 9\n[sources]\nluts = \"counted\"\n",
      "d.toml");
  ASSERT_TRUE(device.ok()) << device.error().to_string();
  EXPECT_EQ(device->name, "d");
  EXPECT_EQ(device->family, "ecp5");
  EXPECT_EQ(device->available,
            (devices::Area{.luts = 10, .registers = 20, .dsps = 1, .memories = 3}));
  EXPECT_EQ(device->synthesis, "synth_ecp5");
  EXPECT_EQ(device->cells, "ecp5");
  EXPECT_EQ(device->timing, devices::TimingTool::nextpnr_ecp5);
  EXPECT_EQ(device->timing_arguments, std::vector<std::string>{"--25k"});
  EXPECT_EQ(device->delays.lut_ns, 9);
  EXPECT_EQ(device->delays.memory_ns, 4.5);
  EXPECT_EQ(device->delays.target_mhz, 100);
  EXPECT_EQ(device->delays.multiplier_size, (devices::MultiplierSize{.a_bits = 18, .b_bits = 18}));
  EXPECT_EQ(std::count(device->sources.begin(), device->sources.end(), "luts: counted"), 1);
}

/// A command or a tool of the file's own comes without the options of the family's.
TEST(DeviceFile, FollowsAPartButForItsOwnCommandAndTool) {
  const auto device = devices::read_device(
      "[device]\nname = \"d\"\npart = \"LFE5U-85F-6BG381C\"\n[synthesis]\ncommand = \"synth_ecp5 "
      "-nodsp\"\n[timing]\ntool = \"none\"\n",
      "d.toml");
  ASSERT_TRUE(device.ok()) << device.error().to_string();
  EXPECT_EQ(device->name, "d");
  EXPECT_EQ(device->available.luts, 83640);
  EXPECT_EQ(device->synthesis, "synth_ecp5 -nodsp");
  EXPECT_EQ(device->cells, "");
  EXPECT_EQ(device->timing, devices::TimingTool::none);
  EXPECT_EQ(device->timing_arguments, std::vector<std::string>{});
}

/// Its tables would be taken for those of the part.
TEST(DeviceFile, HasANameOfItsOwn) {
  const auto device = devices::read_device("[device]\npart = \"xc7a100t\"\n", "d.toml");
  ASSERT_FALSE(device.ok());
  EXPECT_EQ(device.error().field, "device.name");
  EXPECT_EQ(device.error().file, "d.toml");
  EXPECT_EQ(device.error().line, 1);
}

TEST(DeviceFile, BrokenSyntaxIsToldWithItsLine) {
  const auto device = with("luts = 10", "luts = ");
  ASSERT_FALSE(device.ok());
  EXPECT_EQ(device.error().line, 3);
  EXPECT_EQ(device.error().field, "TOML syntax");
}

}  // namespace
}  // namespace mixcmp::test::device_file_test
