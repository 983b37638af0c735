#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "model/base/common/place.hpp"
#include "model/base/common/result.hpp"
#include "model/comparison/data/table.hpp"

namespace mixcmp::data {

/// A column of a file: its name, or its number, counted from 0 as in NumPy.
using ColumnKey = std::variant<std::string, std::uint64_t>;

/// The scene's name for one column of a file, or its name p for a list of columns, which are then
/// called p_0, p_1, ...
struct ColumnNames {
  std::string name;
  std::vector<ColumnKey> columns;  ///< the file's columns
  bool is_list = false;
  std::string field;  ///< "data.columns.p", for errors
  Place place;
};

/// A column that inputs need.
struct WantedColumn {
  std::string name;        ///< the scene's name, which the column has in a Table
  ColumnKey column;        ///< the file's column
  std::string field = {};  ///< the scene's key for it; empty: the file's name is `name` as well
  Place place = {};        ///< place of that key
  /// The format to which its numbers are rounded before they are encoded in the table's, which
  /// holds them; none: the table's.
  std::optional<FloatFormat> rounded_to = {};
};

/// Finds the file's column for each of `wanted`. A column without an entry in `names` keeps the
/// file's name. Errors: a list that is too short, an entry that no input needs, two entries for one
/// column.
Result<std::vector<WantedColumn>> file_columns(std::span<const ColumnNames> names,
                                               std::span<const std::string> wanted);

/// Wanted columns whose names in the scene are the names in the file.
std::vector<WantedColumn> columns_by_name(std::span<const std::string> names);

/// The index of `wanted` among the columns of `source`, whose names are `known`.
Result<std::size_t> find_column(const WantedColumn& wanted, std::span<const std::string> known,
                                const std::string& source);

/// Returns `number` as an index; an error if `source` has only `count` <= `number` columns.
Result<std::size_t> numbered_column(const WantedColumn& wanted, std::uint64_t number,
                                    std::uint64_t count, const std::string& source);

/// An error in the scene's key; it says which column `wanted` is.
Error column_mistake(const WantedColumn& wanted, std::string message, std::string received,
                     std::string accepted);

/// The error, of the kind missing_column, for a wanted column that a file lacks. `known` are the
/// file's columns.
Error missing_column(const std::string& column, std::span<const std::string> known);

/// The error, of the kind unnamed_columns, for a file of `columns` columns without names if the
/// scene gives no numbers. load_tables adds the key's file and line.
Error unnamed_columns(std::span<const WantedColumn> wanted, std::uint64_t columns);

/// The wanted columns of `table`, in their order, under the scene's names.
Result<Table> select_columns(const Table& table, std::span<const WantedColumn> wanted);

}  // namespace mixcmp::data
