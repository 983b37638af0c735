#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace mixcmp::report {

/// The text of a JSON report, with a line end. Bytes that are not UTF-8, as in the names of
/// folders, are replaced by U+FFFD.
std::string json_text(const nlohmann::ordered_json& json);

}  // namespace mixcmp::report
