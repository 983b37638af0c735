#include <fmt/format.h>

#include <algorithm>

#include "model/base/number/double.hpp"
#include "model/plan/profile/in_double.hpp"
#include "model/plan/profile/profile.hpp"

namespace mixcmp::profile {

Result<Done> check_profile(const scene::Scene& scene, const ProfileOptions& options) {
  if (!fits_double(scene.reference.format)) MIXCMP_DO(check_in_double(scene));
  if (scene.reduced.format && !fits_double(*scene.reduced.format)) {
    return Error{.file = scene.path.string(),
                 .field = "reduced.format",
                 .message = "a profile computes in double, which does not hold this format",
                 .received = scene.reduced.format->name(),
                 .accepted = "up to 53 digits and 11 exponent bits"};
  }
  const settings::Limits allowed = settings::lane_precisions(scene.reference.format);
  if (!allowed.allow(options.first_precision) || !allowed.allow(options.last_precision) ||
      options.first_precision > options.last_precision) {
    return Error{
        .file = scene.path.string(),
        .field = "first precision, last precision",
        .message = "no such precisions can be profiled",
        .received = fmt::format("L = {}..{}", options.first_precision, options.last_precision),
        .accepted = fmt::format("{}, at most the reference's, the first not after "
                                "the last",
                                to_string(allowed))};
  }
  const auto is_profiled = [](const Bound& bound) { return bound.is_profiled(); };
  if (options.error_samples == 0 &&
      std::any_of(options.bounds.begin(), options.bounds.end(), is_profiled)) {
    return Error{.file = scene.path.string(),
                 .field = "samples",
                 .message = "the constants of profiled lanes are measured on samples",
                 .received = "0",
                 .accepted = "1 or more"};
  }
  return Done{};
}

}  // namespace mixcmp::profile
