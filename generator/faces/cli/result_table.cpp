#include "generator/faces/cli/result_table.hpp"

#include <fmt/core.h>

namespace mixcmp::cli {
namespace {

namespace fs = std::filesystem;

/// A CSV field by RFC 4180: text with a comma, a quote or a line end is quoted, its quotes doubled.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

/// An item of a comparison, and the name of its column in the CSV.
struct NamedItem {
  const char* name;
  data::Item item;
  const data::Table* table;
};

/// The items that each line of the CSV names; none where comparisons are rows, since then the index
/// names the row.
std::vector<NamedItem> named_items(const data::Comparisons& data) {
  const auto& tables = data.tables();
  const NamedItem row = {"row", data::Item::row, &tables.front()};
  const NamedItem i = {"i", data::Item::first, &tables.front()};
  const NamedItem j = {"j", data::Item::second, &tables.back()};
  switch (data.pairing()) {
    case data::Pairing::rows: return {};
    case data::Pairing::all:
    case data::Pairing::cross: return {i, j};
    case data::Pairing::arg_min: return {row, {"i", data::Item::first, &tables.back()}, j};
  }
  MIXCMP_CHECK(false);
}

}  // namespace

Result<ResultTable> ResultTable::open(const fs::path& path, const data::Comparisons& data,
                                      std::set<std::string> kept) {
  MIXCMP_TRY(file, OutputFile::open(path));
  std::string header = "index";
  const std::vector<NamedItem> items = named_items(data);
  for (const NamedItem& item : items) header += fmt::format(",{}", item.name);
  for (const NamedItem& item : items) {
    if (!item.table->labels.empty()) header += fmt::format(",label_{}", item.name);
  }
  file.write(header + ",verdict,recomputed\n");
  return ResultTable(std::move(file), data, std::move(kept));
}

void ResultTable::add(const verilator_tb::VerifiedResult& result) {
  const std::string verdict(result.word.is_undecided() ? undecided
                                                       : to_string(result.word.verdict()));
  if (kept_.count(verdict) == 0) return;
  std::string row = std::to_string(result.index);
  const std::vector<NamedItem> named = named_items(*data_);
  for (const NamedItem& item : named) row += fmt::format(",{}", result.items.of(item.item));
  for (const NamedItem& item : named) {
    if (item.table->labels.empty()) continue;
    row += "," + field(item.table->labels[result.items.of(item.item)]);
  }
  file_.write(fmt::format("{},{},{}\n", row, verdict, result.word.is_recomputed() ? 1 : 0));
}

Result<Done> ResultTable::finish() {
  return file_.commit();
}

}  // namespace mixcmp::cli
