#pragma once

#include <string>

namespace mixcmp::inline common {

/// The place of something that was read: the file of a scene or a plan and the line in it, or
/// "--set" without a line.
struct Place {
  std::string file;
  int line = 0;
};

}  // namespace mixcmp::inline common
