#include "generator/tasks/generate.hpp"

#include <utility>

#include "generator/tasks/simulations.hpp"

namespace mixcmp::tasks {

Result<BuiltSystem> build_system(const SceneRequest& request, const LoadedScene& loaded) {
  MIXCMP_TRY(design, design_of(request, loaded));
  auto generated = emit::generate_system(design, origin("generate", request));
  if (!generated.ok()) return located(generated.error(), request);
  return BuiltSystem{std::move(design), std::move(generated).value()};
}

Result<BuiltSystem> generate(const SceneRequest& request, const LoadedScene& loaded) {
  MIXCMP_TRY(built, build_system(request, loaded));
  emit::set_simulations(built.generated, simulations_of(built.generated.signature.spec_hash));
  return built;
}

}  // namespace mixcmp::tasks
