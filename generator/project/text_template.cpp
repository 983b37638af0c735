#include "generator/project/text_template.hpp"

#include <algorithm>
#include <vector>

#include "embedded/project_templates.hpp"
#include "model/base/common/check.hpp"

namespace mixcmp::project {
namespace {

std::string_view template_text(std::string_view file) {
  const auto files = project_templates();
  const auto found = std::find_if(files.begin(), files.end(),
                                  [file](const EmbeddedFile& each) { return each.name == file; });
  MIXCMP_CHECK(found != files.end());
  return found->text;
}

bool is_name(std::string_view text) {
  constexpr std::string_view first = "ABCDEFGHIJKLMNOPQRSTUVWXYZ";
  constexpr std::string_view all = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_";
  return !text.empty() && first.find(text.front()) != std::string_view::npos &&
         text.find_first_not_of(all) == std::string_view::npos;
}

const std::string& value_of(std::string_view name, const Values& values) {
  const auto value = values.find(std::string(name));
  MIXCMP_CHECK(value != values.end());
  return value->second;
}

/// The line with its placeholders replaced; an @ that begins none stays.
std::string filled_line(std::string_view line, const Values& values) {
  std::string filled;
  while (!line.empty()) {
    const std::size_t begin = std::min(line.find('@'), line.size());
    filled += line.substr(0, begin);
    line.remove_prefix(begin);
    if (line.empty()) break;
    const std::size_t end = std::min(line.find('@', 1), line.size());
    const std::string_view name = line.substr(1, end - 1);
    const bool is_placeholder = end < line.size() && is_name(name);
    filled += is_placeholder ? value_of(name, values) : "@";
    line.remove_prefix(is_placeholder ? end + 1 : 1);
  }
  return filled;
}

/// The text between `begin` and the @ that ends the line; empty for any other line.
std::string_view argument(std::string_view line, std::string_view begin) {
  if (!line.starts_with(begin) || !line.ends_with('@')) return {};
  return line.substr(begin.size(), line.size() - begin.size() - 1);
}

/// The next line of `text`, without its end, which is taken off with it.
std::string_view take_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  MIXCMP_CHECK(end != std::string_view::npos);
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end + 1);
  return line;
}

/// The lines that @IF, @END@ and @INCLUDE leave of a template.
class Filler {
public:
  explicit Filler(const Values& values) : values_(values) {}

  std::string fill(std::string_view text) {
    const std::size_t outer = conditions_.size();
    std::string filled;
    while (!text.empty()) filled += fill_line(take_line(text));
    MIXCMP_CHECK(conditions_.size() == outer);
    return filled;
  }

private:
  std::string fill_line(std::string_view line) {
    if (line == "@END@") {
      MIXCMP_CHECK(!conditions_.empty());
      conditions_.pop_back();
      return "";
    }
    if (const std::string_view name = argument(line, "@IF "); !name.empty()) {
      conditions_.push_back(is_kept() && !value_of(name, values_).empty());
      return "";
    }
    if (!is_kept()) return "";
    const std::string_view file = argument(line, "@INCLUDE ");
    if (!file.empty()) return fill(template_text(file));
    std::string filled = filled_line(line, values_);
    const bool held_empty_values = filled.empty() && !line.empty();
    return held_empty_values ? "" : filled + "\n";
  }

  bool is_kept() const { return conditions_.empty() || conditions_.back(); }

  const Values& values_;
  std::vector<bool> conditions_;  ///< of the sections around the line, the innermost last
};

}  // namespace

std::string fill_template(std::string_view file, const Values& values) {
  return Filler(values).fill(template_text(file));
}

}  // namespace mixcmp::project
