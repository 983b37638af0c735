#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "generator/tasks/plan_set.hpp"

/// Plan sets of spheres with radii of up to 2, 25 and 100, with areas that were made up.
namespace mixcmp::test::plan_set_task_test {
namespace {

constexpr const char* spheres = R"toml(
[comparison]
name = "spheres"
f = "(cxi - cxj)^2 + (cyi - cyj)^2 + (czi - czj)^2"
g = "(ri + rj)^2"
[inputs]
"*" = { range = [0, 100] }
[reference]
format = "s24e8"
initiation_interval = 1
[reduced]
format = "auto"
[system]
device = "artix7-200t"
operands = "refetched"
lanes_per_group = 4
[engine]
kind = "none"
[data]
items = "uniform_spheres"
count = 100
radius_max = 2
pairs = "all"
)toml";

/// Counters cost LUTs. Without DSPs there is one kind of lane of each precision.
std::optional<devices::Area> made_up(const components::Component& component,
                                     const scene::Scene& scene) {
  const auto logic = [](int luts) { return devices::Area{.luts = luts, .registers = luts}; };
  const measured::ComponentKey& key = component.key;
  if (const auto* lane = std::get_if<measured::Lane>(&key)) {
    return logic(40 * lane->format.precision());
  }
  if (std::holds_alternative<measured::Reference>(key)) return logic(6000);
  const bool counts = scene.system.counters != scene::CounterAccess::none;
  if (std::holds_alternative<measured::Fifo>(key)) return logic(counts ? 330 : 300);
  return logic(100);
}

class PlanSetTask : public testing::Test {
protected:
  static tasks::OptimiseRequest request_with(std::vector<std::string> settings) {
    return {.planning = {.scene = {scene::SceneSource("scene.toml", spheres), settings}},
            .choice = {.first_precision = 7,
                       .last_precision = 14,
                       .bounds = {{NumberSystem::fixed, BoundKind::norm}},
                       .multipliers = {scene::Multipliers::logic}},
            .predict_only = true,
            .area_of = made_up};
  }

  static tasks::DataSet set_of(const tasks::OptimiseRequest& request, int radius) {
    const std::vector<std::string> own = {fmt::format("data.radius_max={}", radius)};
    tasks::SceneRequest scene = request.planning.scene;
    scene.settings = tasks::joined(scene.settings, own);
    return {own, tasks::load(scene).value().data.value()};
  }

  static tasks::PlanSetRequest request_for(int plans, std::vector<std::string> settings = {}) {
    tasks::PlanSetRequest request{.optimise = request_with(std::move(settings)),
                                  .sets = {},
                                  .stream = {},
                                  .most_plans = plans,
                                  .reconfiguration_seconds = 0.01};
    for (const int radius : {2, 25, 100}) request.sets.push_back(set_of(request.optimise, radius));
    return request;
  }

