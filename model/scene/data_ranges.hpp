#pragma once

#include <span>

#include "model/scene/input_ranges.hpp"

namespace mixcmp::scene {

/// Gives each input that is declared with range = "data" the least and the greatest finite number
/// of its column, the smallest range that contains the data. `arriving`: the format of each
/// input. `data` may be null, for a scene without [data]; errors name the declaration.
Result<Done> take_ranges_from_data(const data::DataSpec* data,
                                   const std::vector<std::string>& inputs, FloatFormat format,
                                   std::span<const OperandFormat> arriving,
                                   InputDeclarations& declared);

/// Gives data with items = "uniform" the inputs' ranges and grids, from which they are drawn.
/// Error: an input without a range of its own.
Result<Done> draw_from_ranges(const settings::Settings& settings,
                              const std::vector<std::string>& inputs,
                              const InputDeclarations& declared, data::DataSpec& data);

}  // namespace mixcmp::scene
