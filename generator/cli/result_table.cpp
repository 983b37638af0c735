#include "generator/cli/result_table.hpp"

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
  model::Item item;
  const model::Table* table;
};

/// The items that each line of the CSV names; none where comparisons are rows, since then the index
/// names the row.
std::vector<NamedItem> named_items(const model::Comparisons& data) {
  const auto& tables = data.tables();
  const NamedItem row = {"row", model::Item::row, &tables.front()};
  const NamedItem i = {"i", model::Item::first, &tables.front()};
  const NamedItem j = {"j", model::Item::second, &tables.back()};
  switch (data.pairing()) {
    case model::Pairing::rows: return {};
    case model::Pairing::all:
    case model::Pairing::cross: return {i, j};
    case model::Pairing::arg_min: return {row, {"i", model::Item::first, &tables.back()}, j};
  }
  MIXCMP_CHECK(false);
}

}  // namespace

model::Result<ResultTable> ResultTable::open(const fs::path& path, const model::Comparisons& data,
                                             std::set<std::string> kept) {
  MIXCMP_TRY(file, model::OutputFile::open(path));
  std::string header = "index";
  const std::vector<NamedItem> items = named_items(data);
  for (const NamedItem& item : items) header += fmt::format(",{}", item.name);
  for (const NamedItem& item : items) {
    if (!item.table->labels.empty()) header += fmt::format(",label_{}", item.name);
  }
  file.write(header + ",verdict,recomputed\n");
  return ResultTable(std::move(file), data, std::move(kept));
}

void ResultTable::add(const tb::VerifiedResult& result) {
  const std::string verdict(result.word.is_undecided() ? undecided
                                                       : to_string(result.word.verdict()));
  if (kept_.count(verdict) == 0) return;
  std::string row = std::to_string(result.index);
  const std::vector<NamedItem> named = named_items(*data_);
  const model::Items items = data_->items(result.index);
  for (const NamedItem& item : named) row += fmt::format(",{}", items.of(item.item));
  for (const NamedItem& item : named) {
    if (item.table->labels.empty()) continue;
    row += "," + field(item.table->labels[items.of(item.item)]);
  }
  file_.write(fmt::format("{},{},{}\n", row, verdict, result.word.is_recomputed() ? 1 : 0));
}

model::Result<model::Done> ResultTable::finish() {
  return file_.commit();
}

}  // namespace mixcmp::cli
