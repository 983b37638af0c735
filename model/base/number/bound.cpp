#include "model/base/number/bound.hpp"

#include <fmt/core.h>

#include <array>

#include "model/base/common/check.hpp"

namespace mixcmp::inline number {
namespace {

constexpr std::array fixed_kinds = {BoundKind::norm, BoundKind::constant, BoundKind::running};

std::string_view prefix(NumberSystem system) {
  switch (system) {
    case NumberSystem::floating: return "";
    case NumberSystem::fixed: return "fixed_";
    case NumberSystem::block: return "block_";
  }
  MIXCMP_CHECK(false);
}

std::string name_without_digits(const Bound& bound) {
  return fmt::format("{}{}", prefix(bound.system), to_string(bound.kind));
}

}  // namespace

std::string_view to_string(BoundKind kind) {
  switch (kind) {
    case BoundKind::relative: return "relative";
    case BoundKind::running: return "running";
    case BoundKind::constant: return "constant";
    case BoundKind::norm: return "norm";
    case BoundKind::grid: return "grid";
    case BoundKind::profiled: return "profiled";
  }
  MIXCMP_CHECK(false);
}

FixedPoint Bound::fixed_point(int bits) const {
  return {.bits = bits, .is_block = system == NumberSystem::block, .guard_digits = digits};
}

bool Bound::is_for(const LaneFormat& format) const {
  if (!format.fixed_point) return !is_fixed_point();
  return is_fixed_point() && fixed_point(format.fixed_point->bits) == *format.fixed_point;
}

std::strong_ordering operator<=>(const Bound& a, const Bound& b) {
  const std::strong_ordering names = name_without_digits(a) <=> name_without_digits(b);
  return names != 0 ? names : a.digits <=> b.digits;
}

std::string to_string(const Bound& bound) {
  const std::string name = name_without_digits(bound);
  if (!bound.is_fixed_point() && bound.kind == BoundKind::running) {
    return fmt::format("{}_{}", name, bound.digits);
  }
  return bound.digits == 0 ? name : fmt::format("{}_g{}", name, bound.digits);
}

std::string to_string(const std::optional<Bound>& bound) {
  return bound ? to_string(*bound) : "";
}

std::vector<Bound> bounds_of(const FixedPoint& format) {
  const NumberSystem system = format.is_block ? NumberSystem::block : NumberSystem::fixed;
  std::vector<Bound> bounds;
  for (const BoundKind kind : fixed_kinds) bounds.push_back({system, kind, format.guard_digits});
  if (format.is_plain()) bounds.push_back(grid_bound);
  return bounds;
}

std::span<const Bound> counted_bounds() {
  using enum NumberSystem;
  using enum BoundKind;
  static constexpr std::array<Bound, 9> bounds = {{{floating, relative},
                                                   {floating, running, 4},
                                                   {floating, running, 1},
                                                   {floating, constant},
                                                   {floating, profiled},
                                                   {fixed, norm},
                                                   {fixed, constant},
                                                   {block, norm},
                                                   {block, constant}}};
  return bounds;
}

}  // namespace mixcmp::inline number
