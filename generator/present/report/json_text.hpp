#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "model/base/common/result.hpp"

namespace mixcmp::report {

/// The text of a JSON report, with a line end. Bytes that are not UTF-8, as in the names of
/// folders, are replaced by U+FFFD.
std::string json_text(const nlohmann::ordered_json& json);

/// An error as JSON: its parts that are not empty, and under "text" the line that a user reads.
nlohmann::ordered_json to_json(const Error& error);

}  // namespace mixcmp::report
