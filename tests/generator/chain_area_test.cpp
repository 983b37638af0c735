#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "generator/synthesis/components/characterise.hpp"
#include "generator/synthesis/components/whole_job.hpp"
#include "model/base/settings/bound_name.hpp"
#include "model/cost/devices/device.hpp"
#include "model/design/design.hpp"
#include "model/plan/optimise/feasibility.hpp"
#include "model/plan/optimise/footprint.hpp"
#include "tests/support/scratch_directory.hpp"

/// The rows of an arg-min engine's table, added up as `optimise` does, against the whole engine in
/// one run of Yosys.
namespace mixcmp::test::chain_area_test {
namespace {

using measured::ComponentKind;

/// The whole omits logic that parts keep at their borders, such as bits that nothing reads.
constexpr double tolerance = 0.06;

constexpr characterise::SynthesisOptions areas = {.effort = characterise::TimingEffort::area_only};

components::CharacteriseOptions all_parts(const std::filesystem::path& store) {
  return {.query = {.kinds = {ComponentKind::lane, ComponentKind::segment,
                              ComponentKind::conversion, ComponentKind::engine,
                              ComponentKind::operand_memory, ComponentKind::crossbar,
                              ComponentKind::reference, ComponentKind::reference_port},
                    .precisions = {9},
                    .bounds = {settings::parse_bound("fixed_norm").value()},
                    .multipliers = {scene::Multipliers::embedded},
                    .crossbars = {6}},
          .synthesis = areas,
          .store = store};
}

/// Six lanes and a small reference, which keeps the run short.
constexpr const char* nearest =
    "[comparison]\nname = \"nearest\"\n"
    "f = \"(x - cxi)^2 + (y - cyi)^2\"\ng = \"(x - cxj)^2 + (y - cyj)^2\"\n"
    "[inputs]\n\"*\" = { range = [0, 100] }\n[reference]\nformat = \"s12e5\"\n"
    "[reduced]\nformat = \"q9\"\n[system]\nlanes = 6\nreferences = 1\n"
    "[engine]\nkind = \"arg_min\"\n";

TEST(ChainArea, TheWholeTakesWhatItsPartsTake) {
  const ScratchDirectory scratch;
  const std::filesystem::path file = scratch.path() / "nearest.toml";
  std::ofstream(file) << nearest;
  const scene::Scene scene = scene::load_scene(file, {}).value();
  const devices::Device device = devices::find_device(scene.system.device).value();
  const auto report = components::characterise(scene, nullptr, device,
                                               all_parts(scratch.path() / "store.sqlite"), nullptr)
                          .value();
  ASSERT_TRUE(report.failed.empty()) << report.failed.front().message;
  const design::Design design = design::make_design(scene, nullptr).value();
  const optimise::Footprint parts = optimise::footprint_of(design, &report.table, device);
  ASSERT_TRUE(parts.measured);
  const std::filesystem::path work = scratch.path() / "whole";
  std::filesystem::create_directory(work);
  const auto whole = synthesise(components::system_job(emit::generate_system(design, "").value()),
                                device, areas, work);
  ASSERT_TRUE(whole.ok()) << whole.error().to_string();
  const optimise::Amounts amounts = optimise::amounts_of(whole->area);
  for (std::size_t r = 0; r < amounts.size(); ++r) {
    const auto all = static_cast<double>(amounts[r]);
    EXPECT_NEAR(static_cast<double>(parts.amounts[r]), all, tolerance * all)
        << devices::bounded_resources[r].name;
  }
}

}  // namespace
}  // namespace mixcmp::test::chain_area_test
