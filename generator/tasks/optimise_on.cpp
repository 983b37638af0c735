#include "generator/tasks/optimise_on.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include "generator/synthesis/components/predicted_table.hpp"
#include "generator/tasks/architecture_search.hpp"
#include "model/cost/performance/performance.hpp"

namespace mixcmp::tasks {
namespace {

using devices::Device;

/// A name as the user gave it, with its device.
struct NamedDevice {
  std::string name;
  Device device;
  std::vector<std::string> alike = {};
};
using Family = std::vector<NamedDevice>;  ///< by size

/// What orders devices: LUTs of six inputs, then the other resources.
auto size_of(const Device& device) {
  const auto& [luts, registers, dsps, memories, carries, shift_luts] = device.available;
  return std::tuple(components::six_input_luts(device), dsps, memories, registers, device.name);
}

/// Whether `a` has at least as much of each resource as `b`.
bool has_all_of(const Device& a, const Device& b) {
  return std::all_of(std::begin(devices::bounded_resources), std::end(devices::bounded_resources),
                     [&](const devices::Resource& resource) {
                       return a.available.*resource.amount >= b.available.*resource.amount;
                     });
}

bool is_alike(const Device& a, const Device& b) {
  return a.family == b.family && a.synthesis == b.synthesis && a.delays == b.delays;
}

/// The devices by family and size. Those that differ in nothing that a plan depends on are one.
Result<std::vector<Family>> families_of(const std::vector<std::string>& names) {
  std::vector<Family> families;
  for (const std::string& name : names) {
    MIXCMP_TRY(device, devices::find_device(name));
    auto family = std::find_if(families.begin(), families.end(), [&](const Family& each) {
      return is_alike(each.front().device, device);
    });
    if (family == families.end()) family = families.insert(family, Family());
    const auto twin = std::find_if(family->begin(), family->end(), [&](const NamedDevice& each) {
      return each.device.available == device.available;
    });
    if (twin == family->end()) {
      family->push_back({name, std::move(device)});
    } else if (twin->device.name != device.name) {
      twin->alike.push_back(device.name);
    }
  }
  for (Family& family : families) {
    std::sort(family.begin(), family.end(), [](const NamedDevice& a, const NamedDevice& b) {
      return size_of(a.device) < size_of(b.device);
    });
  }
  // Families with the same predicted areas stand together.
  std::stable_sort(families.begin(), families.end(), [](const Family& a, const Family& b) {
    return a.front().device.synthesis < b.front().device.synthesis;
  });
  return families;
}

class DeviceSearch {
public:
  DeviceSearch(const OptimiseOnRequest& request, const LoadedScene& loaded)
      : request_(request.optimise), names_(request.devices), loaded_(loaded) {
    request_.predict_only = true;
    if (!request_.progress) return;
    request_.progress = [this, tell = request_.progress](const std::string& step, double share) {
      tell_progress(tell, step, share);
    };
  }
  DeviceSearch(const DeviceSearch&) = delete;  // its progress refers to it
  DeviceSearch& operator=(const DeviceSearch&) = delete;

  Result<OptimiseOnResult> run();

private:
  void tell_progress(const StepProgress& tell, const std::string& step, double share) const;
  Result<Done> plan_all(Family family);
  Result<Done> plan_needed(Family family);
  Result<DevicePlan> plan_on(const NamedDevice& named);
  Result<Done> choose_smallest();
  Error nothing_fits() const;
  Error too_slow() const;
  void add_notes();

