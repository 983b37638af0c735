#include "generator/hardware/emit/system.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "tests/support/mixed_spheres.hpp"
#include "tests/support/scratch_directory.hpp"
#include "tests/support/sphere.hpp"

namespace mixcmp::test::system_test {
namespace {

namespace fs = std::filesystem;

constexpr const char* command = "mixcmp generate scene.toml";

emit::GeneratedSystem sphere_system(int lanes = 8, int references = 1) {
  return emit::generate_system(sphere_design(format("s17e8"), format("s53e8"), lanes, references),
                               command)
      .value();
}

const emit::GeneratedFile* find(const emit::GeneratedSystem& system, const std::string& name) {
  for (const emit::GeneratedFile& file : system.files) {
    if (file.name == name) return &file;
  }
  return nullptr;
}

std::string content(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

std::set<std::string> names_in(const fs::path& directory) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(directory)) {
    names.insert(entry.path().filename().string());
  }
  return names;
}

TEST(System, SameDesignGivesTheSameBytes) {
  const emit::GeneratedSystem first = sphere_system();
  const emit::GeneratedSystem second = sphere_system();
  ASSERT_EQ(first.files.size(), second.files.size());
  for (std::size_t k = 0; k < first.files.size(); ++k) {
    EXPECT_EQ(first.files[k].name, second.files[k].name);
    EXPECT_EQ(first.files[k].text, second.files[k].text);
  }
}

TEST(System, TopSaysWhatItComparesAndWhereOperandsAre) {
  design::Design design = sphere_design(format("s17e8"), format("s53e8"), 2, 1);
  design.parts = {{.f = "distance2", .g = "(ri + rj)^2"}};
  design.lets = {{.name = "distance2", .text = "cxi - cxj"}};
  const emit::GeneratedSystem system = emit::generate_system(design, command).value();
  const std::string top = find(system, system.signature.top + ".v")->text;
  for (const char* lines : {"// The verdict is the sign of f - g:\n"
                            "//   f = distance2\n"
                            "//   g = (ri + rj)^2\n"
                            "//   let distance2 = cxi - cxj\n"
                            "// Streams s_axis, m_axis: AXI4-Stream.\n",
                            "//   cxi [60:0], cxj [121:61], cyi [182:122], cyj [243:183], "
                            "czi [304:244], czj [365:305],\n"
                            "//   ri [426:366], rj [487:427]\n"
                            "//   each in s53e8: sign [60], exponent + 127 [59:52], "
                            "fraction [51:0].\n"}) {
    EXPECT_NE(top.find(lines), std::string::npos) << lines << top.substr(0, 2000);
  }
  ASSERT_EQ(system.signature.parts.size(), 1u);
  EXPECT_EQ(system.signature.parts[0].f, "distance2");
  EXPECT_EQ(system.signature.lets[0].text, "cxi - cxj");
}

TEST(System, TopNamesEachPart) {
  design::Design design = sphere_design(format("s17e8"), format("s53e8"), 2, 1);
  design.parts = {{.f = "cxi", .g = "cxj"}, {.f = "ri", .g = "rj"}};
  design.reference.combination = Combination::any;
  const emit::GeneratedSystem system = emit::generate_system(design, command).value();
  const std::string lines =
      "// The verdict is that of any of 2 parts, the signs of f[k] - g[k]:\n"
      "//   f[0] = cxi\n//   g[0] = cxj\n//   f[1] = ri\n//   g[1] = rj\n";
  EXPECT_NE(find(system, system.signature.top + ".v")->text.find(lines), std::string::npos);
  EXPECT_EQ(system.signature.combination, Combination::any);
}

emit::GeneratedSystem mixed_system() {
  return emit::generate_system(test::mixed_sphere_design(), command).value();
}

/// The identifiers of a Verilog text, comments included.
std::set<std::string> words_of(const std::string& text) {
  std::set<std::string> words;
  std::string word;
  for (const char c : text + " ") {
    const bool inside = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
    if (inside) word += c;
    if (!inside && !word.empty()) words.insert(std::exchange(word, ""));
  }
  return words;
}

TEST(System, EveryModuleButTheTopCarriesThePrefix) {
  design::Design design = sphere_design(format("s17e8"), format("s53e8"), 2, 1);
  design.inputs.front() = "fp_add";  // an input's name is the user's
  for (const std::string prefix : {"mixcmp_", "other_", ""}) {
    design.system.prefix = prefix;
    const emit::GeneratedSystem system = emit::generate_system(design, command).value();
    const std::string& top = system.signature.top;
    EXPECT_EQ(top, "sphere_s17e8_2x1");
    for (const std::string& name : system.signature.files) {
      const std::string module = name.substr(0, name.size() - 2);
      EXPECT_TRUE(module == top || module.starts_with(prefix)) << name;
      const std::string& text = find(system, name)->text;
      EXPECT_NE(text.find("\nmodule " + module + " "), std::string::npos) << name;
      if (prefix.empty()) continue;
      const std::set<std::string> words = words_of(text);
      for (const char* other : {"stream_fifo", "stream_crossbar", "fp_round"}) {
        EXPECT_FALSE(words.contains(other)) << other << " in " << name;
      }
    }
    EXPECT_TRUE(words_of(find(system, top + ".v")->text).contains(prefix + "stream_crossbar"));
    const std::string lane = system.signature.lane_groups.front().module;
    EXPECT_TRUE(words_of(find(system, lane + ".v")->text).contains("fp_add"));
  }
}

TEST(MixedSystem, SameDesignGivesTheSameBytes) {
  const emit::GeneratedSystem first = mixed_system(), second = mixed_system();
  ASSERT_EQ(first.files.size(), second.files.size());
  for (std::size_t k = 0; k < first.files.size(); ++k) {
    EXPECT_EQ(first.files[k].name, second.files[k].name);
    EXPECT_EQ(first.files[k].text, second.files[k].text);
  }
}

TEST(MixedSystem, EachKindHasItsModuleAndEqualKindsShareOne) {
  const emit::GeneratedSystem system = mixed_system();
  EXPECT_EQ(system.signature.top, "sphere_s6e8_4_s9e8_3x3");
  std::vector<std::string> modules;
  for (const emit::SignatureLanes& group : system.signature.lane_groups)
    modules.push_back(group.module);
  ASSERT_EQ(modules.size(), 4u);
  EXPECT_TRUE(modules[0].starts_with("mixcmp_sphere_lane_s6e8_exact_relative_l")) << modules[0];
  EXPECT_TRUE(modules[1].starts_with("mixcmp_sphere_lane_s6e8_rounded_running_4_l")) << modules[1];
  EXPECT_TRUE(modules[2].starts_with("mixcmp_sphere_lane_s9e8_l")) << modules[2];
  EXPECT_EQ(modules[3], modules[0]);
  for (const std::string& module : modules) EXPECT_NE(find(system, module + ".v"), nullptr);
  const auto& files = system.signature.files;
  EXPECT_EQ(std::set<std::string>(files.begin(), files.end()).size(), files.size());
}

TEST(MixedSystem, LanesOfOneNameAreToldApartByANumberUnlessTheyAreOneHardware) {
  design::Design design = sphere_design(format("s8e8"), format("s24e8"), 1, 1);
  design.lanes.push_back(design.lanes.front());
  auto& criterion = std::get<error::UlpDistanceCriterion>(
      design::float_lane(design.lanes[1].lane).parts.front().criterion);
  criterion.guard_ulp += 1;
  const emit::GeneratedSystem system = emit::generate_system(design, command).value();
  const std::string& first = system.signature.lane_groups[0].module;
  const std::string& second = system.signature.lane_groups[1].module;
  const std::string suffix = "_channel";
  EXPECT_EQ(second, first.substr(0, first.size() - suffix.size()) + "_2" + suffix);
}

TEST(MixedSystem, TopNumbersLanesThroughTheGroups) {
  const emit::GeneratedSystem system = mixed_system();
  const std::string& top = find(system, system.signature.top + ".v")->text;
  for (const char* loop :
       {"for (lane = 0; lane < 2; lane = lane + 1) begin : g_lanes_s6e8_exact_relative\n",
        "for (lane = 2; lane < 3; lane = lane + 1) begin : g_lanes_s6e8_rounded_running_4\n",
        "for (lane = 3; lane < 6; lane = lane + 1) begin : g_lanes_s9e8\n",
        "for (lane = 6; lane < 7; lane = lane + 1) begin : g_lanes_s6e8_exact_relative_2\n",
        "for (reference = 0; reference < 1; reference = reference + 1) begin : "
        "g_references_s24e8_embedded\n",
        "for (reference = 1; reference < 3; reference = reference + 1) begin : "
        "g_references_s24e8_logic\n"}) {
    EXPECT_NE(top.find(loop), std::string::npos) << loop << top;
  }
  EXPECT_EQ(top.find("genvar lane;"), top.rfind("genvar lane;")) << "declared once";
}

TEST(MixedSystem, ReferencesOfTwoMakesDifferInLatency) {
  const auto groups = mixed_system().signature.reference_groups;
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_NE(groups[0].latency_cycles, groups[1].latency_cycles) << "simulations should see it";
}

TEST(MixedSystem, SlotsAreEnoughForTheSlowestLane) {
  const emit::Signature signature = mixed_system().signature;
  for (const emit::SignatureLanes& group : signature.lane_groups) {
    EXPECT_GE(signature.slots, group.latency_cycles + 6) << group.module;
  }
}

TEST(System, TwoFoldersHoldTheSameBytes) {
  ScratchDirectory scratch;
  ASSERT_TRUE(emit::write_system(sphere_system(), scratch.path() / "one").ok());
  ASSERT_TRUE(emit::write_system(sphere_system(), scratch.path() / "deep" / "two").ok());
  const auto names = names_in(scratch.path() / "one");
  EXPECT_EQ(names, names_in(scratch.path() / "deep" / "two"));
  for (const std::string& name : names) {
    EXPECT_EQ(content(scratch.path() / "one" / name),
              content(scratch.path() / "deep" / "two" / name));
  }
}

TEST(System, OneModuleAFileOfTheSameName) {
  const emit::GeneratedSystem system = sphere_system(7, 3);
  std::set<std::string> names;
  for (const std::string& name : system.signature.files) {
    ASSERT_TRUE(names.insert(name).second) << name;
    const emit::GeneratedFile* file = find(system, name);
    ASSERT_NE(file, nullptr) << name;
    const std::string module = name.substr(0, name.size() - 2);
    int modules = 0;
    std::istringstream lines(file->text);
    for (std::string line; std::getline(lines, line);)
      modules += line.starts_with("module ") ? 1 : 0;
    EXPECT_EQ(modules, 1) << name;
    EXPECT_NE(file->text.find("\nmodule " + module + " "), std::string::npos) << name;
  }
}

TEST(System, EveryVerilogFileSaysItIsUnencumberedAndNamesNoPathOrDate) {
  const emit::GeneratedSystem system = sphere_system();
  for (const std::string& name : system.signature.files) {
    const std::string& text = find(system, name)->text;
    EXPECT_NE(text.find("unencumbered"), std::string::npos) << name;
    EXPECT_EQ(text.find("/home"), std::string::npos) << name;
    EXPECT_EQ(text.find("/work"), std::string::npos) << name;
    EXPECT_FALSE(std::regex_search(text, std::regex("\\b20[2-9][0-9]([01][0-9][0-3][0-9])?\\b")))
        << name << " seems to hold a year";
  }
}

/// docs/ports.md has the cycles beside the lane; simulation measures the same minimum.
TEST(System, TopNamesTheLatencyFromPortToPort) {
  for (const int references : {0, 1}) {
    const emit::GeneratedSystem system = sphere_system(2, references);
    const int channel = references == 0 ? 4 : 5;
    const std::string fact =
        "latency " + std::to_string(system.signature.lane_groups.front().latency_cycles + channel) +
        " cycles";
    const std::string& text = find(system, system.signature.top + ".v")->text;
    EXPECT_NE(text.find(fact), std::string::npos) << fact;
  }
}

TEST(System, FileListAndSignatureNameTheSameFiles) {
  const emit::GeneratedSystem system = sphere_system();
  std::istringstream list(find(system, system.signature.top + ".f")->text);
  std::vector<std::string> listed;
  for (std::string line; std::getline(list, line);) {
    if (!line.starts_with("//")) listed.push_back(line);
  }
  EXPECT_EQ(listed, system.signature.files);
}

TEST(System, SignatureIsReadBackWhole) {
  ScratchDirectory scratch;
  const emit::GeneratedSystem system = sphere_system();
  ASSERT_TRUE(emit::write_system(system, scratch.path() / "out").ok());
  const auto read = emit::read_signature(scratch.path() / "out" / (system.signature.top + ".json"));
  ASSERT_TRUE(read.ok()) << read.error().to_string();
  EXPECT_EQ(to_json(*read), to_json(system.signature));
}

emit::GeneratedSystem ecp5_system() {
  design::Design design = sphere_design(format("s17e8"), format("s53e8"), 2, 1);
  design.system.device = "ecp5-85k";
  return emit::generate_system(design, command).value();
}

TEST(System, Ecp5HasItsCellsBesideTheTemplates) {
  const emit::GeneratedSystem system = ecp5_system();
  const std::string name = "mixcmp_embedded_multiplier.v", adder = "mixcmp_fp_selected_sum.v";
  ASSERT_EQ(system.signature.cells, (std::vector<std::string>{name + ".ecp5", adder + ".ecp5"}));
  EXPECT_NE(find(system, adder + ".ecp5")->text.find("CCU2C"), std::string::npos);
  EXPECT_EQ(find(system, adder)->text.find("CCU2C"), std::string::npos);
  const std::string& cell = find(system, name + ".ecp5")->text;
  EXPECT_NE(cell.find("\nmodule mixcmp_embedded_multiplier #("), std::string::npos) << cell;
  EXPECT_NE(cell.find("MULT18X18D"), std::string::npos);
  EXPECT_NE(cell.find(" mixcmp_fp_ranks #("), std::string::npos) << "its instances have the prefix";
  EXPECT_EQ(find(system, name)->text.find("MULT18X18D"), std::string::npos);
  EXPECT_NE(find(system, system.signature.top + ".f")->text.find("-overwrite DIR/*.v.ecp5"),
            std::string::npos);
  EXPECT_TRUE(sphere_system().signature.cells.empty()) << "other devices have none";
}

TEST(System, UltraPlusHasItsMultiplierAsACellBesideTheTemplate) {
  design::Design design = sphere_design(format("s17e8"), format("s53e8"), 2, 1);
  design.system.device = "ice40-up5k";
  const emit::GeneratedSystem system = emit::generate_system(design, command).value();
  const std::string name = "mixcmp_embedded_multiplier.v.ice40";
  ASSERT_EQ(system.signature.cells, std::vector<std::string>{name});
  EXPECT_NE(find(system, name)->text.find("SB_MAC16"), std::string::npos);
  EXPECT_NE(find(system, system.signature.top + ".f")
                ->text.find("-overwrite DIR/*.v.ice40; synth_ice40 -device u -top "),
            std::string::npos);
}

TEST(System, AnOutputWithCellsIsReadBackAndReplaced) {
  ScratchDirectory scratch;
  const fs::path out = scratch.path() / "out";
  const emit::GeneratedSystem system = ecp5_system();
  ASSERT_TRUE(emit::write_system(system, out).ok());
  const auto read = emit::read_signature(out / (system.signature.top + ".json"));
  ASSERT_TRUE(read.ok()) << read.error().to_string();
  EXPECT_EQ(to_json(*read), to_json(system.signature));
  const emit::GeneratedSystem next = sphere_system();
  ASSERT_TRUE(emit::write_system(next, out).ok());
  EXPECT_EQ(names_in(out).size(), next.files.size());
}

TEST(System, ConstraintHoldsThePeriodOfTheTarget) {
  design::Design design = sphere_design(format("s17e8"), format("s53e8"), 1, 1);
  design.system.target_mhz = 160;
  const emit::GeneratedSystem system = emit::generate_system(design, command).value();
  const std::string& text = find(system, system.signature.top + ".sdc")->text;
  EXPECT_NE(text.find("-period 6.250 [get_ports aclk]"), std::string::npos) << text;
}

TEST(System, ConstraintsHaveADelayForEachPortButTheClock) {
  const emit::GeneratedSystem system = sphere_system(2, 1);
  const std::string& text = find(system, system.signature.top + ".sdc")->text;
  for (const emit::SignaturePort& port : system.signature.ports) {
    if (port.name == "aclk") continue;
    const bool is_input = port.direction == rtl::Direction::input;
    const std::string delay = is_input ? "set_input_delay" : "set_output_delay";
    const std::string name = port.name == "aresetn" ? port.name : port.name + "*";
    EXPECT_NE(text.find(delay + " -clock aclk 0.6 [get_ports " + name + "]\n"), std::string::npos)
        << text;
    // A pattern meets no port of the other direction.
    for (const emit::SignaturePort& other : system.signature.ports) {
      EXPECT_TRUE(other.direction == port.direction || !other.name.starts_with(port.name))
          << port.name << " " << other.name;
    }
  }
  EXPECT_EQ(text.find("_delay -clock aclk 0.6 [get_ports aclk"), std::string::npos);
}

TEST(System, ADifferentSpecHasADifferentHash) {
  std::set<std::string> hashes;
  for (const auto& [lanes, references] : {std::pair{1, 1}, {2, 1}, {2, 2}, {8, 0}}) {
    hashes.insert(sphere_system(lanes, references).signature.spec_hash);
  }
  EXPECT_EQ(hashes.size(), 4u);
}

TEST(System, LaneOnlySystemHasNoReference) {
  const emit::GeneratedSystem system = sphere_system(4, 0);
  for (const std::string& name : system.signature.files) {
    EXPECT_EQ(name.find("reference"), std::string::npos) << name;
    EXPECT_NE(name, "crossbar.v");
  }
}

TEST(System, AFailedWriteLeavesTheOldOutputWhole) {
  ScratchDirectory scratch;
  const fs::path out = scratch.path() / "out";
  ASSERT_TRUE(emit::write_system(sphere_system(), out).ok());
  const auto before = names_in(out);
  emit::GeneratedSystem broken = sphere_system(2, 1);
  broken.files.push_back({broken.files.front().name + "/below.v", "text"});  // below a file
  const auto result = emit::write_system(broken, out);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(names_in(out), before);
  EXPECT_EQ(names_in(scratch.path()), std::set<std::string>{"out"}) << "something was left behind";
}

TEST(System, AnOldOutputIsReplacedWhole) {
  ScratchDirectory scratch;
  const fs::path out = scratch.path() / "out";
  ASSERT_TRUE(emit::write_system(sphere_system(8, 1), out).ok());
  const emit::GeneratedSystem next = sphere_system(4, 0);
  ASSERT_TRUE(emit::write_system(next, out).ok());
  EXPECT_EQ(names_in(out).size(), next.files.size());
  EXPECT_EQ(names_in(scratch.path()), std::set<std::string>{"out"});
}

TEST(System, AFileOfTheUserIsNeverLost) {
  ScratchDirectory scratch;
  const fs::path out = scratch.path() / "out";
  ASSERT_TRUE(emit::write_system(sphere_system(), out).ok());
  std::ofstream(out / "notes.txt") << "mine";
  const auto result = emit::write_system(sphere_system(), out);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().received, "notes.txt");
  EXPECT_EQ(content(out / "notes.txt"), "mine");
}

