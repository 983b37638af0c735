#pragma once

#include <map>
#include <string>
#include <string_view>

namespace mixcmp::project {

/// The text for each placeholder of a template, by its name without the @ around it.
using Values = std::map<std::string, std::string>;

/// The text of a file in generator/project/templates with every placeholder replaced. A placeholder
/// is a name in capitals, digits and underscores between two @. Each must have a value. A line that
/// holds nothing but placeholders with empty values is left out.
///
/// Three directives have a line of their own. The lines between @IF NAME@ and @END@ stay where
/// NAME's value is not empty. @INCLUDE file@ stands for another template, filled with the same
/// values.
std::string fill_template(std::string_view file, const Values& values);

}  // namespace mixcmp::project
