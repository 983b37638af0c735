#pragma once

#include <vector>

#include "model/judge/emulator/code.hpp"

namespace mixcmp::emulator {

/// Adds the lane's criterion to `code`, which was compiled from the lane's graph. False if double
/// cannot reproduce it.
bool add_criterion(Code& code, const error::Lane& lane);

/// The nodes whose encodings the criterion or its bound reads. The encoding of a subnormal number
/// (which a constant may be) does not follow from its double.
std::vector<NodeId> values_as_encodings(const error::Lane& lane);

}  // namespace mixcmp::emulator
