#include "model/cost/devices/device.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

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

TEST(Devices, EveryFigureHasASource) {
  for (const std::string& name : devices::device_names()) {
    const devices::Device device = devices::find_device(name).value();
    for (const char* figure :
         {"technology_nm", "luts", "registers", "dsps", "memories", "delays"}) {
      const auto names_it = [&](const std::string& source) {
        return source.starts_with(fmt::format("{}: ", figure)) &&
               source.size() > std::string_view(figure).size() + 4;
      };
      EXPECT_EQ(std::count_if(device.sources.begin(), device.sources.end(), names_it), 1)
          << name << ": " << figure;
    }
  }
}

/// A longer chain, a larger multiplier: no delay is shorter than that of a part.
TEST(Devices, DelaysAreOrdered) {
  for (const std::string& name : devices::device_names()) {
    const devices::DelayTable delays = devices::find_device(name)->delays;
    EXPECT_GT(delays.register_ns, 0) << name;
    EXPECT_GT(delays.lut_ns, 0) << name;
    EXPECT_GE(delays.carry_start_ns, delays.lut_ns) << name;
    EXPECT_LT(delays.carry_ns_per_bit, delays.lut_ns) << name;
    EXPECT_GT(delays.multiplier_ns, delays.lut_ns) << name;
  }
}

TEST(Devices, OnlyDevicesThatAreRoutedPassArgumentsToARouter) {
  for (const std::string& name : devices::device_names()) {
    const devices::Device device = devices::find_device(name).value();
    const bool routed = device.timing == devices::TimingTool::nextpnr_ice40 ||
                        device.timing == devices::TimingTool::nextpnr_ecp5;
    EXPECT_EQ(!device.timing_arguments.empty(), routed) << name;
    EXPECT_EQ(!device.timing_synthesis.empty(), device.timing == devices::TimingTool::yosys_sta)
        << name;
  }
}

TEST(Devices, AnUnknownNameIsToldWithTheNearestAndTheList) {
  const auto device = devices::find_device("virtex6-lx76");
  ASSERT_FALSE(device.ok());
  EXPECT_EQ(device.error().field, "system.device");
  EXPECT_EQ(device.error().received, "\"virtex6-lx76\"");
  EXPECT_TRUE(device.error().accepted.starts_with("virtex6-lx760 (the nearest), "));
  for (const std::string& name : devices::device_names()) {
    EXPECT_NE(device.error().accepted.find(name), std::string::npos) << name;
  }
}

TEST(Devices, AVendorsPartNumberIsExplained) {
  const auto accepted = [](const char* name) {
    return devices::find_device(name).error().accepted;
  };
  for (const char* part : {"xc7a200t", "XC7A200T-2FBG676", "a200t", "7A200T"}) {
    EXPECT_TRUE(accepted(part).starts_with("artix7-200t (which is XC7A200T), ")) << part;
  }
  EXPECT_TRUE(accepted("LFE5U-85F-6BG381C").starts_with("ecp5-85k (which is LFE5U-85F-8BG756C), "));
  EXPECT_TRUE(accepted("hx8k").starts_with("ice40-hx8k (which is iCE40HX8K-CT256), "));
  EXPECT_TRUE(accepted("xc7a35t").starts_with("artix7-200t (XC7A200T, of the same family), "));
  EXPECT_TRUE(accepted("artix7-200").starts_with("artix7-200t (the nearest), "));
  EXPECT_TRUE(accepted("").starts_with("virtex5-lx330t, ")) << "nothing is near to nothing";
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
