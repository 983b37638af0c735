#include "model/plan/optimise/plan_inputs.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <optional>
#include <utility>

#include "model/base/common/output_file.hpp"
#include "model/base/common/quote.hpp"
#include "model/plan/optimise/second_tier.hpp"
#include "model/scene/plan.hpp"

namespace mixcmp::optimise {
namespace {

namespace fs = std::filesystem;

/// Replaces measured errors by the constants that the scene gives: lanes of a plan have these at
/// every precision.
void use_given_constants(const scene::ReducedSpec& reduced, profile::ErrorProfile& errors) {
  for (profile::ErrorAtPrecision& error : errors.precisions) {
    if (reduced.relative_error_f) error.f = reduced.relative_error_f;
    if (reduced.relative_error_g) error.g = reduced.relative_error_g;
  }
}

/// Checks that a plan can name the path: it must be one line of UTF-8.
Result<std::string> named_in(const fs::path& plan, const std::string& path) {
  if (is_one_line(path)) return path;
  return Error{.file = plan.string(),
               .message = "cannot be written: it would name a path that is not one line of UTF-8",
               .received = in_quotes(path),
               .accepted = "folders with names in UTF-8"};
}

/// The positive number that fills `text`; none for any other text.
std::optional<double> positive_number(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  const bool is_whole = !text.empty() && *end == '\0';
  return is_whole && value > 0 ? std::optional(value) : std::nullopt;
}

Error of_another(const fs::path& path, const char* field, const std::string& received,
                 const std::string& accepted) {
  return Error{.file = path.string(),
               .field = field,
               .message = fmt::format("the table is of another {}", field),
               .received = received,
               .accepted = accepted};
}

/// The bounds of the lanes that are counted: those of `choice`, with that of a second tier.
Result<std::vector<Bound>> counted_for(const scene::Scene& scene, const OptimiseOptions& choice) {
  std::vector<Bound> bounds = choice.bounds;
  if (bounds.empty()) return bounds;
  MIXCMP_TRY(tier, second_tier_lane(scene));
  if (tier) bounds.push_back(tier->bound);
  return bounds;
}

/// Only profiled lanes need measured errors.
bool has_profiled(const std::vector<Bound>& bounds) {
  return std::any_of(bounds.begin(), bounds.end(),
                     [](const Bound& bound) { return bound.is_profiled(); });
}

/// Lanes of at least this many digits are counted on all data. Shorter ones usually leave many
/// comparisons undecided, so that a sample is enough; emulating them all would take most of the
/// time.
constexpr int first_on_all = 11;
/// A sample has at least so many comparisons.
constexpr std::uint64_t sample_size = std::uint64_t{1} << 22;
/// A sample is enough where each lane leaves so many of it undecided: a standard error of 1 %.
constexpr std::uint64_t enough_undecided = 10'000;

/// The errors at the precisions first .. last - 1.
profile::ErrorProfile errors_at(profile::ErrorProfile errors, int first, int last) {
  std::erase_if(errors.precisions, [&](const profile::ErrorAtPrecision& each) {
    return each.precision < first || each.precision >= last;
  });
  return errors;
}

/// Drops the precisions of a sample from the first one on at which some lane leaves too little
/// undecided; returns that one.
int keep_frequent(profile::RateProfile& sample, std::size_t precisions) {
  std::size_t kept = precisions;
  for (const profile::SchemeProfile& scheme : sample.schemes) {
    const auto rare = std::find_if(
        scheme.counts.begin(), scheme.counts.end(),
        [](const auto& counts) { return counts.exists && counts.undecided < enough_undecided; });
    kept = std::min(kept, static_cast<std::size_t>(rare - scheme.counts.begin()));
  }
  for (profile::SchemeProfile& scheme : sample.schemes) scheme.counts.resize(kept);
  return sample.first_precision + static_cast<int>(kept);
}

/// Counts lanes of few digits on a sample if the data are at least twice as large, and all other
/// lanes on all data. The last precision is always among these: only they tell which pairs are
/// reported.
std::vector<profile::RateProfile> sampled_rates(const scene::Scene& scene,
                                                const data::Comparisons& data,
                                                const profile::ErrorProfile& errors,
                                                profile::ProfileOptions options) {
  const int last = errors.precisions.back().precision;
  int first = errors.precisions.front().precision;
  const std::uint64_t stretch = data.size() / sample_size;
  std::vector<profile::RateProfile> rates;
  const int sampled_to = std::min(first_on_all, last);
  if (stretch > 1 && first < sampled_to) {
    options.stretch = stretch;
    const profile::ErrorProfile few_digits = errors_at(errors, first, sampled_to);
    auto sample = profile_rates(scene, data, few_digits, options);
    options.stretch = 1;
    const int frequent_to = keep_frequent(sample, few_digits.precisions.size());
    if (frequent_to > first) rates.push_back(std::move(sample));
    first = frequent_to;
  }
  rates.push_back(profile_rates(scene, data, errors_at(errors, first, last + 1), options));
  return rates;
}

}  // namespace

fs::path default_table(const fs::path& file, const scene::Scene& scene, const std::string& device) {
  const std::string variant = scene.variant.empty() ? "" : "-" + scene.variant;
  // A segment's area depends on the tier, so it needs its own table. A table of streams has rows
  // for both.
  const bool has_own_table =
      scene.leaves_out_second_tier && scene.system.engine.kind == scene::EngineKind::pairwise;
  const std::string tiers = has_own_table ? "-one-tier" : "";
  return file.parent_path() / "characterisation" /
         fmt::format("{}{}{}-{}.csv", file.stem().string(), variant, tiers, device);
}

Result<measured::Characterisation> read_table(const fs::path& path, const scene::Scene& scene,
                                              const devices::Device& device) {
  MIXCMP_TRY(table, measured::read_characterisation(path));
  if (table.device != device.name) return of_another(path, "device", table.device, device.name);
  if (table.scene != scene.name) return of_another(path, "scene", table.scene, scene.name);
  const std::string wanted = measured::engine_text(scene);
  for (const auto& [name, text] : table.spec) {
    if (name != "engine" || wanted.empty()) continue;
    if (text != wanted) return of_another(path, "engine", text, wanted);
  }
  MIXCMP_DO(measured::check_groups(table, path, scene));
  return table;
}

Result<scene::Scene> with_target_of(const measured::Characterisation& table, const fs::path& path,
                                    scene::Scene scene) {
  for (const auto& [name, text] : table.spec) {
    if (name != "target_mhz") continue;
    const std::optional<double> measured = positive_number(text);
    if (!measured) {
      return Error{.file = path.string(),
                   .field = "target_mhz",
                   .message = "cannot be read",
                   .received = text,
                   .accepted = "a clock in MHz"};
    }
    scene.system.target_mhz = *measured;
    break;
  }
  return scene;
}

std::set<LaneInputs> inputs_of_lanes(const measured::Characterisation& table) {
  std::set<LaneInputs> inputs = {LaneInputs::exact, LaneInputs::rounded};
  for (const measured::Measurement& row : table.rows) {
    const measured::Lane* lane = measured::lane_of(row.key);
    if (lane != nullptr && lane->inputs) inputs.insert(*lane->inputs);
  }
  return inputs;
}

Result<std::vector<profile::RateProfile>> measure_rates(
    const scene::Scene& scene, const data::Comparisons& data, const std::set<LaneInputs>& inputs,
    const OptimiseOptions& choice,
    const std::function<void(const std::string&, double)>& progress) {
  profile::ProfileOptions options{.first_precision = choice.first_precision,
                                  .last_precision = choice.last_precision};
  // Lane precisions that the reference does not allow are left out; check_profile refuses a first
  // one that is.
  const int most = settings::lane_precisions(scene.reference.format).most;
  if (options.first_precision <= most) {
    options.last_precision = std::min(options.last_precision, most);
  }
  options.progress = progress;
  MIXCMP_TRY(bounds, counted_for(scene, choice));
  options.bounds = std::move(bounds);
  if (!options.bounds.empty() && !has_profiled(options.bounds)) options.error_samples = 0;
  MIXCMP_DO(check_profile(scene, options));
  auto errors = profile_errors(scene, data, {inputs.begin(), inputs.end()}, options);
  std::vector<profile::RateProfile> rates;
  for (profile::ErrorProfile& each : errors) {
    use_given_constants(scene.reduced, each);
    if (choice.samples_rates) {
      std::ranges::move(sampled_rates(scene, data, each, options), std::back_inserter(rates));
    } else {
      rates.push_back(profile_rates(scene, data, each, options));
    }
    // Lanes in fixed point take their operands as they are: only the first kind of inputs counts
    // them. No bounds stand for all of them, so that none can be erased.
    if (options.bounds.empty()) continue;
    std::erase_if(options.bounds, [](const Bound& bound) { return bound.is_fixed_point(); });
    if (options.bounds.empty()) break;
  }
  return rates;
}

Result<PlanSource> make_plan_source(const fs::path& scene, std::span<const std::string> overrides,
                                    const std::string& device, const fs::path& plan,
                                    std::string command) {
  // Symbolic links of folders and of the plan are followed, since names in the plan are relative to
  // the folder that contains it. A link that is the scene itself is not followed: the scene finds
  // its data beside the link. In a plan that goes to a pipe, names are relative to the working
  // directory.
  MIXCMP_TRY(target, follow_links(plan));
  std::error_code failed;
  const fs::path place = fs::weakly_canonical(fs::absolute(target), failed);
  const fs::path folder = failed ? fs::current_path() : place.parent_path();
  const fs::path file = fs::canonical(fs::absolute(scene).parent_path()) / scene.filename();
  const bool device_is_file = device.ends_with(".toml");
  MIXCMP_TRY(read, scene::read_scene_settings(scene, overrides));
  MIXCMP_TRY(scene_name, named_in(plan, file.lexically_relative(folder).generic_string()));
  MIXCMP_TRY(device_name, named_in(plan, device_is_file ? fs::canonical(device).string() : device));
  return PlanSource{.scene_file = scene_name,
                    .overrides = settings::overridden_entries(read.settings.root, overrides),
                    .device = device_name,
                    .command = std::move(command)};
}

}  // namespace mixcmp::optimise
