#include "model/comparison/data/input_sources.hpp"

#include <fmt/core.h>

#include "model/base/common/check.hpp"

namespace mixcmp::data {
namespace {

std::string item_name(Pairing pairing, Item item) {
  const bool row = item == Item::row;
  const char letter = item == Item::first ? 'i' : 'j';
  switch (pairing) {
    case Pairing::rows: return {};
    case Pairing::all:
    case Pairing::cross: return fmt::format("item {}", letter);
    case Pairing::arg_min: return row ? "row" : fmt::format("candidate {}", letter);
  }
  MIXCMP_CHECK(false);
}

}  // namespace

std::string InputSource::shown() const {
  const std::string name = column.name.empty() ? "" : fmt::format(" \"{}\"", column.name);
  return fmt::format("column {}{} of {}{}{}", column.number, name, source, item.empty() ? "" : ", ",
                     item);
}

std::vector<InputSource> input_sources(const Comparisons& data,
                                       const std::vector<std::string>& inputs) {
  MIXCMP_CHECK(inputs.size() == data.input_count());
  std::vector<InputSource> sources;
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    const Comparisons::Source& place = data.sources()[k];
    const Table& table = data.tables()[place.table];
    if (table.origins.empty()) return {};
    sources.push_back({.input = inputs[k],
                       .column = table.origins[place.column],
                       .source = table.source,
                       .item = item_name(data.pairing(), place.item)});
  }
  return sources;
}

}  // namespace mixcmp::data
