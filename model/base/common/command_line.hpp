#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace mixcmp::inline common {

/// A command of the program that repeats a run: a verb, its scene, its settings, and those of its
/// options that differ from their defaults.
///
///     CommandLine line("characterise", "scene.toml", {"system.lanes=3"});
///     line.add("--seeds", std::to_string(seeds), "3").add_flag("--quick", quick);
///     line.text();  // mixcmp characterise scene.toml --set system.lanes=3 --seeds 5
class CommandLine {
public:
  CommandLine(const std::string& verb, const std::filesystem::path& scene,
              std::span<const std::string> settings);

  /// Adds the option with its value, unless that is the usual one.
  CommandLine& add(const char* option, const std::string& value, const std::string& usual = "");
  /// Adds the flag if it is given.
  CommandLine& add_flag(const char* flag, bool given);
  /// Adds the option once for each of the values.
  CommandLine& add_each(const char* option, std::span<const std::string> values);
  /// Adds the option with all values behind it, unless there are none.
  CommandLine& add_all(const char* option, std::span<const std::string> values);

  const std::string& text() const { return line_; }

private:
  std::string line_;
};

}  // namespace mixcmp::inline common
