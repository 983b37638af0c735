#pragma once

#include <span>
#include <string>
#include <vector>

#include "model/common/place.hpp"
#include "model/common/result.hpp"
#include "model/data/table.hpp"

namespace mixcmp::model {

/// What a scene calls columns of a file: one name for one column, or p for a list of them, which
/// are then p_0, p_1, ...
struct ColumnNames {
  std::string name;
  std::vector<std::string> columns;  ///< the file's
  bool is_list = false;
  std::string field;  ///< "data.columns.p", for errors
  Place place;
};

/// What the file calls each of `wanted`; a name that no one explains is the file's own. A list that
/// ends before the number that is wanted is an error, as is a name that nothing wanted has, and two
/// names of one that is.
Result<std::vector<std::string>> file_columns(std::span<const ColumnNames> names,
                                              std::span<const std::string> wanted);

/// What a reader says of a wanted column that its file, which has those of `known`, lacks.
Error missing_column(const std::string& column, std::span<const std::string> known);
bool is_missing_column(const Error& error);

/// The columns of `table` that it calls `columns`, in that order, under the names `wanted`.
Result<Table> select_columns(const Table& table, std::span<const std::string> columns,
                             std::span<const std::string> wanted);

}  // namespace mixcmp::model
