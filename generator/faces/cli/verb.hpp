#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "model/base/common/result.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace mixcmp::cli {

/// The word for a file or a folder in --help. Options with this word complete to files.
inline constexpr const char* path_placeholder = "PATH";

/// A condition on the text of an option.
struct Condition {
  std::function<std::string(const std::string& text)> problem;  ///< empty where the text will do
  std::string description;                                      ///< for --help
};

/// One option of a verb.
class Option {
public:
  explicit Option(CLI::Option* option) : option_(option) {}

  Option required() const;
  Option check(const Condition& check) const;
  Option one_of(const std::vector<std::string>& words) const;
  Option needs(Option other) const;
  Option excludes(Option other) const;
  Option excludes(const std::string& name) const;
  /// Several values in one argument, with `separator` between them.
  Option separated_by(char separator) const;
  /// The option may be repeated; each time it has one value.
  Option one_value_each() const;

private:
  friend class Verb;
  CLI::Option* option_;
};

/// A verb of the command line, `mixcmp VERB`. CLI11 does the parsing. Its header takes the compiler
/// seconds in each file, so only verb.cpp, main.cpp, usage.cpp and command_table.cpp include it.
class Verb {
public:
  Verb(CLI::App& app, const std::string& name, const std::string& help);

  Option flag(const std::string& names, bool& target, const std::string& help) const;
  /// A flag that calls `use` where it is given.
  Option flag(const std::string& names, const std::function<void()>& use,
              const std::string& help) const;
  /// `Value` is one of those that verb.cpp instantiates.
  template <class Value>
  Option option(const std::string& names, Value& target, const std::string& help) const;
  Option text_option(const std::string& names, const std::function<void(const std::string&)>& use,
                     const std::string& help) const;
  Option list_option(const std::string& names,
                     const std::function<void(const std::vector<std::string>&)>& use,
                     const std::string& help) const;

  /// Lets only options of these names go with `option`.
  void keep_alone(Option option, const std::set<std::string>& with) const;

  void when_chosen(std::function<void()> run) const;

private:
  CLI::App* verb_;
};

/// Reads these words as arguments of a verb whose options `add` adds, and runs nothing. The error
/// is the one that a user of the verb would see.
Result<Done> parse_words(const std::vector<std::string>& words,
                         const std::function<void(const Verb&)>& add);

}  // namespace mixcmp::cli
