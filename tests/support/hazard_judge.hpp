#pragma once

#include <span>
#include <string>

#include "model/lane/error/lane.hpp"

namespace mixcmp::test {

/// Holds the parts that a lane's hardware leaves out against the golden model's values of one
/// comparison. Returns an empty string, or the operation that met a hazard which had been ruled
/// out. Operands that fail a check, and all values that follow an exceptional operation, prove
/// nothing.
std::string broken_promise(const error::Lane& lane, std::span<const Bits> inputs);

}  // namespace mixcmp::test
