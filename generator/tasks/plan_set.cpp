#include "generator/tasks/plan_set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>

#include "generator/tasks/architecture_search.hpp"
#include "model/base/common/check.hpp"

namespace mixcmp::tasks {
namespace {

using optimise::PlanAtRates;
using Words = std::vector<std::string>;

/// How long a block of the stream takes, in reconfigurations.
constexpr std::array block_reconfigurations = {1, 10, 100, 1000};
/// Points of the rule lie no closer than this part of the way from one data set to the next.
constexpr double finest_mixture = 1.0 / 64;
/// How often the counters are read in the time of a reconfiguration.
constexpr int readings_of_reconfiguration = 10;

std::uint64_t items_of(const data::Comparisons& data) {
  std::uint64_t items = 0;
  for (const data::Table& table : data.tables()) items += table.rows();
  return items;
}

/// The rates of the lanes of the request's table, or of all that a plan without a table may have.
Result<optimise::Rates> counted_rates(const OptimiseRequest& request, const LoadedScene& loaded) {
  if (request.planning.table.empty()) return count_rates(request, loaded);
  MIXCMP_TRY(known, load_planning(request.planning, loaded.scene, loaded.data_if_any()));
  return rates_by_table(request, loaded, known.table);
}

/// The constants of profiled lanes are measured on data, so such lanes are wrong on other data.
Result<Done> check_certified(const scene::Scene& scene) {
  if (!scene.reduced.is_profiled) return Done{};
  return Error{.file = scene.path.string(),
               .field = "reduced.bound",
               .message = "a set of plans is for data that change",
               .received = "\"profiled\", lanes with errors measured on one data set",
               .accepted = "\"certified\""};
}

/// A plan and the settings of its system: two such plans are the same hardware.
std::string identity_of(const SetPlan& each) {
  const optimise::PrecisionPlan& plan = each.plan();
  const optimise::Allocation& chosen = *plan.allocation();
  std::string text = fmt::format("{}", fmt::join(each.system.settings, " "));
  for (std::size_t k = 0; k < plan.lanes.size(); ++k) {
    if (chosen.lanes[k] == 0) continue;
    text += fmt::format(", {} {}", chosen.lanes[k], plan.lanes[k].kind.name);
  }
  for (std::size_t k = 0; k < plan.problem.references.size(); ++k) {
    if (chosen.references[k] == 0) continue;
    text += fmt::format(", {} {}", chosen.references[k], plan.problem.references[k].name);
  }
  if (plan.second_lanes) text += fmt::format(", {} second", plan.second_lanes->count);
  return text;
}

std::vector<double> seconds_of(const std::vector<PlanAtRates>& at) {
  std::vector<double> seconds;
  for (const PlanAtRates& each : at) seconds.push_back(1 / each.throughput_per_s);
  return seconds;
}

double total(const std::vector<double>& seconds) {
  return std::accumulate(seconds.begin(), seconds.end(), 0.0);
}

bool has_counters(const SetPlan& each) {
  return each.system.known.scene.system.counters != scene::CounterAccess::none;
}

class PlanSetSearch {
public:
  explicit PlanSetSearch(const PlanSetRequest& request) : request_(&request) {}
  Result<PlanSetResult> run();

private:
  using Members = std::vector<std::size_t>;  // places in plans_

  struct Mixture {
    double of_b;
    std::vector<PlanAtRates> at;  ///< by plan
  };

  struct Choice {
    Members members;  ///< all plans of the interface
    std::vector<optimise::PlanChoice> choices;
  };

