#pragma once

#include <gmpxx.h>

namespace mixcmp::inline expression {

/// A closed interval of exact numbers.
struct Range {
  mpq_class low;
  mpq_class high;

  friend bool operator==(const Range&, const Range&) = default;
};

}  // namespace mixcmp::inline expression
