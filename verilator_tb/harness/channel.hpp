#pragma once

#include <unistd.h>

#include <cstddef>
#include <cstdlib>

namespace mixcmp::harness {

/// The socket to the host. The simulator ends when the host closes it.
class Channel {
public:
  /// Takes over standard input, which is the socket, and sends standard output to standard error:
  /// texts of the model must not mix with the answers.
  Channel() : descriptor_(dup(STDIN_FILENO)) { dup2(STDERR_FILENO, STDOUT_FILENO); }

  template <class T>
  void read(T* items, std::size_t count) {
    transfer(reinterpret_cast<char*>(items), count * sizeof(T), ::read);
  }
  template <class T>
  void write(const T* items, std::size_t count) {
    transfer(reinterpret_cast<const char*>(items), count * sizeof(T), ::write);
  }

private:
  template <class Bytes, class Call>
  void transfer(Bytes* bytes, std::size_t size, Call call) {
    while (size > 0) {
      const ssize_t done = call(descriptor_, bytes, size);
      if (done <= 0) std::exit(EXIT_FAILURE);
      bytes += done;
      size -= static_cast<std::size_t>(done);
    }
  }

  int descriptor_;
};

}  // namespace mixcmp::harness
