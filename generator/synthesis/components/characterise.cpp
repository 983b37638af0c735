#include "generator/synthesis/components/characterise.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "generator/synthesis/characterise/job_hash.hpp"
#include "model/base/common/check.hpp"
#include "model/cost/measured/component_cells.hpp"

namespace mixcmp::components {
namespace {

using characterise::SynthesisOptions;
using characterise::TimingEffort;
using devices::Device;
using measured::Characterisation;
using measured::ComponentKey;
using measured::Measurement;

/// The options with which a row was measured.
SynthesisOptions options_of(const Measurement& row) {
  if (row.timing_seeds == 0) return {.effort = TimingEffort::area_only};
  return {.effort = TimingEffort::timing, .seeds = row.timing_seeds};
}

bool is_current(const Measurement& row, ComponentMaker& maker, const Device& device) {
  const Result<Component> component = maker.make(row.key);
  if (!component.ok() || component->key != row.key) return false;
  const std::string hash = row.is_imported()
                               ? characterise::imported_hash(component->job, row.tools)
                               : job_hash(component->job, device, options_of(row), row.tools);
  return hash == row.hash;
}

/// One run of the verb.
class Campaign {
public:
  Campaign(const scene::Scene& scene, const data::Comparisons* data, const Device& device,
           const CharacteriseOptions& options, const Characterisation* previous)
      : maker_(scene, data), device_(device), options_(options), previous_(previous) {
    report_.table.device = device.name;
    report_.table.scene = scene.name;
  }

  Result<CharacteriseReport> run() {
    MIXCMP_TRY(asked, ask_tools());
    MIXCMP_TRY(planned, plan());
    MIXCMP_TRY(jobs, pending_jobs());
    MIXCMP_TRY(measured, measure(jobs));
    take(std::move(measured));
    MIXCMP_DO(collect());
    keep_previous();
    auto& rows = report_.table.rows;
    std::sort(rows.begin(), rows.end(),
              [](const Measurement& a, const Measurement& b) { return a.key < b.key; });
    return std::move(report_);
  }

  Result<std::vector<PlannedJob>> list() {
    MIXCMP_TRY(asked, ask_tools());
    MIXCMP_TRY(planned, plan());
    std::map<std::string, std::string> labels;
    for (const Measurement& row : planned_) labels.emplace(row.hash, label(row.key));
    std::vector<PlannedJob> jobs;
    for (const auto& [hash, text] : labels) jobs.push_back({hash, text});
    return jobs;
  }

  Result<characterise::JobRun> run_some(const std::set<std::string>& hashes) {
    MIXCMP_TRY(asked, ask_tools());
    MIXCMP_TRY(planned, plan());
    MIXCMP_TRY(jobs, pending_jobs());
    std::erase_if(jobs,
                  [&](const characterise::PendingJob& job) { return !hashes.contains(job.hash); });
    return measure(jobs);
  }

private:
  bool times() const { return options_.synthesis.effort == TimingEffort::timing; }

  Result<Done> ask_tools() {
    MIXCMP_TRY(tools, tool_versions(device_, options_.synthesis.effort));
    tools_ = tools;
    for (const TimingEffort effort : {TimingEffort::area_only, TimingEffort::timing}) {
      const Result<std::string> here = tool_versions(device_, effort);
      const bool is_broken = !here.ok() && here.error().kind != ErrorKind::missing_tool;
      if (is_broken && effort == options_.synthesis.effort) return here.error();
      if (here.ok()) tools_here_[effort] = *here;
    }
    return Done{};
  }

  Result<Done> plan() {
    const auto use = [this](const Component& component) {
      planned_.push_back({.key = component.key,
                          .latency_cycles = component.latency_cycles,
                          .timing_seeds = times() ? options_.synthesis.seeds : 0,
                          .hash = job_hash(component.job, device_, options_.synthesis, tools_),
                          .tools = tools_});
    };
    MIXCMP_TRY(missing, for_each_component(maker_, options_.query, use));
    report_.missing = std::move(missing);
    report_.components = static_cast<int>(planned_.size());
    for (const Measurement& row : planned_) asked_.insert(row.key);
    use_better_rows();
    return Done{};
  }

  /// Replaces planned rows by better rows of the previous table: imported ones and, if only areas
  /// are asked for, those that also have a clock.
  void use_better_rows() {
    const auto known = [this](const Measurement& planned) {
      const Measurement* row = previous_ == nullptr ? nullptr : previous_->find(planned.key);
      if (row == nullptr) return false;
      const bool is_better = row->is_imported() || (!times() && row->timing_seeds > 0);
      if (!is_better || !is_kept(*row)) return false;
      if (row->is_imported()) ++report_.imported;
      report_.table.rows.push_back(*row);
      return true;
    };
    planned_.erase(std::remove_if(planned_.begin(), planned_.end(), known), planned_.end());
  }

  /// Tells whether neither the RTL nor the tools nor the device's synthesis have changed since the
  /// row was measured. For an imported row only the RTL is compared, since this program does not
  /// run its tool.
  bool is_kept(const Measurement& row) {
    if (row.is_imported()) return is_current(row, maker_, device_);
    const auto tools = tools_here_.find(options_of(row).effort);
    return tools != tools_here_.end() && row.tools == tools->second &&
           is_current(row, maker_, device_);
  }

