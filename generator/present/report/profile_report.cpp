#include "generator/present/report/profile_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

namespace mixcmp::report {

using profile::ErrorAtPrecision;
using profile::ErrorProfile;
using profile::RateProfile;
using profile::SchemeCounts;
using profile::SchemeKind;
using profile::SchemeProfile;

namespace {

using Json = nlohmann::ordered_json;

/// Text that grows by formatted pieces.
class FormattedText {
public:
  template <class... Arguments>
  void add(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Arguments>(arguments)...);
  }
  std::string take() { return std::move(text_); }

private:
  std::string text_;
};

double rate_of(const SchemeCounts& counts, const RateProfile& profile) {
  return static_cast<double>(counts.undecided) / static_cast<double>(profile.comparisons);
}

/// "none" where no comparison has an error.
std::string measured(const std::optional<mpq_class>& error) {
  return error ? fmt::format("{:.3e}", error->get_d()) : "none";
}

/// How many comparisons the errors of a row leave out; empty where they leave out none.
std::string left_out(const ErrorAtPrecision& error) {
  if (error.f_unbounded + error.g_unbounded == 0) return "";
  return fmt::format("  left out: {} of f, {} of g", error.f_unbounded, error.g_unbounded);
}

std::string shown(const std::optional<double>& bound) {
  return bound ? fmt::format("{:.3e}", *bound) : "none";
}

void add_errors(FormattedText& page, const ErrorProfile& profile) {
  page.add("\nrelative error of f and g, {}: {}what is proven\n", describe(profile.inputs),
           profile.comparisons == 0
               ? "none was measured; "
               : fmt::format("the largest of {} comparisons, and ", profile.comparisons));
  page.add("{:>4}  {:>10}  {:>10}  {:>10}  {:>10}\n", "L", "f", "f bound", "g", "g bound");
  for (const ErrorAtPrecision& error : profile.precisions) {
    page.add("{:>4}  {:>10}  {:>10}  {:>10}  {:>10}{}\n", error.precision, measured(error.f),
             shown(error.f_bound), measured(error.g), shown(error.g_bound), left_out(error));
  }
  if (!profile.no_f_bound.empty()) page.add("no bound for f: {}\n", profile.no_f_bound);
  if (!profile.no_g_bound.empty()) page.add("no bound for g: {}\n", profile.no_g_bound);
}

std::string cell(const SchemeProfile& scheme, std::size_t k, const RateProfile& profile) {
  const SchemeCounts& counts = scheme.counts[k];
  if (!counts.exists) return fmt::format("  {:>20}", "-");
  if (scheme.kind == SchemeKind::lanes_alone) return fmt::format("  {:>12}", counts.wrong);
  return fmt::format("  {:>9.2e} {:>10}", rate_of(counts, profile), counts.wrong);
}

/// The number of rows up to the last precision at which some scheme recomputes or errs, or after
/// which one begins to exist.
std::size_t interesting_rows(const RateProfile& profile) {
  std::size_t rows = 0;
  for (const SchemeProfile& scheme : profile.schemes) {
    bool exists_later = false;
    for (std::size_t k = scheme.counts.size(); k > rows; --k) {
      const SchemeCounts& counts = scheme.counts[k - 1];
      const bool begins = exists_later && !counts.exists;
      if (begins || counts.undecided + counts.wrong > 0) rows = k;
      exists_later = exists_later || counts.exists;
    }
  }
  return rows;
}

/// Adds the number of wrong verdicts that lanes decided, for each scheme over all L.
void add_wrong_lanes(FormattedText& page, const RateProfile& profile) {
  page.add("wrong verdicts that a lane decided, at all L together:");
  for (const SchemeProfile& scheme : profile.schemes) {
    if (!scheme.exists()) continue;
    std::uint64_t wrong = 0;
    for (const SchemeCounts& counts : scheme.counts) wrong += counts.wrong_by_lane;
    page.add(" {} {}", scheme.name, wrong);
  }
  page.add("\n");
}

void add_rates(FormattedText& page, const RateProfile& profile) {
  page.add("\nrecomputation rate and wrong verdicts, {}, {} comparisons\n",
           describe(profile.inputs), profile.comparisons);
  page.add("the reference alone: {} wrong\n", profile.reference_wrong);
  if (profile.undetermined > 0) {
    page.add("the truth is undetermined of {}, which count as wrong of nobody\n",
             profile.undetermined);
  }
  page.add("{:>4}", "L");
  std::string units = "    ";
  for (const SchemeProfile& scheme : profile.schemes) {
    if (!scheme.exists()) continue;
    const bool alone = scheme.kind == SchemeKind::lanes_alone;
    page.add("  {:>{}}", scheme.name, alone ? 12 : 20);
    units +=
        alone ? fmt::format("  {:>12}", "wrong") : fmt::format("  {:>9} {:>10}", "rate", "wrong");
  }
  page.add("\n{}\n", units);
  const std::size_t rows = profile.schemes.front().counts.size(), told = interesting_rows(profile);
  for (std::size_t k = 0; k < told; ++k) {
    page.add("{:>4}", profile.first_precision + static_cast<int>(k));
    for (const SchemeProfile& scheme : profile.schemes) {
      if (scheme.exists()) page.add("{}", cell(scheme, k, profile));
    }
    page.add("\n");
  }
  if (told < rows) {
    page.add("from L = {} on all of them decide everything, and rightly\n",
             profile.first_precision + static_cast<int>(told));
  }
  add_wrong_lanes(page, profile);
  for (const SchemeProfile& scheme : profile.schemes) {
    if (!scheme.reason.empty()) page.add("{}: {}\n", scheme.name, scheme.reason);
  }
}

Json to_json(const ErrorProfile& profile) {
  Json rows = Json::array();
  const auto bound = [](const std::optional<double>& value) {
    return value ? Json(*value) : Json();
  };
  const auto measured = [](const std::optional<mpq_class>& error) {
    return error ? Json(error->get_d()) : Json();
  };
  for (const ErrorAtPrecision& error : profile.precisions) {
    rows.push_back({{"precision", error.precision},
                    {"f_error", measured(error.f)},
                    {"g_error", measured(error.g)},
                    {"f_unbounded", error.f_unbounded},
                    {"g_unbounded", error.g_unbounded},
                    {"f_bound", bound(error.f_bound)},
                    {"g_bound", bound(error.g_bound)}});
  }
  return {{"inputs", to_string(profile.inputs)},
          {"comparisons", profile.comparisons},
          {"no_f_bound", profile.no_f_bound},
          {"no_g_bound", profile.no_g_bound},
          {"precisions", std::move(rows)}};
}

Json to_json(const SchemeProfile& scheme, const RateProfile& profile) {
  Json rows = Json::array();
  for (std::size_t k = 0; k < scheme.counts.size(); ++k) {
    const SchemeCounts& counts = scheme.counts[k];
    if (!counts.exists) continue;
    rows.push_back({{"precision", profile.first_precision + static_cast<int>(k)},
                    {"undecided", counts.undecided},
                    {"rate", rate_of(counts, profile)},
                    {"wrong", counts.wrong},
                    {"wrong_by_lane", counts.wrong_by_lane}});
  }
  return {{"scheme", scheme.name},
          {"certified", scheme.kind == SchemeKind::certified},
          {"reason", scheme.reason},
          {"precisions", std::move(rows)}};
}

Json to_json(const RateProfile& profile) {
  Json schemes = Json::array();
  for (const SchemeProfile& scheme : profile.schemes) schemes.push_back(to_json(scheme, profile));
  return {{"inputs", to_string(profile.inputs)},
          {"comparisons", profile.comparisons},
          {"reference_wrong", profile.reference_wrong},
          {"true_verdicts_by_mpfr", profile.true_verdicts},
          {"truth_undetermined", profile.undetermined},
          {"lane_evaluations", profile.emulated},
          {"schemes", std::move(schemes)}};
}

}  // namespace

