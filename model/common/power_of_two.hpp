#pragma once

#include <gmpxx.h>

namespace mixcmp::model {

/// Whether a canonical rational is 2^k for an integer k: 1/4, 1, 1024, ...
inline bool is_power_of_two(const mpq_class& value) {
  return value > 0 && mpz_popcount(value.get_num_mpz_t()) == 1 &&
         mpz_popcount(value.get_den_mpz_t()) == 1;
}

}  // namespace mixcmp::model