  Result<LoadedScene> loaded_with(const DataSet& set, const Words& variant) const;
  Result<const optimise::Rates*> rates_of(const DataSet& set, const Words& variant);
  Result<Done> find_all();
  void note_none(const Words& variant, const Error& error);
  Result<Done> find_plans(const Words& variant);
  Result<Done> add_plans(const Words& variant, const optimise::Rates& rates);
  Result<Done> add(PlannedSystem system, const Words& variant);
  Result<std::optional<std::vector<PlanAtRates>>> at(const SetPlan& plan, const Words& variant,
                                                     const std::vector<DataSet>& sets);
  Result<Choice> choose() const;
  std::vector<double> best_per_s(const Members& members) const;
  Words variant_of(const SetPlan& plan) const;
  Result<Mixture> mixture(const std::vector<SetPlan>& plans, std::size_t a, std::size_t b,
                          double of_b);
  Result<bool> is_straight(const std::vector<SetPlan>& plans, std::size_t a, std::size_t b,
                           const Mixture& low, const Mixture& high);
  Result<std::vector<Mixture>> mixtures(const std::vector<SetPlan>& plans, std::size_t a,
                                        std::size_t b);
  Result<optimise::SwitchingRule> rule_of(const std::vector<SetPlan>& plans);
  Result<std::vector<Drift>> drifts_of(const std::vector<SetPlan>& plans,
                                       const optimise::SwitchingRule& rule);

