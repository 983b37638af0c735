#include <fmt/core.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "generator/synthesis/components/characterise.hpp"
#include "generator/synthesis/components/component_maker.hpp"

namespace mixcmp::test::stored_tables_test {
namespace {

namespace fs = std::filesystem;
using measured::Characterisation;

/// The scene that a table's command names, with the command's settings.
scene::Scene scene_of(const Characterisation& table, const fs::path& path) {
  std::istringstream words(table.command);
  std::string program, verb, file;
  words >> program >> verb >> file;
  std::vector<std::string> overrides;
  for (std::string word; words >> word;) {
    if (word == "--set" && words >> word) overrides.push_back(word);
  }
  return scene::load_scene(path.parent_path().parent_path() / file, overrides).value();
}

TEST(StoredTables, HaveNoRowThatWouldBeRefused) {
  int rows = 0;
  for (const auto& entry : fs::recursive_directory_iterator(MIXCMP_EXAMPLES)) {
    const fs::path& path = entry.path();
    if (path.extension() != ".csv" || path.parent_path().filename() != "characterisation") continue;
    const Characterisation table = measured::read_characterisation(path).value();
    const devices::Device device = devices::find_device(table.device).value();
    components::ComponentMaker maker(scene_of(table, path), nullptr);
    for (const measured::Measurement& row : table.rows) {
      const auto component = maker.make(row.key);
      ASSERT_TRUE(component.ok()) << component.error().to_string();
      const auto checked =
          characterise::check_multipliers(row.area, component->job().needed, device);
      EXPECT_TRUE(checked.ok()) << path.filename() << " " << components::label(row.key) << ": "
                                << checked.error().to_string();
      ++rows;
    }
  }
  EXPECT_GT(rows, 400);
}

}  // namespace
}  // namespace mixcmp::test::stored_tables_test
