#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

#include "model/base/common/result.hpp"

/// The common part of every fuzzer of a reader (docs/development.md, "Fuzzers").
namespace mixcmp::test {

/// The bytes of an input as a file, for readers that take a path. There is one such file, in
/// memory, and each input replaces the last.
std::filesystem::path file_of(const std::uint8_t* data, std::size_t size);

std::string text_of(const std::uint8_t* data, std::size_t size);

/// Ends the program, as a sanitizer would, where a property of a reader does not hold.
void require(bool holds);

/// Every error must have a message and a text of one printable line.
void check(const Error& error);

/// Checks the error, if there is one; whether there is a value.
template <class T>
bool is_read(const Result<T>& result) {
  if (!result.ok()) check(result.error());
  return result.ok();
}

}  // namespace mixcmp::test
