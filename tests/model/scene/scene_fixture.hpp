#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include "model/scene/scene.hpp"
#include "tests/support/scratch_directory.hpp"

namespace mixcmp::test {

inline const std::string sphere_scene = R"([comparison]
name = "sphere_collision"
f = "(cxi - cxj)^2 + (cyi - cyj)^2 + (czi - czj)^2"
g = "(ri + rj)^2"

[inputs]
"c*" = { range = [0, 100] }
"r*" = { range = [0, 0.1] }

[reference]
format = "s53e8"

[reduced]
format = "s17e8"
bound = "profiled"
inputs = "rounded"
relative_error_f = 1e-4

[system]
device = "virtex5-lx330t"
lanes = 87
references = "auto"
slack = 0.25
order = "in_order"

[data]
items = "uniform_spheres"
count = 512
radius_max = 25
seed = 7
pairs = "all"
)";

/// Loads scenes from text, each from the same file.
class SceneTest : public testing::Test {
protected:
  Result<scene::Scene> load(const std::string& text,
                            const std::vector<std::string>& overrides = {}) {
    std::filesystem::remove(path_);  // truncating a file in place waits for the disk
    std::ofstream(path_, std::ios::binary) << text;
    return scene::load_scene(path_, overrides);
  }

  /// The sphere scene with its first occurrence of `from` replaced by `to`.
  Result<scene::Scene> load_changed(const std::string& from, const std::string& to) {
    std::string text = sphere_scene;
    const std::size_t place = text.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    return load(text.replace(place, from.size(), to));
  }

  test::ScratchDirectory directory_;
  std::filesystem::path path_ = directory_.path() / "scene.toml";
};

}  // namespace mixcmp::test
