#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "generator/tasks/optimise.hpp"
#include "model/base/common/output_file.hpp"
#include "model/judge/workload/load_comparisons.hpp"
#include "tests/support/scratch_directory.hpp"

/// Engines whose operands arrive in fixed point, planned on predicted areas.
namespace mixcmp::test::optimise_integers_test {
namespace {

class IntegerEngines : public testing::Test {
protected:
  IntegerEngines() {
    write_rows("items.csv", 24);
    write_rows("candidates.csv", 8);
  }

  /// `sections`: of the scene, behind its inputs.
  tasks::OptimiseResult found_for(const std::string& f, const std::string& g,
                                  const std::string& sections) const {
    const std::string text = fmt::format(
        "[comparison]\nname = \"n\"\nf = \"{}\"\ng = \"{}\"\n[inputs]\n\"*\" = {{ format = "
        "\"uint8\" }}\n[system]\ndevice = \"artix7-200t\"\n{}",
        f, g, sections);
    const scene::SceneSource source(directory_.path() / "scene.toml", text);
    const scene::Scene scene = scene::load_scene(source, {}).value();
    const tasks::LoadedScene loaded = {scene, workload::load_comparisons(scene).value()};
    const auto found = tasks::optimise({.planning = {.scene = {source, {}}},
                                        .choice = {.first_precision = 4, .last_precision = 9},
                                        .predict_only = true},
                                       loaded);
    EXPECT_TRUE(found.ok()) << (found.ok() ? "" : found.error().to_string());
    return found.value();
  }

private:
  void write_rows(const char* name, int rows) const {
    std::string text = "x,y,z\n";
    for (int k = 0; k < rows; ++k) {
      text += fmt::format("{},{},{}\n", k * 37 % 256, k * k * 11 % 256, k * 101 % 256);
    }
    EXPECT_TRUE(write_file(directory_.path() / name, text).ok());
  }

  ScratchDirectory directory_;
};

/// A chain of exact lanes has no references; the best chain of mixed precision is listed beside it.
/// Both are as fast as rows come in, and the smaller one is chosen. Items are stored as they
/// arrive: there is no conversion.
TEST_F(IntegerEngines, AnArgMinEngineIsPlannedWithAndWithoutReferences) {
  const tasks::OptimiseResult found = found_for(
      "sum(k in 0..2, abs(p[k] - ci[k]))", "sum(k in 0..2, abs(p[k] - cj[k]))",
      "[engine]\nkind = \"arg_min\"\n[data]\nfile = \"items.csv\"\nwith = \"candidates.csv\"\n"
      "columns = { p = [\"x\", \"y\", \"z\"] }\nwith_columns = { c = [\"x\", \"y\", \"z\"] }\n"
      "pairs = \"arg_min\"\n");
  const auto luts = [](const tasks::PlannedSystem& system) {
    return system.found.best()->allocation()->used.luts;
  };
  int with = 0, without = 0;
  for (const tasks::PlannedSystem& system : found.systems) {
    ASSERT_NE(system.found.best(), nullptr) << system.interface;
    const optimise::Allocation& plan = *system.found.best()->allocation();
    EXPECT_EQ(plan.lane_count(), 7) << system.interface;
    const bool has_none = plan.reference_count() == 0;
    EXPECT_EQ(system.interface.starts_with("arg-min engine, no references, "), has_none);
    ++(has_none ? without : with);
    if (has_none) continue;
    EXPECT_GT(luts(system), luts(found.best())) << system.interface;
    EXPECT_EQ(system.found.best()->problem.references.front().name.substr(0, 2), "q8")
        << "the exact lane";
  }
  EXPECT_GE(with, 1);
  EXPECT_GE(without, 1);
  EXPECT_EQ(found.best().found.best()->allocation()->reference_count(), 0);
}

/// Exact lanes by themselves are another interface than mixed precision; both are told.
TEST_F(IntegerEngines, APairwiseEngineIsPlannedWithAndWithoutReferences) {
  const tasks::OptimiseResult found =
      found_for("(xi - xj)^2 + (yi - yj)^2", "(zi - zj)^2",
                "[engine]\nkind = \"pairwise\"\n[data]\nfile = \"items.csv\"\npairs = \"all\"\n");
  int with = 0, without = 0;
  for (const tasks::PlannedSystem& system : found.systems) {
    if (system.found.best() == nullptr) continue;
    const bool has_none = system.found.best()->allocation()->reference_count() == 0;
    EXPECT_EQ(system.interface.starts_with("pairwise engine, no references, "), has_none)
        << system.interface;
    ++(has_none ? without : with);
  }
  EXPECT_GE(with, 1);
  EXPECT_GE(without, 1);
}

}  // namespace
}  // namespace mixcmp::test::optimise_integers_test
