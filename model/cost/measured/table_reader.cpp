#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>

#include "model/base/common/file.hpp"
#include "model/base/common/quote.hpp"
#include "model/cost/measured/component_cells.hpp"
#include "model/cost/measured/measurement.hpp"
#include "model/cost/measured/table_columns.hpp"

namespace mixcmp::measured {
namespace {

/// A field with its position in the file.
struct Field {
  std::string text;
  int line = 0;
  int column = 0;  ///< 1-based, in bytes
};

class TableReader {
public:
  TableReader(const std::filesystem::path& path, std::string_view text)
      : path_(path), text_(text) {}

  Result<Characterisation> read() {
    Characterisation table;
    while (peek() == '#') read_comment(table);
    const int header_line = line_;
    const std::string_view header = rest_of_line();
    has_stages_ = header == staged_table_header;
    if (!has_stages_ && header != mapped_table_header) {
      return error({.text = std::string(header), .line = header_line, .column = 1},
                   "not the columns of a characterisation",
                   std::string(mapped_table_header) + "[,area_stage]");
    }
    while (place_ < text_.size()) {
      if (peek() == '\n' || peek() == '\r') {
        rest_of_line();
        continue;
      }
      MIXCMP_TRY(row, read_row());
      table.rows.push_back(std::move(row));
    }
    MIXCMP_DO(sort(table));
    return table;
  }

private:
  char peek() const { return place_ < text_.size() ? text_[place_] : '\0'; }

  std::string_view rest_of_line() {
    const std::size_t end = std::min(text_.find('\n', place_), text_.size());
    std::string_view line = text_.substr(place_, end - place_);
    if (line.ends_with('\r')) line.remove_suffix(1);
    place_ = std::min(end + 1, text_.size());
    ++line_;
    line_start_ = place_;
    return line;
  }

  void read_comment(Characterisation& table) {
    std::string_view line = rest_of_line().substr(1);
    const std::size_t colon = line.find(": ");
    if (colon == std::string_view::npos) return;
    std::string name(line.substr(0, colon));
    name.erase(0, name.find_first_not_of(' '));
    std::string value(line.substr(colon + 2));
    if (name == "device") {
      table.device = value;
    } else if (name == "scene") {
      table.scene = value;
    } else if (name == "command") {
      table.command = value;
    } else {
      table.spec.emplace_back(std::move(name), std::move(value));
    }
  }

  Error error(const Field& field, std::string message, std::string accepted) const {
    return {.file = path_.string(),
            .line = field.line,
            .column = field.column,
            .message = std::move(message),
            .received = in_quotes(field.text),
            .accepted = std::move(accepted)};
  }

  Field start_field() const {
    return {.line = line_, .column = static_cast<int>(place_ - line_start_) + 1};
  }

  bool at_field_end() const {
    const char c = peek();
    return place_ == text_.size() || c == ',' || c == '\n' || c == '\r';
  }

  Result<Field> read_field() {
    Field field = start_field();
    if (peek() != '"') {
      while (!at_field_end()) field.text += text_[place_++];
      return field;
    }
    for (++place_; place_ < text_.size(); ++place_) {
      if (text_[place_] == '"' && text_.substr(place_, 2) != "\"\"") break;
      if (text_[place_] == '"') ++place_;
      field.text += text_[place_];
    }
    if (peek() != '"') return error(field, "the quotes are not closed", "a closing quote");
    ++place_;
    if (!at_field_end()) return error(field, "text behind the quotes", "a comma or the end");
    return field;
  }

  /// Reads the next field of the current record. A comma must follow each field except the last.
  Result<Field> next() {
    MIXCMP_TRY(field, read_field());
    if (++fields_read_ < field_count()) {
      if (peek() != ',') return error(field, "the record ends here", fields_a_record());
      ++place_;
    } else if (peek() == ',') {
      return error(field, "the record goes on", fields_a_record());
    } else {
      rest_of_line();
    }
    return field;
  }

  template <class Number>
  Result<Number> number(const char* accepted) {
    MIXCMP_TRY(field, next());
    Number value = 0;
    const char* end = field.text.data() + field.text.size();
    const auto [stop, failed] = std::from_chars(field.text.data(), end, value);
    const bool finite = value >= 0 && value <= Number(1e9);
    if (failed == std::errc() && stop == end && finite) return value;
    return error(field, "not a number", accepted);
  }
  Result<int> integer() { return number<int>("a whole number of at least 0"); }
  Result<double> mhz() {
    Field field = start_field();
    MIXCMP_TRY(value, number<double>("a clock in MHz"));
    if (value > 0) return value;
    field.text = fmt::format("{}", value);
    return error(field, "no clock", "a clock in MHz, above 0");
  }

