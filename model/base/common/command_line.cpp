#include "model/base/common/command_line.hpp"

#include "model/base/common/quote.hpp"

namespace mixcmp::inline common {

CommandLine::CommandLine(const std::string& verb, const std::filesystem::path& scene,
                         std::span<const std::string> settings)
    : line_("mixcmp " + verb + " " + quoted(scene.string())) {
  add_each("--set", settings);
}

CommandLine& CommandLine::add(const char* option, const std::string& value,
                              const std::string& usual) {
  if (value != usual) line_ += std::string(" ") + option + " " + quoted(value);
  return *this;
}

CommandLine& CommandLine::add_flag(const char* flag, bool given) {
  if (given) line_ += std::string(" ") + flag;
  return *this;
}

CommandLine& CommandLine::add_each(const char* option, std::span<const std::string> values) {
  for (const std::string& value : values) {
    line_ += std::string(" ") + option + " " + quoted(value);
  }
  return *this;
}

CommandLine& CommandLine::add_all(const char* option, std::span<const std::string> values) {
  add_flag(option, !values.empty());
  for (const std::string& value : values) line_ += " " + quoted(value);
  return *this;
}

}  // namespace mixcmp::inline common
