#pragma once

namespace mixcmp::report {

/// Rates are printed in G/s.
inline constexpr double giga = 1e9;

}  // namespace mixcmp::report
