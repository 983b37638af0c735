#pragma once

#include "generator/emit/signature.hpp"
#include "generator/page/element.hpp"

namespace mixcmp::schematic {

/// The block diagram of a generated system: its lanes, the crossbar and its references, with the
/// system's own numbers. Lanes of one kind share a box; an engine is left out.
page::Element system_picture(const emit::Signature& signature);

}  // namespace mixcmp::schematic
