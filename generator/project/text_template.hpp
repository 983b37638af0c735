#pragma once

#include <map>
#include <string>
#include <string_view>

namespace mixcmp::project {

/// What stands for each placeholder of a template: its name, without the @ around it, and a text.
using Values = std::map<std::string, std::string>;

/// The text of a file in generator/project/templates with every placeholder replaced. A placeholder
/// is a name in capitals, digits and underscores between two @. Each must have a value. A
/// placeholder that is alone in its line and has an empty value leaves no line.
std::string fill_template(std::string_view file, const Values& values);

}  // namespace mixcmp::project
