#include "generator/hardware/emit/templates.hpp"

#include <algorithm>
#include <cctype>

#include "embedded/ecp5_cells.hpp"
#include "embedded/ice40_cells.hpp"
#include "embedded/rtl_templates.hpp"
#include "model/base/common/check.hpp"

namespace mixcmp::emit {
namespace {

std::string_view module_of(const EmbeddedFile& file) {
  return file.name.substr(0, file.name.rfind('.'));
}

const EmbeddedFile* find_template(std::string_view module) {
  for (const EmbeddedFile& file : rtl_templates()) {
    if (module_of(file) == module) return &file;
  }
  return nullptr;
}

bool is_identifier(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

std::size_t end_of_identifier(std::string_view text, std::size_t start) {
  const auto end = std::find_if_not(text.begin() + static_cast<std::ptrdiff_t>(start), text.end(),
                                    is_identifier);
  return static_cast<std::size_t>(end - text.begin());
}

/// All identifiers of a Verilog text outside of `//` comments.
std::set<std::string> identifiers(std::string_view text) {
  std::set<std::string> words;
  for (std::size_t k = 0; k < text.size();) {
    if (text.substr(k, 2) == "//") {
      k = std::min(text.find('\n', k), text.size());
    } else if (is_identifier(text[k])) {
      const std::size_t end = end_of_identifier(text, k);
      words.emplace(text.substr(k, end - k));
      k = end;
    } else {
      ++k;
    }
  }
  return words;
}

void add_closure(const std::string& module, std::set<std::string>& closure) {
  const EmbeddedFile* file = find_template(module);
  if (file == nullptr || !closure.insert(module).second) return;
  for (const std::string& word : identifiers(file->text)) add_closure(word, closure);
}

}  // namespace

std::string_view template_text(const std::string& module) {
  const EmbeddedFile* file = find_template(module);
  MIXCMP_CHECK(file != nullptr);
  return file->text;
}

bool is_template(const std::string& module) {
  return find_template(module) != nullptr;
}

std::vector<TechnologyCell> technology_cells(const std::vector<std::string>& modules) {
  std::vector<TechnologyCell> cells;
  const auto add = [&](const std::string& family, const EmbeddedFile& file) {
    const std::string module(module_of(file));
    if (std::find(modules.begin(), modules.end(), module) == modules.end()) return;
    cells.push_back({module, family, std::string(file.text)});
  };
  for (const EmbeddedFile& file : ecp5_cells()) add("ecp5", file);
  for (const EmbeddedFile& file : ice40_cells()) add("ice40", file);
  return cells;
}

std::string with_prefix(std::string_view text, const std::string& prefix) {
  std::string prefixed;
  for (std::size_t k = 0; k < text.size();) {
    if (!is_identifier(text[k])) {
      prefixed += text[k++];
      continue;
    }
    const std::size_t end = end_of_identifier(text, k);
    const std::string_view word = text.substr(k, end - k);
    if (find_template(word) != nullptr) prefixed += prefix;
    prefixed += word;
    k = end;
  }
  return prefixed;
}

std::vector<std::string> template_closure(const std::set<std::string>& modules) {
  std::set<std::string> closure;
  for (const std::string& module : modules) add_closure(module, closure);
  return {closure.begin(), closure.end()};
}

}  // namespace mixcmp::emit