std::string to_text(const ProfileReport& report) {
  FormattedText page;
  page.add("{}: {} comparisons, reference {}\n", report.scene, report.comparisons,
           report.reference.name());
  for (const ErrorProfile& errors : report.errors) add_errors(page, errors);
  for (const RateProfile& rates : report.rates) add_rates(page, rates);
  return page.take();
}

Json to_json(const ProfileReport& report) {
  Json errors = Json::array(), rates = Json::array();
  for (const ErrorProfile& profile : report.errors) errors.push_back(to_json(profile));
  for (const RateProfile& profile : report.rates) rates.push_back(to_json(profile));
  return {{"scene", report.scene},
          {"reference", report.reference.name()},
          {"comparisons", report.comparisons},
          {"relative_errors", std::move(errors)},
          {"recomputation_rates", std::move(rates)}};
}

std::string figure4_csv(const ProfileReport& report) {
  FormattedText page;
  page.add("inputs,precision,f_error,g_error,f_bound,g_bound,f_unbounded,g_unbounded\n");
  const auto bound = [](const std::optional<double>& value) {
    return value ? fmt::format("{}", *value) : "";
  };
  const auto measured = [](const std::optional<mpq_class>& error) {
    return error ? fmt::format("{}", error->get_d()) : "";
  };
  for (const ErrorProfile& profile : report.errors) {
    for (const ErrorAtPrecision& error : profile.precisions) {
      page.add("{},{},{},{},{},{},{},{}\n", to_string(profile.inputs), error.precision,
               measured(error.f), measured(error.g), bound(error.f_bound), bound(error.g_bound),
               error.f_unbounded, error.g_unbounded);
    }
  }
  return page.take();
}

std::string figure5_csv(const ProfileReport& report) {
  FormattedText page;
  page.add("inputs,precision,scheme,comparisons,undecided,rate,wrong,wrong_by_lane\n");
  for (const RateProfile& profile : report.rates) {
    const auto inputs = to_string(profile.inputs);
    page.add("{},{},reference,{},0,0,{},0\n", inputs, report.reference.precision(),
             profile.comparisons, profile.reference_wrong);
    for (const SchemeProfile& scheme : profile.schemes) {
      for (std::size_t k = 0; k < scheme.counts.size(); ++k) {
        const SchemeCounts& counts = scheme.counts[k];
        if (!counts.exists) continue;
        page.add("{},{},{},{},{},{},{},{}\n", inputs, profile.first_precision + static_cast<int>(k),
                 scheme.name, profile.comparisons, counts.undecided, rate_of(counts, profile),
                 counts.wrong, counts.wrong_by_lane);
      }
    }
  }
  return page.take();
}

}  // namespace mixcmp::report
