#include "model/design/request_beats.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace mixcmp::design {
namespace {

constexpr int beat_interval_cycles = 2;
constexpr int most_auto_beats = 8;
/// A beat has the operands and some 12 bits more, the numbers of lane and slot.
constexpr int fewest_auto_bits = 16;

}  // namespace

int arrival_cycles(int request_beats) {
  return request_beats == 1 ? 1 : beat_interval_cycles * request_beats;
}

int planned_service_cycles(int initiation_interval, int request_beats) {
  return std::max(initiation_interval, arrival_cycles(request_beats));
}

int request_beats(const scene::SystemSpec& system, int operand_bits, int initiation_interval) {
  if (system.operands != scene::OperandStore::carried) return 1;
  if (system.request_beats) return *system.request_beats;
  if (system.operand_memory != scene::OperandMemory::block) return 1;
  int beats = 1;
  while (beats < most_auto_beats && arrival_cycles(2 * beats) <= initiation_interval &&
         operand_bits / (2 * beats) >= fewest_auto_bits) {
    beats *= 2;
  }
  return beats;
}

Result<Done> check_request_beats(const scene::SystemSpec& system, int initiation_interval) {
  const int beats = system.request_beats.value_or(1);
  if (beats == 1) return Done{};
  const std::string received = fmt::format("{}", beats);
  if (system.operands != scene::OperandStore::carried) {
    return Error{.field = "system.request_beats",
                 .message = "operands that are not carried need no beats",
                 .received = received,
                 .accepted = "1, or operands = \"carried\""};
  }
  if (initiation_interval > 1 && arrival_cycles(beats) > initiation_interval) {
    return Error{.field = "system.request_beats",
                 .message = "a request takes longer than a folded reference",
                 .received = received,
                 .accepted = fmt::format("at most half of reference.initiation_interval = {}",
                                         initiation_interval)};
  }
  return Done{};
}

}  // namespace mixcmp::design
