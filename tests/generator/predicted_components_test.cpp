#include <gtest/gtest.h>

#include <algorithm>

#include "generator/synthesis/characterise/synthesis.hpp"
#include "generator/synthesis/components/component_list.hpp"
#include "generator/synthesis/components/predicted_table.hpp"
#include "generator/synthesis/components/shortlist.hpp"
#include "generator/synthesis/components/synthesis_jobs.hpp"
#include "model/cost/devices/device.hpp"
#include "tests/generator/components_fixture.hpp"

/// Areas of components by units, and the promising ones of an engine.
namespace mixcmp::test::predicted_components_test {
namespace {

/// Rates of lanes with each bound: `halving` halves with each digit from 1 at four digits on.
optimise::Rates rates_of(const std::map<std::string, bool>& halving) {
  constexpr std::uint64_t comparisons = 1 << 20;
  profile::RateProfile rates{.first_precision = 4, .comparisons = comparisons};
  for (const auto& [name, halves] : halving) {
    profile::SchemeProfile scheme{.name = name, .bound = settings::parse_bound(name).value()};
    for (int digits = 4; digits <= 16; ++digits) {
      scheme.counts.push_back(
          {.exists = true, .undecided = halves ? comparisons >> (digits - 4) : comparisons});
    }
    rates.schemes.push_back(std::move(scheme));
  }
  return optimise::Rates::of({rates});
}

TEST_F(Components, UnitsAreMadeFromTheirNamesAlone) {
  components::ComponentQuery query = lanes({12}, {"relative", "running_4"});
  query.kinds = {measured::ComponentKind::unit};
  const Found found = find(scene(one_system), query);
  EXPECT_GT(found.components.size(), 4u);
  for (const auto& [key, unit] : found.components) {
    const std::string& name = std::get<measured::Unit>(key).name;
    const auto again = components::instance_of_name(name);
    ASSERT_TRUE(again.ok()) << name;
    EXPECT_EQ(components::instance_name(*again), name);
    std::istringstream words(name);
    std::string word;
    for (words >> word; words >> word;) {
      const std::string value = word.substr(word.find('=') + 1);
      const std::string text = source(unit, unit.job().top + ".v");
      EXPECT_NE(text.find("= " + value), std::string::npos) << name << "\n" << text;
    }
  }
  EXPECT_TRUE(components::instance_of_name("fp_convert PRECISION=24 SCALE=-3").ok());
  EXPECT_FALSE(components::instance_of_name("").ok());
  EXPECT_FALSE(components::instance_of_name("fp_nothing PRECISION=3").ok());
  EXPECT_FALSE(components::instance_of_name("fp_add NOTHING=3").ok());
  EXPECT_FALSE(components::instance_of_name("fp_add PRECISION").ok());
  EXPECT_FALSE(components::instance_of_name("fp_add PRECISION=3)").ok());
}

/// A lane whose multipliers take registers and sums of the lane: its area is far from the sum of
/// its units' without them.
TEST_F(Components, AreasArePredictedAboutAsYosysMapsThem) {
  const std::string artix = one_system + "device = \"artix7-200t\"\n";
  const Found found = find(scene(artix), lanes({9}, {"fixed_norm"}));
  const devices::Device device = devices::find_device("artix7-200t").value();
  auto predictor = components::AreaPredictor::make(device).value();
  EXPECT_FALSE(predictor.is_rough());
  const auto lane = std::find_if(found.components.begin(), found.components.end(), [](auto& each) {
    const auto* key = std::get_if<measured::Lane>(&each.first);
    return key != nullptr && key->multipliers == scene::Multipliers::embedded;
  });
  ASSERT_NE(lane, found.components.end());
  const std::optional<devices::Area> predicted = predictor.of(lane->second);
  ASSERT_TRUE(predicted.has_value());
  EXPECT_TRUE(predictor.unknown().empty());
  EXPECT_TRUE(predictor.outdated().empty());
  const auto mapped = characterise::synthesise(lane->second.job(), device,
                                               {.effort = characterise::TimingEffort::area_only},
                                               directory_.path());
  ASSERT_TRUE(mapped.ok()) << mapped.error().to_string();
  EXPECT_EQ(predicted->dsps, mapped->area.dsps);
  EXPECT_NEAR(predicted->luts, mapped->area.luts, 0.1 * mapped->area.luts);
  EXPECT_NEAR(predicted->registers, mapped->area.registers, 0.1 * mapped->area.registers);
}

TEST_F(Components, TheShortlistHasTheBestPrecisionsOfTheBestKinds) {
  const scene::Scene two_kinds = scene(one_system);
  components::ComponentMaker maker(two_kinds, nullptr);
  const devices::Device device = devices::find_device("virtex6-lx760").value();
  components::ComponentQuery query =
      lanes({4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14}, {"running_4", "fixed_norm"});
  query.multipliers = {scene::Multipliers::logic};
  const auto list = [&](const std::map<std::string, bool>& halving) {
    const auto found = components::shortlist(maker, query, device, rates_of(halving));
    EXPECT_TRUE(found.ok()) << found.error().to_string();
    std::map<std::string, std::vector<int>> precisions;
    for (const measured::Lane& key : found->lanes) {
      precisions[to_string(key.bound)].push_back(key.format.precision());
    }
    EXPECT_GT(found->seconds, 0);
    return precisions;
  };
  // A kind of lane that recomputes everything is worthless, however small it is.
  const auto float_alone = list({{"running_4", true}, {"fixed_norm", false}});
  ASSERT_EQ(float_alone.size(), 1u);
  EXPECT_EQ(float_alone.begin()->first, "running_4");
  // Where both kinds recompute as often, the kind with the smaller lane is the better one.
  const auto fixed_alone = list({{"running_4", true}, {"fixed_norm", true}});
  ASSERT_EQ(fixed_alone.size(), 1u);
  ASSERT_EQ(fixed_alone.begin()->first, "fixed_norm");
  const std::vector<int>& chosen = fixed_alone.begin()->second;
  ASSERT_EQ(chosen.size(), 3u);
  EXPECT_GT(chosen[0], 5) << "one in two is recomputed at five digits";
  EXPECT_LT(chosen[2], 14) << "one in a thousand at fourteen, where lanes still grow";

  query.lanes =
      components::shortlist(maker, query, device, rates_of({{"fixed_norm", true}}))->lanes;
  EXPECT_EQ(find(two_kinds, query).components.size(), 3u) << "no lane but those of the list";
}

}  // namespace
}  // namespace mixcmp::test::predicted_components_test
