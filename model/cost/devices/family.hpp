#pragma once

#include "model/base/common/result.hpp"
#include "model/base/settings/settings.hpp"

namespace mixcmp::devices {

/// A device file with everything that it leaves to its part or family (docs/devices.md). A file
/// that names neither stays as it is.
Result<settings::Settings> with_family(settings::Settings file);

}  // namespace mixcmp::devices
