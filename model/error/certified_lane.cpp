#include "model/error/certified_lane.hpp"

#include "model/common/check.hpp"
#include "model/error/relative_bound.hpp"

namespace mixcmp::model {

std::string_view to_string(ErrorBoundKind kind) {
  switch (kind) {
    case ErrorBoundKind::relative: return "relative";
    case ErrorBoundKind::running: return "running";
    case ErrorBoundKind::constant: return "constant";
  }
  MIXCMP_CHECK(false);
}

}  // namespace mixcmp::model
