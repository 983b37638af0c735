#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "model/common/result.hpp"

namespace mixcmp::model {

using Command = std::vector<std::string>;

/// What is being done, for a line on a terminal.
using Progress = std::function<void(const std::string&)>;

/// A child process whose standard input is a socket to us, for both directions. Standard output and
/// error go to a log file.
class Child {
public:
  static Result<Child> spawn(const Command& command, const std::filesystem::path& log);
  Child(Child&& other) noexcept;
  Child& operator=(Child&&) = delete;
  /// Ends the child.
  ~Child();

  /// False if the child is gone.
  bool send(std::span<const std::byte> bytes);
  bool receive(std::span<std::byte> bytes);

private:
  Child(pid_t process, int socket) : process_(process), socket_(socket) {}

  pid_t process_;
  int socket_;
};

/// Runs a tool in `directory` to its end. If it fails, the error names the log and shows its end.
Result<Done> run_tool(const Command& command, const std::filesystem::path& directory,
                                    const std::filesystem::path& log, const Progress& progress);

/// The first line a tool prints about its version; an error that names the package if it is not
/// there.
Result<std::string> tool_version(const std::string& tool, const std::string& version_option,
                                        const std::string& package);

/// The last lines of a file, for error messages.
std::string last_lines(const std::filesystem::path& file, std::size_t count);

/// A command as a shell would take it.
std::string to_shell(const Command& command);

}  // namespace mixcmp::model
