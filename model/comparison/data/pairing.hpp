#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "model/base/common/result.hpp"

namespace mixcmp::data {

/// Which rows are compared; the words of `data.pairs`.
enum class Pairing {
  rows,     ///< every row of one table is one comparison
  all,      ///< every two rows i < j of one table
  cross,    ///< every row i of one table with every row j of a second
  arg_min,  ///< finds the best row of a second table for each row of the first: see Comparisons
};
std::string_view to_string(Pairing pairing);

/// Whether there is a second table.
bool has_second_table(Pairing pairing);

/// The item of a comparison to which an input's number belongs.
enum class Item {
  row,     ///< the comparison's own row
  first,   ///< item i
  second,  ///< item j
};

struct ItemColumn {
  std::string name;
  bool second;
};
/// The column and the item of an input's name: "cxi" is column "cx" of the first item, "cj_2" (in
/// the scene cj[2]) is column "c_2" of the second. None for other names.
std::optional<ItemColumn> item_column(std::string_view input);

/// The table, the column and the item of an input's numbers.
struct InputColumn {
  std::size_t table;  ///< 0 for the first, 1 for the second
  std::string name;
  Item item;
};
Result<InputColumn> input_column(Pairing pairing, const std::string& input);

}  // namespace mixcmp::data