  const PlanSetRequest* request_;
  std::optional<DataSet> own_;        ///< the scene's own data
  const DataSet* largest_ = nullptr;  ///< engines hold its items
  std::map<Words, optimise::Rates> rates_;
  std::vector<SetPlan> plans_;
  std::set<std::string> known_, notes_;
  std::optional<Error> why_none_;
};

Result<LoadedScene> PlanSetSearch::loaded_with(const DataSet& set, const Words& variant) const {
  const SceneRequest& scene = request_->optimise.planning.scene;
  const Words settings = joined(joined(scene.settings, set.settings), variant);
  MIXCMP_TRY(read, scene::load_scene(scene.source, settings));
  return LoadedScene{std::move(read), set.data};
}

Result<const optimise::Rates*> PlanSetSearch::rates_of(const DataSet& set, const Words& variant) {
  const Words key = joined(set.settings, variant);
  const auto known = rates_.find(key);
  if (known != rates_.end()) return &known->second;
  MIXCMP_TRY(loaded, loaded_with(set, variant));
  MIXCMP_TRY(rates, counted_rates(request_->optimise, loaded));
  if (auto note = note_on_sample(rates)) notes_.insert(*std::move(note));
  return &rates_.emplace(key, std::move(rates)).first->second;
}

Result<Done> PlanSetSearch::find_plans(const Words& variant) {
  optimise::Rates worst;
  for (const DataSet& set : request_->sets) {
    MIXCMP_TRY(rates, rates_of(set, variant));
    worst.raise_to(*rates);
    MIXCMP_DO(add_plans(variant, *rates));
  }
  return request_->sets.size() > 1 ? add_plans(variant, worst) : Result<Done>(Done{});
}

void PlanSetSearch::note_none(const Words& variant, const Error& error) {
  if (!why_none_) why_none_ = error;
  const std::string name = variant.empty() ? "[comparison]" : variant.front();
  notes_.insert(fmt::format("{} left out: {}", name, error.to_string()));
}

/// Adds the plans for these rates, if there are any.
Result<Done> PlanSetSearch::add_plans(const Words& variant, const optimise::Rates& rates) {
  OptimiseRequest request = request_->optimise;
  Words& settings = request.planning.scene.settings;
  settings = joined(joined(settings, largest_->settings), variant);
  request.rates = rates;
  request.predict_only = true;
  MIXCMP_TRY(loaded, loaded_with(*largest_, variant));
  Result<OptimiseResult> found = optimise(request, loaded);
  if (!found.ok()) {
    note_none(variant, found.error());
    return Done{};
  }
  OptimiseResult result = std::move(found).value();
  notes_.insert(result.notes.begin(), result.notes.end());
  for (PlannedSystem& system : result.systems) MIXCMP_DO(add(std::move(system), variant));
  return Done{};
}

/// Adds all plans of a system whose throughput is known on all data sets.
Result<Done> PlanSetSearch::add(PlannedSystem system, const Words& variant) {
  system.settings.insert(system.settings.begin(), variant.begin(), variant.end());
  const optimise::Optimisation& found = system.found;
  for (std::size_t k = 0; k < found.plans.size(); ++k) {
    const optimise::PrecisionPlan& plan = found.plans[k];
    const bool is_dear = found.crossover && plan.precision >= *found.crossover;
    if (plan.allocation() == nullptr || is_dear) continue;
    SetPlan each{.system = system, .number = k, .at_set = {}};
    if (!known_.insert(identity_of(each)).second) continue;
    MIXCMP_TRY(at_sets, at(each, variant, request_->sets));
    if (!at_sets) continue;
    each.at_set = *std::move(at_sets);
    plans_.push_back(std::move(each));
  }
  return Done{};
}

/// The plan on each of these data; none if a rate is unknown.
Result<std::optional<std::vector<PlanAtRates>>> PlanSetSearch::at(
    const SetPlan& plan, const Words& variant, const std::vector<DataSet>& sets) {
  std::vector<PlanAtRates> all;
  for (const DataSet& set : sets) {
    MIXCMP_TRY(rates, rates_of(set, variant));
    const auto here = at_rates(plan.plan(), plan.system.known.scene, *rates);
    if (!here) return std::optional<std::vector<PlanAtRates>>();
    all.push_back(*here);
  }
  return std::optional(std::move(all));
}

Words PlanSetSearch::variant_of(const SetPlan& plan) const {
  Words variant = plan.system.settings;
  std::erase_if(variant,
                [](const std::string& each) { return !each.starts_with("comparison.variant="); });
  return variant;
}

/// The interface whose plans lose least, and its choices.
Result<PlanSetSearch::Choice> PlanSetSearch::choose() const {
  std::map<std::string, Members> by_interface;
  for (std::size_t k = 0; k < plans_.size(); ++k) {
    if (request_->most_plans > 1 && !has_counters(plans_[k])) continue;
    by_interface[plans_[k].system.interface].push_back(k);
  }
  std::optional<Choice> best;
  for (const auto& [interface, members] : by_interface) {
    optimise::PlanSeconds seconds;
    for (const std::size_t k : members) seconds.push_back(seconds_of(plans_[k].at_set));
    Choice choice{members, optimise::choose_plans(seconds, request_->most_plans)};
    const bool is_better = !best || choice.choices.back().seconds < best->choices.back().seconds;
    if (is_better) best = std::move(choice);
  }
  if (best) return *std::move(best);
  return Error{.field = "system.counters",
               .message = "plans are switched by what a system counts",
               .received = "none",
               .accepted = "\"ports\" or \"axi_lite\""};
}

/// Plans on a mixture of two data sets, of which `of_b` is the part of the second.
Result<PlanSetSearch::Mixture> PlanSetSearch::mixture(const std::vector<SetPlan>& plans,
                                                      std::size_t a, std::size_t b, double of_b) {
  Mixture mixed{of_b, {}};
  for (const SetPlan& plan : plans) {
    MIXCMP_TRY(at_a, rates_of(request_->sets[a], variant_of(plan)));
    MIXCMP_TRY(at_b, rates_of(request_->sets[b], variant_of(plan)));
    const optimise::Rates rates = at_a->mixed_with(*at_b, of_b);
    const auto here = at_rates(plan.plan(), plan.system.known.scene, rates);
    MIXCMP_CHECK(here);
    mixed.at.push_back(*here);
  }
  return mixed;
}

/// Whether each plan's seconds between two mixtures are on a straight line, to a percent.
/// References that begin to be too slow make a corner, which may be near an end.
Result<bool> PlanSetSearch::is_straight(const std::vector<SetPlan>& plans, std::size_t a,
                                        std::size_t b, const Mixture& low, const Mixture& high) {
  for (const double part : {1.0 / 16, 1.0 / 2, 15.0 / 16}) {
    MIXCMP_TRY(between, mixture(plans, a, b, low.of_b + part * (high.of_b - low.of_b)));
    for (std::size_t k = 0; k < plans.size(); ++k) {
      const double line =
          (1 - part) / low.at[k].throughput_per_s + part / high.at[k].throughput_per_s;
      if (std::abs(line * between.at[k].throughput_per_s - 1) > 0.01) return false;
    }
  }
  return true;
}

/// Two data sets, and mixtures of them wherever the line between two neighbours is not straight.
Result<std::vector<PlanSetSearch::Mixture>> PlanSetSearch::mixtures(
    const std::vector<SetPlan>& plans, std::size_t a, std::size_t b) {
  std::vector<Mixture> line;
  for (const double end : {0.0, 1.0}) {
    MIXCMP_TRY(pure, mixture(plans, a, b, end));
    line.push_back(std::move(pure));
  }
  for (std::size_t k = 0; k + 1 < line.size();) {
    const double low = line[k].of_b, high = line[k + 1].of_b;
    MIXCMP_TRY(straight, is_straight(plans, a, b, line[k], line[k + 1]));
    if (straight || high - low < finest_mixture) {
      ++k;
    } else {
      MIXCMP_TRY(middle, mixture(plans, a, b, (low + high) / 2));
      line.insert(line.begin() + static_cast<std::ptrdiff_t>(k) + 1, std::move(middle));
    }
  }
  return line;
}

/// The rule whose points are the data sets, by rising rates of the first plan, and mixtures of
/// neighbours.
Result<optimise::SwitchingRule> PlanSetSearch::rule_of(const std::vector<SetPlan>& plans) {
  std::vector<std::size_t> order(request_->sets.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const std::vector<PlanAtRates>& at_set = plans.front().at_set;
    return at_set[a].counted_rate < at_set[b].counted_rate;
  });
  MIXCMP_TRY(last, mixture(plans, order.back(), order.back(), 1));
  std::vector<Mixture> all = {std::move(last)};
  for (std::size_t k = 0; k + 1 < order.size(); ++k) {
    MIXCMP_TRY(between, mixtures(plans, order[k], order[k + 1]));
    all.insert(all.end(), between.begin(), between.end() - 1);
  }
  std::vector<std::vector<optimise::RatePoint>> points(plans.size());
  for (const Mixture& each : all) {
    for (std::size_t k = 0; k < plans.size(); ++k) {
      points[k].push_back({.rate = each.at[k].counted_rate, .seconds = seconds_of(each.at)});
    }
  }
  const devices::Device& device = plans.front().system.known.device;
  const double usual = optimise::configuration_seconds(device);
  return optimise::SwitchingRule(std::move(points),
                                 request_->reconfiguration_seconds.value_or(usual));
}

Result<std::vector<Drift>> PlanSetSearch::drifts_of(const std::vector<SetPlan>& plans,
                                                    const optimise::SwitchingRule& rule) {
  const std::size_t blocks = request_->stream.size();
  if (blocks == 0) return std::vector<Drift>();
  optimise::StreamThroughPlans stream(blocks);
  for (const SetPlan& each : plans) {
    MIXCMP_TRY(at_blocks, at(each, variant_of(each), request_->stream));
    for (std::size_t b = 0; b < blocks; ++b) {
      const PlanAtRates& here = at_blocks.value()[b];
      stream[b].push_back({1 / here.throughput_per_s, here.counted_rate});
    }
  }
  std::vector<double> fastest(blocks, std::numeric_limits<double>::infinity());
  double single = std::numeric_limits<double>::infinity();
  for (const SetPlan& each : plans_) {
    MIXCMP_TRY(at_blocks, at(each, variant_of(each), request_->stream));
    if (!at_blocks) continue;
    const std::vector<double> seconds = seconds_of(*at_blocks);
    single = std::min(single, total(seconds));
    for (std::size_t b = 0; b < blocks; ++b) fastest[b] = std::min(fastest[b], seconds[b]);
  }
  std::vector<Drift> drifts;
  for (const int reconfigurations : block_reconfigurations) {
    const double pay = rule.reconfiguration_seconds();
    const double mean = total(fastest) / static_cast<double>(blocks);
    const auto comparisons = std::llround(std::ceil(reconfigurations * pay / mean));
    const auto count = static_cast<double>(comparisons);
    drifts.push_back(
        {.comparisons = static_cast<std::uint64_t>(comparisons),
         .single_seconds = count * single,
         .rule = time_by_rule(rule, stream, comparisons, pay / readings_of_reconfiguration),
         .foresight = least_time(stream, comparisons, pay),
         .free_seconds = count * total(fastest)});
  }
  return drifts;
}

/// Finds the plans of all variants.
Result<Done> PlanSetSearch::find_all() {
  const auto fewer_items = [](const DataSet& a, const DataSet& b) {
    return items_of(a.data) < items_of(b.data);
  };
  largest_ = &*std::max_element(request_->sets.begin(), request_->sets.end(), fewer_items);
  for (const DataSet& block : request_->stream) {
    if (fewer_items(*largest_, block)) largest_ = &block;
  }
  if (request_->own) own_ = DataSet{{}, *request_->own};
  if (own_ && fewer_items(*largest_, *own_)) largest_ = &*own_;
  MIXCMP_TRY(loaded, loaded_with(*largest_, {}));
  MIXCMP_DO(check_certified(loaded.scene));
  std::vector<Words> variants = settings_of_variants(request_->optimise, loaded.scene);
  variants.insert(variants.begin(), Words());
  for (const Words& variant : variants) {
    const Result<Done> found = find_plans(variant);  // an error if it has no table, for instance
    if (!found.ok()) note_none(variant, found.error());
  }
  if (!plans_.empty()) return Done{};
  if (why_none_) return *why_none_;
  return Error{.field = "system.device",
               .message = "no data set has a plan",
               .received = loaded.scene.system.device,
               .accepted = "a device on which optimise finds one for a data set"};
}

/// The fastest plan of an interface on each data set.
std::vector<double> PlanSetSearch::best_per_s(const Members& members) const {
  std::vector<double> best(request_->sets.size(), 0);
  for (const std::size_t k : members) {
    for (std::size_t s = 0; s < best.size(); ++s) {
      best[s] = std::max(best[s], plans_[k].at_set[s].throughput_per_s);
    }
  }
  return best;
}

Result<PlanSetResult> PlanSetSearch::run() {
  MIXCMP_CHECK(!request_->sets.empty() && request_->most_plans >= 1 && !request_->optimise.rates);
  MIXCMP_DO(find_all());
  MIXCMP_TRY(choice, choose());
  std::vector<SetPlan> plans;
  for (const std::size_t k : choice.choices.back().plans) {
    plans.push_back(plans_[choice.members[k]]);
  }
  std::vector<double> seconds_with;
  for (const optimise::PlanChoice& each : choice.choices) seconds_with.push_back(each.seconds);
  const auto single =
      std::min_element(plans_.begin(), plans_.end(), [](const SetPlan& a, const SetPlan& b) {
        return total(seconds_of(a.at_set)) < total(seconds_of(b.at_set));
      });
  MIXCMP_TRY(rule, rule_of(plans));
  MIXCMP_TRY(drifts, drifts_of(plans, rule));
  return PlanSetResult{.plans = std::move(plans),
                       .best_per_s = best_per_s(choice.members),
                       .seconds_with = std::move(seconds_with),
                       .single_seconds = total(seconds_of(single->at_set)),
                       .single_interface = single->system.interface,
                       .rule = std::move(rule),
                       .drifts = std::move(drifts),
                       .notes = {notes_.begin(), notes_.end()}};
}

}  // namespace

double PlanSetResult::least_seconds() const {
  double seconds = 0;
  for (const double each : best_per_s) seconds += 1 / each;
  return seconds;
}

Result<PlanSetResult> plan_set(const PlanSetRequest& request) {
  MIXCMP_DO(check_options(request.optimise.choice));
  return PlanSetSearch(request).run();
}

}  // namespace mixcmp::tasks
