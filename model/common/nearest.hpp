#pragma once

#include <span>
#include <string>
#include <string_view>

namespace mixcmp::inline common {

/// The number of insertions, deletions, substitutions and swaps of neighbours that turn `a` into
/// `b`.
int edit_distance(std::string_view a, std::string_view b);

/// The name closest to `text`, or empty where none is close enough to be a slip of the fingers.
std::string nearest(std::string_view text, std::span<const std::string> names);

/// "a, b, c", with `text`'s nearest name first: "format (the nearest), bound, inputs".
std::string list_with_nearest(std::string_view text, std::span<const std::string> names);

}  // namespace mixcmp::inline common
