#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "generator/software/program.hpp"
#include "model/golden/evaluate.hpp"
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
    filters_ = gen::float_filters(scene_);
  }

  const model::Scene& scene() const { return scene_; }
  const gen::FloatFilters& filters() const { return filters_; }

  model::Comparisons comparisons(model::Table table, bool pairs = false) const {
    const auto& inputs = scene_.graph.inputs();
    return pairs ? model::Comparisons::all_pairs(std::move(table), inputs).value()
                 : model::Comparisons::rows(std::move(table), inputs).value();
  }

  /// Compiles at the first call.
  std::vector<gen::KernelOutput> verdicts(const model::Comparisons& data) {
    if (!program_) program_ = compile(data);
    return program_->verdicts(data).value();
  }

private:
  model::Scene read(const SoftwareScene& text) const {
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
    return model::load_scene(path, {}).value();
  }

  gen::SoftwareProgram compile(const model::Comparisons& data) const {
    return gen::SoftwareProgram::compile(scene_, data, filters_, {.work = directory_.path()})
        .value();
  }

  ScratchDirectory directory_;
  model::Scene scene_;
  gen::FloatFilters filters_;
  std::optional<gen::SoftwareProgram> program_;
};

}  // namespace mixcmp::test
