#include "model/base/common/command_line.hpp"

#include <gtest/gtest.h>

namespace mixcmp::test {
namespace {

TEST(CommandLine, NamesTheVerbItsSceneAndItsSettings) {
  const std::vector<std::string> settings = {"system.lanes=3", "comparison.variant=a b"};
  EXPECT_EQ(CommandLine("generate", "my scene.toml", settings).text(),
            "mixcmp generate 'my scene.toml' --set system.lanes=3 --set 'comparison.variant=a b'");
}

TEST(CommandLine, LeavesOutOptionsThatHaveTheirUsualValues) {
  CommandLine line("characterise", "s.toml", {});
  line.add("--seeds", "3", "3").add("--ports", "1-8", "1-64").add("--table", "");
  line.add_flag("--quick", false).add_flag("--area-only", true);
  EXPECT_EQ(line.text(), "mixcmp characterise s.toml --ports 1-8 --area-only");
}

TEST(CommandLine, RepeatsAnOptionForEachOrNamesItOnceForAll) {
  const std::vector<std::string> two = {"a", "b c"}, none;
  CommandLine line("explore", "s.toml", {});
  line.add_each("--on", two).add_all("--import", two).add_each("--to", none).add_all("--no", none);
  EXPECT_EQ(line.text(), "mixcmp explore s.toml --on a --on 'b c' --import a 'b c'");
}

}  // namespace
}  // namespace mixcmp::test
