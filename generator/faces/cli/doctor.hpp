#pragma once

#include <string>
#include <vector>

#include "model/base/common/result.hpp"

namespace mixcmp::cli {

/// A tool that verbs start, as it was found on this machine.
struct FoundTool {
  std::string name;
  Result<std::string> version;  ///< an error says why the tool is unusable
  std::string package;          ///< the Debian package
  std::string disables;         ///< the functions that are missing without it
  bool required = true;         ///< a verb needs it
};

/// Asks every tool for its version, one after the other.
std::vector<FoundTool> find_tools();

}  // namespace mixcmp::cli
