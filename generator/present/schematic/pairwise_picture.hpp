#pragma once

#include "generator/hardware/emit/signature.hpp"
#include "generator/present/page/element.hpp"

namespace mixcmp::schematic {

/// The block diagram of a pairwise engine: items, their way through its lanes, the reports, and the
/// references that read items again.
page::Element pairwise_picture(const emit::Signature& signature);

}  // namespace mixcmp::schematic
