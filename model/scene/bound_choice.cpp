#include "model/scene/bound_choice.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "model/common/nearest.hpp"
#include "model/common/quote.hpp"
#include "model/settings/limits.hpp"

namespace mixcmp::scene {
namespace {

using Kind = BoundChoice::Kind;

constexpr std::string_view running_prefix = "running_", guard_infix = "_g";

constexpr std::array fixed_kinds = {Kind::fixed_norm, Kind::fixed_constant, Kind::fixed_running,
                                    Kind::block_norm, Kind::block_constant, Kind::block_running};

std::string_view word(Kind kind) {
  switch (kind) {
    case Kind::block_constant: return "block_constant";
    case Kind::block_norm: return "block_norm";
    case Kind::block_running: return "block_running";
    case Kind::constant: return "constant";
    case Kind::fixed_constant: return "fixed_constant";
    case Kind::fixed_norm: return "fixed_norm";
    case Kind::fixed_running: return "fixed_running";
    case Kind::profiled: return "profiled";
    case Kind::relative: return "relative";
    case Kind::running: return "running";
  }
  MIXCMP_CHECK(false);
}

std::vector<BoundChoice> all_choices() {
  std::vector<BoundChoice> choices = {{Kind::constant}, {Kind::profiled}, {Kind::relative}};
  constexpr settings::Limits digits = settings::limits::bound_digits;
  for (int count = digits.least; count <= digits.most; ++count) {
    choices.push_back({Kind::running, count});
  }
  for (const Kind kind : fixed_kinds) {
    for (int count = 0; count < settings::limits::fixed_bits.most; ++count) {
      choices.push_back({kind, count});
    }
  }
  return choices;
}

}  // namespace

FixedPoint BoundChoice::fixed_point(int bits) const {
  return {.bits = bits, .is_block = is_block(), .guard_digits = digits};
}

bool BoundChoice::is_for(const LaneFormat& format) const {
  if (!format.fixed_point) return !is_fixed_point();
  return is_fixed_point() && fixed_point(format.fixed_point->bits) == *format.fixed_point;
}

std::string to_string(const BoundChoice& choice) {
  const std::string name(word(choice.kind));
  if (choice.kind == Kind::running) return fmt::format("{}{}", running_prefix, choice.digits);
  return choice.digits == 0 ? name : fmt::format("{}{}{}", name, guard_infix, choice.digits);
}

std::string to_string(const std::optional<BoundChoice>& choice) {
  return choice ? to_string(*choice) : "";
}

Result<BoundChoice> parse_bound_choice(std::string_view name) {
  for (const BoundChoice& choice : all_choices()) {
    if (to_string(choice) == name) return choice;
  }
  std::vector<std::string> names;
  for (const BoundChoice& choice : all_choices()) names.push_back(to_string(choice));
  const std::string likely = nearest(name, names);
  return Error{
      .message = "not a bound",
      .received = in_quotes(name),
      .accepted = (likely.empty() ? "" : likely + " (the nearest); ") + bound_choice_names()};
}

std::string bound_choice_names() {
  constexpr settings::Limits digits = settings::limits::bound_digits;
  return fmt::format(
      "relative, running_{} to running_{}, constant, profiled, fixed_norm, fixed_constant, "
      "fixed_running, block_norm, block_constant, block_running, each of the last six also with G "
      "guard digits as fixed_norm_gG",
      digits.least, digits.most);
}

BoundChoice bound_choice(const error::LanePart& part) {
  if (!part.certified()) return {Kind::profiled};
  const auto* absolute = std::get_if<error::AbsoluteBoundCriterion>(&part.criterion);
  if (absolute == nullptr) return {Kind::relative};
  if (absolute->bound.nodes.back().operation == error::BoundOperation::constant)
    return {Kind::constant};
  return {Kind::running, absolute->bound.format.precision};
}

std::optional<BoundChoice> bound_choice(const error::Lane& lane) {
  const BoundChoice first = bound_choice(lane.parts.front());
  const bool all_alike =
      std::all_of(lane.parts.begin(), lane.parts.end(),
                  [&](const error::LanePart& part) { return bound_choice(part) == first; });
  return all_alike ? std::optional(first) : std::nullopt;
}

BoundChoice bound_choice(const fixed::FixedLane& lane) {
  const bool is_block = lane.format.is_block;
  const Kind kind = has_norm(lane)      ? is_block ? Kind::block_norm : Kind::fixed_norm
                    : has_running(lane) ? is_block ? Kind::block_running : Kind::fixed_running
                    : is_block          ? Kind::block_constant
                                        : Kind::fixed_constant;
  return {kind, lane.format.guard_digits};
}

BoundChoice bound_choice(const error::CandidateLane& candidate) {
  switch (candidate.kind) {
    case error::ErrorBoundKind::relative: return {Kind::relative};
    case error::ErrorBoundKind::running: return {Kind::running, candidate.bound_digits};
    case error::ErrorBoundKind::constant: return {Kind::constant};
    case error::ErrorBoundKind::norm: break;
  }
  MIXCMP_CHECK(false);
}

std::vector<BoundChoice> fixed_bound_choices(const FixedPoint& format) {
  std::vector<BoundChoice> choices;
  for (const Kind kind : fixed_kinds) {
    const BoundChoice choice{kind, format.guard_digits};
    if (choice.is_block() == format.is_block) choices.push_back(choice);
  }
  return choices;
}

std::span<const BoundChoice> counted_bound_choices() {
  static constexpr std::array<BoundChoice, 9> choices = {{{Kind::relative},
                                                          {Kind::running, 4},
                                                          {Kind::running, 1},
                                                          {Kind::constant},
                                                          {Kind::profiled},
                                                          {Kind::fixed_norm},
                                                          {Kind::fixed_constant},
                                                          {Kind::block_norm},
                                                          {Kind::block_constant}}};
  return choices;
}

ReducedSpec with_bound(const ReducedSpec& reduced, const BoundChoice& choice) {
  ReducedSpec copy = reduced;
  copy.bound = BoundKind::certified;
  if (!choice.is_fixed_point()) {
    copy.fixed_point.reset();
  } else if (copy.fixed_point || copy.format) {
    const int bits = copy.format ? copy.format->precision() : copy.fixed_point->bits;
    copy.fixed_point = choice.fixed_point(bits);
  }
  switch (choice.kind) {
    case Kind::block_constant:
    case Kind::fixed_constant:
    case Kind::constant: copy.error_bound = error::ErrorBoundKind::constant; break;
    case Kind::block_norm:
    case Kind::fixed_norm: copy.error_bound = error::ErrorBoundKind::norm; break;
    case Kind::block_running:
    case Kind::fixed_running: copy.error_bound = error::ErrorBoundKind::running; break;
    case Kind::relative: copy.error_bound = error::ErrorBoundKind::relative; break;
    case Kind::running:
      copy.error_bound = error::ErrorBoundKind::running;
      copy.bound_digits = choice.digits;
      break;
    case Kind::profiled:
      copy.bound = BoundKind::profiled;
      copy.error_bound.reset();
      break;
  }
  return copy;
}

}  // namespace mixcmp::scene
