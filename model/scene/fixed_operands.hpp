#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/base/settings/settings.hpp"
#include "model/scene/scene.hpp"

namespace mixcmp::scene {

/// Checks the formats in which operands arrive, one per input: the reference format must hold their
/// numbers, and a column of the data has one format in floating point. Errors name the setting.
Result<Done> check_operand_formats(const settings::Settings& settings,
                                   const std::vector<std::string>& inputs,
                                   std::span<const OperandFormat> formats, FloatFormat reference,
                                   const std::optional<data::DataSpec>& data);

/// Checks that systems of the scene can take its operands. If some of them are in fixed point,
/// lanes are in fixed point as well. References in fixed point are not folded. The inputs of one
/// column of an engine's items have one format. Errors name the setting.
Result<Done> check_fixed_operands(const settings::Settings& settings, const Scene& scene);

}  // namespace mixcmp::scene
