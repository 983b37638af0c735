#include "model/scene/override_error.hpp"

#include <fmt/core.h>

namespace mixcmp::scene {

Error with_setting(Error error, std::span<const std::string> overrides, const Attempt& attempt) {
  if (overrides.empty() || error.file.starts_with("--")) return error;
  const std::string text = error.to_string();
  const auto comes_up = [&](std::size_t count) {
    const std::optional<Error> found = attempt(overrides.first(count));
    return found && found->to_string() == text;
  };
  if (!comes_up(overrides.size())) return error;  // the error did not recur: its cause is unknown
  std::size_t count = 0;
  while (!comes_up(count)) ++count;
  if (count == 0) return error;
  const std::string& culprit = overrides[count - 1];
  if (error.line > 0) {
    error.message += fmt::format(" (at {}:{})", error.file, error.line);
  } else if (!error.file.empty()) {
    error.message += fmt::format(" (in {})", error.file);
  }
  error.file = fmt::format("--set {}", culprit.substr(0, culprit.find('=')));
  error.line = error.column = 0;
  return error;
}

}  // namespace mixcmp::scene
