#include "model/plan/profile/unsettled_comparisons.hpp"

namespace mixcmp::profile {

UnsettledComparisons::UnsettledComparisons(std::size_t inputs, std::size_t capacity)
    : truth(capacity),
      reference(capacity),
      schemes(capacity),
      failing(capacity),
      operands_(inputs, capacity) {}

void UnsettledComparisons::append(const UnsettledComparisons& from, std::size_t row,
                                  std::uint32_t schemes_left) {
  MIXCMP_CHECK(size() < capacity());
  const std::size_t place = size();
  truth[place] = from.truth[row];
  reference[place] = from.reference[row];
  schemes[place] = schemes_left;
  failing[place] = from.failing[row];
  operands_.append(from.operands_, row);
}

}  // namespace mixcmp::profile
