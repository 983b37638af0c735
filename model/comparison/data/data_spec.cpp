#include "model/comparison/data/data_spec.hpp"

namespace mixcmp::data {

std::string table_name(const DataSpec& data, std::size_t which) {
  const std::filesystem::path& file = which == 0 ? data.file : data.with;
  return file.empty() ? data.items : file.filename().string();
}

}  // namespace mixcmp::data
