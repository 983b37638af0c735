#pragma once

#include <nlohmann/json_fwd.hpp>

#include "generator/faces/cli/characterise_options.hpp"

namespace mixcmp::cli {

/// Takes areas and a clock from the reports of a vendor's tool into the table of the command. Ends
/// the program where a report is not of the scene's system on its device.
void import_reports(const CharacteriseCommand& command);

/// A table's row as --json prints it.
nlohmann::ordered_json json_of_row(const measured::Measurement& row);

}  // namespace mixcmp::cli