  template <class Choices>
  Result<typename Choices::value_type> choice(const Choices& choices) {
    MIXCMP_TRY(field, next());
    std::string accepted;
    for (const auto each : choices) {
      if (field.text == to_string(each)) return each;
      accepted += (accepted.empty() ? "" : ", ") + std::string(to_string(each));
    }
    return error(field, "not a choice", accepted);
  }

  Result<Measurement> read_row() {
    fields_read_ = 0;
    Measurement row;
    MIXCMP_TRY(key, read_key());
    row.key = std::move(key);
    MIXCMP_TRY(latency, integer());
    row.latency_cycles = latency;
    for (const auto& column : area_columns) {
      MIXCMP_TRY(amount, integer());
      row.area.*column.field = amount;
    }
    MIXCMP_TRY(clock, read_clock());
    row.clock = clock;
    return read_provenance(std::move(row));
  }

  /// Reads the cells that identify a component. An error has the place of its cell.
  Result<ComponentKey> read_key() {
    KeyCells cells;
    std::array<Field, key_columns.size()> fields;
    for (std::size_t k = 0; k < fields.size(); ++k) {
      MIXCMP_TRY(field, next());
      cells.*key_columns[k].cell = field.text;
      fields[k] = std::move(field);
    }
    Result<ComponentKey> key = key_of(cells);
    if (key.ok()) return key;
    const auto* const column =
        std::find_if(key_columns.begin(), key_columns.end(),
                     [&](const KeyColumn& each) { return each.name == key.error().field; });
    const Field& field = fields[static_cast<std::size_t>(column - key_columns.begin())];
    return error(field, key.error().message, key.error().accepted);
  }

  Result<Measurement> read_provenance(Measurement row) {
    MIXCMP_TRY(seeds, integer());
    row.timing_seeds = seeds;
    MIXCMP_TRY(hash, next());
    row.hash = hash.text;
    MIXCMP_TRY(tools, next());
    row.tools = tools.text;
    if (!has_stages_) return row;
    MIXCMP_TRY(stage,
               choice(std::array{AreaStage::predicted, AreaStage::mapped, AreaStage::synthesised,
                                 AreaStage::placed, AreaStage::routed}));
    row.stage = stage;
    return row;
  }

  /// Reads a clock's five fields, which are all empty if there is no clock.
  Result<std::optional<Clock>> read_clock() {
    if (text_.substr(place_, 5) == ",,,,,") {
      place_ += 5;
      fields_read_ += 5;
      return std::optional<Clock>();
    }
    MIXCMP_TRY(median, mhz());
    MIXCMP_TRY(low, mhz());
    MIXCMP_TRY(high, mhz());
    MIXCMP_TRY(seeds, integer());
    MIXCMP_TRY(source,
               choice(std::array{ClockSource::estimate_before_routing, ClockSource::routed}));
    return std::optional<Clock>(
        Clock{.mhz = median, .low_mhz = low, .high_mhz = high, .seeds = seeds, .source = source});
  }

  Result<Done> sort(Characterisation& table) const {
    const auto by_key = [](const Measurement& a, const Measurement& b) { return a.key < b.key; };
    std::sort(table.rows.begin(), table.rows.end(), by_key);
    const auto twin = std::adjacent_find(
        table.rows.begin(), table.rows.end(),
        [](const Measurement& a, const Measurement& b) { return a.key == b.key; });
    if (twin == table.rows.end()) return Done{};
    return Error{.file = path_.string(),
                 .message = "two rows of one component",
                 .received = in_words(cells_of(twin->key)),
                 .accepted = "one"};
  }

  static std::string in_words(const KeyCells& key) {
    return fmt::format("{} {} {} {} {} {}, initiation interval {}, ports {}", key.kind, key.name,
                       key.format, key.inputs, key.bound, key.multipliers, key.initiation_interval,
                       key.ports);
  }

  int field_count() const { return mapped_table_columns + (has_stages_ ? 1 : 0); }
  std::string fields_a_record() const { return fmt::format("{} fields a record", field_count()); }

  const std::filesystem::path& path_;
  std::string_view text_;
  std::size_t place_ = 0;
  std::size_t line_start_ = 0;
  int line_ = 1;
  int fields_read_ = 0;
  bool has_stages_ = false;
};

}  // namespace

Result<Characterisation> read_characterisation(const std::filesystem::path& path) {
  MIXCMP_TRY(text, read_file(path));
  return TableReader(path, text).read();
}

}  // namespace mixcmp::measured
