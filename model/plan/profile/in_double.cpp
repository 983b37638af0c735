#include "model/plan/profile/in_double.hpp"

#include <algorithm>

#include "model/base/number/double.hpp"
#include "model/design/design.hpp"

namespace mixcmp::profile {
namespace {

Error unsuitable(const scene::Scene& scene, const std::string& reason, std::string accepted) {
  return {.file = scene.path.string(),
          .field = "reference.format",
          .message = "a profile computes in double, which does not hold this format" + reason,
          .received = scene.reference.format.name(),
          .accepted = std::move(accepted)};
}

bool is_double(const OperandFormat& operand) {
  return operand.fixed() != nullptr && operand.fixed()->magnitude_bits() <= double_digits;
}

}  // namespace

Result<Done> check_in_double(const scene::Scene& scene) {
  if (!scene.has_only_fixed_operands()) {
    return unsuitable(scene, "", "up to 53 digits and 11 exponent bits");
  }
  const auto& formats = scene.operand_formats;
  const auto wide = std::find_if_not(formats.begin(), formats.end(), is_double);
  if (wide != formats.end()) {
    return unsuitable(scene, ", nor operands in " + wide->name(),
                      "operands in fixed point of at most 53 digits");
  }
  const auto exact = design::reference_datapath(scene);
  if (exact.ok()) return Done{};
  return unsuitable(scene, "; " + exact.error().message, exact.error().accepted);
}

InDouble in_double(const scene::Scene& scene, const data::Comparisons& data) {
  const FloatFormat format = FloatFormat::parse("binary64").value();
  InDouble result{scene, data.in_format(format),
                  std::get<fixed::FixedLane>(design::reference_datapath(scene).value())};
  result.scene.reference.format = format;
  result.exact_reference.input_format = format;
  return result;
}

}  // namespace mixcmp::profile
