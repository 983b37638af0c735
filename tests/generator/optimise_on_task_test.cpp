#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "generator/tasks/optimise_on.hpp"
#include "model/base/number/exact.hpp"
#include "model/cost/devices/parts.hpp"

/// Plans on many devices against the plans that each device has by itself.
namespace mixcmp::test::optimise_on_task_test {
namespace {

using tasks::DevicePlan;
using tasks::OptimiseOnResult;

constexpr const char* products = R"toml(
[comparison]
name = "products"
f = "a*b"
g = "c*d"
[inputs]
"*" = { range = [0, 100] }
[reference]
format = "s24e8"
initiation_interval = 1
[reduced]
format = "auto"
[system]
device = "virtex6-lx760"
operands = "carried"
operand_memory = "logic"
request_beats = 1
lanes_per_group = 1
counters = "none"
[engine]
kind = "none"
)toml";

data::Comparisons random_rows() {
  const FloatFormat format = FloatFormat::make(24, 8).value();
  data::Table table{.format = format, .columns = {"a", "b", "c", "d"}, .values = {}};
  std::uint64_t state = 1;
  for (int k = 0; k < 4 * 2000; ++k) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    const double value = static_cast<double>(state >> 40) * 100.0 / (1 << 24);
    table.values.push_back(from_rational(format, mpq_class(value)));
  }
  return data::Comparisons::rows(std::move(table), {"a", "b", "c", "d"}).value();
}

/// Areas that are made up, about those of predictions: the library takes seconds to read.
std::optional<devices::Area> made_up(const components::Component& component, const scene::Scene&) {
  const auto logic = [](int luts, int dsps = 0) {
    return devices::Area{.luts = luts, .registers = luts, .dsps = dsps};
  };
  if (const auto* lane = std::get_if<measured::Lane>(&component.key)) {
    const int bits = lane->format.precision();
    const bool embedded = lane->multipliers == scene::Multipliers::embedded;
    return embedded ? logic(9 * bits, 2) : logic(9 * bits + 2 * bits * bits);
  }
  if (std::holds_alternative<measured::Reference>(component.key)) return logic(3000, 8);
  if (const auto* crossbar = std::get_if<measured::Crossbar>(&component.key)) {
    return logic(50 + 60 * crossbar->lanes);
  }
  return logic(150);
}

class OptimiseOn : public testing::Test {
protected:
  static tasks::OptimiseRequest request_with(std::vector<std::string> settings) {
    return {
        .planning = {.scene = {scene::SceneSource("scene.toml", products), std::move(settings)}},
        .choice = {.first_precision = 11,
                   .last_precision = 12,
                   .inputs = {LaneInputs::exact},
                   .bounds = {{NumberSystem::fixed, BoundKind::constant}},
                   .multipliers = {scene::Multipliers::embedded, scene::Multipliers::logic}},
        .predict_only = true};
  }
  static tasks::LoadedScene load(const tasks::OptimiseRequest& request) {
    const tasks::SceneRequest& scene = request.planning.scene;
    return {scene::load_scene(scene.source, scene.settings).value(), random_rows()};
  }
  tasks::OptimiseRequest request_for(std::vector<std::string> settings, double at_least_per_s) {
    tasks::OptimiseRequest request = request_with(std::move(settings));
    request.at_least_per_s = at_least_per_s;
    request.area_of = area_of_;
    return request;
  }
  Result<OptimiseOnResult> planned_on(const std::vector<std::string>& devices,
                                      double at_least_per_s = 0) {
    const tasks::OptimiseRequest request = request_for({}, at_least_per_s);
    return optimise_on({request, devices}, load(request));
  }
  tasks::OptimiseResult planned_by_itself(const std::string& device, double at_least_per_s = 0) {
    const tasks::OptimiseRequest request = request_for({"system.device=" + device}, at_least_per_s);
    return tasks::optimise(request, load(request)).value();
  }
  static std::vector<std::string> names_of(const OptimiseOnResult& result) {
    std::vector<std::string> names;
    for (const DevicePlan& each : result.devices) names.push_back(each.device.name);
    return names;
  }