  OptimiseRequest request_;
  const std::vector<std::string>& names_;
  const LoadedScene& loaded_;
  std::optional<ArchitectureSearch> search_;
  std::vector<std::pair<std::string, DevicePlan>> found_;  ///< with names as the user gave them
  std::size_t settled_ = 0;                                ///< devices, for the progress
  std::size_t count_ = 0;                                  ///< devices that differ
  std::string now_;                                        ///< the device that is planned on
  std::optional<Error> why_none_;                          ///< of the first without a system
  std::vector<std::string> rough_;                         ///< families
  std::set<std::string> notes_;
  OptimiseOnResult result_;
};

/// Tells how far the search is over all devices, whose share never falls. Steps before the first
/// device, and those that complete the chosen plan, have shares of their own.
void DeviceSearch::tell_progress(const StepProgress& tell, const std::string& step,
                                 double share) const {
  if (now_.empty()) return tell(step, share);
  const double done = static_cast<double>(settled_) + progress_of_search(step, share);
  tell(fmt::format("device {} of {}, {}", settled_ + 1, count_, now_),
       done / static_cast<double>(count_));
}

/// Plans on a device. That a device has no plan is no error of the search.
Result<DevicePlan> DeviceSearch::plan_on(const NamedDevice& named) {
  const Device& device = named.device;
  now_ = device.name;
  DevicePlan plan{.device = device,
                  .alike = named.alike,
                  .six_input_luts = components::six_input_luts(device),
                  .plan = {},
                  .used = {},
                  .interface = {},
                  .settings = {},
                  .why_none = "nothing fits"};
  MIXCMP_DO(search_->move_to(named.name));
  add_notes();
  const Result<OptimiseResult> found = search_->fastest();
  if (!found.ok()) {
    if (!why_none_) why_none_ = found.error();
    plan.why_none = found.error().message;
    return plan;
  }
  const PlannedSystem& best = found->best();
  if (best.found.best() == nullptr) return plan;
  plan.plan = summary_of(best.found);
  plan.used = optimise::largest_share(
      plan.plan.used, performance::usable(device.available, best.known.scene.system.slack));
  plan.interface = best.interface;
  plan.settings = best.settings;
  return plan;
}

void DeviceSearch::add_notes() {
  notes_.insert(search_->notes().begin(), search_->notes().end());
  const Device& device = search_->device();
  const std::string& name = device.family.empty() ? device.name : device.family;
  const bool known = std::find(rough_.begin(), rough_.end(), name) != rough_.end();
  if (search_->is_rough() && !known) rough_.push_back(name);
}

Result<Done> DeviceSearch::plan_all(Family family) {
  for (const NamedDevice& each : family) {
    MIXCMP_TRY(plan, plan_on(each));
    found_.emplace_back(each.name, std::move(plan));
    ++settled_;
  }
  return Done{};
}

/// Finds the smallest device of a family that is fast enough. The middle of those that it may be is
/// planned: if it is fast enough no larger one is needed, and if not none that has no more.
Result<Done> DeviceSearch::plan_needed(Family open) {
  while (!open.empty()) {
    const auto middle = open.begin() + static_cast<std::ptrdiff_t>((open.size() - 1) / 2);
    MIXCMP_TRY(plan, plan_on(*middle));
    const NamedDevice tried = std::move(*middle);
    const std::size_t before = open.size();
    if (plan.plan.throughput_per_s >= request_.at_least_per_s) {
      open.erase(middle, open.end());
    } else {
      open.erase(middle);
      std::erase_if(open,
                    [&](const NamedDevice& each) { return has_all_of(tried.device, each.device); });
    }
    settled_ += before - open.size();
    result_.passed_over += static_cast<int>(before - open.size()) - 1;
    found_.emplace_back(tried.name, std::move(plan));
  }
  return Done{};
}

/// Why no device has a plan.
Error DeviceSearch::nothing_fits() const {
  if (why_none_) return *why_none_;
  const DevicePlan& largest = found_.back().second;
  return {.field = "system.device",
          .message = "no system fits on any of these devices",
          .received = fmt::format("{}, the largest of {}", largest.device.name, names_.size()),
          .accepted = "a larger device"};
}

/// Why no device is fast enough.
Error DeviceSearch::too_slow() const {
  const auto fastest =
      std::max_element(found_.begin(), found_.end(), [](const auto& a, const auto& b) {
        return a.second.plan.throughput_per_s < b.second.plan.throughput_per_s;
      });
  const DevicePlan& most = fastest->second;
  return {.field = request_.at_least_option,
          .message = "no system on these devices is so fast",
          .received = fmt::format("{:.4g} G comparisons/s", request_.at_least_per_s / 1e9),
          .accepted = fmt::format("at most {:.4g}, which {} reaches",
                                  most.plan.throughput_per_s / 1e9, most.device.name)};
}

Result<Done> DeviceSearch::choose_smallest() {
  const auto chosen = std::find_if(found_.begin(), found_.end(), [&](const auto& each) {
    return each.second.plan.throughput_per_s >= request_.at_least_per_s;
  });
  if (chosen == found_.end()) return too_slow();
  now_.clear();
  MIXCMP_DO(search_->move_to(chosen->first));
  MIXCMP_TRY(best, search_->best());
  MIXCMP_TRY(smallest, completed(request_, loaded_, *search_, std::move(best)));
  result_.smallest = std::move(smallest);
  return Done{};
}

Result<OptimiseOnResult> DeviceSearch::run() {
  MIXCMP_TRY(families, families_of(names_));
  for (const Family& family : families) count_ += family.size();
  MIXCMP_TRY(formulations, formulations_of(request_, loaded_));
  for (Formulation& each : formulations) {
    use_device(each.loaded.scene.system, families.front().front().name);
  }
  MIXCMP_TRY(search, ArchitectureSearch::make(request_, formulations));
  search_ = std::move(search);
  const bool is_least = request_.at_least_per_s > 0;
  for (Family& family : families) {
    MIXCMP_DO(is_least ? plan_needed(std::move(family)) : plan_all(std::move(family)));
  }
  std::sort(found_.begin(), found_.end(), [](const auto& a, const auto& b) {
    return size_of(a.second.device) < size_of(b.second.device);
  });
  const bool is_any = std::any_of(found_.begin(), found_.end(),
                                  [](const auto& each) { return each.second.plan.precision != 0; });
  if (!is_any) return nothing_fits();
  if (is_least) MIXCMP_DO(choose_smallest());
  for (auto& [name, plan] : found_) result_.devices.push_back(std::move(plan));
  if (result_.smallest)
    notes_.insert(result_.smallest->notes.begin(), result_.smallest->notes.end());
  result_.notes.assign(notes_.begin(), notes_.end());
  if (!rough_.empty()) {
    result_.notes.push_back(rough_note(fmt::format("{}", fmt::join(rough_, ", "))));
  }
  return std::move(result_);
}

}  // namespace

Result<OptimiseOnResult> optimise_on(const OptimiseOnRequest& request, const LoadedScene& loaded) {
  MIXCMP_CHECK(!request.devices.empty());
  MIXCMP_DO(check_options(request.optimise.choice));
  return DeviceSearch(request, loaded).run();
}

}  // namespace mixcmp::tasks
