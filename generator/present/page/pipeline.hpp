#pragma once

#include <string>
#include <vector>

#include "generator/present/page/element.hpp"

namespace mixcmp::page {

enum class UnitRole {
  input,
  arithmetic,
  check,  ///< watches values; computes none that f and g depend on
  bound,  ///< computes the bound of an error
  decision,
};

/// One box of a pipeline: the work of a hardware unit, and its cycles.
struct PipelineUnit {
  std::string title;
  std::string detail;
  std::string tip;  ///< shown where a reader points at the box
  UnitRole role = UnitRole::arithmetic;
  int start_cycle = 0;        ///< in which operands are read
  int ready_cycle = 0;        ///< in which the result is there; equal to `start_cycle` for wires
  std::vector<int> operands;  ///< indices of units before this one
};

/// A pipeline whose units start when their operands are ready, or later: the operands are then
/// delayed. Time runs downwards.
struct Pipeline {
  std::string title;  ///< describes the picture to readers who cannot see it
  std::vector<PipelineUnit> units;
  int cycles = 0;  ///< from the operands to the result
};

Element draw(const Pipeline& pipeline);

}  // namespace mixcmp::page
