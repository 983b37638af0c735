#pragma once

#include <span>
#include <string>

#include "model/error/lane.hpp"

namespace mixcmp::test {

/// Holds what a lane's hardware leaves out against the golden model's values of one comparison:
/// empty, or which operation met what had been ruled out of it. Operands that fail a check, and
/// whatever follows an exceptional operation, prove nothing.
std::string broken_promise(const error::Lane& lane, std::span<const Bits> inputs);

}  // namespace mixcmp::test
