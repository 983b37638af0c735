#include "model/base/number/verdict.hpp"

#include "model/base/common/check.hpp"

namespace mixcmp::inline number {

std::string_view to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::less: return "less";
    case Verdict::equal: return "equal";
    case Verdict::greater: return "greater";
    case Verdict::unordered: return "unordered";
  }
  MIXCMP_CHECK(false);
}

std::string_view to_string(const std::optional<Verdict>& truth) {
  return truth ? to_string(*truth) : "undetermined";
}

}  // namespace mixcmp::inline number
