#include "generator/project/text_template.hpp"

#include <algorithm>

#include "embedded/project_templates.hpp"
#include "model/common/check.hpp"

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

/// The end of the placeholder that begins with the @ at `begin`: the position of its second @. None
/// where no placeholder begins.
std::size_t end_of_placeholder(std::string_view text, std::size_t begin) {
  const std::size_t end = text.find('@', begin + 1);
  if (end == std::string_view::npos) return end;
  return is_name(text.substr(begin + 1, end - begin - 1)) ? end : std::string_view::npos;
}

/// Appends what stands for the @ at `begin`, a placeholder's value or the @ itself, and returns the
/// position behind it.
std::size_t append_value(std::string_view text, std::size_t begin, const Values& values,
                         std::string& filled) {
  const std::size_t end = end_of_placeholder(text, begin);
  if (end == std::string_view::npos) {
    filled += '@';
    return begin + 1;
  }
  const auto value = values.find(std::string(text.substr(begin + 1, end - begin - 1)));
  MIXCMP_CHECK(value != values.end());
  const bool fills_line =
      (filled.empty() || filled.back() == '\n') && text.substr(end + 1, 1) == "\n";
  if (value->second.empty() && fills_line) return end + 2;
  filled += value->second;
  return end + 1;
}

}  // namespace

std::string fill_template(std::string_view file, const Values& values) {
  const std::string_view text = template_text(file);
  std::string filled;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t begin = std::min(text.find('@', at), text.size());
    filled += text.substr(at, begin - at);
    at = begin == text.size() ? begin : append_value(text, begin, values, filled);
  }
  return filled;
}

}  // namespace mixcmp::project
