#pragma once

#include "generator/hardware/emit/signature.hpp"
#include "generator/present/page/element.hpp"

namespace mixcmp::schematic {

/// The block diagram of a generated system: its lanes, the crossbar and its references, with the
/// system's own numbers. Lanes of one kind share a box, and so do the groups that they form. A
/// pairwise engine is drawn as such, an arg-min engine by the system inside it.
page::Element system_picture(const emit::Signature& signature);

}  // namespace mixcmp::schematic
