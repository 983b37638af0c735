#pragma once

#include <string>
#include <string_view>

#include "model/base/common/embedded_file.hpp"
#include "model/base/common/result.hpp"

namespace mixcmp::characterise {

/// The longest path that Yosys' `sta` found between registers and ports, in picoseconds, from its
/// printed text. An error if there is no path, or if the text names cells without known delays,
/// since a longer path may lead through these.
Result<int> longest_path_ps(std::string_view sta_text);

/// A techmap file that moves the last register of each shift register out of it.
const EmbeddedFile& shift_register_output();

}  // namespace mixcmp::characterise
