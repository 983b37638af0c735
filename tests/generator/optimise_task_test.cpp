#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "generator/synthesis/components/predicted_table.hpp"
#include "generator/tasks/optimise.hpp"
#include "model/base/number/exact.hpp"
#include "model/judge/workload/load_comparisons.hpp"
#include "model/plan/optimise/architecture.hpp"
#include "model/scene/plan.hpp"

/// The search over architectures against all of them, with areas that were made up.
namespace mixcmp::test::optimise_task_test {
namespace {

constexpr const char* orientation = R"toml(
[comparison]
name = "orientation"
f = "(bx-ax)*(cy-ay)"
g = "(by-ay)*(cx-ax)"
[inputs]
"*" = { range = [0, 100] }
[reference]
format = "s24e8"
[reduced]
format = "auto"
[system]
device = "artix7-200t"
)toml";

/// Six columns of random numbers; the scene names no data.
data::Comparisons random_rows(int rows = 2000) {
  const FloatFormat format = FloatFormat::make(24, 8).value();
  data::Table table{
      .format = format, .columns = {"bx", "ax", "cy", "ay", "by", "cx"}, .values = {}};
  std::uint64_t state = 1;
  for (int k = 0; k < 6 * rows; ++k) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    const double value = static_cast<double>(state >> 40) * 100.0 / (1 << 24);
    table.values.push_back(from_rational(format, mpq_class(value)));
  }
  return data::Comparisons::rows(std::move(table), {"bx", "ax", "cy", "ay", "by", "cx"}).value();
}

int width_of(const scene::Scene& scene) {
  const bool carried = scene.system.operands == scene::OperandStore::carried;
  return scene.system.tag_bits + (carried ? 6 * 32 / scene.system.request_beats.value_or(1) : 0);
}

/// About what Yosys finds: a scoreboard of a group costs its tags once, counters cost 300 LUTs,
/// and block memories hold operands that would take LUTs.
devices::Area area_of(const measured::ComponentKey& key, const scene::Scene& scene) {
  const scene::SystemSpec& system = scene.system;
  const bool carried = system.operands == scene::OperandStore::carried;
  const bool in_blocks = carried && system.operand_memory == scene::OperandMemory::block;
  const int width = width_of(scene);
  const auto logic = [](int luts, int dsps = 0) {
    return devices::Area{.luts = luts, .registers = luts, .dsps = dsps};
  };
  if (const auto* lane = std::get_if<measured::Lane>(&key)) {
    const int bits = lane->format.precision();
    const int luts = (lane->format.fixed_point ? 9 : 40) * bits;
    const bool embedded = lane->multipliers == scene::Multipliers::embedded;
    return embedded ? logic(luts, 2) : logic(luts + 2 * bits * bits);
  }
  if (std::holds_alternative<measured::Reference>(key)) return logic(3000, 8);
  if (std::holds_alternative<measured::Fifo>(key)) {
    const int counters = system.counters == scene::CounterAccess::none ? 0 : 300;
    const int group = system.lanes_per_group;
    devices::Area area = logic(120 + 12 * group + counters + (in_blocks ? 40 : width * group / 2));
    if (in_blocks) area.memories = group * 6 * 32 / 36;
    return area;
  }
  if (const auto* crossbar = std::get_if<measured::Crossbar>(&key)) {
    return logic(50 + width * crossbar->lanes / 2);
  }
  return logic(100);
}

std::optional<devices::Area> made_up(const components::Component& component,
                                     const scene::Scene& scene) {
  return area_of(component.key, scene);
}

