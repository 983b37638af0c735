#include "model/base/settings/settings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <string_view>

#include "model/base/common/file.hpp"
#include "model/base/common/quote.hpp"

namespace mixcmp::settings {
namespace {

using File = std::shared_ptr<const SettingsFile>;

Setting to_setting(std::string key, const toml::node& node, const File& file);

int line_of(const toml::source_position& position) {
  return static_cast<int>(position.line);
}

Setting::Table to_table(const toml::table& table, const File& file) {
  Setting::Table entries;
  for (const auto& [key, node] : table) {
    Setting setting = to_setting(std::string(key.str()), node, file);
    setting.line = line_of(key.source().begin);
    entries.entries.push_back(std::move(setting));
  }
  std::stable_sort(entries.entries.begin(), entries.entries.end(),
                   [](const Setting& a, const Setting& b) { return a.line < b.line; });
  return entries;
}

Setting::Array to_array(const toml::array& array, const File& file) {
  Setting::Array elements;
  for (const toml::node& node : array) elements.push_back(to_setting({}, node, file));
  return elements;
}

Setting to_setting(std::string key, const toml::node& node, const File& file) {
  Setting setting{.key = std::move(key),
                  .file = file,
                  .line = line_of(node.source().begin),
                  .end_line = line_of(node.source().end),
                  .value = Setting::Foreign{"a date or time"}};
  if (const auto* truth = node.as_boolean()) setting.value = truth->get();
  if (const auto* integer = node.as_integer()) setting.value = integer->get();
  if (const auto* real = node.as_floating_point()) setting.value = real->get();
  if (const auto* text = node.as_string()) setting.value = text->get();
  if (const auto* array = node.as_array()) setting.value = to_array(*array, file);
  if (const auto* table = node.as_table()) setting.value = to_table(*table, file);
  return setting;
}

/// An error if a key has too many parts, counted as dots outside of quotes. The TOML parser calls
/// itself for each part of a dotted key, and a million parts are too many for its stack.
std::optional<Error> too_many_dots(const std::string& text, const std::string& file) {
  constexpr int most = 1000;
  int line = 1, dots = 0;
  char quote = '\0';
  for (const char c : text) {
    if (c == '\n') {
      ++line;
      quote = '\0';
    }
    if (quote != '\0') {
      if (c == quote) quote = '\0';
      continue;
    }
    if (c == '"' || c == '\'') quote = c;
    if (std::string_view("\n=,{}").find(c) != std::string_view::npos) dots = 0;
    dots += c == '.';
    if (dots > most) {
      return Error{.file = file,
                   .line = line,
                   .field = "TOML syntax",
                   .message = "a key of too many parts",
                   .received = fmt::format("more than {} dots", most),
                   .accepted = "section.key"};
    }
  }
  return std::nullopt;
}

Result<toml::table> parse_toml(const std::string& text, const std::string& file) {
  if (const auto error = too_many_dots(text, file)) return *error;
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error& problem) {
    std::string message(problem.description());
    std::replace(message.begin(), message.end(), '\n', ' ');
    return Error{.file = file,
                 .line = line_of(problem.source().begin),
                 .column = static_cast<int>(problem.source().begin.column),
                 .field = "TOML syntax",
                 .message = message};
  }
}

/// The most keys in a table of a scene, and the deepest nesting. Looking up a key takes time in
/// proportion to the size of its table.
constexpr std::size_t max_keys = 4096, max_depth = 16;

Result<Done> check_sizes(const std::string& name, const toml::node& node, const std::string& file,
                         std::size_t depth) {
  const auto wrong = [&](std::string message, std::string received, std::string accepted) {
    return Error{.file = file,
                 .line = line_of(node.source().begin),
                 .field = name,
                 .message = std::move(message),
                 .received = std::move(received),
                 .accepted = std::move(accepted)};
  };
  if (depth > max_depth) {
    return wrong("nested too deeply", fmt::format("{} levels or more", depth),
                 fmt::format("at most {} levels", max_depth));
  }
  if (const toml::array* array = node.as_array()) {
    for (const toml::node& element : *array) {
      MIXCMP_TRY(checked, check_sizes(name, element, file, depth + 1));
    }
  }
  const toml::table* table = node.as_table();
  if (table == nullptr) return Done{};
  if (table->size() > max_keys) {
    return wrong("too many keys", fmt::format("{}", table->size()),
                 fmt::format("at most {} in one table", max_keys));
  }
  for (const auto& [key, value] : *table) {
    const std::string below =
        name.empty() ? std::string(key.str()) : name + "." + std::string(key.str());
    MIXCMP_DO(check_sizes(below, value, file, depth + 1));
  }
  return Done{};
}

/// Removes the lines of a setting, as if it were set on the command line.
void forget_lines(Setting& setting) {
  setting.line = setting.end_line = 0;
  if (auto* table = std::get_if<Setting::Table>(&setting.value)) {
    for (Setting& entry : table->entries) forget_lines(entry);
  }
  if (auto* array = std::get_if<Setting::Array>(&setting.value)) {
    for (Setting& element : *array) forget_lines(element);
  }
}

Setting parse_override_value(const std::string& key, const std::string& text) {
  const Result<toml::table> parsed = parse_toml("value = " + text, "--set");
  Setting setting{.key = key, .value = text};
  if (parsed.ok() && parsed->size() == 1 && parsed->contains("value")) {
    setting = to_setting(key, *parsed->get("value"), nullptr);
    forget_lines(setting);
  }
  return setting;
}

Result<Done> apply_override(Setting::Table& root, const std::string& text) {
  const std::size_t equals = text.find('=');
  const std::size_t dot = text.find('.');
  const std::string path = "." + text.substr(0, equals) + ".";
  if (equals == std::string::npos || dot == std::string::npos || dot > equals ||
      path.find("..") != std::string::npos) {
    return Error{.file = "--set",
                 .message = "not an override",
                 .received = in_quotes(text),
                 .accepted = "section.key=value"};
  }
  Setting::Table* table = &root;
  std::size_t begin = 0;
  for (std::size_t end = dot; end < equals; end = text.find('.', begin)) {
    Setting& section = find_or_add(*table, text.substr(begin, end - begin));
    if (std::holds_alternative<Setting::Array>(section.value)) {
      return Error{.file = "--set",
                   .field = text.substr(0, end),
                   .message = "a list: its entries have no names of their own",
                   .received = in_quotes(text),
                   .accepted = "the key of a section; lists are changed in the file or by a plan"};
    }
    table = std::get_if<Setting::Table>(&section.value);
    // A section of the file that is not a table is a mistake in the file, reported when the section
    // is read.
    if (table == nullptr && begin == 0 && section.file != nullptr) return Done{};
    if (table == nullptr) {
      const std::string name = text.substr(0, end);
      return Error{.file = "--set",
                   .field = name,
                   .message = fmt::format("{}, which has no keys", section.kind()),
                   .received = in_quotes(text),
                   .accepted = fmt::format("{}=VALUE", name)};
    }
    begin = end + 1;
  }
  const std::string key = text.substr(begin, equals - begin);
  find_or_add(*table, key) = parse_override_value(key, text.substr(equals + 1));
  return Done{};
}

}  // namespace