  /// Lists the jobs whose results the store lacks. The store is closed before processes are forked.
  Result<std::vector<characterise::PendingJob>> pending_jobs() {
    MIXCMP_TRY(store, characterise::ResultStore::open(options_.store));
    std::vector<characterise::PendingJob> jobs;
    std::set<std::string> seen;
    for (const Measurement& row : planned_) {
      if (!seen.insert(row.hash).second) continue;
      MIXCMP_TRY(known, store.find(row.hash));
      if (known) continue;
      const auto job = [this, key = row.key] { return maker_.make(key).value().job.get(); };
      jobs.push_back({.hash = row.hash, .label = label(row.key), .job = job});
    }
    return jobs;
  }

  Result<characterise::JobRun> measure(const std::vector<characterise::PendingJob>& jobs) {
    if (jobs.empty()) return characterise::JobRun{};
    const int count = static_cast<int>(jobs.size());
    const auto progress = [&](int finished, double seconds) {
      if (options_.progress) options_.progress(finished, count, seconds);
    };
    return run_jobs(
        jobs, device_, tools_, options_.store,
        {.synthesis = options_.synthesis, .workers = options_.workers, .progress = progress});
  }

  void take(characterise::JobRun run) {
    report_.interrupted_by = run.interrupted_by;
    report_.synthesised = run.done - static_cast<int>(run.failed.size());
    report_.failed = std::move(run.failed);
  }

  /// Makes the table's rows from the store; jobs that failed or were interrupted have no row.
  Result<Done> collect() {
    MIXCMP_TRY(store, characterise::ResultStore::open(options_.store));
    for (Measurement& row : planned_) {
      MIXCMP_TRY(result, store.find(row.hash));
      if (!result) {
        if (report_.failed.empty() && report_.interrupted_by == 0) return lost(row);
        continue;
      }
      row.area = result->area;
      row.clock = result->clock;
      if (times() && !row.clock) report_.no_clock[result->no_clock].push_back(label(row.key));
      report_.table.rows.push_back(std::move(row));
    }
    return Done{};
  }

  Error lost(const Measurement& row) const {
    return {.file = options_.store.string(),
            .message = "the store has lost a result of this run",
            .received = "none for " + label(row.key),
            .accepted = "a file that nothing else removes or replaces"};
  }

  void keep_previous() {
    if (previous_ == nullptr) return;
    for (const Measurement& row : previous_->rows) {
      if (asked_.contains(row.key)) continue;
      if (is_kept(row)) {
        report_.table.rows.push_back(row);
        ++report_.kept;
      } else {
        ++report_.dropped;
      }
    }
  }

  ComponentMaker maker_;
  const Device& device_;
  const CharacteriseOptions& options_;
  const Characterisation* previous_;
  std::string tools_;
  std::map<TimingEffort, std::string> tools_here_;
  std::vector<Measurement> planned_;
  std::set<ComponentKey> asked_;
  CharacteriseReport report_;
};

}  // namespace

std::string label(const ComponentKey& key) {
  std::string text(to_string(kind_of(key)));
  if (const auto* unit = std::get_if<measured::Unit>(&key)) text += " " + unit->name;
  const measured::KeyCells cells = cells_of(key);
  for (const std::string& word : {cells.format, cells.inputs, cells.bound, cells.multipliers}) {
    if (!word.empty()) text += " " + word;
  }
  if (const measured::Reference* reference = reference_of(key)) {
    const int interval = reference->initiation_interval;
    if (reference->sums == Sums::fused) text += " fused";
    if (interval > 1) text += fmt::format(" ii{}", interval);
    if (reference->target_mhz) text += fmt::format(" for {} MHz", *reference->target_mhz);
  }
  const std::optional<int> count = count_of(key);
  return count ? fmt::format("{} {} ports", text, *count) : text;
}

Result<CharacteriseReport> characterise(const scene::Scene& scene, const data::Comparisons* data,
                                        const Device& device, const CharacteriseOptions& options,
                                        const Characterisation* previous) {
  return Campaign(scene, data, device, options, previous).run();
}

Result<std::vector<PlannedJob>> list_jobs(const scene::Scene& scene, const data::Comparisons* data,
                                          const Device& device,
                                          const CharacteriseOptions& options) {
  return Campaign(scene, data, device, options, nullptr).list();
}

Result<characterise::JobRun> run_some(const scene::Scene& scene, const data::Comparisons* data,
                                      const Device& device, const CharacteriseOptions& options,
                                      const std::set<std::string>& hashes) {
  return Campaign(scene, data, device, options, nullptr).run_some(hashes);
}

std::vector<const Measurement*> current_rows(const Characterisation& table,
                                             const scene::Scene& scene,
                                             const data::Comparisons* data, const Device& device) {
  ComponentMaker maker(scene, data);
  std::vector<const Measurement*> current;
  for (const Measurement& row : table.rows) {
    if (is_current(row, maker, device)) current.push_back(&row);
  }
  return current;
}

RowCount count_rows(const Characterisation& table, const scene::Scene& scene,
                    const data::Comparisons* data, const Device& device) {
  const int all = static_cast<int>(table.rows.size());
  const int current = static_cast<int>(current_rows(table, scene, data, device).size());
  return {.all = all, .outdated = all - current};
}

}  // namespace mixcmp::components
