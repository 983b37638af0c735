#include "model/common/quote.hpp"

namespace mixcmp::model {

std::string in_quotes(std::string_view text) {
  constexpr std::size_t most = 80;
  std::string shown = "\"";
  for (const char c : text.substr(0, most)) shown += ' ' <= c && c <= '~' ? c : '?';
  if (text.size() > most) shown += "...";
  shown += '"';
  return shown;
}

}  // namespace mixcmp::model
