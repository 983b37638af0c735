#include "model/design/engine_data.hpp"

#include <fmt/core.h>

#include <cstdint>

#include "model/base/common/check.hpp"

namespace mixcmp::design {
namespace {

Result<Done> check_items(int capacity, const data::Comparisons& data) {
  std::uint64_t items = 0;
  for (const data::Table& table : data.tables()) items += table.rows();
  if (items <= static_cast<std::uint64_t>(capacity)) return Done{};
  return Error{.field = "engine.capacity",
               .message = "the data have more items than the engine holds",
               .received = fmt::format("{} items, a capacity of {}", items, capacity),
               .accepted = fmt::format("a capacity of at least {}, at most {}", items,
                                       scene::EngineSpec::max_capacity)};
}

Result<Done> check_candidates(int lanes, const data::Comparisons& data) {
  MIXCMP_CHECK(data.pairing() == data::Pairing::arg_min);  // load_scene refuses other pairings
  const std::uint64_t candidates = data.tables()[1].rows();
  if (candidates <= static_cast<std::uint64_t>(lanes) + 1) return Done{};
  return Error{
      .field = "system.lanes",
      .message = "the data have more candidates than the engine",
      .received = fmt::format("{} candidates, {} lanes", candidates, lanes),
      .accepted = fmt::format("{} lanes, one for each candidate but the first", candidates - 1)};
}

}  // namespace

Result<Done> check_engine_data(const scene::EngineSpec& engine, int lanes,
                               const data::Comparisons& data) {
  switch (engine.kind) {
    case scene::EngineKind::none: return Done{};
    case scene::EngineKind::pairwise: return check_items(engine.capacity, data);
    case scene::EngineKind::arg_min: return check_candidates(lanes, data);
  }
  MIXCMP_CHECK(false);
}

}  // namespace mixcmp::design