  components::PredictedArea area_of_ = made_up;
};

/// A search by itself also has plans of other precisions, so it may find half a percent more.
TEST_F(OptimiseOn, EachDeviceHasThePlanThatItHasByItself) {
  area_of_ = {};  // predictions
  const OptimiseOnResult all =
      planned_on({"xc7k70t", "lfe5u-25f", "xc7a25t", "ice40lp384"}).value();
  EXPECT_EQ(names_of(all),
            (std::vector<std::string>{"ice40lp384", "xc7a25t", "lfe5u-25f", "xc7k70t"}))
      << "24,288 LUTs of four inputs are 16,192 of six";
  for (const DevicePlan& each : all.devices) {
    const tasks::OptimiseResult single = planned_by_itself(each.device.name);
    const double per_s = single.best().throughput_per_s();
    EXPECT_LE(each.plan.throughput_per_s, per_s) << each.device.name;
    EXPECT_GE(1.005 * each.plan.throughput_per_s, per_s) << each.device.name;
    EXPECT_EQ(each.plan.throughput_per_s == 0, each.device.name == "ice40lp384")
        << each.device.name;
    if (each.plan.throughput_per_s == 0) {
      EXPECT_EQ(each.why_none, "nothing fits");
      continue;
    }
    EXPECT_EQ(each.interface, single.best().interface);
    EXPECT_EQ(each.settings.front(), "system.device=" + each.device.name);
    EXPECT_GT(each.used.share, 0.8) << each.device.name;
    EXPECT_LE(each.used.share, 1) << each.device.name;
  }
  EXPECT_FALSE(all.smallest);
  ASSERT_EQ(all.notes.size(), 1U) << "only the ECP5 and the iCE40 have no library";
  EXPECT_NE(all.notes.front().find("ecp5, ice40-lp:"), std::string::npos) << all.notes.front();
}

/// The progress over several devices is one: it names each of them, and its share never falls.
TEST_F(OptimiseOn, TheProgressCountsTheDevices) {
  for (const double at_least_per_s : {0.0, 1e9}) {
    tasks::OptimiseRequest request = request_for({}, at_least_per_s);
    std::vector<std::string> steps;
    std::vector<double> shares;
    request.progress = [&](const std::string& step, double share) {
      if (!step.starts_with("device ")) return;
      if (steps.empty() || steps.back() != step) steps.push_back(step);
      shares.push_back(share);
    };
    const std::vector<std::string> names = {"xc7k70t", "xc7a25t", "xc7a100t"};
    ASSERT_TRUE(optimise_on({request, names}, load(request)).ok());
    ASSERT_FALSE(steps.empty());
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
    EXPECT_LT(shares.front(), 0.2);
    EXPECT_LE(shares.back(), 1);
    if (at_least_per_s > 0) continue;  // devices are passed over
    EXPECT_EQ(steps, (std::vector<std::string>{"device 1 of 3, xc7k70t", "device 2 of 3, xc7a25t",
                                               "device 3 of 3, xc7a100t"}));
    EXPECT_GT(shares.back(), 0.8);
  }
}

/// The device that the user gives as a setting is not one of those that are planned on.
TEST_F(OptimiseOn, ADeviceAmongTheSettingsIsReplaced) {
  const tasks::OptimiseRequest request = request_for({"system.device=ecp5-85k"}, 1e9);
  const auto found = optimise_on({request, {"xc7a25t", "lfe5u-25f"}}, load(request));
  ASSERT_TRUE(found.ok()) << found.error().to_string();
  const std::vector<std::string> settings = settings_of(request, found->smallest->best());
  const auto names_device = [](const std::string& each) {
    return each.starts_with("system.device=");
  };
  EXPECT_EQ(std::count_if(settings.begin(), settings.end(), names_device), 1);
  EXPECT_EQ(found->smallest->best().known.scene.system.target_mhz, 200) << "not the ECP5's";
}