class OptimiseTask : public testing::Test {
protected:
  static tasks::OptimiseRequest request_with(std::vector<std::string> settings) {
    return {
        .planning = {.scene = {scene::SceneSource("scene.toml", orientation), std::move(settings)}},
        .choice = {.first_precision = 10,
                   .last_precision = 12,
                   .inputs = {LaneInputs::exact},
                   .bounds = {{NumberSystem::fixed, BoundKind::norm},
                              {NumberSystem::fixed, BoundKind::constant}}},
        .predict_only = true,
        .area_of = made_up};
  }
  static tasks::LoadedScene load(const tasks::OptimiseRequest& request) {
    const tasks::SceneRequest& scene = request.planning.scene;
    return {scene::load_scene(scene.source, scene.settings).value(), random_rows()};
  }
  static tasks::OptimiseResult found_for(const tasks::OptimiseRequest& request) {
    return tasks::optimise(request, load(request)).value();
  }
  /// The reasons of all precisions without a plan.
  static std::string reasons_of(const optimise::Optimisation& found) {
    std::string text;
    for (const optimise::PrecisionPlan& plan : found.plans) {
      const auto* none = std::get_if<optimise::Infeasible>(&plan.result);
      text += fmt::format("{}: {}\n", plan.precision, none == nullptr ? "a plan" : none->message);
    }
    return text;
  }
  /// Whether a note of the chosen plan begins like this.
  static bool has_note(const tasks::OptimiseResult& result, const std::string& note) {
    const std::vector<std::string>& notes = result.best().found.notes;
    return std::any_of(notes.begin(), notes.end(),
                       [&](const std::string& each) { return each.starts_with(note); });
  }
  static optimise::OpenKeys open_of(const tasks::OptimiseRequest& request) {
    const tasks::SceneRequest& scene = request.planning.scene;
    return optimise::open_keys(
        scene::read_scene_settings(scene.source, scene.settings).value().settings);
  }
};

/// The scene's own number of lanes is for generate; a plan has another one.
TEST_F(OptimiseTask, GroupsNeedNotDivideTheScenesLanes) {
  const tasks::OptimiseResult found =
      found_for(request_with({"system.lanes=6", "system.lanes_per_group=4"}));
  const optimise::Allocation& chosen = *found.best().found.best()->allocation();
  EXPECT_GT(chosen.lane_count(), 0);
  EXPECT_EQ(chosen.lane_count() % 4, 0);
}

/// Few intervals and groups keep the exhaustive side small: each architecture is a search of its
/// own, with all of its keys given.
TEST_F(OptimiseTask, FindsTheBestOfAllArchitectures) {
  const std::vector<std::string> some = {"reference.initiation_interval=1",
                                         "system.request_beats=1"};
  const tasks::OptimiseRequest request = request_with(some);
  const tasks::OptimiseResult found = found_for(request);
  ASSERT_EQ(found.systems.size(), 4U) << "carried or refetched, with counters or without";
  const tasks::LoadedScene loaded = load(request);
  const optimise::OpenKeys open = open_of(request);
  std::map<std::string, double> best;
  for (const optimise::Architecture& each : architectures_of(loaded.scene, open)) {
    std::vector<std::string> settings = some;
    for (std::string& own : settings_of(each, loaded.scene, open)) settings.push_back(own);
    const tasks::OptimiseResult single = found_for(request_with(settings));
    ASSERT_EQ(single.systems.size(), 1U) << settings.back();
    const tasks::PlannedSystem& system = single.best();
    EXPECT_EQ(system.known.scene.system.lanes_per_group,
              with_architecture(loaded.scene, each, open).system.lanes_per_group);
    double& most = best[system.interface];
    most = std::max(most, system.throughput_per_s());
  }
  for (const tasks::PlannedSystem& system : found.systems) {
    EXPECT_LE(system.throughput_per_s(), best.at(system.interface)) << system.interface;
    EXPECT_GE(1.005 * system.throughput_per_s(), best.at(system.interface)) << system.interface;
  }
  EXPECT_GT(best.at("operands refetched, no counters"), best.at("operands refetched, counters"));
  EXPECT_EQ(found.best().interface, "operands refetched, no counters");
  EXPECT_GE(found.best().known.scene.system.lanes_per_group, 4);
}

