#include "generator/datapath/delays.hpp"

namespace mixcmp::gen {

model::Result<DelayTable> delays_of(std::string_view device) {
  MIXCMP_TRY(found, model::find_device(device));
  return found.delays;
}

}  // namespace mixcmp::gen
