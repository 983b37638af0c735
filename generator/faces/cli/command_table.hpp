#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace mixcmp::cli {

/// The kind of value that follows the name of an option.
enum class OptionValue {
  none,    ///< a flag
  path,    ///< a file or a folder
  choice,  ///< one of `choices`
  text,    ///< anything else: a number, a name
};

/// An option or a positional argument of a verb, as --help lists it.
struct CommandOption {
  std::vector<std::string> names;  ///< "-o", "--output"; for an argument only its name, "SCENE"
  std::string help;
  OptionValue value = OptionValue::none;
  std::string type;  ///< "PATH", "INT:4..52", "FLOAT:MHZ"; empty for a flag
  std::vector<std::string> choices;
  bool is_argument = false;
  bool required = false;
  bool repeated = false;
};

struct CommandEntry {
  std::string name;
  std::string help;
  std::vector<CommandOption> options;
};

/// The command line of the program, from which --help, manual pages and completions are made.
struct CommandTable {
  CommandEntry program;  ///< `mixcmp` itself with the options that go before a verb
  std::vector<CommandEntry> verbs;
};

CommandTable command_table(const CLI::App& app);

/// The names of all verbs.
std::vector<std::string> verbs_of(const CLI::App& app);

}  // namespace mixcmp::cli