/// Only lanes of 20 bits are exact; those of fewer bits have such lanes as references.
TEST_F(OptimiseTask, ExactLanesAreWeighedAgainstMixedPrecision) {
  const std::string integers = R"toml(
[comparison]
name = "orientation"
f = "(bx-ax)*(cy-ay)"
g = "(by-ay)*(cx-ax)"
[inputs]
"*" = { format = "uint20" }
[data]
items = "uniform"
count = 300
[system]
device = "artix7-200t"
)toml";
  tasks::OptimiseRequest request = request_with({});
  request.planning.scene.source = scene::SceneSource("scene.toml", integers);
  request.choice.first_precision = 12;
  request.choice.last_precision = 24;
  const scene::Scene scene = scene::load_scene(request.planning.scene.source, {}).value();
  const tasks::LoadedScene loaded = {scene, workload::load_comparisons(scene).value()};
  const tasks::OptimiseResult found = tasks::optimise(request, loaded).value();
  const optimise::PrecisionPlan& mixed = *found.best().found.best();
  EXPECT_LT(mixed.precision, 20);
  EXPECT_GE(mixed.allocation()->reference_count(), 1);
  const auto exact = std::find_if(found.systems.begin(), found.systems.end(), [](const auto& each) {
    return each.interface == "no references, no counters";
  });
  ASSERT_NE(exact, found.systems.end());
  const optimise::PrecisionPlan& plan = *exact->found.best();
  EXPECT_EQ(plan.precision, 20);
  EXPECT_EQ(plan.allocation()->reference_count(), 0);
  EXPECT_EQ(plan.recomputation_rate(), 0);
  EXPECT_GT(plan.allocation()->lane_count(), 8);
  EXPECT_GT(found.best().throughput_per_s(), exact->throughput_per_s());
  request.choice.last_precision = 19;
  request.planning.scene.settings = {"system.references=0"};
  const tasks::LoadedScene without = {
      scene::load_scene(request.planning.scene.source, request.planning.scene.settings).value(),
      workload::load_comparisons(scene).value()};
  const auto none = tasks::optimise(request, without);
  ASSERT_FALSE(none.ok());
  EXPECT_EQ(none.error().message, "only exact lanes have no references, and none has so few bits");
}

TEST_F(OptimiseTask, GivenKeysStayAndOpenOnesAreSettings) {
  const tasks::OptimiseResult found =
      found_for(request_with({"system.operands=carried", "system.counters=ports",
                              "system.lanes_per_group=4", "reference.initiation_interval=1"}));
  ASSERT_EQ(found.systems.size(), 1U);
  EXPECT_EQ(found.best().interface, "operands carried, counters");
  const std::vector<std::string>& settings = found.best().settings;
  ASSERT_EQ(settings.size(), 2U);
  EXPECT_TRUE(settings[0].starts_with("system.operand_memory="));
  EXPECT_TRUE(settings[1].starts_with("system.request_beats="));
}

/// A 64th of the device less does not suffice, and the plan's own settings make it again.
TEST_F(OptimiseTask, PlansTheSmallestSystemThatIsFastEnough) {
  const std::vector<std::string> some = {"reference.initiation_interval=1",
                                         "system.operands=refetched", "system.counters=none"};
  tasks::OptimiseRequest request = request_with(some);
  const double most = found_for(request).best().throughput_per_s();
  request.at_least_per_s = 0.3 * most;
  const tasks::OptimiseResult found = found_for(request);
  EXPECT_GE(found.best().throughput_per_s(), request.at_least_per_s);
  const double slack = found.best().known.scene.system.slack;
  EXPECT_GT(slack, 0.6);
  EXPECT_EQ(found.best().settings.back(), fmt::format("system.slack={}", slack));
  const auto per_s_with = [&](double other) {
    std::vector<std::string> settings = some;
    settings.push_back(fmt::format("system.slack={}", other));
    return found_for(request_with(settings)).best().throughput_per_s();
  };
  EXPECT_EQ(per_s_with(slack), found.best().throughput_per_s());
  EXPECT_LT(per_s_with(slack + 0.8 / 64), request.at_least_per_s);
  request.at_least_per_s = 1.1 * most;
  request.at_least_option = "--at-least";
  const auto refused = tasks::optimise(request, load(request));
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().field, "--at-least");
  EXPECT_EQ(refused.error().file, "scene.toml");
}

