#include "model/base/settings/section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "model/base/common/nearest.hpp"
#include "model/base/number/literal.hpp"

namespace mixcmp::settings {

std::string file_of(const Setting& setting) {
  return setting.file ? setting.file->path.string() : "--set";
}

Error mistake_at(const Setting& setting, std::string field, std::string message,
                 std::string received, std::string accepted) {
  return {.file = file_of(setting),
          .line = setting.line,
          .field = std::move(field),
          .message = std::move(message),
          .received = std::move(received),
          .accepted = std::move(accepted)};
}

std::optional<mpq_class> exact_value(const Setting& setting) {
  if (const auto* integer = std::get_if<std::int64_t>(&setting.value)) {
    return mpq_class(static_cast<long>(*integer));
  }
  if (const auto* real = std::get_if<double>(&setting.value)) {
    return parse_signed_literal(fmt::format("{}", *real));
  }
  if (const auto* text = std::get_if<std::string>(&setting.value)) {
    return parse_signed_literal(*text);
  }
  return std::nullopt;
}

std::string exact_problem(const Setting& setting) {
  const auto* text = std::get_if<std::string>(&setting.value);
  return text != nullptr && is_signed_literal(*text) ? "needs too many digits"
                                                     : "is not a finite number";
}

std::string accepted_exact_values() {
  return fmt::format("finite numbers, as fractions at most {} bits above and below the bar",
                     max_constant_bits);
}

Section::Section(const Settings& settings, std::string name)
    : name_(std::move(name)), file_(settings.path.string()) {
  const Setting* section = settings.root.find(name_);
  if (section == nullptr) return;
  *this = Section(std::move(name_), *section);
  if (table_ != nullptr) return;
  error_ = mistake_at(*section, name_, "not a section", section->shown(),
                      fmt::format("a table [{}]", name_));
}

Section::Section(std::string name, const Setting& table)
    : name_(std::move(name)),
      table_(std::get_if<Setting::Table>(&table.value)),
      file_(file_of(table)),
      line_(table.line) {}

const Setting* Section::find(const std::string& key) {
  known_keys_.push_back(key);
  return table_ == nullptr ? nullptr : table_->find(key);
}

std::span<const Setting> Section::entries() const {
  if (table_ == nullptr) return {};
  return table_->entries;
}

Error Section::mistake(const std::string& key, std::string message, std::string received,
                       std::string accepted) const {
  const std::string field = key.empty() ? name_ : fmt::format("{}.{}", name_, key);
  const Setting* setting = table_ == nullptr ? nullptr : table_->find(key);
  if (setting != nullptr) {
    return mistake_at(*setting, field, std::move(message), std::move(received),
                      std::move(accepted));
  }
  return {.file = file_,
          .line = line_,
          .field = field,
          .message = std::move(message),
          .received = std::move(received),
          .accepted = std::move(accepted)};
}

void Section::fail(const std::string& key, std::string message, std::string received,
                   std::string accepted) {
  fail(mistake(key, std::move(message), std::move(received), std::move(accepted)));
}

void Section::fail(Error error) {
  if (!error_) error_ = std::move(error);
}

void Section::require(const std::string& key) {
  if (find(key) == nullptr) fail(key, "missing", "nothing", fmt::format("a key {}", key));
}

const Setting* Section::find_string(const std::string& key) {
  const Setting* setting = find(key);
  if (setting == nullptr || std::holds_alternative<std::string>(setting->value)) return setting;
  fail(key, "wrong type", fmt::format("{} ({})", setting->shown(), setting->kind()), "a string");
  return nullptr;
}

void Section::text(const std::string& key, std::string& target) {
  const Setting* setting = find_string(key);
  if (setting != nullptr) target = std::get<std::string>(setting->value);
}

void Section::number(const std::string& key, double& target, double low, double high) {
  const Setting* setting = find(key);
  if (setting == nullptr) return;
  double value = std::numeric_limits<double>::quiet_NaN();
  if (const auto* real = std::get_if<double>(&setting->value)) value = *real;
  if (const auto* integer = std::get_if<std::int64_t>(&setting->value)) {
    value = static_cast<double>(*integer);
  }
  const std::string accepted = fmt::format("a number from {} to {}", low, high);
  const bool numeric = std::holds_alternative<double>(setting->value) ||
                       std::holds_alternative<std::int64_t>(setting->value);
  if (!numeric) return fail(key, "wrong type", setting->shown(), accepted);
  if (!(low <= value && value <= high))
    return fail(key, "out of range", setting->shown(), accepted);
  target = value;
}

void Section::exact(const std::string& key, std::optional<mpq_class>& target) {
  const Setting* setting = find(key);
  if (setting == nullptr) return;
  target = exact_value(*setting);
  if (!target) {
    fail(key, exact_problem(*setting), setting->shown(),
         "a number, or a string with a decimal or hex-float: " + accepted_exact_values());
  }
}

void Section::format(const std::string& key, std::optional<FloatFormat>& target, Limits precisions,
                     const std::string& accepted) {
  const Setting* setting = find_string(key);
  if (setting == nullptr) return;
  Result<FloatFormat> parsed = FloatFormat::parse(std::get<std::string>(setting->value));
  if (!parsed.ok()) return fail(key, parsed.error().message, setting->shown(), accepted);
  if (!precisions.allow(parsed->precision())) {
    return fail(key, "precision out of range", setting->shown(), accepted);
  }
  target = *parsed;
}

std::optional<std::int64_t> Section::read_integer(const std::string& key, std::int64_t low,
                                                  std::int64_t high,
                                                  const std::string& alternative) {
  const Setting* setting = find(key);
  if (setting == nullptr) return std::nullopt;
  const std::string accepted = fmt::format("{}an integer {}..{}", alternative, low, high);
  const auto* value = std::get_if<std::int64_t>(&setting->value);
  if (value == nullptr) {
    fail(key, "wrong type", fmt::format("{} ({})", setting->shown(), setting->kind()), accepted);
    return std::nullopt;
  }
  if (*value < low || *value > high) {
    fail(key, "out of range", setting->shown(), accepted);
    return std::nullopt;
  }
  return *value;
}

void Section::integer_or_zero(const std::string& key, int& target, Limits limits,
                              const std::string& zero) {
  const Setting* setting = find(key);
  const auto* value = setting == nullptr ? nullptr : std::get_if<std::int64_t>(&setting->value);
  if (value != nullptr && *value == 0) {
    target = 0;
    return;
  }
  const auto read = read_integer(key, limits.least, limits.most, fmt::format("0 ({}) or ", zero));
  if (read) target = static_cast<int>(*read);
}

void Section::integer_or_auto(const std::string& key, std::optional<int>& target, Limits limits) {
  const Setting* setting = find(key);
  const auto* word = setting == nullptr ? nullptr : std::get_if<std::string>(&setting->value);
  if (word != nullptr && *word == "auto") {
    target.reset();
    return;
  }
  const auto value = read_integer(key, limits.least, limits.most, "\"auto\" or ");
  if (value) target = static_cast<int>(*value);
}

void Section::choose(const std::string& key, std::span<const std::string> accepted,
                     std::optional<std::size_t>& chosen) {
  const Setting* setting = find_string(key);
  if (setting == nullptr) return;
  const auto& word = std::get<std::string>(setting->value);
  const auto found = std::find(accepted.begin(), accepted.end(), word);
  if (found == accepted.end()) {
    return fail(key, "not a choice", setting->shown(), list_with_nearest(word, accepted));
  }
  chosen = static_cast<std::size_t>(found - accepted.begin());
}

std::vector<std::size_t> Section::choose_several(const std::string& key,
                                                 std::span<const std::string> accepted) {
  const Setting* setting = find(key);
  if (setting == nullptr) return {};
  const auto* words = std::get_if<Setting::Array>(&setting->value);
  const std::string list = fmt::format("a list of one or more of {}", fmt::join(accepted, ", "));
  std::vector<std::size_t> chosen;
  for (const Setting& word : words == nullptr ? Setting::Array{} : *words) {
    const auto* text = std::get_if<std::string>(&word.value);
    const auto found =
        text == nullptr ? accepted.end() : std::find(accepted.begin(), accepted.end(), *text);
    const auto number = static_cast<std::size_t>(found - accepted.begin());
    const bool again = std::find(chosen.begin(), chosen.end(), number) != chosen.end();
    if (found == accepted.end() || again) {
      fail(key, again ? "named twice" : "not a choice", word.shown(), list);
      return {};
    }
    chosen.push_back(number);
  }
  if (chosen.empty()) fail(key, "no list of choices", setting->shown(), list);
  return chosen;
}

std::optional<Error> Section::finish() const {
  for (const Setting& entry : entries()) {
    const auto known = std::find(known_keys_.begin(), known_keys_.end(), entry.key);
    if (known != known_keys_.end()) continue;
    std::vector<std::string> keys = known_keys_;
    std::sort(keys.begin(), keys.end());
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    return mistake(entry.key, "unknown key", entry.key, list_with_nearest(entry.key, keys));
  }
  return error_;
}

Result<std::span<const Setting>> tables_of(const Settings& settings, const std::string& name,
                                           const std::string& purpose) {
  const Setting* list = settings.root.find(name);
  if (list == nullptr) return std::span<const Setting>();
  const auto* tables = std::get_if<Setting::Array>(&list->value);
  const bool all_tables = tables != nullptr && !tables->empty() &&
                          std::all_of(tables->begin(), tables->end(), [](const Setting& table) {
                            return std::holds_alternative<Setting::Table>(table.value);
                          });
  if (all_tables) return std::span<const Setting>(*tables);
  return mistake_at(*list, name, "not a list of tables", list->shown(),
                    fmt::format("[[{}]], {}", name, purpose));
}

}  // namespace mixcmp::settings
