#include "model/common/result.hpp"

#include <fmt/core.h>

namespace mixcmp::model {

std::string Error::to_string() const {
  std::string text = file;
  if (line > 0) text += fmt::format(":{}", line);
  if (line > 0 && column > 0) text += fmt::format(":{}", column);
  if (!field.empty()) text += (text.empty() ? "" : ": ") + field;
  if (!message.empty()) text += (text.empty() ? "" : ": ") + message;
  if (!received.empty()) text += fmt::format(": received {}", received);
  if (!accepted.empty()) text += fmt::format("; accepted {}", accepted);
  return text;
}

}  // namespace mixcmp::model
