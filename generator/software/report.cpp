#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "generator/software/baseline.hpp"

namespace mixcmp::software {
namespace {

std::string share_text(std::uint64_t part, std::uint64_t whole) {
  return fmt::format("{:.3e}", static_cast<double>(part) / static_cast<double>(whole));
}

std::string row(const Baseline& baseline, const BaselineKernel& kernel) {
  const auto millions = [](double per_s) { return fmt::format("{:.0f}", per_s / 1e6); };
  return fmt::format("  {:<30}{:>10}{:>10}{:>10}{:>10}  {}\n", kernel_name(kernel),
                     millions(kernel.one_core.best_per_s), millions(kernel.one_core.median_per_s),
                     millions(kernel.all_cores.best_per_s), millions(kernel.all_cores.median_per_s),
                     kernel.filter ? share_text(kernel.recomputed, baseline.comparisons) : "-");
}

std::string verdict_text(const Baseline& baseline) {
  const VerdictCounts& counts = baseline.exact().verdicts;
  std::string text = fmt::format("  verdicts: {} less, {} equal, {} greater, {} unordered\n",
                                 counts.less, counts.equal, counts.greater, counts.unordered);
  for (const BaselineKernel& kernel : baseline.kernels) {
    if (kernel.verdicts == counts) continue;
    const VerdictCounts& other = kernel.verdicts;
    text +=
        fmt::format("  DIFFERENT: {}: {} less, {} equal, {} greater, {} unordered\n",
                    kernel_name(kernel), other.less, other.equal, other.greater, other.unordered);
  }
  return text;
}

std::string check_text(const BaselineCheck& check) {
  return fmt::format(
      "  sample: {} comparisons; doubles: {} unlike the golden model's, {} unlike the reference, "
      "{} untrue; {} decided wrongly by filters{}\n",
      check.comparisons, check.wrong, check.unlike_reference, check.not_true, check.decided_wrongly,
      check.undetermined == 0
          ? ""
          : fmt::format("; {} not held against the truth, which is undetermined",
                        check.undetermined));
}

std::string name_of(const std::optional<BoundKind>& filter) {
  return filter ? std::string(to_string(*filter)) : "none";
}

nlohmann::ordered_json to_json(const MeasuredRate& rate) {
  return {{"threads", rate.threads},
          {"best_per_s", rate.best_per_s},
          {"median_per_s", rate.median_per_s},
          {"processor_share", rate.processor_share}};
}

nlohmann::ordered_json to_json(const BaselineKernel& kernel) {
  return {{"filter", name_of(kernel.filter)},       {"less", kernel.verdicts.less},
          {"equal", kernel.verdicts.equal},         {"greater", kernel.verdicts.greater},
          {"unordered", kernel.verdicts.unordered}, {"recomputed", kernel.recomputed},
          {"one_core", to_json(kernel.one_core)},   {"all_cores", to_json(kernel.all_cores)}};
}

nlohmann::ordered_json to_json(const BaselineCheck& check) {
  return {{"comparisons", check.comparisons},           {"unlike_golden", check.wrong},
          {"unlike_reference", check.unlike_reference}, {"untrue", check.not_true},
          {"truth_undetermined", check.undetermined},   {"decided_wrongly", check.decided_wrongly}};
}

}  // namespace

std::string kernel_name(const BaselineKernel& kernel) {
  if (!kernel.filter) return "double";
  return fmt::format("float filter, {} bound", to_string(*kernel.filter));
}

std::string to_text(const Baseline& baseline) {
  std::string text = fmt::format(
      "software: {}, {} comparisons\n  {}, {}\n  {}\n  {} rounds of {} s a kernel; million "
      "comparisons a second\n  {:<30}{:>20}{:>20}\n  {:<30}{:>10}{:>10}{:>10}{:>10}  recomputed\n",
      baseline.scene, baseline.comparisons, baseline.processor, baseline.compiler,
      baseline.compile_command, baseline.rounds, baseline.seconds, "", "1 thread",
      fmt::format("{} threads", baseline.threads), "", "best", "median", "best", "median");
  double least_share = 1;
  for (const BaselineKernel& kernel : baseline.kernels) {
    text += row(baseline, kernel);
    least_share =
        std::min({least_share, kernel.one_core.processor_share, kernel.all_cores.processor_share});
  }
  for (const MissingFilter& missing : baseline.missing) {
    text +=
        fmt::format("  no filter with a {} bound: {}\n", to_string(missing.kind), missing.reason);
  }
  text += verdict_text(baseline) + check_text(baseline.check);
  if (least_share < 0.95) {
    text += fmt::format(
        "  the machine was shared: {:.0f} % of a processor in the best round of "
        "some kernel\n",
        100 * least_share);
  }
  return text;
}

std::string to_csv(const Baseline& baseline) {
  std::string text =
      "filter,threads,best_per_s,median_per_s,processor_share,comparisons,recomputed\n";
  for (const BaselineKernel& kernel : baseline.kernels) {
    for (const MeasuredRate* rate : {&kernel.one_core, &kernel.all_cores}) {
      text += fmt::format("{},{},{:.6e},{:.6e},{:.4f},{},{}\n", name_of(kernel.filter),
                          rate->threads, rate->best_per_s, rate->median_per_s,
                          rate->processor_share, baseline.comparisons, kernel.recomputed);
    }
  }
  return text;
}

nlohmann::ordered_json to_json(const Baseline& baseline) {
  nlohmann::ordered_json report = {{"scene", baseline.scene},
                                   {"processor", baseline.processor},
                                   {"compiler", baseline.compiler},
                                   {"command", baseline.compile_command},
                                   {"comparisons", baseline.comparisons},
                                   {"threads", baseline.threads},
                                   {"rounds", baseline.rounds},
                                   {"seconds", baseline.seconds},
                                   {"passed", baseline.passed()}};
  for (const BaselineKernel& kernel : baseline.kernels) {
    report["kernels"].push_back(to_json(kernel));
  }
  report["missing"] = nlohmann::ordered_json::array();
  for (const MissingFilter& missing : baseline.missing) {
    report["missing"].push_back({{"filter", to_string(missing.kind)}, {"reason", missing.reason}});
  }
  report["check"] = to_json(baseline.check);
  return report;
}

}  // namespace mixcmp::software
