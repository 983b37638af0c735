#pragma once

#include <string>
#include <string_view>

namespace mixcmp::model {

/// `text` in quotes, fit for one line of an error message: control characters and bytes beyond
/// ASCII's become '?', and what is too long ends in "...".
std::string in_quotes(std::string_view text);

}  // namespace mixcmp::model
