#pragma once

#include "model/scene/input_ranges.hpp"

namespace mixcmp::scene {

/// Gives each input that is declared with range = "data" the least and the greatest finite number
/// of its column, the smallest range that contains the data. `data` may be null, for a scene
/// without [data]; errors name the declaration.
Result<Done> take_ranges_from_data(const data::DataSpec* data,
                                   const std::vector<std::string>& inputs, FloatFormat format,
                                   InputDeclarations& declared);

}  // namespace mixcmp::scene
