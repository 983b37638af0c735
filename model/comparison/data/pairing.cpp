#include "model/comparison/data/pairing.hpp"

#include <fmt/core.h>

#include "model/base/common/check.hpp"

namespace mixcmp::data {
namespace {

constexpr std::string_view digit_letters = "0123456789";

/// The subscripts at the end of a name: "_1_0" of "si_1_0".
std::string_view subscripts_of(std::string_view name) {
  std::size_t begin = name.size();
  while (true) {
    const std::size_t letter = name.substr(0, begin).find_last_not_of(digit_letters);
    const bool subscript =
        letter != std::string_view::npos && letter + 1 < begin && name[letter] == '_';
    if (!subscript) return name.substr(begin);
    begin = letter;
  }
}

}  // namespace

std::string_view to_string(Pairing pairing) {
  switch (pairing) {
    case Pairing::rows: return "rows";
    case Pairing::all: return "all";
    case Pairing::cross: return "cross";
    case Pairing::arg_min: return "arg_min";
  }
  MIXCMP_CHECK(false);
}

bool has_second_table(Pairing pairing) {
  return pairing == Pairing::cross || pairing == Pairing::arg_min;
}

std::optional<ItemColumn> item_column(std::string_view input) {
  const std::string_view subscripts = subscripts_of(input);
  const std::string_view base = input.substr(0, input.size() - subscripts.size());
  if (base.size() < 2 || (!base.ends_with('i') && !base.ends_with('j'))) return std::nullopt;
  return ItemColumn{.name = fmt::format("{}{}", base.substr(0, base.size() - 1), subscripts),
                    .second = base.ends_with('j')};
}

Result<InputColumn> input_column(Pairing pairing, const std::string& input) {
  const auto item = item_column(input);
  const std::size_t items_table = has_second_table(pairing) ? 1 : 0;
  switch (pairing) {
    case Pairing::rows: return InputColumn{.table = 0, .name = input, .item = Item::row};
    case Pairing::all:
    case Pairing::cross:
      if (!item) {
        return Error{.field = "data.pairs",
                     .message = "with pairs, inputs are columns of item i or item j",
                     .received = input,
                     .accepted = "a column's name followed by i or j, then subscripts"};
      }
      return InputColumn{.table = item->second ? items_table : 0,
                         .name = item->name,
                         .item = item->second ? Item::second : Item::first};
    case Pairing::arg_min:
      if (!item) return InputColumn{.table = 0, .name = input, .item = Item::row};
      return InputColumn{.table = items_table,
                         .name = item->name,
                         .item = item->second ? Item::second : Item::first};
  }
  MIXCMP_CHECK(false);
}

}  // namespace mixcmp::data
