#pragma once

#include <stdlib.h>

#include <filesystem>

#include "model/common/check.hpp"

namespace mixcmp::cli {

/// A folder of our own that ends with us.
class Scratch {
public:
  Scratch() {
    std::string name = (std::filesystem::temp_directory_path() / "mixcmp.XXXXXX").string();
    MIXCMP_CHECK(mkdtemp(name.data()) != nullptr);
    path_ = name;
  }
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  const std::filesystem::path& path() const { return path_; }

private:
  std::filesystem::path path_;
};

}  // namespace mixcmp::cli
