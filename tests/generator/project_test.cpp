#include "generator/project/project.hpp"

#include <gtest/gtest.h>

#include "generator/project/text_template.hpp"
#include "generator/project/vhdl.hpp"

namespace mixcmp::test::project_test {
namespace {

using project::VhdlPort;

TEST(TextTemplate, OnlyNamesInCapitalsArePlaceholders) {
  const std::string text = project::fill_template("testbench_refetch.v", {});
  EXPECT_NE(text.find("always @(posedge aclk)"), std::string::npos);
}

TEST(TextTemplate, SectionsAreThereWhereTheirValueIsNotEmpty) {
  project::Values values = {{"DUT", "spheres"}, {"COUNTS", ""}, {"COUNTED_UNIT", "lane"}};
  const std::string without = project::fill_template("testbench_common.v", values);
  values["COUNTS"] = "yes";
  const std::string with = project::fill_template("testbench_common.v", values);
  EXPECT_EQ(without.find("check_counter"), std::string::npos);
  EXPECT_NE(with.find("task check_counter("), std::string::npos);
  EXPECT_NE(with.find("$dumpvars(0, spheres_tb);"), std::string::npos);
  for (const std::string& text : {with, without}) {
    EXPECT_EQ(text.find('@'), std::string::npos) << text;
    EXPECT_EQ(text.find("\n\n\n"), std::string::npos) << text;
  }
}

TEST(TextTemplate, AnIncludedTemplateHasTheSameValues) {
  const project::Values values = {{"DUT", "spheres"}, {"COUNTS", "yes"}, {"COUNTED_UNIT", "lane"}};
  const std::string common = project::fill_template("testbench_common.v", values);
  EXPECT_EQ(project::fill_template("testbench_engine.v", values).find(common), 0u);
}

TEST(TextTemplate, APlaceholderAloneInItsLineLeavesNoLine) {
  const project::Values values = {
      {"BUILD_TOP", "x"}, {"TARGET_MHZ", "200"}, {"PERIOD_NS", "5.000"}, {"PORT_DELAYS", "p q"}};
  project::Values with_head = values, without_head = values;
  with_head["PROVENANCE"] = "# head";
  without_head["PROVENANCE"] = "";
  const std::string with = project::fill_template("vivado_clock.xdc", with_head);
  const std::string without = project::fill_template("vivado_clock.xdc", without_head);
  EXPECT_EQ(
      with,
      "# The clock of x: 200 MHz, the target that its registers were placed for.\n#\n# head\n\n"
      "create_clock -name aclk -period 5.000 [get_ports aclk]\n\np q\n");
  EXPECT_EQ(with.size(), without.size() + std::string("# head\n").size());
}

TEST(Vhdl, NamesThatVhdlRefusesAreExtendedIdentifiers) {
  EXPECT_EQ(project::vhdl_name("scene_s8e8_2x1"), "scene_s8e8_2x1");
  EXPECT_EQ(project::vhdl_name("a__b"), "\\a__b\\");
  EXPECT_EQ(project::vhdl_name("_a"), "\\_a\\");
  EXPECT_EQ(project::vhdl_name("a_"), "\\a_\\");
}

TEST(Vhdl, APortWithARangeIsAVector) {
  const std::vector<VhdlPort> ports = {{.name = "aclk"},
                                       {.name = "valid", .is_input = false, .is_vector = true}};
  EXPECT_EQ(project::vhdl_component("m", ports),
            "  component m is\n    port (\n      aclk  : in  std_logic;\n"
            "      valid : out std_logic_vector(0 downto 0)\n    );\n  end component;\n");
}

TEST(ProjectTools, NamesAndToolsAreOneToOne) {
  const std::vector<std::string> names = project::tool_names();
  EXPECT_EQ(names.size(), 7u);
  for (const std::string& name : names) {
    EXPECT_EQ(project::to_string(project::tool_named(name)), name);
  }
}

}  // namespace
}  // namespace mixcmp::test::project_test