/// Lanes with running bounds are left out above the digits at which nothing is undecided. The
/// others there do not fit: their reason is no reason for those that were left out.
TEST_F(OptimiseTask, SaysWhereLanesAreLeftOut) {
  const std::vector<std::string> some = {"system.counters=none", "system.operands=refetched",
                                         "reference.initiation_interval=1"};
  tasks::OptimiseRequest request = request_with(some);
  request.choice.first_precision = 6;
  request.choice.last_precision = 16;
  request.choice.bounds = {{NumberSystem::fixed, BoundKind::running},
                           {NumberSystem::fixed, BoundKind::constant}};
  request.area_of = [](const components::Component& component, const scene::Scene& scene) {
    devices::Area area = area_of(component.key, scene);
    const auto* lane = std::get_if<measured::Lane>(&component.key);
    if (lane != nullptr && lane->bound.kind == BoundKind::constant) area.luts = 1'000'000;
    return std::optional(area);
  };
  const tasks::LoadedScene few{load(request).scene, random_rows(20)};
  const tasks::OptimiseResult found = tasks::optimise(request, few).value();
  const optimise::Optimisation& plans = found.best().found;
  ASSERT_NE(plans.best(), nullptr) << reasons_of(plans);
  int left_out = 0;
  for (const optimise::PrecisionPlan& plan : plans.plans) {
    const auto* none = std::get_if<optimise::Infeasible>(&plan.result);
    const bool says = none != nullptr && none->message.starts_with(
                                             "some lanes are left out (fewer digits leave nothing "
                                             "undecided), the others: the smallest system does not "
                                             "fit");
    if (!says) continue;
    EXPECT_GT(plan.precision, plans.best()->precision);
    ++left_out;
  }
  EXPECT_GT(left_out, 0) << reasons_of(plans);
  const auto is_note = [](const std::string& note) {
    return note.starts_with("some lanes of L = ");
  };
  EXPECT_EQ(std::count_if(plans.notes.begin(), plans.notes.end(), is_note), 1);
  const tasks::OptimiseResult many = found_for(request_with(some));
  EXPECT_TRUE(std::none_of(many.best().found.notes.begin(), many.best().found.notes.end(), is_note))
      << "2000 comparisons leave something undecided at each of these precisions";
}

/// The tier's lanes are larger than the device.
TEST_F(OptimiseTask, ASecondTierWithoutAPlanIsTold) {
  tasks::OptimiseRequest request =
      request_with({"system.counters=none", "system.operands=refetched", "second_tier.format=q16"});
  request.planning.scene.source =
      scene::SceneSource("scene.toml", std::string(orientation) +
                                           "[second_tier]\nformat = \"q16\"\ncount = \"auto\"\n");
  request.planning.scene.settings.pop_back();
  request.area_of = [](const components::Component& component, const scene::Scene& scene) {
    devices::Area area = area_of(component.key, scene);
    if (std::holds_alternative<measured::SecondLane>(component.key)) area.luts = 1'000'000;
    return std::optional(area);
  };
  const auto result = tasks::optimise(request, load(request));
  ASSERT_TRUE(result.ok()) << result.error().to_string();
  const tasks::OptimiseResult& found = *result;
  EXPECT_TRUE(found.best().known.scene.leaves_out_second_tier);
  ASSERT_EQ(found.left_out.size(), 1U);
  EXPECT_EQ(found.left_out[0].first, "[comparison], second tier q16");
  EXPECT_TRUE(found.left_out[0].second.message.starts_with("no plan at any precision; L = "))
      << found.left_out[0].second.message;
  EXPECT_TRUE(has_note(
      found, "the plan is without the scene's second tier (q16): no system with it has a plan"));
}

/// Notes that belong to the plan are in its report, not only on standard error.
TEST_F(OptimiseTask, ItsNotesAreThoseOfThePlan) {
  tasks::OptimiseRequest request = request_with({"system.counters=none", "engine.kind=none"});
  tasks::OptimiseResult found = found_for(request);
  const double bytes_per_s = found.best().throughput_per_s() * 6 * 32 / 8;
  EXPECT_TRUE(
      has_note(found, fmt::format("all operands of each comparison arrive at its ports, 192 "
                                  "bits: {:.3g} GB/s",
                                  bytes_per_s / 1e9)));
  EXPECT_FALSE(has_note(found, "no lane in fixed point"));
  request = request_with({"system.counters=none", "comparison.f=(bx-ax)/(cy-ay)"});
  request.choice.bounds.push_back({NumberSystem::floating, BoundKind::relative});
  EXPECT_TRUE(has_note(found_for(request),
                       "no lane in fixed point can be planned: the divisor may be below 0 and "
                       "above it: (bx - ax) / (cy - ay)"));
  request.choice.bounds = {{NumberSystem::floating, BoundKind::relative}};
  EXPECT_FALSE(has_note(found_for(request), "no lane in fixed point")) << "none was asked for";
}

