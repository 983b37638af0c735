#pragma once

#include <span>
#include <string>
#include <vector>

#include "model/base/common/result.hpp"
#include "model/comparison/data/data_spec.hpp"
#include "model/comparison/data/table.hpp"

namespace mixcmp::data {

/// Reads or generates the tables that [data] names, one or two by its pairing, with the columns
/// that `inputs` need. Tables are in `format`. Numbers are rounded to it or, first, to the format
/// in floating point in which their input arrives: `arriving` has one per input, each held by
/// `format` and the same for all inputs of a column, or it is empty.
Result<std::vector<Table>> load_tables(const DataSpec& data, const std::vector<std::string>& inputs,
                                       FloatFormat format,
                                       std::span<const OperandFormat> arriving = {});

/// Places an error that has no file yet at the key that it names, or at [data]. An error about one
/// table also names that table.
Error with_place(const DataSpec& data, Error error);

}  // namespace mixcmp::data
