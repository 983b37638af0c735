#include "model/base/settings/limits.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "model/scene/scene.hpp"
#include "tests/support/scratch_directory.hpp"

/// Tests that every limit is the same in the documentation, in messages and in the accepted values.
namespace mixcmp::test::limits_test {
namespace {

struct Stated {
  std::string section;  ///< heading of docs/scene_file.md
  std::string key;
  std::string limits;
};

/// The row of a key in its section's table.
std::string row_of(const std::string& section, const std::string& key) {
  std::ifstream page(MIXCMP_SOURCE_DIR "/docs/scene_file.md");
  bool inside = false;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("## ")) inside = line == "## " + section;
    if (inside && line.starts_with("| `" + key + "`")) return line;
  }
  return "no row of " + key;
}

TEST(Limits, DocumentationStatesThem) {
  const std::string exponents = "exponent bits " + to_string(settings::limits::exponent_bits);
  const std::string capacity = to_string(settings::limits::engine_capacity);
  for (const Stated& stated : std::vector<Stated>{
           {"[reference]", "format",
            "precision " + to_string(settings::limits::reference_precision)},
           {"[reference]", "format", exponents},
           {"[reduced]", "format", "precision " + to_string(settings::limits::lane_precision)},
           {"[reduced]", "format", "W = " + to_string(settings::limits::fixed_bits)},
           {"[reduced]", "bound_digits", to_string(settings::limits::bound_digits)},
           {"[system]", "lanes", to_string(settings::limits::lanes)},
           {"[system]", "references", to_string(settings::limits::references)},
           {"[reference]", "target_mhz", to_string(settings::limits::target_mhz)},
           {"[system]", "target_mhz", to_string(settings::limits::target_mhz)},
           {"[system]", "lanes_per_group", to_string(settings::limits::lanes_per_group)},
           {"[system]", "input_registers", to_string(settings::limits::input_registers)},
           {"[system]", "tag_bits", to_string(settings::limits::tag_bits)},
           {"[system]", "counter_bits", "0 or " + to_string(settings::limits::counter_bits)},
           {"[system]", "counter_bits", to_string(settings::limits::read_counter_bits)},
           {"[engine]", "capacity", capacity},
           {"[engine]", "tag_bits", to_string(settings::limits::tag_bits)},
           {"[[lanes]] and [[references]]", "count", to_string(settings::limits::lanes)},
           {"[data]", "count", to_string(settings::limits::items)},
           {"[data]", "with_count", to_string(settings::limits::items)}}) {
    EXPECT_NE(row_of(stated.section, stated.key).find(stated.limits), std::string::npos)
        << stated.section << " " << stated.key << " " << stated.limits;
  }
}

class Edges : public testing::Test {
protected:
  Result<scene::Scene> load(const std::string& reference,
                            const std::vector<std::string>& settings) {
    const std::filesystem::path path = directory_.path() / "scene.toml";
    std::ofstream(path) << "[comparison]\nname = \"edges\"\nf = \"a * b\"\ng = \"c\"\n[reference]\n"
                        << "format = \"" << reference << "\"\n";
    return scene::load_scene(path, settings);
  }

  /// Checks that the last value in each direction is accepted, and that the next one is refused
  /// with the limits.
  void expect_edges(const std::string& key, settings::Limits limits, const std::string& before = "",
                    const std::string& after = "") {
    const auto with = [&](int value) {
      return load("s53e8", {key + "=" + before + std::to_string(value) + after});
    };
    for (const int inside : {limits.least, limits.most}) {
      const auto scene = with(inside);
      EXPECT_TRUE(scene.ok()) << (scene.ok() ? "" : scene.error().to_string());
    }
    for (const int outside : {limits.least - 1, limits.most + 1}) {
      const auto scene = with(outside);
      ASSERT_FALSE(scene.ok()) << key << " = " << outside;
      EXPECT_NE(scene.error().accepted.find(to_string(limits)), std::string::npos)
          << scene.error().to_string();
    }
  }

  test::ScratchDirectory directory_;
};

TEST_F(Edges, OfWholeNumbers) {
  expect_edges("reduced.bound_digits", settings::limits::bound_digits);
  expect_edges("system.lanes", settings::limits::lanes);
  expect_edges("system.references", settings::limits::references);
  expect_edges("system.tag_bits", settings::limits::tag_bits);
  expect_edges("system.counter_bits", settings::limits::counter_bits);
  EXPECT_TRUE(load("s53e8", {"system.counter_bits=0"}).ok());
}

TEST_F(Edges, OfLanesInGroups) {
  expect_edges("system.lanes_per_group", settings::limits::lanes_per_group);
  const auto lanes = [&](int group, int count) {
    return load("s53e8", {"system.lanes_per_group=" + std::to_string(group),
                          "system.lanes=" + std::to_string(count)})
        .ok();
  };
  EXPECT_TRUE(lanes(2, 2 * 512));
  EXPECT_FALSE(lanes(2, 2 * 513));
  EXPECT_TRUE(lanes(64, 4096));
  EXPECT_FALSE(lanes(64, 4160));
}

TEST_F(Edges, OfPrecisionsAndExponentBits) {
  expect_edges("reduced.format", settings::limits::lane_precision, "s", "e8");
  expect_edges("reduced.format", settings::limits::exponent_bits, "s17e");
  expect_edges("reduced.format", settings::limits::lane_precision, "s");
  expect_edges("reference.format", settings::limits::reference_precision, "s", "e8");
  expect_edges("reference.format", settings::limits::exponent_bits, "s53e");
}

TEST_F(Edges, OfAReferencesTarget) {
  expect_edges("reference.target_mhz", settings::limits::target_mhz);
}

TEST_F(Edges, ALanesDigitsEndAtTheReferences) {
  EXPECT_TRUE(load("s11e5", {"reduced.format=s11e5"}).ok());
  const auto wider = load("s11e5", {"reduced.format=s12e5"});
  ASSERT_FALSE(wider.ok());
  EXPECT_EQ(wider.error().accepted,
            "\"auto\", \"exact\", sP or sPeE with P 4..11 and E 2..15, or binary16, bfloat16; P at "
            "most the "
            "reference's; qW or blockW with W 2..11, likewise W + G of qWgG and blockWgG");
}

TEST(Limits, LanesOfAReference) {
  EXPECT_EQ(to_string(settings::lane_precisions(FloatFormat::make(11, 5).value())), "4..11");
  EXPECT_EQ(to_string(settings::lane_precisions(FloatFormat::make(113, 15).value())), "4..52");
}

}  // namespace
}  // namespace mixcmp::test::limits_test
