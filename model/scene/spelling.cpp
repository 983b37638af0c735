#include "model/scene/scene.hpp"

namespace mixcmp::scene {

std::string_view ReducedSpec::bound_word() const {
  return is_profiled ? "profiled" : "certified";
}

std::string_view ReducedSpec::error_bound_word() const {
  return error_bound ? to_string(*error_bound) : "auto";
}

std::string_view to_string(ResultOrder order) {
  switch (order) {
    case ResultOrder::tagged: return "tagged";
    case ResultOrder::in_order: return "in_order";
  }
  MIXCMP_CHECK(false);
}

std::string_view to_string(OperandStore store) {
  switch (store) {
    case OperandStore::carried: return "carried";
    case OperandStore::refetched: return "refetched";
  }
  MIXCMP_CHECK(false);
}

std::string_view to_string(OperandMemory memory) {
  switch (memory) {
    case OperandMemory::logic: return "logic";
    case OperandMemory::block: return "block";
  }
  MIXCMP_CHECK(false);
}

std::string_view to_string(CounterAccess access) {
  switch (access) {
    case CounterAccess::none: return "none";
    case CounterAccess::ports: return "ports";
    case CounterAccess::axi_lite: return "axi_lite";
  }
  MIXCMP_CHECK(false);
}

std::string_view to_string(Multipliers multipliers) {
  switch (multipliers) {
    case Multipliers::embedded: return "embedded";
    case Multipliers::logic: return "logic";
    case Multipliers::memory: return "memory";
  }
  MIXCMP_CHECK(false);
}

std::string_view to_string(const std::optional<Multipliers>& multipliers) {
  return multipliers ? to_string(*multipliers) : std::string_view();
}

}  // namespace mixcmp::scene
