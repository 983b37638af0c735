#include "model/comparison/data/data_spec.hpp"

namespace mixcmp::data {

std::string table_name(const DataSpec& data, std::size_t which) {
  if (which == 1) return data.with.filename().string();
  return data.file.empty() ? data.items : data.file.filename().string();
}

}  // namespace mixcmp::data
