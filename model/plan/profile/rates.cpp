#include <algorithm>
#include <array>
#include <mutex>
#include <utility>

#include "model/base/common/check.hpp"
#include "model/base/number/double.hpp"
#include "model/design/design.hpp"
#include "model/judge/golden/fixed_evaluate.hpp"
#include "model/plan/profile/in_double.hpp"
#include "model/plan/profile/rate_worker.hpp"
#include "model/scene/reference_model.hpp"

namespace mixcmp::profile {
namespace {

/// The precisions at which envelopes are computed anew. They are closer together at low precisions,
/// since the errors of a few digits are coarse.
constexpr std::array<int, 8> usual_anchors = {7, 11, 16, 22, 29, 36, 42, 48};

std::vector<int> anchors_of(const ErrorProfile& errors) {
  const int first = errors.precisions.front().precision, last = errors.precisions.back().precision;
  std::vector<int> anchors = {first};
  for (const int anchor : usual_anchors) {
    if (anchor > first && anchor <= last) anchors.push_back(anchor);
  }
  anchors.push_back(last + 1);
  return anchors;
}

std::vector<NodeMagnitude> input_magnitudes(const data::OperandSource& source) {
  std::vector<NodeMagnitude> magnitudes;
  for (std::size_t input = 0; input < source.data().input_count(); ++input) {
    magnitudes.push_back(magnitude_of(source.values(input)));
  }
  return magnitudes;
}

/// The operands that the lanes of one scheme take.
struct TakenOperands {
  std::vector<error::RangeCheck> checks;
  const fixed::FixedLane* fixed_lane = nullptr;

