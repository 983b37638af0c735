#pragma once

namespace mixcmp::inline common {

/// Prints the broken invariant with its place and aborts. Never for a user's mistake.
[[noreturn]] void fail_check(const char* condition, const char* file, int line);

}  // namespace mixcmp::inline common

/// The one assert: always on, for broken invariants.
#define MIXCMP_CHECK(condition) \
  ((condition) ? void() : ::mixcmp::fail_check(#condition, __FILE__, __LINE__))
