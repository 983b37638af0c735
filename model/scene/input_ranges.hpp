#pragma once

#include "model/base/number/operand_format.hpp"
#include "model/base/settings/settings.hpp"
#include "model/scene/scene.hpp"

namespace mixcmp::scene {

/// The declarations of [inputs], one entry per input in the order of `inputs`.
struct InputDeclarations {
  std::vector<std::optional<Range>> ranges;
  std::vector<std::optional<mpq_class>> grids;  ///< powers of two; an input with a grid has a range
  /// The formats that inputs have of their own; none: the reference's. Range and grid of one in
  /// fixed point follow from it.
  std::vector<std::optional<OperandFormat>> formats;
  /// The entries with range = "data", whose inputs have no range yet; null for other inputs. They
  /// live as long as the settings.
  std::vector<const settings::Setting*> from_data;
};

/// Reads [inputs]. In a pattern, '*' stands for any characters; an exact key has priority over
/// patterns. A key that matches nothing, and two patterns that match the same input, are errors.
Result<InputDeclarations> read_inputs(const settings::Settings& settings,
                                      const std::vector<std::string>& inputs);

/// Whether `name` matches `pattern`.
bool matches(std::string_view pattern, std::string_view name);

}  // namespace mixcmp::scene
