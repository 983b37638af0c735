#include "generator/synthesis/components/unit_library.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include "generator/hardware/emit/templates.hpp"
#include "generator/synthesis/components/predicted_table.hpp"
#include "model/base/settings/bound_name.hpp"
#include "tests/support/scratch_directory.hpp"

namespace mixcmp::test::unit_library_test {
namespace {

namespace fs = std::filesystem;

/// The templates that no other template instantiates.
std::set<std::string> roots() {
  std::set<std::string> all, parts;
  for (const auto& file : fs::recursive_directory_iterator(MIXCMP_TEMPLATES)) {
    const std::string module = file.path().stem().string();
    if (file.path().extension() != ".v" || !emit::is_template(module)) continue;
    all.insert(module);
    for (const std::string& part : emit::template_closure({module})) {
      if (part != module) parts.insert(part);
    }
  }
  std::set<std::string> roots;
  for (const std::string& module : all) {
    if (!parts.contains(module)) roots.insert(module);
  }
  return roots;
}

/// Of Xilinx' 7 series.
const units::UnitAreas& library() {
  static const auto libraries = units::shipped_libraries().value();
  return libraries.front();
}

/// The counters' port is in no component, and the serial square only on families without wide
/// tables. Squares from a memory of one port and fused sums that no comparison ends are not
/// measured yet: lanes and references with them have no predicted area.
const std::set<std::string> without_units = {"counter_port", "fp_serial_square",
                                             "fixed_memory_square", "fp_fused_sum"};

/// Without its units a template makes every plan with it impossible.
TEST(UnitLibrary, KnowsEveryTemplateThatIsNoPart) {
  const std::set<std::string> all = roots();
  EXPECT_GT(all.size(), 40u);
  for (const std::string& module : all) {
    if (without_units.contains(module)) continue;
    EXPECT_NE(library().find(module), nullptr) << module << ": measure it by mixcmp units";
  }
}

/// The references of a scene in all forms, and its lanes.
TEST(UnitLibrary, PredictsLanesAndReferencesOfAllOperations) {
  const ScratchDirectory directory;
  const fs::path path = directory.path() / "scene.toml";
  std::ofstream(path)
      << "[comparison]\nname = \"all\"\n"
         "f = \"min(abs(a - b), c) * c / (b + 300) + sqrt(c) + within(a, -9, 9)^2\"\n"
         "g = \"max(a * b, c)^2 + a^2 + b^2\"\n"
         "[inputs]\n\"*\" = { range = [1, 100] }\n"
         "[reference]\nformat = \"s24e8\"\n"
         "[system]\ndevice = \"artix7-200t\"\n";
  const devices::Device device = devices::find_device("artix7-200t").value();
  auto predictor = components::AreaPredictor::make(device).value();
  components::ComponentQuery query{.precisions = {9, 16}};
  query.kinds = {measured::ComponentKind::lane, measured::ComponentKind::reference,
                 measured::ComponentKind::fifo, measured::ComponentKind::crossbar};
  query.multipliers.push_back(scene::Multipliers::memory);
  query.initiation_intervals = {1, 4, 16};
  query.crossbars = {3};
  for (const char* bound : {"relative", "running_4", "constant", "fixed_norm", "fixed_constant",
                            "fixed_running", "block_norm", "block_constant", "block_running"}) {
    query.bounds.push_back(settings::parse_bound(bound).value());
  }
  int predicted = 0;
  for (const char* sums : {"composed", "fused"}) {
    const std::vector<std::string> settings = {std::string("reference.sums=") + sums};
    const auto scene = scene::load_scene(path, settings).value();
    components::ComponentMaker maker(scene, nullptr);
    const auto visited = for_each_component(maker, query, [&](const components::Component& each) {
      predicted += predictor.of(each) ? 1 : 0;
    });
    ASSERT_TRUE(visited.ok()) << visited.error().to_string();
  }
  EXPECT_GT(predicted, 20);
  EXPECT_EQ(predictor.unknown(), std::set<std::string>());
}

}  // namespace
}  // namespace mixcmp::test::unit_library_test
