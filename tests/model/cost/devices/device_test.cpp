#include "model/cost/devices/device.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <utility>

#include "tests/support/scratch_directory.hpp"

/// The devices that come with the program.
namespace mixcmp::test::device_test {
namespace {

TEST(Devices, EveryListedNameIsFoundAndNamesItself) {
  ASSERT_EQ(devices::device_names().size(), 7u);
  for (const std::string& name : devices::device_names()) {
    const auto device = devices::find_device(name);
    ASSERT_TRUE(device.ok()) << device.error().to_string();
    EXPECT_EQ(device->name, name);
    EXPECT_FALSE(device->vendor_name.empty()) << name;
    EXPECT_GT(device->technology_nm, 0) << name;
  }
}

TEST(Devices, HaveThePapersCapacities) {
  const devices::Area virtex5 = devices::find_device("virtex5-lx330t")->available;
  EXPECT_EQ(virtex5.luts, 207360);
  const devices::Area virtex6 = devices::find_device("virtex6-lx760")->available;
  EXPECT_EQ(virtex6.luts, 474240);
  EXPECT_EQ(virtex6.dsps, 864);
}

TEST(Devices, ThePapersSmallerDeviceIsSynthesisedWithoutMultiplierBlocks) {
  EXPECT_NE(devices::find_device("virtex5-lx330t")->synthesis.find("-nodsp"), std::string::npos);
  EXPECT_EQ(devices::find_device("virtex6-lx760")->synthesis.find("-nodsp"), std::string::npos);
}

/// The figures of a device in one line, without its sources.
std::string figures_of(const devices::Device& device) {
  const devices::Area& area = device.available;
  const devices::DelayTable& delays = device.delays;
  return fmt::format(
      "{}|{}|{} nm|{} {} {} {}|{}|{}|{}|{}|{}|{} {} {} {} {} {} {} {} {}|{} {} {}x{} {}x{}",
      device.vendor_name, device.vivado_part + device.quartus_part, device.technology_nm, area.luts,
      area.registers, area.dsps, area.memories, device.synthesis, device.cells,
      to_string(device.timing), device.timing_synthesis, fmt::join(device.timing_arguments, " "),
      delays.lut_ns, delays.carry_start_ns, delays.carry_ns_per_bit, delays.multiplier_input_ns,
      delays.multiplier_ns, delays.multiplier_output_ns, delays.multiplier_add_ns, delays.memory_ns,
      delays.register_ns, delays.lut_inputs, delays.sum_selects, delays.multiplier_size.a_bits,
      delays.multiplier_size.b_bits, delays.memory_block.bits, delays.memory_block.read_ports);
}

/// Tables of measured areas name these devices, and the delays place the registers of their RTL, so
/// all figures must stay as they were before families had files.
TEST(Devices, DevicesOfOlderTablesAreAsTheyWere) {
  const std::string xilinx = "-flatten -noiopad -noclkbuf|";
  const std::pair<const char*, std::string> as_before[] = {
      {"virtex5-lx330t",
       "XC5VLX330T||65 nm|207360 207360 192 648|synth_xilinx -family xc5v -nodsp " + xilinx +
           "|yosys_sta|synth_xilinx -family xc7 -abc9 -nodsp " + xilinx +
           "|0.9 1 0.025 0 2.3 1.4 1.6 2.2 0.8|6 2 24x17 18432x2"},
      {"virtex6-lx760", "XC6VLX760||40 nm|474240 948480 864 1440|synth_xilinx -family xc6v " +
                            xilinx + "|yosys_sta|synth_xilinx -family xc7 -abc9 " + xilinx +
                            "|0.7 0.8 0.02 0 1.9 1.2 1.2 1.9 0.6|6 2 24x17 18432x2"},
      {"artix7-200t",
       "XC7A200T|xc7a200tfbg676-2|28 nm|134600 269200 740 730|synth_xilinx -family xc7 " + xilinx +
           "|yosys_sta|synth_xilinx -family xc7 -abc9 " + xilinx +
           "|0.7 0.8 0.02 0 1.9 1.2 1.2 2.1 0.6|6 2 24x17 18432x2"},
      {"ultrascale+-vu9p",
       "XCVU9P|xcvu9p-flga2104-2L-e|16 nm|1182240 2364480 6840 4320|synth_xilinx -family xcup " +
           xilinx + "|yosys_sta|synth_xilinx -family xc7 -abc9 " + xilinx +
           "|0.42 0.48 0.012 0 1.14 0.72 0.72 1.14 0.36|6 2 26x17 18432x2"},
      {"ecp5-85k",
       "LFE5U-85F-8BG756C||40 nm|83640 83640 156 208|synth_ecp5|ecp5|nextpnr_ecp5||--85k "
       "--package CABGA756 --speed 8|1.1 1.1 0.035 2 3.4 0 3.6 4.5 0.9|4 1 18x18 18432x2"},
      {"ice40-hx8k",
       "iCE40HX8K-CT256||40 nm|7680 7680 0 32|synth_ice40||nextpnr_ice40||--hx8k --package "
       "ct256|1.3 1.4 0.13 0 14 0 3 2.2 1.2|4 0 24x17 4096x1"},
      {"ice40-up5k",
       "iCE40UP5K-SG48||40 nm|5280 5280 8 30|synth_ice40 -device u|ice40|nextpnr_ice40||--up5k "
       "--package sg48|2.6 2.8 0.28 0 12 0 12 4.4 2.4|4 0 16x16 4096x1"}};
  for (const auto& [name, figures] : as_before) {
    EXPECT_EQ(figures_of(devices::find_device(name).value()), figures) << name;
  }
}

TEST(Devices, EveryFigureHasASource) {
  for (const devices::KnownDevice& known : devices::known_devices()) {
    for (const char* figure :
         {"technology_nm", "luts", "registers", "dsps", "memories", "delays", "clock"}) {
      const auto names_it = [&](const std::string& source) {
        return source.starts_with(fmt::format("{}: ", figure)) &&
               source.size() > std::string_view(figure).size() + 5;
      };
      const auto& sources = known.device.sources;
      EXPECT_EQ(std::count_if(sources.begin(), sources.end(), names_it), 1)
          << known.device.name << ": " << figure;
    }
  }
}

/// A longer chain, a larger multiplier: no delay is shorter than that of a part.
TEST(Devices, DelaysAreOrdered) {
  for (const devices::KnownDevice& known : devices::known_devices()) {
    const devices::DelayTable& delays = known.device.delays;
    EXPECT_GT(delays.register_ns, 0) << known.device.name;
    EXPECT_GT(delays.lut_ns, 0) << known.device.name;
    EXPECT_GE(delays.carry_start_ns, delays.lut_ns) << known.device.name;
    EXPECT_LT(delays.carry_ns_per_bit, delays.lut_ns) << known.device.name;
    EXPECT_GT(delays.multiplier_ns, delays.lut_ns) << known.device.name;
  }
}

/// A router needs to know the part; Yosys' estimate needs a command.
TEST(Devices, ToolsOfClocksHaveWhatTheyNeed) {
  for (const devices::KnownDevice& known : devices::known_devices()) {
    const devices::Device& device = known.device;
    const bool routed = to_string(device.timing).starts_with("nextpnr");
    EXPECT_TRUE(!routed || !device.timing_arguments.empty()) << device.name;
    EXPECT_EQ(!device.timing_synthesis.empty(), device.timing == devices::TimingTool::yosys_sta)
        << device.name;
    EXPECT_EQ(device.synthesis.empty(), !device.no_synthesis.empty()) << device.name;
  }
}

TEST(Devices, AnAbsentFileIsToldByItsPath) {
  const auto device = devices::find_device("no/such/device.toml");
  ASSERT_FALSE(device.ok());
  EXPECT_EQ(device.error().file, "no/such/device.toml");
}

TEST(Devices, AUsersFileIsADevice) {
  const test::ScratchDirectory directory;
  const auto path = directory.path() / "mine.toml";
  std::ofstream(path)
      << "[device]\nname = \"mine\"\nluts = 1000\nregisters = 2000\ndsps = 3\n"
         "memories = 4\nmemory_bits = 9000\nmultiplier_a_bits = 12\nmultiplier_b_bits = "
         "9\n[synthesis]\ncommand = \"synth_ice40\"\n"
         "[timing]\ntool = \"none\"\n"
         "[delays]\nlut_ns = 1\ncarry_start_ns = 1.5\ncarry_ns_per_bit = 0.1\n"
         "multiplier_ns = 9\nmultiplier_add_ns = 2\nregister_ns = 1\n";
  const auto device = devices::find_device(path.string());
  ASSERT_TRUE(device.ok()) << device.error().to_string();
  EXPECT_EQ(device->name, "mine");
  EXPECT_EQ(device->available,
            (devices::Area{.luts = 1000, .registers = 2000, .dsps = 3, .memories = 4}));
  EXPECT_EQ(device->delays.multiplier_ns, 9);
  EXPECT_EQ(device->delays.multiplier_size, (devices::MultiplierSize{.a_bits = 12, .b_bits = 9}));
  EXPECT_EQ(device->delays.memory_block, (devices::MemoryBlock{.bits = 9000, .read_ports = 2}));
}

}  // namespace
}  // namespace mixcmp::test::device_test
