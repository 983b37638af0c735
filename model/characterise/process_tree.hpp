#pragma once

#include <sys/types.h>

namespace mixcmp::model {

/// Ends a child and everything that it has started, in whatever process groups (`timeout` makes one
/// of its own). The child is left to be waited for. Knows processes as /proc lists them.
void end_process_tree(pid_t root);

}  // namespace mixcmp::model
