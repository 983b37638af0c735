#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "generator/synthesis/components/component_list.hpp"
#include "model/base/settings/bound_name.hpp"
#include "model/scene/scene.hpp"
#include "tests/support/scratch_directory.hpp"

/// The components of a small scene of spheres.
namespace mixcmp::test {

inline constexpr const char* spheres =
    "[comparison]\nname = \"spheres\"\n"
    "f = \"(xi - xj)^2 + (yi - yj)^2\"\ng = \"(ri + rj)^2\"\n"
    "[inputs]\n\"*\" = { range = [0, 100] }\n"
    "[reference]\nformat = \"s24e8\"\n";

class Components : public testing::Test {
protected:
  /// The scene with further sections behind it.
  scene::Scene scene(const std::string& rest, const std::string& head = spheres) {
    const auto path = directory_.path() / "scene.toml";
    std::ofstream(path) << head << rest;
    const auto loaded = scene::load_scene(path, {});
    EXPECT_TRUE(loaded.ok()) << loaded.error().to_string();
    return *loaded;
  }

  struct Found {
    std::map<measured::ComponentKey, components::Component> components;
    std::vector<components::MissingLane> missing;

    int count(measured::ComponentKind kind) const {
      return static_cast<int>(
          std::count_if(components.begin(), components.end(),
                        [&](const auto& entry) { return kind_of(entry.first) == kind; }));
    }
    std::vector<std::string> formats(const std::string& bound) const {
      std::vector<std::string> names;
      for (const auto& [key, component] : components) {
        const auto* lane = std::get_if<measured::Lane>(&key);
        if (lane != nullptr && to_string(lane->bound) == bound) {
          names.push_back(lane->format.name());
        }
      }
      return names;
    }
  };

  static Found find(const scene::Scene& scene, const components::ComponentQuery& query) {
    components::ComponentMaker maker(scene, nullptr);
    Found found;
    const auto missing =
        for_each_component(maker, query, [&](const components::Component& component) {
          EXPECT_TRUE(found.components.emplace(component.key, component).second) << "told twice";
        });
    EXPECT_TRUE(missing.ok()) << missing.error().to_string();
    found.missing = *missing;
    return found;
  }

  static components::ComponentQuery lanes(std::vector<int> precisions,
                                          const std::vector<std::string>& names) {
    std::vector<Bound> bounds;
    for (const std::string& name : names) {
      bounds.push_back(settings::parse_bound(name).value());
    }
    return {.kinds = {measured::ComponentKind::lane},
            .precisions = std::move(precisions),
            .bounds = std::move(bounds),
            .inputs = {LaneInputs::exact},
            .multipliers = {scene::Multipliers::embedded}};
  }

  ScratchDirectory directory_;
};

inline const std::string one_system =
    "[reduced]\nformat = \"s12e8\"\n[system]\nlanes = 1\nreferences = 1\nprefix = \"\"\n";

/// The text of one of its sources; empty if it has none of this name.
inline std::string source(const components::Component& component, const std::string& name) {
  for (const characterise::SourceText& text : component.job().sources) {
    if (text.name == name) return text.text;
  }
  return "";
}

}  // namespace mixcmp::test