std::string toml_string(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7f) {
      quoted += fmt::format("\\u{:04x}", byte);
      continue;
    }
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "\"";
}

std::string toml_key(const std::string& key) {
  const auto is_bare = [](char c) {
    return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') || c == '_' ||
           c == '-';
  };
  return !key.empty() && std::all_of(key.begin(), key.end(), is_bare) ? key : toml_string(key);
}

std::string toml_value(const Setting& value) {
  struct Texts {
    std::string operator()(bool truth) const { return truth ? "true" : "false"; }
    std::string operator()(std::int64_t integer) const { return fmt::format("{}", integer); }
    std::string operator()(double real) const { return fmt::format("{}", real); }
    std::string operator()(const std::string& text) const { return toml_string(text); }
    std::string operator()(const Setting::Array& array) const {
      std::vector<std::string> items;
      for (const Setting& item : array) items.push_back(toml_value(item));
      return fmt::format("[{}]", fmt::join(items, ", "));
    }
    std::string operator()(const Setting::Table& table) const {
      std::vector<std::string> items;
      for (const Setting& entry : table.entries) {
        items.push_back(fmt::format("{} = {}", toml_key(entry.key), toml_value(entry)));
      }
      return fmt::format("{{ {} }}", fmt::join(items, ", "));
    }
    std::string operator()(const Setting::Foreign&) const { MIXCMP_CHECK(false); }
  };
  return std::visit(Texts{}, value.value);
}

