#pragma once

#include <string>

#include "generator/tasks/architecture_search.hpp"

namespace mixcmp::tasks {

/// Says what makes room for a system where none fits on the search's device, by predicted areas: no
/// slack, and the smallest larger device of the family. Both are tried. The search is on another
/// device afterwards.
std::string note_on_room(ArchitectureSearch& search, double slack);

}  // namespace mixcmp::tasks
