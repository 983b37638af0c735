#pragma once

#include <string>
#include <vector>

#include "generator/hardware/emit/scheduled_system.hpp"

namespace mixcmp::emit {

/// A module and the facts that its header comment states.
struct Described {
  rtl::Module module;
  std::vector<std::string> facts;
};

/// The modules of a system, each once: lanes, references and their channels, then the top module,
/// then an arg-min engine if there is one. For a pairwise engine they are the conversion of items,
/// lanes and their segments, references and their channels, then the engine. Groups of the same
/// hardware share their modules.
std::vector<Described> describe_modules(const design::Design& design,
                                        const ScheduledSystem& scheduled);

}  // namespace mixcmp::emit
