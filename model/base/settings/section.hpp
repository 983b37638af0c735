#pragma once

#include <gmpxx.h>

#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <optional>
#include <span>

#include "model/base/number/float_format.hpp"
#include "model/base/settings/limits.hpp"
#include "model/base/settings/settings.hpp"

namespace mixcmp::settings {

/// Reads one table of a scene, key by key, into variables that keep their defaults if a key is
/// absent. The first mistake is stored until `finish`, which also finds unknown keys.
class Section {
public:
  /// The section [name] of the file; an absent one reads as empty.
  Section(const Settings& settings, std::string name);
  /// A table inside a section or a list.
  Section(std::string name, const Setting& table);

  bool present() const { return table_ != nullptr; }
  int line() const { return line_; }
  const Setting* find(const std::string& key);
  std::span<const Setting> entries() const;

  void require(const std::string& key);
  void text(const std::string& key, std::string& target);
  void number(const std::string& key, double& target, double low, double high);
  void exact(const std::string& key, std::optional<mpq_class>& target);
  /// A format with a precision in `precisions`; `accepted` says so in an error.
  void format(const std::string& key, std::optional<FloatFormat>& target, Limits precisions,
              const std::string& accepted);
  template <std::integral Integer>
  void integer(const std::string& key, Integer& target, std::int64_t low, std::int64_t high);
  template <std::integral Integer>
  void integer(const std::string& key, Integer& target, Limits limits);
  /// An integer, or 0; `zero` describes the meaning of 0 in an error.
  void integer_or_zero(const std::string& key, int& target, Limits limits, const std::string& zero);
  /// An integer, or "auto" for none.
  void integer_or_auto(const std::string& key, std::optional<int>& target, Limits limits);
  /// One of `accepted`, by its to_string.
  template <class Enum>
  void choice(const std::string& key, Enum& target, std::initializer_list<Enum> accepted);

  /// One of these words; `target` becomes the value beside it.
  template <class T>
  void choice(const std::string& key, T& target,
              std::initializer_list<std::pair<std::string_view, T>> accepted);

  /// A list of at least one of `accepted`, each once.
  template <class Enum>
  void choices(const std::string& key, std::vector<Enum>& target,
               std::initializer_list<Enum> accepted);

  /// Stores a mistake found by the caller, unless there is one already.
  void fail(const std::string& key, std::string message, std::string received,
            std::string accepted);
  void fail(Error error);
  /// Makes the error of a key without storing it.
  Error mistake(const std::string& key, std::string message, std::string received,
                std::string accepted) const;

  /// The first mistake, if any. An unknown key goes first: it may be the reason why another is
  /// missing.
  std::optional<Error> finish() const;

private:
  const Setting* find_string(const std::string& key);
  void choose(const std::string& key, std::span<const std::string> accepted,
              std::optional<std::size_t>& chosen);
  std::vector<std::size_t> choose_several(const std::string& key,
                                          std::span<const std::string> accepted);
  std::optional<std::int64_t> read_integer(const std::string& key, std::int64_t low,
                                           std::int64_t high, const std::string& accepted);

  std::string name_;
  const Setting::Table* table_ = nullptr;
  std::string file_;
  int line_ = 0;
  std::vector<std::string> known_keys_;
  std::optional<Error> error_;
};

/// The file of a setting, or "--set".
std::string file_of(const Setting& setting);

/// An error about the setting `field`: it names the setting's file and line, or "--set".
Error mistake_at(const Setting& setting, std::string field, std::string message,
                 std::string received, std::string accepted);

/// The tables of the list [[name]]; none if it is absent. `purpose` describes them in an error:
/// "one table for each kind".
Result<std::span<const Setting>> tables_of(const Settings& settings, const std::string& name,
                                           const std::string& purpose);

/// The exact value of an integer, of a number (the shortest decimal that names it), or of a string
/// with a decimal or hex-float literal.
std::optional<mpq_class> exact_value(const Setting& setting);

/// The reason why a setting has no exact value, for an error: "is not a finite number".
std::string exact_problem(const Setting& setting);

/// The numbers that exact_value accepts, in words, for an error.
std::string accepted_exact_values();

template <std::integral Integer>
void Section::integer(const std::string& key, Integer& target, std::int64_t low,
                      std::int64_t high) {
  const auto value = read_integer(key, low, high, {});
  if (value) target = static_cast<Integer>(*value);
}

template <std::integral Integer>
void Section::integer(const std::string& key, Integer& target, Limits limits) {
  integer(key, target, limits.least, limits.most);
}

template <class Enum>
void Section::choice(const std::string& key, Enum& target, std::initializer_list<Enum> accepted) {
  std::vector<std::string> words;
  for (const Enum value : accepted) words.emplace_back(to_string(value));
  std::optional<std::size_t> chosen;
  choose(key, words, chosen);
  if (chosen) target = accepted.begin()[*chosen];
}

template <class T>
void Section::choice(const std::string& key, T& target,
                     std::initializer_list<std::pair<std::string_view, T>> accepted) {
  std::vector<std::string> words;
  for (const auto& [word, value] : accepted) words.emplace_back(word);
  std::optional<std::size_t> chosen;
  choose(key, words, chosen);
  if (chosen) target = accepted.begin()[*chosen].second;
}

template <class Enum>
void Section::choices(const std::string& key, std::vector<Enum>& target,
                      std::initializer_list<Enum> accepted) {
  std::vector<std::string> words;
  for (const Enum value : accepted) words.emplace_back(to_string(value));
  for (const std::size_t chosen : choose_several(key, words)) {
    target.push_back(accepted.begin()[chosen]);
  }
}

}  // namespace mixcmp::settings
