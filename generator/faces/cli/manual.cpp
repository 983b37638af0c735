#include "generator/faces/cli/manual.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

#include "generator/faces/cli/exit.hpp"
#include "generator/hardware/emit/version.hpp"

namespace mixcmp::cli {
namespace {

/// Text for roff: a backslash and a hyphen have escapes, and no line begins with a control
/// character.
std::string roff_text(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\') {
      result += "\\e";
    } else if (c == '-') {
      result += "\\-";
    } else {
      result += c;
    }
  }
  const bool is_request = result.starts_with('.') || result.starts_with('\'');
  return is_request ? "\\&" + result : result;
}

std::string in_capitals(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

/// The text with a full stop.
std::string sentence(const std::string& text) {
  return text.ends_with('.') ? text : text + ".";
}

/// A sentence that begins with a capital letter. Helps of options keep theirs: p_L is no P_L.
std::string description(std::string help) {
  help.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(help.front())));
  return sentence(help);
}

std::string page_header(const std::string& page, const std::string& summary) {
  // The third field is a date, which would differ from build to build of the same sources. Lines
  // are not adjusted: long options and keys would tear gaps into them.
  return fmt::format(".TH {} 1 \"\" \"mixcmp {}\" \"User Commands\"\n.ad l\n.SH NAME\n{} \\- {}\n",
                     roff_text(in_capitals(page)), emit::version, roff_text(page),
                     roff_text(summary));
}

std::string option_item(const CommandOption& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.names) names.push_back("\\fB" + roff_text(name) + "\\fR");
  std::string text = fmt::format(".TP\n{}", fmt::join(names, ", "));
  if (!option.type.empty()) text += fmt::format(" \\fI{}\\fR", roff_text(option.type));
  return text + "\n" + roff_text(sentence(option.help)) + "\n";
}

std::string option_items(const CommandEntry& command) {
  std::string arguments, options;
  for (const CommandOption& option : command.options) {
    (option.is_argument ? arguments : options) += option_item(option);
  }
  const std::string section = arguments.empty() ? "" : ".SH ARGUMENTS\n" + arguments;
  return section + ".SH OPTIONS\n" + options;
}

std::string synopsis(const CommandEntry& verb) {
  std::string text = fmt::format(".SH SYNOPSIS\n\\fBmixcmp {}\\fR", roff_text(verb.name));
  for (const CommandOption& option : verb.options) {
    if (!option.is_argument) continue;
    const std::string name = "\\fI" + roff_text(option.names.front()) + "\\fR";
    text += option.required ? " " + name : " [" + name + "]";
  }
  return text + " [\\fIOPTION\\fR]...\n";
}

std::string exit_status() {
  struct Row {
    ExitCode code;
    const char* meaning;
  };
  constexpr Row rows[] = {
      {ExitCode::done, "All that was asked for was done."},
      {ExitCode::mistake,
       "It was not done: a mistake of the user's, missing data, a place that cannot be written, or "
       "a tool that fails."},
      {ExitCode::refuted,
       "The answer is no: hardware, software or a variant differs from the model, Gappa refuses a "
       "bound, or no plan fits."},
      {ExitCode::incomplete,
       "A part was not done, because a tool or data are missing; standard error says which."},
  };
  std::string text = ".SH EXIT STATUS\n";
  for (const Row& row : rows) {
    text += fmt::format(".TP\n{}\n{}\n", static_cast<int>(row.code), roff_text(row.meaning));
  }
  return text + ".TP\n128 + N\nThe program was ended by signal N.\n";
}

std::string see_also(const std::vector<std::string>& pages) {
  std::vector<std::string> references;
  for (const std::string& page : pages) {
    references.push_back(fmt::format(".BR {} (1)", roff_text(page)));
  }
  return fmt::format(".SH SEE ALSO\n{}\n", fmt::join(references, " ,\n"));
}

std::string page_of(const CommandEntry& verb) {
  return "mixcmp-" + verb.name;
}

}  // namespace

std::string manual_page(const CommandTable& table) {
  std::string text =
      page_header("mixcmp", "numerical comparisons as verified Verilog") +
      ".SH SYNOPSIS\n\\fBmixcmp\\fR \\fIVERB\\fR [\\fIARGUMENT\\fR]...\n.SH DESCRIPTION\n" +
      roff_text(table.program.help) + "\n.SH VERBS\n";
  std::vector<std::string> pages;
  for (const CommandEntry& verb : table.verbs) {
    text += fmt::format(".TP\n.BR {} (1)\n{}\n", roff_text(page_of(verb)),
                        roff_text(sentence(verb.help)));
    pages.push_back(page_of(verb));
  }
  return text + option_items(table.program) + exit_status() + see_also(pages);
}

std::string manual_page(const CommandTable& table, const CommandEntry& verb) {
  return page_header(page_of(verb), verb.help) + synopsis(verb) + ".SH DESCRIPTION\n" +
         roff_text(description(verb.help)) + "\n" + option_items(verb) + exit_status() +
         see_also({table.program.name});
}

}  // namespace mixcmp::cli
