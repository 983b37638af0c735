#include "generator/synthesis/components/unit_library.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

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
/// tables. Fused sums that no comparison ends are not measured yet: references with them have no
/// predicted area. The area of a table is known from its words.
const std::set<std::string> without_units = {"counter_port", "fp_serial_square", "fixed_table",
                                             "fp_fused_sum"};

/// Without its units a template makes every plan with it impossible.
TEST(UnitLibrary, KnowsEveryTemplateThatIsNoPart) {
  const std::set<std::string> all = roots();
  EXPECT_GT(all.size(), 40u);
  for (const std::string& module : all) {
    if (without_units.contains(module)) continue;
    EXPECT_NE(library().find(module), nullptr) << module << ": measure it by mixcmp units";
  }
}

/// The errors of the LUTs that a library without them predicts for every fifth crossbar, in percent
/// of those measured. `packets`: crossbars whose requests have several beats.
std::vector<double> errors_of_crossbars_left_out(bool packets) {
  const devices::Device device = devices::find_device("artix7-200t").value();
  std::vector<double> errors;
  for (std::size_t turn = 0; turn < 5; ++turn) {
    units::UnitAreas areas = components::unit_library(device).value().areas;
    const units::TemplateAreas all = *areas.find("stream_crossbar");
    units::TemplateAreas some{.module = all.module, .rtl = all.rtl, .units = {}, .areas = {}};
    const auto is_out = [&](std::size_t k) { return 7 * k % 5 == turn; };  // the rows are sorted
    for (std::size_t k = 0; k < all.units.size(); ++k) {
      if (is_out(k)) continue;
      some.units.push_back(all.units[k]);
      some.areas.push_back(all.areas[k]);
    }
    areas.set(some);
    for (std::size_t k = 0; k < all.units.size(); ++k) {
      const units::Parameter& beats = all.units[k].parameters[6];
      EXPECT_EQ(beats.name, "BEAT_BITS");
      if (!is_out(k) || (beats.size() > 0) != packets || all.areas[k].luts < 40) continue;
      const double off = areas.of(all.units[k])->luts - all.areas[k].luts;
      errors.push_back(100 * std::abs(off) / all.areas[k].luts);
    }
  }
  std::sort(errors.begin(), errors.end());
  return errors;
}

/// Yosys maps crossbars of packets evenly, in a LUT for each bit of an arbiter. Those of words take
/// one to two, as its optimisation happens to end.
TEST(UnitLibrary, PredictsCrossbarsThatItLacks) {
  const std::vector<double> packets = errors_of_crossbars_left_out(true);
  const std::vector<double> words = errors_of_crossbars_left_out(false);
  ASSERT_GT(packets.size(), 30U);
  ASSERT_GT(words.size(), 25U);
  EXPECT_LT(packets[packets.size() / 2], 7);
  EXPECT_LT(packets[packets.size() * 9 / 10], 12);
  EXPECT_LT(words[words.size() / 2], 12);
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
