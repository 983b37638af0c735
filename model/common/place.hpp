#pragma once

#include <string>

namespace mixcmp::model {

/// Where something stands that was read: a scene's file, a plan's, or "--set" without a line.
struct Place {
  std::string file;
  int line = 0;
};

}  // namespace mixcmp::model
