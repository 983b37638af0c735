#pragma once

#include <cctype>
#include <string>
#include <vector>

namespace mixcmp::test {

/// The end of a reference such as "&lt;" that begins at `at`; npos if none does.
inline std::size_t end_of_reference(const std::string& text, std::size_t at) {
  std::size_t end = at + 1;
  while (end < text.size() && (std::isalnum(static_cast<unsigned char>(text[end])) != 0)) ++end;
  return end > at + 1 && end < text.size() && text[end] == ';' ? end : std::string::npos;
}

/// The fault in the attributes of a tag; empty if there is none.
inline std::string fault_of_attributes(const std::string& tag) {
  bool quoted = false;
  for (std::size_t k = 0; k < tag.size(); ++k) {
    if (tag[k] == '"') quoted = !quoted;
    if (tag[k] == '=' && !quoted && (k + 1 == tag.size() || tag[k + 1] != '"')) {
      return "an attribute without quotes: " + tag;
    }
  }
  return quoted ? "a quote that does not end: " + tag : "";
}

/// The first fault of a text as XML: tags that do not match, attributes without quotes, a "&" that
/// is no reference. Empty if there is none. CDATA and a document type are passed over.
inline std::string fault_of_markup(const std::string& text) {
  std::vector<std::string> open;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '&' && end_of_reference(text, at) == std::string::npos) {
      return "a bare & at " + text.substr(at, 40);
    }
    if (text[at] != '<') continue;
    const bool verbatim = text.compare(at, 9, "<![CDATA[") == 0;
    const std::size_t end = text.find(verbatim ? "]]>" : ">", at);
    if (end == std::string::npos) return "a tag that does not end: " + text.substr(at, 40);
    const std::string tag = text.substr(at + 1, end - at - 1);
    at = verbatim ? end + 2 : end;
    if (tag.starts_with("!")) continue;
    const std::string name = tag.substr(0, tag.find_first_of(" /", 1));
    if (tag.starts_with("/")) {
      if (open.empty() || "/" + open.back() != tag) return "does not match: <" + tag + ">";
      open.pop_back();
      continue;
    }
    const std::string fault = fault_of_attributes(tag);
    if (!fault.empty()) return fault;
    if (!tag.ends_with("/")) open.push_back(name);
  }
  return open.empty() ? "" : "not closed: <" + open.back() + ">";
}

}  // namespace mixcmp::test