TEST(System, ASecondTierOfStreamsIsInTheTopsNameAndHeaderAndInTheSignature) {
  design::Design design = sphere_design(format("s8e8"), format("s24e8"), 8, 1);
  design.second_tier = {.lane = fixed_spheres({.bits = 13}, format("s24e8")), .count = 2};
  design.system.operands = scene::OperandStore::refetched;
  const auto system = emit::generate_system(design, command);
  ASSERT_TRUE(system.ok()) << system.error().to_string();
  EXPECT_EQ(system->signature.top, "sphere_s8e8_8xq13_2x1");
  EXPECT_EQ(system->signature.second_tier->count, 2);
  EXPECT_EQ(emit::refetch_streams(system->signature), 3);
  const emit::GeneratedFile* const top = find(*system, "sphere_s8e8_8xq13_2x1.v");
  ASSERT_NE(top, nullptr);
  EXPECT_NE(top->text.find("// Second-tier lanes 0 to 1: "), std::string::npos) << top->text;
  EXPECT_NE(top->text.find("come those of the second tier's lanes.\n"), std::string::npos);
  EXPECT_NE(top->text.find(".m_refetch_tvalid(m_refetch_tvalid[1 + lane])"), std::string::npos);
}

TEST(System, AnEmptyFolderIsFilled) {
  ScratchDirectory scratch;
  fs::create_directory(scratch.path() / "out");
  EXPECT_TRUE(emit::write_system(sphere_system(), scratch.path() / "out").ok());
  EXPECT_FALSE(names_in(scratch.path() / "out").empty());
}

TEST(System, AFinalSlashChangesNothing) {
  ScratchDirectory scratch;
  ASSERT_TRUE(emit::write_system(sphere_system(), (scratch.path() / "out").string() + "/").ok());
  ASSERT_TRUE(emit::write_system(sphere_system(), (scratch.path() / "out").string() + "/").ok());
  EXPECT_EQ(names_in(scratch.path()), std::set<std::string>{"out"});
}

TEST(System, AFileInTheWayIsAnError) {
  ScratchDirectory scratch;
  std::ofstream(scratch.path() / "out") << "mine";
  EXPECT_FALSE(emit::write_system(sphere_system(), scratch.path() / "out").ok());
  EXPECT_EQ(content(scratch.path() / "out"), "mine");
}

}  // namespace
}  // namespace mixcmp::test::system_test
