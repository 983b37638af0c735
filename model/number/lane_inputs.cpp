#include "model/number/lane_inputs.hpp"

#include "model/common/check.hpp"

namespace mixcmp::inline number {

std::string_view to_string(LaneInputs inputs) {
  switch (inputs) {
    case LaneInputs::rounded: return "rounded";
    case LaneInputs::exact: return "exact";
  }
  MIXCMP_CHECK(false);
}

}  // namespace mixcmp::inline number