TEST_F(OptimiseOn, TheSmallestDeviceHasTheSmallestSystemThatItHasByItself) {
  const double wanted = planned_by_itself("xc7a100t").best().throughput_per_s() / 3;
  const OptimiseOnResult found = planned_on({"xc7a200t", "xc7a25t", "xc7a100t"}, wanted).value();
  ASSERT_TRUE(found.smallest);
  const tasks::PlannedSystem& smallest = found.smallest->best();
  EXPECT_EQ(smallest.found.device.name, "xc7a100t");
  const tasks::OptimiseResult single = planned_by_itself("xc7a100t", wanted);
  EXPECT_EQ(smallest.throughput_per_s(), single.best().throughput_per_s());
  std::vector<std::string> settings = single.best().settings;
  settings.insert(settings.begin(), "system.device=xc7a100t");
  EXPECT_EQ(smallest.settings, settings);
  EXPECT_EQ(found.smallest->front.size(), single.front.size());
  EXPECT_EQ(names_of(found), (std::vector<std::string>{"xc7a25t", "xc7a100t"}));
  EXPECT_EQ(found.passed_over, 1) << "the largest need not be planned";
}

/// Virtex-5 has devices with more LUTs and fewer multipliers than others, so a larger one may be
/// slower.
TEST_F(OptimiseOn, NoSmallerDeviceThatIsFastEnoughIsPassedOver) {
  std::vector<std::string> names;
  for (const devices::KnownDevice& each : devices::devices_with("virtex5")) {
    names.push_back(each.device.name);
  }
  ASSERT_GT(names.size(), 20U);
  const OptimiseOnResult all = planned_on(names).value();
  EXPECT_EQ(all.devices.size(), names.size());
  EXPECT_FALSE(std::is_sorted(all.devices.begin(), all.devices.end(),
                              [](const DevicePlan& a, const DevicePlan& b) {
                                return 1.02 * a.plan.throughput_per_s < b.plan.throughput_per_s;
                              }))
      << "this family tests nothing";
  for (const double part : {0.1, 0.5, 0.8}) {
    double most = 0;
    for (const DevicePlan& each : all.devices) most = std::max(most, each.plan.throughput_per_s);
    const double wanted = part * most;
    const auto first =
        std::find_if(all.devices.begin(), all.devices.end(),
                     [&](const DevicePlan& each) { return each.plan.throughput_per_s >= wanted; });
    const OptimiseOnResult found = planned_on(names, wanted).value();
    EXPECT_EQ(found.smallest->best().found.device.name, first->device.name) << part;
    EXPECT_EQ(found.devices.size() + static_cast<std::size_t>(found.passed_over), names.size());
    EXPECT_LT(found.devices.size(), names.size()) << part;
  }
}

TEST_F(OptimiseOn, DevicesWithTheSameResourcesAreOneRow) {
  const OptimiseOnResult found =
      planned_on({"xc7a35t", "lfe5u-25f", "lfe5um-25f", "xc7a35t"}).value();
  ASSERT_EQ(found.devices.size(), 2U);
  EXPECT_EQ(found.devices[0].alike, std::vector<std::string>{"lfe5um-25f"});
  EXPECT_TRUE(found.devices[1].alike.empty()) << "a device is not like itself";
}

TEST_F(OptimiseOn, ErrorsNameTheFastestOrTheLargest) {
  const auto slow = planned_on({"xc7a25t", "xc7a100t"}, 1e15);
  ASSERT_FALSE(slow.ok());
  EXPECT_EQ(slow.error().field, "at_least");
  EXPECT_NE(slow.error().accepted.find("xc7a100t"), std::string::npos);
  const auto none = planned_on({"ice40lp384"});
  ASSERT_FALSE(none.ok());
  EXPECT_EQ(none.error().field, "system.device");
  EXPECT_NE(none.error().received.find("ice40lp384"), std::string::npos);
}

}  // namespace
}  // namespace mixcmp::test::optimise_on_task_test
