#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "generator/software/program.hpp"
#include "model/judge/golden/evaluate.hpp"
#include "tests/support/scratch_directory.hpp"

namespace mixcmp::test {

/// A comparison on doubles as a scene file declares it.
struct SoftwareScene {
  std::string f, g;         ///< with `combine` the elements of lists: "a", "b"
  std::string inputs = "";  ///< lines of [inputs]
  bool pairs = false;
  std::string combine = "";
};

/// The compiled comparison with a folder of its own.
class CompiledSoftware {
public:
  explicit CompiledSoftware(const SoftwareScene& text) : scene_(read(text)) {
    filters_ = software::float_filters(scene_);
  }

  const scene::Scene& scene() const { return scene_; }
  const software::FloatFilters& filters() const { return filters_; }

  data::Comparisons comparisons(data::Table table, bool pairs = false) const {
    const auto& inputs = scene_.graph.inputs();
    return pairs ? data::Comparisons::all_pairs(std::move(table), inputs).value()
                 : data::Comparisons::rows(std::move(table), inputs).value();
  }

  /// Compiles at the first call.
  std::vector<software::KernelOutput> verdicts(const data::Comparisons& data) {
    if (!program_) program_ = compile(data);
    return program_->verdicts(data).value();
  }

private:
  scene::Scene read(const SoftwareScene& text) const {
    const auto path = directory_.path() / "scene.toml";
    const auto quoted = [&](const std::string& side) {
      return text.combine.empty() ? "\"" + side + "\"" : "[" + side + "]";
    };
    std::ofstream scene(path);
    scene << "[comparison]\nname = \"scene\"\nf = " << quoted(text.f) << "\ng = " << quoted(text.g)
          << "\n";
    if (!text.combine.empty()) scene << "combine = \"" << text.combine << "\"\n";
    scene << "[reference]\nformat = \"binary64\"\n[inputs]\n" << text.inputs;
    scene.close();
    return scene::load_scene(path, {}).value();
  }

  software::SoftwareProgram compile(const data::Comparisons& data) const {
    return software::SoftwareProgram::compile(scene_, data, filters_, {.work = directory_.path()})
        .value();
  }

  ScratchDirectory directory_;
  scene::Scene scene_;
  software::FloatFilters filters_;
  std::optional<software::SoftwareProgram> program_;
};

}  // namespace mixcmp::test
