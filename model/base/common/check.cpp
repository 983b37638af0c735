#include "model/base/common/check.hpp"

#include <fmt/core.h>

#include <cstdio>
#include <cstdlib>

namespace mixcmp::inline common {

void fail_check(const char* condition, const char* file, int line) {
  fmt::print(stderr, "{}:{}: broken invariant: {}\n", file, line, condition);
  std::abort();
}

}  // namespace mixcmp::inline common
