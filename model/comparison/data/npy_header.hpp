#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/common/result.hpp"

namespace mixcmp::data {

/// One number of an array: NumPy's "<f8", ">i4", "|u1", ...
struct NpyScalar {
  bool big_endian;
  char kind;  ///< 'f', 'i' or 'u'
  int bytes;
};

struct NpyField {
  std::string name;  ///< empty in plain arrays
  /// None for an unsupported type; `type` names it.
  std::optional<NpyScalar> scalar;
  std::string type;
  std::size_t bytes;   ///< size of the field, even if `scalar` is none
  std::size_t offset;  ///< bytes before it in its row of a structured array
};

struct NpyHeader {
  bool structured = false;
  std::vector<NpyField> fields;  ///< a single nameless one in plain arrays
  bool fortran_order = false;
  std::vector<std::uint64_t> shape;
  std::size_t data_offset = 0;  ///< where the numbers begin in the file
};

Result<NpyHeader> parse_npy_header(std::string_view file);

}  // namespace mixcmp::data