/// A system fits with each remedy that the note names, and with no smaller one.
TEST_F(OptimiseTask, WithoutRoomItTriesWhatMakesRoom) {
  const std::vector<std::string> some = {"system.counters=none", "system.operands=refetched",
                                         "reference.initiation_interval=1",
                                         "system.device=xc7a25t"};
  const auto request_of = [&](int reference_luts, const std::vector<std::string>& more = {}) {
    std::vector<std::string> settings = some;
    settings.insert(settings.end(), more.begin(), more.end());
    tasks::OptimiseRequest request = request_with(settings);
    request.area_of = [=](const components::Component& component, const scene::Scene& scene) {
      devices::Area area = area_of(component.key, scene);
      if (std::holds_alternative<measured::Reference>(component.key)) area.luts = reference_luts;
      return std::optional(area);
    };
    return request;
  };
  constexpr int usable = 14600 * 8 / 10;
  const tasks::OptimiseResult close = found_for(request_of(usable + 100));
  EXPECT_EQ(close.best().found.best(), nullptr);
  EXPECT_TRUE(has_note(close,
                       "a system fits, by predicted areas, with: --set system.slack=0, or with: "
                       "--device xc7a35t"));
  EXPECT_NE(found_for(request_of(usable + 100, {"system.slack=0"})).best().found.best(), nullptr);
  const tasks::OptimiseResult far = found_for(request_of(40'000));
  EXPECT_TRUE(has_note(far, "a system fits, by predicted areas, with: --device xc7a100t"));
  EXPECT_TRUE(has_note(found_for(request_of(1'000'000)),
                       "no system fits with system.slack = 0 either, nor on a larger device of "
                       "artix7"));
  EXPECT_FALSE(has_note(found_for(request_of(3000)), "fits"));
}

TEST_F(OptimiseTask, ItsProgressNamesTheSteps) {
  tasks::OptimiseRequest request =
      request_with({"system.counters=none", "system.operands=refetched"});
  std::map<std::string, double> shares;
  request.progress = [&](const std::string& step, double share) {
    EXPECT_TRUE(0 <= share && share <= 1) << step << share;
    shares[step] = std::max(shares[step], share);
  };
  found_for(request);
  for (const char* step : {"systems bounded", "plans searched"}) {
    ASSERT_TRUE(shares.contains(step)) << step;
    EXPECT_GT(shares[step], 0.5) << step;
  }
  EXPECT_TRUE(shares.contains("areas predicted"));
}

/// The steps of --at-least and of the front are many searches; their shares never fall.
TEST_F(OptimiseTask, TheProgressOfManySearchesNeverFalls) {
  tasks::OptimiseRequest request =
      request_with({"system.counters=none", "system.operands=refetched"});
  request.at_least_per_s = 0.3 * found_for(request).best().throughput_per_s();
  std::map<std::string, std::vector<double>> shares;
  request.progress = [&](const std::string& step, double share) { shares[step].push_back(share); };
  found_for(request);
  for (const char* step : {"smallest system searched", "plans of smaller systems searched"}) {
    ASSERT_TRUE(shares.contains(step)) << step;
    EXPECT_TRUE(std::is_sorted(shares[step].begin(), shares[step].end())) << step;
    EXPECT_LE(shares[step].front(), 0.2) << step;
    EXPECT_GT(shares[step].back(), 0.8) << step;
    EXPECT_LE(shares[step].back(), 1) << step;
  }
  EXPECT_TRUE(std::is_sorted(shares["plans searched"].begin(), shares["plans searched"].end()));
}

/// More of the device is never slower; the last point is the plan, and a fixed cost is felt in the
/// first ones.
TEST_F(OptimiseTask, TheFrontLeadsToThePlan) {
  const tasks::OptimiseResult found = found_for(request_with({}));
  ASSERT_EQ(found.front.size(), 5U);
  for (std::size_t k = 1; k < found.front.size(); ++k) {
    EXPECT_GE(1.005 * found.front[k].plan.throughput_per_s,
              found.front[k - 1].plan.throughput_per_s);
    EXPECT_EQ(found.front[k].share, 2 * found.front[k - 1].share);
  }
  EXPECT_NEAR(found.front.back().plan.throughput_per_s, found.best().throughput_per_s(),
              0.005 * found.best().throughput_per_s());
  EXPECT_EQ(found.front.back().settings, found.best().settings);
  EXPECT_EQ(found.front.back().share, 0.8) << "of the device: R_S leaves no more";
  const tasks::FrontPoint* knee = knee_of(found.front);
  ASSERT_NE(knee, nullptr);
  EXPECT_LT(knee->share, 1);
  EXPECT_GT(knee->share, found.front.front().share);
}

constexpr const char* circles = R"toml(
[comparison]
name = "circles"
f = "(cxi - cxj)^2 + (cyi - cyj)^2"
g = "(ri + rj)^2"
[inputs]
"*" = { range = [0, 100] }
[reference]
format = "s24e8"
initiation_interval = 1
[reduced]
format = "auto"
[engine]
kind = "pairwise"
lanes_per_group = 4
report = ["less"]
[system]
device = "artix7-200t"
counters = "none"
[data]
items = "uniform_spheres"
count = 100
radius_max = 20
pairs = "all"
)toml";

/// An eighth of the circles meet, so that one stream serves few lanes. Each further row of the
/// table has more streams and is faster for it; all that it could be is some system's best.
TEST_F(OptimiseTask, StreamsOfReportsAreAsManyAsAreWorthTheirPorts) {
  tasks::OptimiseRequest request = request_with({});
  request.planning.scene.source = scene::SceneSource("scene.toml", circles);
  const auto found_with = [&](const std::vector<std::string>& settings) {
    request.planning.scene.settings = settings;
    return tasks::optimise(request, tasks::load(request.planning.scene).value()).value();
  };
  const tasks::OptimiseResult open = found_with({});
  std::map<int, double> by_streams;
  for (const tasks::PlannedSystem& system : open.systems) {
    const int streams = system.known.scene.system.engine.report_streams;
    EXPECT_TRUE(by_streams.empty() || streams > by_streams.rbegin()->first) << "rows by streams";
    by_streams[streams] = system.throughput_per_s();
  }
  ASSERT_GE(by_streams.size(), 3U);
  double before = 0;
  for (const int streams : {1, 2, 4, 8, 16, 32}) {
    const auto given = found_with({fmt::format("engine.report_streams={}", streams)});
    ASSERT_EQ(given.systems.size(), 1U);
    const double alone = given.best().throughput_per_s();
    const auto row = by_streams.find(streams);
    if (row == by_streams.end()) {
      EXPECT_LE(alone, 1.011 * before) << streams << " streams are left out";
    } else {
      EXPECT_NEAR(row->second / alone, 1, 0.006) << streams;
      EXPECT_GT(row->second, 1.005 * before) << streams;
      before = row->second;
    }
  }
  const int chosen = open.best().known.scene.system.engine.report_streams;
  EXPECT_EQ(chosen, by_streams.rbegin()->first);
  EXPECT_EQ(open.best().settings,
            std::vector<std::string>{fmt::format("engine.report_streams={}", chosen)});
}

/// The plan's settings and the search's own scene are one system.
TEST(Architectures, AreWhatTheirSettingsMake) {
  const scene::SceneSource source("scene.toml", orientation);
  const scene::Scene scene = scene::load_scene(source, {}).value();
  const optimise::OpenKeys open =
      optimise::open_keys(scene::read_scene_settings(source, {}).value().settings);
  EXPECT_TRUE(open.operands && open.counters && open.lanes_per_group && open.engine);
  const auto all = architectures_of(scene, open);
  EXPECT_EQ(all.size(), 2U * (6 * 2 * 4 + 6));
  for (const optimise::Architecture& each : all) {
    const scene::Scene made = with_architecture(scene, each, open);
    const std::vector<std::string> settings = settings_of(each, scene, open);
    const scene::SystemSpec read = scene::load_scene(source, settings).value().system;
    EXPECT_EQ(read.operands, made.system.operands);
    EXPECT_EQ(read.operand_memory, made.system.operand_memory);
    EXPECT_EQ(read.lanes_per_group, made.system.lanes_per_group);
    EXPECT_EQ(read.request_beats.value_or(1), made.system.request_beats.value_or(1));
    EXPECT_EQ(read.counters, made.system.counters);
    EXPECT_EQ(read.counter_bits, made.system.counter_bits);
  }
}

}  // namespace
}  // namespace mixcmp::test::optimise_task_test
