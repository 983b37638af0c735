#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "model/cost/measured/component_cells.hpp"
#include "model/cost/measured/measurement.hpp"
#include "model/cost/measured/table_columns.hpp"

namespace mixcmp::measured {
namespace {

/// A field, quoted where RFC 4180 requires it.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

/// Replaces line ends by blanks, since a comment has one line.
std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
}

void add_clock(std::vector<std::string>& fields, const std::optional<Clock>& clock) {
  if (!clock) {
    fields.insert(fields.end(), 5, "");
    return;
  }
  for (const double mhz : {clock->mhz, clock->low_mhz, clock->high_mhz}) {
    fields.push_back(fmt::format("{:.2f}", mhz));
  }
  fields.push_back(std::to_string(clock->seeds));
  fields.emplace_back(to_string(clock->source));
}

std::string record(const Measurement& row, bool with_stage) {
  std::vector<std::string> fields;
  const KeyCells key = cells_of(row.key);
  for (const KeyColumn& column : key_columns) fields.push_back(field(key.*column.cell));
  fields.push_back(std::to_string(row.latency_cycles));
  for (const auto& column : area_columns) {
    fields.push_back(std::to_string(row.area.*column.field));
  }
  add_clock(fields, row.clock);
  fields.push_back(std::to_string(row.timing_seeds));
  fields.push_back(row.hash);
  fields.push_back(field(row.tools));
  if (with_stage) fields.emplace_back(to_string(row.stage));
  return fmt::format("{}\n", fmt::join(fields, ","));
}

}  // namespace

std::string to_csv(const Characterisation& table) {
  std::string text;
  const auto comment = [&](const std::string& name, const std::string& value) {
    text += fmt::format("# {}: {}\n", name, one_line(value));
  };
  comment("device", table.device);
  comment("scene", table.scene);
  comment("command", table.command);
  for (const auto& [name, value] : table.spec) comment(name, value);
  const bool with_stage = std::any_of(table.rows.begin(), table.rows.end(),
                                      [](const Measurement& row) { return row.is_imported(); });
  text += (with_stage ? staged_table_header : std::string(mapped_table_header)) + "\n";
  for (const Measurement& row : table.rows) text += record(row, with_stage);
  return text;
}

}  // namespace mixcmp::measured
