#pragma once

#include "generator/hardware/rtl/channel_modules.hpp"

namespace mixcmp::rtl {

/// The crossbar between the channels of all lanes and `asked` channels that answer them.
TemplateInstance crossbar_template(const SystemShape& shape, int asked);

/// The whole system: lanes, the second tier if there is one, references, and crossbars between
/// them.
Module top_module(const SystemShape& shape);

}  // namespace mixcmp::rtl
