#pragma once

#include <span>
#include <string>
#include <string_view>

namespace mixcmp::inline common {

/// The number of insertions, deletions, substitutions and swaps of neighbours that turn `a` into
/// `b`.
int edit_distance(std::string_view a, std::string_view b);

/// The name closest to `text`, or empty if no name is close enough for a typing error.
std::string nearest(std::string_view text, std::span<const std::string> names);

/// "a, b, c", with `text`'s nearest name first: "format (the nearest), bound, inputs".
std::string list_with_nearest(std::string_view text, std::span<const std::string> names);

}  // namespace mixcmp::inline common
