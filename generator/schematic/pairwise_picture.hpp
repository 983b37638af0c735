#pragma once

#include "generator/emit/signature.hpp"
#include "generator/page/element.hpp"

namespace mixcmp::schematic {

/// The block diagram of a pairwise engine: items, the walk through its lanes, what they report, and
/// the references that read items again.
page::Element pairwise_picture(const emit::Signature& signature);

}  // namespace mixcmp::schematic
