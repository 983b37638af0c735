#pragma once

#include <string_view>

namespace mixcmp::inline common {

/// A source text compiled into the program (cmake/embed.cmake).
struct EmbeddedFile {
  std::string_view name;  ///< without folders
  std::string_view text;
};

}  // namespace mixcmp::inline common
