#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "model/base/common/counter_random.hpp"
#include "model/base/settings/bound_name.hpp"
#include "model/plan/optimise/optimise.hpp"
#include "model/plan/optimise/plan_at_rates.hpp"
#include "tests/model/plan/profile/profile_cases.hpp"
#include "tests/support/sphere.hpp"

namespace mixcmp::test {

/// A small device with a table that was made up: lanes of 8, 10 and 12 digits with two kinds of
/// multipliers, two kinds of references.
class PlanningTest : public testing::Test {
protected:
  static constexpr int fifo_64_luts = 20;

  PlanningTest() {
    scene_.name = "made_up";
    scene_.system.slack = 0.2;
    device_.name = "small";
    device_.available = {.luts = 10000, .registers = 20000, .dsps = 50};
    for (const int precision : {8, 10, 12}) {
      const std::string format = "s" + std::to_string(precision) + "e8";
      table_.rows.push_back(lane_row(format, "exact", "relative", "embedded", 30 * precision, 2));
      table_.rows.push_back(lane_row(format, "exact", "relative", "logic", 45 * precision));
      table_.rows.push_back(lane_row(format, "exact", "profiled", "embedded", 40 * precision, 3));
    }
    table_.rows.push_back(reference_row("embedded", 3000, 20));
    table_.rows.push_back(reference_row("logic", 5000, 0));
    table_.rows.push_back(row_of(measured::Fifo{32}, 10));
    table_.rows.push_back(row_of(measured::Fifo{64}, fifo_64_luts));
    table_.rows.push_back(row_of(measured::Crossbar{1}, 10));
    table_.rows.push_back(row_of(measured::Crossbar{8}, 111));
    rates_ = rates_of({{8, 5000}, {10, 200}, {12, 10}});
    sort();
  }

  static measured::Measurement row_of(measured::ComponentKey key, int luts, int dsps = 0) {
    return {.key = std::move(key),
            .latency_cycles = 20,
            .area = {.luts = luts, .registers = luts, .dsps = dsps},
            .clock = measured::Clock{.mhz = 300, .low_mhz = 300, .high_mhz = 300},
            .hash = {},
            .tools = {}};
  }

  static scene::Multipliers multipliers_of(const std::string& word) {
    return word == "logic" ? scene::Multipliers::logic : scene::Multipliers::embedded;
  }

  /// `inputs` is empty in fixed point.
  static measured::Lane lane(const std::string& format, const std::string& inputs,
                             const std::string& bound, const std::string& multipliers) {
    return {.format = LaneFormat::parse(format).value(),
            .inputs = inputs.empty() ? std::nullopt
                                     : std::optional(LaneInputs::parse(inputs, 4, 52).value()),
            .bound = settings::parse_bound(bound).value(),
            .multipliers = multipliers_of(multipliers)};
  }

  static measured::Measurement lane_row(const std::string& format, const std::string& inputs,
                                        const std::string& bound, const std::string& multipliers,
                                        int luts, int dsps = 0) {
    return row_of(lane(format, inputs, bound, multipliers), luts, dsps);
  }

  static measured::Reference reference(const std::string& multipliers) {
    return {.format = LaneFormat::parse("s53e8").value(),
            .multipliers = multipliers_of(multipliers)};
  }

  static measured::Measurement reference_row(const std::string& multipliers, int luts, int dsps) {
    measured::Measurement row = row_of(reference(multipliers), luts, dsps);
    row.clock->mhz = 150;
    return row;
  }

  void sort() {
    std::sort(table_.rows.begin(), table_.rows.end(),
              [](const auto& a, const auto& b) { return a.key < b.key; });
  }

  /// Undecided of a million, by precision, for exact inputs; profiled lanes the same.
  static profile::RateProfile profile_of(const std::map<int, std::uint64_t>& undecided) {
    profile::RateProfile profile{.comparisons = 1'000'000};
    for (const auto& [name, kind] : {std::pair("relative", profile::SchemeKind::certified),
                                     std::pair("profiled", profile::SchemeKind::profiled)}) {
      profile.schemes.push_back({.name = name,
                                 .bound = settings::parse_bound(name).value(),
                                 .kind = kind,
                                 .counts = {},
                                 .reason = {}});
      for (int precision = 4; precision <= 16; ++precision) {
        const auto found = undecided.find(precision);
        const bool exists = found != undecided.end();
        profile.schemes.back().counts.push_back(
            {.exists = exists, .undecided = exists ? found->second : 0});
      }
    }
    return profile;
  }

  /// With the pairs of 1000 items. `reported`: those of a million that an engine reports.
  static optimise::Rates rates_of(const std::map<int, std::uint64_t>& undecided,
                                  std::uint64_t reported = 0) {
    profile::RateProfile profile = profile_of(undecided);
    performance::PairwiseData pairs{.set = {.items = 1000}};
    pairs.reported.resize((pairs.pairs() + 63) / 64);
    for (std::uint64_t k = 0; k < pairs.pairs(); ++k) {
      const bool is_reported = counter_random(0, k) % 1'000'000 < reported;
      pairs.reported[k / 64] |= std::uint64_t{is_reported} << k % 64;
    }
    profile.pairs = std::make_shared<performance::PairwiseData>(std::move(pairs));
    return optimise::Rates::of({profile});
  }

  optimise::Optimisation optimise_now() {
    sort();
    auto found = optimise::optimise(scene_, device_, table_, rates_, options_);
    if (!found.ok()) throw std::runtime_error(found.error().to_string());
    return std::move(found).value();
  }

  /// At its own rates each plan has its own throughput; at higher ones it is slower, but serves as
  /// many recomputations as before.
  void expect_plans_at_rates(const optimise::Rates& higher) const {
    const auto found = optimise::optimise(scene_, device_, table_, rates_, options_);
    ASSERT_TRUE(found.ok()) << found.error().to_string();
    int feasible = 0;
    for (const optimise::PrecisionPlan& plan : found->plans) {
      if (plan.allocation() == nullptr) continue;
      ++feasible;
      const auto own = at_rates(plan, scene_, rates_);
      ASSERT_TRUE(own) << plan.precision;
      EXPECT_NEAR(own->throughput_per_s / plan.throughput_per_s(), 1, 1e-9) << plan.precision;
      const auto other = at_rates(plan, scene_, higher);
      ASSERT_TRUE(other) << plan.precision;
      EXPECT_GT(other->counted_rate, own->counted_rate) << plan.precision;
      EXPECT_LT(other->throughput_per_s, own->throughput_per_s) << plan.precision;
      EXPECT_GE(other->throughput_per_s * other->counted_rate,
                own->throughput_per_s * own->counted_rate * (1 - 1e-9))
          << plan.precision;
    }
    EXPECT_GT(feasible, 0);
  }

  scene::Scene scene_ = scene_of(sphere_graph(), format_of(53, 8), {format_of(8, 8)});
  devices::Device device_;
  measured::Characterisation table_{.device = "small", .scene = {}, .command = {}, .rows = {}};
  optimise::Rates rates_;
  optimise::OptimiseOptions options_;
};

}  // namespace mixcmp::test
