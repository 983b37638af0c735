#include "model/plan/profile/variant_check.hpp"

#include <algorithm>

#include "model/base/common/check.hpp"
#include "model/base/number/exact.hpp"
#include "model/judge/golden/fixed_evaluate.hpp"
#include "model/scene/reference_model.hpp"

namespace mixcmp::profile {
namespace {

/// Whether all operands are numbers of the declared ranges.
bool are_in_range(const scene::Scene& scene, const std::vector<Bits>& operands) {
  const FloatFormat format = scene.reference.format;
  for (std::size_t k = 0; k < operands.size(); ++k) {
    if (!scene.ranges[k]) continue;
    if (!format.is_finite(operands[k])) return false;
    const mpq_class number = to_rational(format, operands[k]);
    if (number < scene.ranges[k]->low || number > scene.ranges[k]->high) return false;
  }
  return true;
}

}  // namespace

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
    // A move is another way to write the comparison only within the ranges.
    if (given.variants_are_moves && !are_in_range(given, operands)) {
      ++check.out_of_range;
      continue;
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
