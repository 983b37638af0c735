#include "tests/fuzz/input.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>

namespace mixcmp::test {

std::filesystem::path file_of(const std::uint8_t* data, std::size_t size) {
  static const int file = memfd_create("input", 0);
  require(file >= 0 && ftruncate(file, 0) == 0);
  require(pwrite(file, data, size, 0) == static_cast<ssize_t>(size));
  return "/proc/self/fd/" + std::to_string(file);
}

std::string text_of(const std::uint8_t* data, std::size_t size) {
  return {data, data + size};
}

void require(bool holds) {
  if (!holds) std::abort();
}

void check(const Error& error) {
  require(!error.message.empty());
  const std::string text = error.to_string();
  require(std::all_of(text.begin(), text.end(),
                      [](unsigned char c) { return (c >= ' ' && c != 0x7f) || c == '\n'; }));
}

}  // namespace mixcmp::test