  bool take(int input, FloatFormat format, Bits operand) const {
    const auto fails = [&](const error::RangeCheck& check) {
      return check.input == input && !golden::passes(check, format, operand);
    };
    return std::none_of(checks.begin(), checks.end(), fails) &&
           (fixed_lane == nullptr || golden::takes(*fixed_lane, input, operand));
  }
};

/// The checks of lanes repeat from precision to precision; one of each is enough. All fixed-point
/// lanes with one kind of bound take the same operands.
TakenOperands taken_operands(const SchemeLanes& scheme) {
  TakenOperands taken;
  for (const std::optional<design::Lane>& lane : scheme.lanes) {
    if (!lane) continue;
    if (const auto* fixed_lane = std::get_if<fixed::FixedLane>(&*lane)) {
      taken.fixed_lane = fixed_lane;
      continue;
    }
    for (const error::RangeCheck& check : design::float_lane(*lane).checks) {
      const bool known =
          std::find(taken.checks.begin(), taken.checks.end(), check) != taken.checks.end();
      if (!known) taken.checks.push_back(check);
    }
  }
  return taken;
}

/// Bit k is set if scheme k does not take the operand for this input.
std::uint32_t failing_schemes(const std::vector<TakenOperands>& schemes, int input,
                              FloatFormat format, Bits operand) {
  std::uint32_t failing = 0;
  for (std::size_t scheme = 0; scheme < schemes.size(); ++scheme) {
    const bool fails = !schemes[scheme].take(input, format, operand);
    failing |= std::uint32_t{fails} << scheme;
  }
  return failing;
}

void find_failing(RateJob& job) {
  std::vector<TakenOperands> schemes;
  for (const SchemeLanes& scheme : job.schemes) schemes.push_back(taken_operands(scheme));
  const data::Comparisons& data = job.source.data();
  for (std::size_t input = 0; input < data.input_count(); ++input) {
    const data::Comparisons::Source& source = data.sources()[input];
    const data::Table& table = data.tables()[source.table];
    RateJob::Failing failing{.item = source.item, .of_row = {}};
    std::uint32_t any = 0;
    for (std::size_t row = 0; row < table.rows(); ++row) {
      failing.of_row.push_back(failing_schemes(schemes, static_cast<int>(input), table.format,
                                               table.at(row, source.column)));
      any |= failing.of_row.back();
    }
    if (any != 0) job.failing.push_back(std::move(failing));
  }
}

std::vector<SchemeLanes> existing_schemes(std::vector<SchemeLanes> schemes) {
  std::erase_if(schemes, [](const SchemeLanes& scheme) { return !scheme.exists(); });
  return schemes;
}

void add_bands(RateJob& job, const ErrorProfile& errors) {
  const std::vector<int> anchors = anchors_of(errors);
  const std::vector<NodeMagnitude> inputs = input_magnitudes(job.source);
  for (std::size_t k = 0; k + 1 < anchors.size(); ++k) {
    const Envelope::Options options{.anchor = anchors[k],
                                    .last = anchors.back() - 1,
                                    .reference = job.scene.reference.format,
                                    .inputs = inputs};
    std::optional<TypedGraph> graph;
    if (!job.scene.graph.first_function()) {
      graph = graph_at(job.scene, anchors[k], errors.inputs);
    }
    job.bands.emplace_back(options, anchors[k + 1], anchors.front(), graph, job.schemes);
  }
}

RateTally run(const RateJob& job, const ProfileOptions& options) {
  MIXCMP_CHECK(job.stretch > 0 && (job.pairs == nullptr || job.stretch == 1));
  RateTally total(job);
  std::mutex mutex;
  WorkSplit split{.size = job.counted(), .block = RateWorker::block, .threads = options.threads};
  if (options.progress) {
    split.progress = [&](double share) { options.progress("recomputation rates", share); };
  }
  run_workers(split, [&](const BlockSource& next) {
    RateWorker worker(job);
    worker.run(next);
    const std::lock_guard lock(mutex);
    total.add(worker.tally());
  });
  return total;
}

/// A reference in fixed point, made a lane: the verdicts that it decides are those of real numbers.
std::optional<emulator::Emulator> certified_reference(const scene::Scene& scene) {
  if (!scene.reference_fixed_point) return std::nullopt;
  const scene::ReducedSpec lane{.fixed_point = scene.reference_fixed_point,
                                .error_bound = BoundKind::constant};
  const auto made = design::design_lane(scene, lane, nullptr);
  if (!made.ok()) return std::nullopt;
  return emulator::Emulator(std::get<fixed::FixedLane>(*made));
}

RateProfile rates_of(const scene::Scene& scene, const data::Comparisons& data,
                     const ErrorProfile& errors, const ProfileOptions& options,
                     emulator::Emulator reference) {
  const std::vector<SchemeLanes> schemes = make_schemes(scene, errors, options.bounds);
  const data::OperandSource source(data);
  RateJob job{.scene = scene,
              .source = source,
              .method = options.method,
              .schemes = existing_schemes(schemes),
              .bands = {},
              .reference = std::move(reference),
              .certified_reference = certified_reference(scene),
              .failing = {},
              .stretch = options.stretch};
  std::shared_ptr<performance::PairwiseData> pairs;
  const std::optional<performance::ItemSet> set = set_of(data);
  const bool holds_items = set && set->items + set->others <= scene::EngineSpec::max_capacity;
  if (holds_items && options.stretch == 1) {
    pairs = std::make_shared<performance::PairwiseData>(performance::PairwiseData{.set = *set});
    pairs->reported.resize((data.size() + 63) / 64);
    job.pairs = pairs.get();
  }
  find_failing(job);
  add_bands(job, errors);
  const RateTally tally = run(job, options);
  RateProfile profile{.inputs = errors.inputs,
                      .first_precision = errors.precisions.front().precision,
                      .comparisons = job.counted(),
                      .reference_wrong = tally.reference_wrong,
                      .true_verdicts = tally.true_verdicts,
                      .undetermined = tally.undetermined,
                      .emulated = tally.emulated,
                      .pairs = std::move(pairs),
                      .schemes = {}};
  std::size_t counted = 0;
  for (const SchemeLanes& scheme : schemes) {
    SchemeProfile& row = profile.schemes.emplace_back(
        SchemeProfile{scheme.name, scheme.bound, scheme.kind, {}, scheme.reason});
    row.counts = scheme.exists() ? tally.counts[counted++]
                                 : std::vector<SchemeCounts>(errors.precisions.size());
  }
  return profile;
}

}  // namespace

bool SchemeProfile::exists() const {
  return std::any_of(counts.begin(), counts.end(),
                     [](const SchemeCounts& each) { return each.exists; });
}

std::optional<performance::ItemSet> set_of(const data::Comparisons& data) {
  switch (data.pairing()) {
    case data::Pairing::all: return performance::ItemSet{.items = data.table().rows()};
    case data::Pairing::cross:
      return performance::ItemSet{.items = data.tables()[0].rows(),
                                  .others = data.tables()[1].rows()};
    case data::Pairing::rows:
    case data::Pairing::arg_min: return std::nullopt;
  }
  MIXCMP_CHECK(false);
}

RateProfile profile_rates(const scene::Scene& scene, const data::Comparisons& data,
                          const ErrorProfile& errors, const ProfileOptions& options) {
  if (!fits_double(scene.reference.format)) {
    InDouble same = in_double(scene, data);
    return rates_of(same.scene, same.data, errors, options,
                    emulator::Emulator(std::move(same.exact_reference)));
  }
  return rates_of(scene, data, errors, options,
                  emulator::Emulator(scene::reference_model(scene).value()));
}

}  // namespace mixcmp::profile
