#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "generator/faces/cli/options.hpp"
#include "generator/tasks/optimise_on.hpp"

/// `optimise --on`: plans on many devices.
namespace mixcmp::cli {

/// Adds --on to `optimise`, whose other options must be there.
void add_on_option(const Verb& verb, std::vector<std::string>& words);

/// The names of the devices that these words of --on mean: "all", letters as `mixcmp devices` takes
/// them, or a name that --device takes. Ends the program if a word means none.
std::vector<std::string> devices_on(const std::vector<std::string>& words);

/// The devices as people read them, the smallest first.
std::string to_text(const tasks::OptimiseOnResult& result);
/// An object with the field "devices".
nlohmann::ordered_json to_json(const tasks::OptimiseOnResult& result);

}  // namespace mixcmp::cli
