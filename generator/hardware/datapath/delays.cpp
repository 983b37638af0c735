#include "generator/hardware/datapath/delays.hpp"

namespace mixcmp::datapath {

Result<DelayTable> delays_of(std::string_view device) {
  MIXCMP_TRY(found, devices::find_device(device));
  return found.delays;
}

}  // namespace mixcmp::datapath
