#include "generator/emit/templates.hpp"

#include <cctype>

#include "embedded/rtl_templates.hpp"
#include "model/common/check.hpp"

namespace mixcmp::gen {
namespace {

const model::EmbeddedFile* find_template(std::string_view module) {
  for (const model::EmbeddedFile& file : rtl_templates()) {
    if (file.name.substr(0, file.name.rfind('.')) == module) return &file;
  }
  return nullptr;
}

bool is_identifier(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// Every identifier outside of `//` comments.
std::set<std::string> identifiers(std::string_view text) {
  std::set<std::string> words;
  for (std::size_t k = 0; k < text.size();) {
    if (text.substr(k, 2) == "//") {
      k = std::min(text.find('\n', k), text.size());
    } else if (is_identifier(text[k])) {
      const std::size_t start = k;
      while (k < text.size() && is_identifier(text[k])) ++k;
      words.emplace(text.substr(start, k - start));
    } else {
      ++k;
    }
  }
  return words;
}

void add_closure(const std::string& module, std::set<std::string>& closure) {
  const model::EmbeddedFile* file = find_template(module);
  if (file == nullptr || !closure.insert(module).second) return;
  for (const std::string& word : identifiers(file->text)) add_closure(word, closure);
}

}  // namespace

std::string_view template_text(const std::string& module) {
  const model::EmbeddedFile* file = find_template(module);
  MIXCMP_CHECK(file != nullptr);
  return file->text;
}

std::vector<std::string> template_closure(const std::set<std::string>& modules) {
  std::set<std::string> closure;
  for (const std::string& module : modules) add_closure(module, closure);
  return {closure.begin(), closure.end()};
}

}  // namespace mixcmp::gen
