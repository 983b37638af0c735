#include "model/cost/devices/parts.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "model/cost/devices/device.hpp"

/// The tables of parts and boards, and the names by which users find a device.
namespace mixcmp::test::parts_test {
namespace {

TEST(Parts, EveryRowIsAPlausibleDevice) {
  ASSERT_GT(devices::parts().size(), 200u);
  for (const devices::Part& part : devices::parts()) {
    const auto device = devices::find_device(part.name);
    ASSERT_TRUE(device.ok()) << part.name << ": " << device.error().to_string();
    EXPECT_EQ(device->name, part.device.empty() ? part.name : part.device);
    EXPECT_EQ(device->family, part.family) << part.name;
    const devices::Area& area = device->available;
    EXPECT_EQ(fmt::format("{} {} {} {}", area.luts, area.registers, area.dsps, area.memories),
              fmt::format("{} {} {} {}", part.luts, part.registers, part.dsps, part.memories))
        << part.name;
    EXPECT_GE(2 * area.registers, area.luts) << part.name;
    EXPECT_LE(area.registers, 2 * area.luts) << part.name;
    EXPECT_LE(area.dsps, area.luts / 40) << part.name;
    EXPECT_LE(area.memories, area.luts / 40) << part.name;
    EXPECT_GE(device->technology_nm, 16) << part.name;
    EXPECT_TRUE(device->delays.lut_inputs == 4 || device->delays.lut_inputs == 6) << part.name;
    for (const std::string_view vendors : {part.vivado_part, part.quartus_part}) {
      EXPECT_TRUE(vendors.empty() || devices::lower_case(vendors).starts_with(part.name))
          << vendors << " is no number for orders of " << part.name;
    }
    EXPECT_EQ(!part.quartus_part.empty(), part.family == "cyclonev") << part.name;
  }
}

/// Only families whose routed systems are slower than 200 MHz have another target, so that plans on
/// all others stay as they are.
TEST(Parts, OnlySlowFamiliesHaveAnotherTarget) {
  for (const devices::Part& part : devices::parts()) {
    const devices::Device device = devices::find_device(part.name).value();
    const bool is_routed = device.timing != devices::TimingTool::none &&
                           device.timing != devices::TimingTool::yosys_sta;
    const bool is_slow = is_routed || part.family == "certuspro-nx";
    EXPECT_EQ(device.delays.target_mhz < 200, is_slow) << part.name;
    EXPECT_LE(device.delays.target_mhz, 200) << part.name;
  }
  EXPECT_GT(devices::find_device("ice40-hx8k")->delays.target_mhz,
            devices::find_device("ice40-up5k")->delays.target_mhz);
}

/// A mistyped row shows beside its neighbours.
TEST(Parts, AreSortedBySizeWithinTheirFamily) {
  const std::vector<devices::Part> parts = devices::parts();
  for (std::size_t k = 1; k < parts.size(); ++k) {
    if (parts[k].family != parts[k - 1].family) continue;
    EXPECT_GE(std::stoi(std::string(parts[k].luts)), std::stoi(std::string(parts[k - 1].luts)))
        << parts[k].name;
  }
}

TEST(Parts, NoTwoNamesAreEqualAndEveryBoardHasAPart) {
  std::set<std::string> names;
  const auto add = [&names](std::string_view name) {
    EXPECT_TRUE(names.insert(std::string(name)).second) << name << " is listed twice";
    EXPECT_EQ(name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-+"), name.npos) << name;
  };
  std::set<std::string_view> parts;
  for (const std::string& name : devices::device_names()) add(name);
  for (const devices::Part& part : devices::parts()) add(part.name);
  for (const devices::Part& part : devices::parts()) parts.insert(part.name);
  ASSERT_GT(devices::boards().size(), 100u);
  for (const devices::Board& board : devices::boards()) {
    add(board.name);
    EXPECT_TRUE(parts.contains(board.part)) << board.name << ": " << board.part;
    EXPECT_FALSE(board.maker.empty()) << board.name;
    EXPECT_TRUE(board.page.starts_with("http")) << board.name;
    EXPECT_EQ(devices::find_part(board.name)->name, board.part);
  }
}

struct Name {
  const char* given;
  const char* device;
};

class DeviceNames : public testing::TestWithParam<Name> {};

TEST_P(DeviceNames, AreFound) {
  const auto device = devices::find_device(GetParam().given);
  ASSERT_TRUE(device.ok()) << device.error().to_string();
  EXPECT_EQ(device->name, GetParam().device) << GetParam().given;
}

/// A part that tables of areas know by an older name keeps it, so that they hold for the part and
/// its boards. The virtex5-lx330t is no such part: it leaves its multipliers unused.
INSTANTIATE_TEST_SUITE_P(
    All, DeviceNames,
    testing::Values(Name{"xc7a100t", "xc7a100t"}, Name{"XC7A100T", "xc7a100t"},
                    Name{"xc7a100tcsg324-1", "xc7a100t"}, Name{"XC7A100T-1CSG324C", "xc7a100t"},
                    Name{"arty-a7-100", "xc7a100t"}, Name{"Arty-A7-100", "xc7a100t"},
                    Name{"xc7a200t", "artix7-200t"}, Name{"Artix7-200T", "artix7-200t"},
                    Name{"XC7A200T-2FBG676", "artix7-200t"}, Name{"nexys-video", "artix7-200t"},
                    Name{"xc5vlx330t", "xc5vlx330t"}, Name{"virtex5-lx330t", "virtex5-lx330t"},
                    Name{"xc5vlx330", "xc5vlx330"}, Name{"XC6SLX45-2CSG324", "xc6slx45"},
                    Name{"XC6SLX45T-2CSG324", "xc6slx45t"}, Name{"LFE5U-85F-6BG381C", "ecp5-85k"},
                    Name{"ulx3s-85", "ecp5-85k"}, Name{"ulx3s-12", "lfe5u-12f"},
                    Name{"icebreaker", "ice40-up5k"}, Name{"iCE40HX8K-CT256", "ice40-hx8k"},
                    Name{"de10-nano", "5cseba6"}, Name{"5CSEBA6U23I7", "5cseba6"},
                    Name{"pynq-z2", "xc7z020"}, Name{"tang-nano-9k", "gw1nr-9c"},
                    Name{"vcu118", "ultrascale+-vu9p"}));

struct Refused {
  const char* given;
  const char* accepted;  ///< the beginning of the list
};

class NoDeviceNames : public testing::TestWithParam<Refused> {};

TEST_P(NoDeviceNames, AreToldWithTheNearest) {
  const auto device = devices::find_device(GetParam().given);
  ASSERT_FALSE(device.ok()) << device->name;
  const Error& error = device.error();
  EXPECT_EQ(error.field, "system.device");
  EXPECT_EQ(error.received, fmt::format("\"{}\"", GetParam().given));
  EXPECT_TRUE(error.accepted.starts_with(GetParam().accepted)) << error.accepted;
  EXPECT_NE(error.accepted.find("mixcmp devices"), std::string::npos) << error.accepted;
  EXPECT_LT(error.accepted.size(), 250u) << error.accepted;
}

INSTANTIATE_TEST_SUITE_P(
    All, NoDeviceNames,
    testing::Values(
        Refused{"xc7a", "xc7a25t, xc7a35t, xc7a50t, xc7a100t, xc7a200t ("},
        Refused{"arty-a7", "arty-a7-100, arty-a7-35 ("}, Refused{"arty", "arty-a7-100, "},
        Refused{"a200t", "xc7a200t ("}, Refused{"HX8K", "ice40-hx8k, ice40hx8k, "},
        Refused{"kintex7", "xc7k70t, xc7k160t, "}, Refused{"artix7-200", "artix7-200t ("},
        Refused{"virtex6-lx76", "virtex6-lx760 ("}, Refused{"xc7a15t", "xc7a25t, xc7a35t, "},
        Refused{"arty-a8-100", "arty-a7-100, "}, Refused{"gw1n-1s", "gw1n-1, "},
        Refused{"GW1N-1P5", "gw1n-1, "}, Refused{"xc7a10", "xc7a100t ("},
        Refused{"5", "5ceba2, 5cefa2, "}, Refused{"", "virtex5-lx330t, virtex6-lx760, "},
        Refused{"what is this", "virtex5-lx330t, virtex6-lx760, "}));

TEST(NoDeviceNames, ALongListSaysHowManyItLeavesOut) {
  const std::string accepted = devices::find_device("xc7").error().accepted;
  EXPECT_TRUE(accepted.starts_with("xc7s15, xc7s25, ")) << accepted;
  EXPECT_NE(accepted.find(", 19 more (mixcmp devices"), std::string::npos) << accepted;
}

TEST(KnownDevices, HaveTheirOtherNames) {
  const auto known = devices::known_devices();
  EXPECT_EQ(known.size(), devices::parts().size() + 1) << "the virtex5-lx330t is no part";
  const auto other_names = [&](const std::string& name) {
    const auto found = std::find_if(known.begin(), known.end(),
                                    [&](const auto& each) { return each.device.name == name; });
    return found == known.end() ? std::vector<std::string>{"absent"} : found->other_names;
  };
  EXPECT_EQ(
      other_names("ice40-hx8k"),
      (std::vector<std::string>{"ice40hx8k", "alchitry-cu", "ice40-hx8k-b-evn", "ice40-hx8k-evb"}));
  EXPECT_EQ(other_names("virtex5-lx330t"), std::vector<std::string>{});
}

}  // namespace
}  // namespace mixcmp::test::parts_test
