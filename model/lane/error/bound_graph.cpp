#include "model/lane/error/bound_graph.hpp"

#include "model/base/common/check.hpp"

namespace mixcmp::error {

int arity(BoundOperation operation) {
  switch (operation) {
    case BoundOperation::constant:
    case BoundOperation::magnitude:
    case BoundOperation::binade:
    case BoundOperation::reciprocal: return 0;
    case BoundOperation::add:
    case BoundOperation::multiply:
    case BoundOperation::maximum: return 2;
  }
  MIXCMP_CHECK(false);
}

std::string_view to_string(BoundOperation operation) {
  switch (operation) {
    case BoundOperation::constant: return "constant";
    case BoundOperation::magnitude: return "magnitude";
    case BoundOperation::binade: return "binade";
    case BoundOperation::reciprocal: return "reciprocal";
    case BoundOperation::add: return "add";
    case BoundOperation::multiply: return "multiply";
    case BoundOperation::maximum: return "maximum";
  }
  MIXCMP_CHECK(false);
}

}  // namespace mixcmp::error