  /// What `optimise` finds on one data set by itself.
  static tasks::OptimiseResult found_for(const tasks::PlanSetRequest& request, std::size_t set) {
    tasks::OptimiseRequest single = request.optimise;
    auto& settings = single.planning.scene.settings;
    settings = tasks::joined(settings, request.sets[set].settings);
    return tasks::optimise(single, tasks::load(single.planning.scene).value()).value();
  }
};

TEST_F(PlanSetTask, OnePlanIsAsGoodAsEachThatOptimiseFinds) {
  const tasks::PlanSetRequest request = request_for(1);
  const tasks::PlanSetResult found = plan_set(request).value();
  ASSERT_EQ(found.plans.size(), 1U);
  EXPECT_EQ(found.seconds_with[0], found.single_seconds) << "no other interface is better";
  EXPECT_EQ(found.plans[0].system.interface, "operands refetched, no counters");
  int compared = 0;
  for (std::size_t s = 0; s < request.sets.size(); ++s) {
    const tasks::OptimiseResult own = found_for(request, s);
    for (const optimise::PrecisionPlan& plan : own.best().found.plans) {
      if (plan.allocation() == nullptr) continue;
      double seconds = 0;
      for (const tasks::DataSet& set : request.sets) {
        const tasks::LoadedScene here{own.best().known.scene, set.data};
        const auto profiles =
            tasks::measure_rates(here, {LaneInputs::exact}, request.optimise.choice, {});
        const auto at = at_rates(plan, here.scene, optimise::Rates::of(profiles.value()));
        seconds += 1 / at.value().throughput_per_s;
      }
      EXPECT_LE(found.seconds_with[0], seconds * (1 + 1e-12)) << plan.precision;
      ++compared;
    }
  }
  EXPECT_GT(compared, 5);
}

/// A plan names no data set, so it is a scene of the scene's own data. Scoreboards are so dear here
/// that an engine is the fastest system.
TEST_F(PlanSetTask, EnginesHoldTheItemsOfTheScenesOwnData) {
  std::string text = spheres;
  for (const char* given :
       {"operands = \"refetched\"\nlanes_per_group = 4\n", "[engine]\nkind = \"none\"\n"}) {
    text.erase(text.find(given), std::string(given).size());
  }
  tasks::PlanSetRequest request = request_for(1);
  request.optimise.planning.scene.source = scene::SceneSource("scene.toml", text);
  request.optimise.choice.first_precision = request.optimise.choice.last_precision = 10;
  request.optimise.area_of = [](const components::Component& component, const scene::Scene& scene) {
    std::optional<devices::Area> area = made_up(component, scene);
    if (std::holds_alternative<measured::Fifo>(component.key)) area->luts = 200'000;
    return area;
  };
  const auto capacity = [&] {
    const tasks::PlanSetResult found = plan_set(request).value();
    return found.plans[0].system.known.scene.system.engine.capacity;
  };
  EXPECT_EQ(capacity(), 128) << "the sets have 100 items each";
  tasks::SceneRequest larger = request.optimise.planning.scene;
  larger.settings = {"data.count=300"};
  request.own = tasks::load(larger).value().data;
  EXPECT_EQ(capacity(), 512);
}

TEST_F(PlanSetTask, APlanForEachDataSetLosesNothing) {
  const tasks::PlanSetRequest request = request_for(3);
  const tasks::PlanSetResult found = plan_set(request).value();
  EXPECT_GE(found.plans.size(), 2U);
  EXPECT_GT(found.seconds_with[0], found.seconds_with[1]);
  EXPECT_GE(found.seconds_with[1], found.seconds_with[2]);
  EXPECT_DOUBLE_EQ(found.seconds_with[2], found.least_seconds());
  for (std::size_t s = 0; s < request.sets.size(); ++s) {
    double fastest = 0;
    for (const tasks::SetPlan& plan : found.plans) {
      EXPECT_EQ(plan.system.interface, "operands refetched, counters");
      fastest = std::max(fastest, plan.at_set[s].throughput_per_s);
    }
    EXPECT_EQ(fastest, found.best_per_s[s]);
    for (const tasks::PlannedSystem& system : found_for(request, s).systems) {
      if (system.interface == found.plans[0].system.interface) {
        EXPECT_GE(fastest, system.throughput_per_s() * (1 - 1e-9));
      }
    }
  }
}

/// On a long stream of the data that the plans were made for, no single plan is as fast.
TEST_F(PlanSetTask, TheRuleIsFasterThanOnePlanWhereDataStayLongEnough) {
  tasks::PlanSetRequest request = request_for(3);
  for (const int radius : {2, 25, 100, 2, 100}) {
    request.stream.push_back(set_of(request.optimise, radius));
  }
  const tasks::PlanSetResult found = plan_set(request).value();
  ASSERT_EQ(found.drifts.size(), 4U);
  for (const tasks::Drift& drift : found.drifts) {
    EXPECT_LT(drift.free_seconds, drift.foresight.seconds);
    EXPECT_LE(drift.foresight.seconds, drift.rule.seconds * (1 + 1e-9));
  }
  EXPECT_EQ(found.drifts.front().rule.switches, 0) << "blocks are as short as a reconfiguration";
  EXPECT_GE(found.drifts.back().rule.switches, 3);
  EXPECT_LT(found.drifts.back().rule.seconds, found.drifts.back().single_seconds);
  EXPECT_LT(found.drifts.back().rule.seconds, 1.03 * found.drifts.back().free_seconds)
      << "counters cost 2 %";
}

/// The seconds that the rule has for a loaded plan at a rate that it counts.
double own_seconds(const optimise::SwitchingRule& rule, std::size_t plan, double rate) {
  const std::vector<optimise::RatePoint>& points = rule.points()[plan];
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    const auto& [low, low_seconds] = points[k];
    const auto& [high, high_seconds] = points[k + 1];
    if (rate > high) continue;
    const double part = (rate - low) / (high - low);
    return low_seconds[plan] + part * (high_seconds[plan] - low_seconds[plan]);
  }
  return points.back().seconds[plan];
}

/// Between two data sets references begin to be too slow: a straight line would be far off.
TEST_F(PlanSetTask, TheRuleKnowsPlansBetweenTheDataSets) {
  tasks::PlanSetRequest request = request_for(2);
  request.sets.erase(request.sets.begin() + 1);
  const tasks::PlanSetResult found = plan_set(request).value();
  ASSERT_EQ(found.plans.size(), 2U);
  for (const int radius : {5, 10, 20}) {
    const tasks::DataSet other = set_of(request.optimise, radius);
    for (std::size_t k = 0; k < 2; ++k) {
      const tasks::LoadedScene here{found.plans[k].system.known.scene, other.data};
      const auto profiles =
          tasks::measure_rates(here, {LaneInputs::exact}, request.optimise.choice, {});
      const auto at =
          at_rates(found.plans[k].plan(), here.scene, optimise::Rates::of(profiles.value()));
      const double seconds = own_seconds(found.rule, k, at->counted_rate);
      EXPECT_NEAR(seconds * at->throughput_per_s, 1, 0.02) << radius << ", plan " << k + 1;
    }
  }
}

TEST_F(PlanSetTask, SeveralPlansHaveCounters) {
  const auto refused = plan_set(request_for(2, {"system.counters=none"}));
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().field, "system.counters");
  EXPECT_TRUE(plan_set(request_for(1, {"system.counters=none"})).ok());
}

TEST_F(PlanSetTask, LanesAreCertified) {
  const auto refused = plan_set(request_for(2, {"reduced.bound=profiled"}));
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().field, "reduced.bound");
}

}  // namespace
}  // namespace mixcmp::test::plan_set_task_test
