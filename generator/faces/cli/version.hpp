#pragma once

#include <string>

namespace mixcmp::cli {

/// How much `mixcmp --version` prints.
enum class VersionDetail {
  line,  ///< "mixcmp 0.1.0 (commit 8e977b4c...)"
  full,  ///< also compiler, libraries and tools, which takes a second: tools are started
};

std::string version_text(VersionDetail detail);
/// The full detail as JSON.
std::string version_json();

}  // namespace mixcmp::cli
