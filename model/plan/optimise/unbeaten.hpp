#pragma once

#include <vector>

namespace mixcmp::optimise {

/// The numbers below `count` that no other one beats. `beats(a, b)` is never asked for a == b.
template <class Number, class Beats>
std::vector<Number> unbeaten(Number count, Beats beats) {
  std::vector<Number> kept;
  for (Number b = 0; b < count; ++b) {
    bool is_beaten = false;
    for (Number a = 0; a < count && !is_beaten; ++a) is_beaten = a != b && beats(a, b);
    if (!is_beaten) kept.push_back(b);
  }
  return kept;
}

}  // namespace mixcmp::optimise
