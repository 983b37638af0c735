#include "generator/rtl/engine_module.hpp"

#include <algorithm>

#include "generator/rtl/pairwise_module.hpp"
#include "model/common/check.hpp"
#include "model/data/pairing.hpp"

namespace mixcmp::gen {

std::optional<EngineShape> engine_shape(const SystemShape& system,
                                        const std::vector<std::string>& inputs,
                                        const model::EngineSpec& spec) {
  if (spec.kind == model::EngineKind::none) return std::nullopt;
  EngineShape engine{.top = system.top + "_" + std::string(to_string(spec.kind)),
                     .spec = spec,
                     .columns = {},
                     .sources = {},
                     .column_width = system.input_width};
  for (const std::string& input : inputs) {
    const auto item = model::item_column(input);
    MIXCMP_CHECK(item.has_value());
    const auto known = std::find(engine.columns.begin(), engine.columns.end(), item->name);
    engine.sources.push_back(
        {static_cast<std::size_t>(known - engine.columns.begin()), item->second});
    if (known == engine.columns.end()) engine.columns.push_back(item->name);
  }
  return engine;
}

rtl::Module engine_module(const EngineShape& engine, const SystemShape& system) {
  switch (engine.spec.kind) {
    case model::EngineKind::none: break;
    case model::EngineKind::pairwise: return pairwise_module(engine, system);
  }
  MIXCMP_CHECK(false);
}

}  // namespace mixcmp::gen
