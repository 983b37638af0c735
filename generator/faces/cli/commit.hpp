#pragma once

namespace mixcmp::cli {

/// The commit that the program was built from: "8e977b4c...", ", modified" behind it where the
/// sources differed from that commit, or "unknown". cmake/commit.cmake writes the definition.
const char* commit();

}  // namespace mixcmp::cli
