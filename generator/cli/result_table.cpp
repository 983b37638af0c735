#include "generator/cli/result_table.hpp"

#include <fmt/core.h>

#include <cerrno>
#include <cstring>

namespace mixcmp::cli {
namespace {

namespace fs = std::filesystem;

fs::path unfinished(const fs::path& path) {
  return path.string() + ".part";
}

model::Error cannot_write(const fs::path& path) {
  return {.file = path.string(),
          .message = fmt::format("cannot be written: {}", std::strerror(errno))};
}

/// RFC 4180: a field with a comma, a quote or a line end stands in quotes, its quotes doubled.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

/// What a comparison is about, and the column that says so.
struct NamedItem {
  const char* name;
  model::Item item;
  const model::Table* table;
};

/// Of comparisons of rows none: their index is the row.
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

ResultTable::~ResultTable() {
  if (!stream_.is_open()) return;
  stream_.close();
  std::error_code ignored;
  fs::remove(unfinished(path_), ignored);
}

ResultTable::ResultTable(fs::path path, std::ofstream stream, const model::Comparisons& data,
                         std::set<std::string> kept)
    : path_(std::move(path)), stream_(std::move(stream)), data_(&data), kept_(std::move(kept)) {}

model::Result<ResultTable> ResultTable::open(const fs::path& path, const model::Comparisons& data,
                                             std::set<std::string> kept) {
  std::ofstream stream(unfinished(path), std::ios::binary);
  stream << "index";
  const std::vector<NamedItem> items = named_items(data);
  for (const NamedItem& item : items) stream << ',' << item.name;
  for (const NamedItem& item : items) {
    if (!item.table->labels.empty()) stream << ",label_" << item.name;
  }
  stream << ",verdict,recomputed\n";
  if (!stream) return cannot_write(path);
  return ResultTable(path, std::move(stream), data, std::move(kept));
}

void ResultTable::add(const tb::VerifiedResult& result) {
  const std::string verdict(result.undecided ? undecided : to_string(result.verdict));
  if (kept_.count(verdict) == 0) return;
  stream_ << result.index;
  const std::vector<NamedItem> named = named_items(*data_);
  const model::Items items = data_->items(result.index);
  for (const NamedItem& item : named) stream_ << ',' << items.of(item.item);
  for (const NamedItem& item : named) {
    if (!item.table->labels.empty())
      stream_ << ',' << field(item.table->labels[items.of(item.item)]);
  }
  stream_ << ',' << verdict << ',' << (result.recomputed ? 1 : 0) << '\n';
}

model::Result<model::Done> ResultTable::finish() {
  stream_.close();
  std::error_code failed;
  if (stream_) fs::rename(unfinished(path_), path_, failed);
  if (!stream_ || failed) return cannot_write(path_);
  return model::Done{};
}

}  // namespace mixcmp::cli
