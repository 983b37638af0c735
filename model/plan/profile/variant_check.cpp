#include "model/plan/profile/variant_check.hpp"

#include <algorithm>

#include "model/base/common/check.hpp"
#include "model/judge/golden/fixed_evaluate.hpp"
#include "model/scene/reference_model.hpp"

namespace mixcmp::profile {

VariantCheck check_variant(const scene::Scene& given, const scene::Scene& variant,
                           const data::Comparisons& data, std::uint64_t most,
                           const std::function<void(double)>& progress) {
  MIXCMP_CHECK(given.graph.inputs() == variant.graph.inputs());
  const FloatFormat format = given.reference.format;
  const auto reference = scene::reference_model(given).value();
  const auto variant_reference = scene::reference_model(variant).value();
  VariantCheck check{.variant = variant.variant, .comparisons = std::min(most, data.size())};
  std::vector<Bits> operands(data.input_count());
  for (std::uint64_t k = 0; k < check.comparisons; ++k) {
    const auto index = static_cast<std::uint64_t>(Bits{k} * data.size() / check.comparisons);
    data.fetch(index, operands);
    if (progress && k % 1024 == 0) {
      progress(static_cast<double>(k) / static_cast<double>(check.comparisons));
    }
    const auto is = golden::verdict_within(given.graph, format, operands, checked_bits);
    const auto becomes = golden::verdict_within(variant.graph, format, operands, checked_bits);
    check.reference_differences += golden::evaluate_reference(reference, operands) !=
                                   golden::evaluate_reference(variant_reference, operands);
    check.undetermined += !is || !becomes;
    if (!is || !becomes || *is == *becomes) continue;
    ++check.differences;
    if (!check.first_difference) check.first_difference = {index, *is, *becomes};
  }
  return check;
}

}  // namespace mixcmp::profile