const Setting* Setting::Table::find(const std::string& key) const {
  const auto found = std::find_if(entries.begin(), entries.end(),
                                  [&](const Setting& entry) { return entry.key == key; });
  return found == entries.end() ? nullptr : &*found;
}

std::string Setting::kind() const {
  struct Names {
    std::string operator()(bool) const { return "a boolean"; }
    std::string operator()(std::int64_t) const { return "an integer"; }
    std::string operator()(double) const { return "a number"; }
    std::string operator()(const std::string&) const { return "a string"; }
    std::string operator()(const Array&) const { return "an array"; }
    std::string operator()(const Table&) const { return "a table"; }
    std::string operator()(const Foreign& foreign) const { return foreign.kind; }
  };
  return std::visit(Names{}, value);
}

std::string Setting::shown() const {
  struct Texts {
    const Setting& setting;
    std::string operator()(bool truth) const { return truth ? "true" : "false"; }
    std::string operator()(std::int64_t integer) const { return fmt::format("{}", integer); }
    std::string operator()(double real) const { return fmt::format("{}", real); }
    std::string operator()(const std::string& text) const { return in_quotes(text); }
    std::string operator()(const Array& array) const {
      return fmt::format("an array of {}", array.size());
    }
    std::string operator()(const Table& table) const {
      if (table.entries.empty()) return setting.kind();
      return fmt::format("a table with the key {}", in_quotes(table.entries.front().key));
    }
    std::string operator()(const Foreign&) const { return setting.kind(); }
  };
  return std::visit(Texts{*this}, value);
}

Setting& find_or_add(Setting::Table& table, const std::string& key) {
  const auto found = std::find_if(table.entries.begin(), table.entries.end(),
                                  [&](const Setting& entry) { return entry.key == key; });
  if (found != table.entries.end()) return *found;
  return table.entries.emplace_back(Setting{.key = key, .value = Setting::Table{}});
}

Result<Settings> parse_settings(std::string text, const std::filesystem::path& path) {
  const auto file = std::make_shared<const SettingsFile>(SettingsFile{path, std::move(text)});
  MIXCMP_TRY(table, parse_toml(file->text, path.string()));
  MIXCMP_DO(check_sizes("", table, path.string(), 0));
  return Settings{.path = path, .root = to_table(table, file)};
}

Result<Done> apply_overrides(Settings& settings, std::span<const std::string> overrides) {
  std::map<std::string, std::string> given;
  for (const std::string& setting : overrides) {
    const std::string key = setting.substr(0, setting.find('='));
    const auto [first, is_new] = given.emplace(key, setting);
    if (!is_new && first->second != setting) {
      return Error{
          .file = "--set",
          .field = key,
          .message = "given twice",
          .received = fmt::format("{} and {}", in_quotes(first->second), in_quotes(setting)),
          .accepted = "one value"};
    }
    const Result<Done> applied = apply_override(settings.root, setting);
    if (!applied.ok()) return applied.error();
  }
  return Done{};
}

Setting::Table overridden_entries(const Setting::Table& root,
                                  std::span<const std::string> overrides) {
  Setting::Table touched;
  for (const std::string& override_text : overrides) {
    const std::size_t dot = override_text.find('.');
    const std::string section = override_text.substr(0, dot);
    const std::size_t end = override_text.find_first_of(".=", dot + 1);
    const std::string key = override_text.substr(dot + 1, end - dot - 1);
    const Setting* now = root.find(section);
    const auto* entries = now == nullptr ? nullptr : std::get_if<Setting::Table>(&now->value);
    const Setting* entry = entries == nullptr ? nullptr : entries->find(key);
    MIXCMP_CHECK(entry != nullptr);
    find_or_add(std::get<Setting::Table>(find_or_add(touched, section).value), key) = *entry;
  }
  return touched;
}

Result<Settings> read_settings(const std::filesystem::path& path,
                               std::span<const std::string> overrides) {
  MIXCMP_TRY(text, read_file(path));
  MIXCMP_TRY(settings, parse_settings(std::move(text), path));
  MIXCMP_DO(apply_overrides(settings, overrides));
  return settings;
}

}  // namespace mixcmp::settings
