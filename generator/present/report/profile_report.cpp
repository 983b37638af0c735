#include "generator/present/report/profile_report.hpp"

#include <fmt/format.h>

#include <functional>

namespace mixcmp::report {

using profile::ErrorAtPrecision;
using profile::ErrorProfile;
using profile::RateProfile;
using profile::SchemeCounts;
using profile::SchemeKind;
using profile::SchemeProfile;
using table::Field;
using table::Fields;
using table::Json;
using table::Table;

namespace {

double rate_of(const SchemeCounts& counts, const RateProfile& profile) {
  return static_cast<double>(counts.undecided) / static_cast<double>(profile.comparisons);
}

/// An error, rounded; missing where no comparison has one.
auto measured(std::optional<mpq_class> ErrorAtPrecision::*error) {
  return [error](const ErrorAtPrecision& row) {
    return row.*error ? Json((row.*error)->get_d()) : Json();
  };
}

auto bound(std::optional<double> ErrorAtPrecision::*error) {
  return [error](const ErrorAtPrecision& row) { return table::cell(row.*error); };
}

/// A table whose first column names the inputs.
template <class Row>
Table with_inputs(const Fields<Row>& fields, const std::string& inputs,
                  const std::vector<Row>& rows) {
  return table_of(table::constant<Row>({"inputs"}, inputs) + fields, rows);
}

const Fields<ErrorAtPrecision>& error_fields() {
  static const Fields<ErrorAtPrecision> fields = {
      {{"precision", "L", 4, 0}, &ErrorAtPrecision::precision},
      {{"f_error", "f", 10, 2, "{:.3e}"}, measured(&ErrorAtPrecision::f)},
      {{"g_error", "g", 10, 2, "{:.3e}"}, measured(&ErrorAtPrecision::g)},
      {{"f_unbounded"}, &ErrorAtPrecision::f_unbounded},
      {{"g_unbounded"}, &ErrorAtPrecision::g_unbounded},
      {{"f_bound", "f bound", 10, 2, "{:.3e}"}, bound(&ErrorAtPrecision::f_bound)},
      {{"g_bound", "g bound", 10, 2, "{:.3e}"}, bound(&ErrorAtPrecision::g_bound)}};
  return fields;
}

/// How many comparisons the errors of a row leave out; empty where they leave out none.
std::string left_out(const ErrorAtPrecision& error) {
  if (error.f_unbounded + error.g_unbounded == 0) return "";
  return fmt::format("left out: {} of f, {} of g", error.f_unbounded, error.g_unbounded);
}

/// Whether anything is known of the errors. Functions have none in floating point.
bool knows_errors(const ErrorProfile& profile) {
  return profile.comparisons > 0 || !profile.no_f_bound.empty() ||
         std::any_of(profile.precisions.begin(), profile.precisions.end(),
                     [](const ErrorAtPrecision& error) { return error.f_bound || error.g_bound; });
}

std::string text_of(const ErrorProfile& profile) {
  if (!knows_errors(profile)) return "";
  const Fields<ErrorAtPrecision> shown =
      pick(error_fields(), {"precision", "f_error", "f_bound", "g_error", "g_bound"});
  const Fields<ErrorAtPrecision> remark = {{{""}, left_out}};
  Table table = table_of(shown + remark, profile.precisions);
  table.missing = "none";
  std::string text =
      fmt::format("\nrelative error of f and g, {}: {}what is proven\n", describe(profile.inputs),
                  profile.comparisons == 0
                      ? "none was measured; "
                      : fmt::format("the largest of {} comparisons, and ", profile.comparisons)) +
      to_text(table);
  if (!profile.no_f_bound.empty()) text += fmt::format("no bound for f: {}\n", profile.no_f_bound);
  if (!profile.no_g_bound.empty()) text += fmt::format("no bound for g: {}\n", profile.no_g_bound);
  return text;
}

/// The counts of one scheme at one precision.
struct RateRow {
  int precision;
  std::string scheme;
  std::uint64_t comparisons;
  double rate;
  SchemeCounts counts;
};

const Fields<RateRow>& rate_fields() {
  static const Fields<RateRow> fields = {
      {{"precision"}, &RateRow::precision},
      {{"scheme"}, &RateRow::scheme},
      {{"comparisons"}, &RateRow::comparisons},
      {{"undecided"}, [](const RateRow& row) { return row.counts.undecided; }},
      {{"rate"}, &RateRow::rate},
      {{"wrong"}, [](const RateRow& row) { return row.counts.wrong; }},
      {{"wrong_by_lane"}, [](const RateRow& row) { return row.counts.wrong_by_lane; }}};
  return fields;
}

/// The precisions at which there is a lane of this scheme.
std::vector<RateRow> rows_of(const SchemeProfile& scheme, const RateProfile& profile) {
  std::vector<RateRow> rows;
  for (std::size_t k = 0; k < scheme.counts.size(); ++k) {
    const SchemeCounts& counts = scheme.counts[k];
    if (!counts.exists) continue;
    rows.push_back({profile.first_precision + static_cast<int>(k), scheme.name, profile.comparisons,
                    rate_of(counts, profile), counts});
  }
  return rows;
}

/// The first rows of counts, with the columns of each scheme beside each other. `columns`: those of
/// a scheme. A scheme that does not exist at a precision has only its last cell, which is missing.
Table by_precision(
    const RateProfile& profile, std::size_t rows,
    const std::function<Fields<SchemeCounts>(const SchemeProfile& scheme)>& columns) {
  Table table{.columns = {{"precision", "L", 4, 0}}, .rows = {}};
  for (std::size_t k = 0; k < rows; ++k) {
    table.rows.push_back({{profile.first_precision + static_cast<int>(k)}});
  }
  for (const SchemeProfile& scheme : profile.schemes) {
    if (!scheme.exists()) continue;
    const Fields<SchemeCounts> fields = columns(scheme);
    for (const Field<SchemeCounts>& field : fields) {
      table.columns.push_back(field.column);
      table.columns.back().group = scheme.name;
      const Json none = &field == &fields.back() ? Json() : Json("");
      for (std::size_t k = 0; k < rows; ++k) {
        const SchemeCounts& counts = scheme.counts[k];
        table.rows[k].cells.push_back(counts.exists ? field.value(counts) : none);
      }
    }
  }
  return table;
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

/// The number of wrong verdicts that lanes decided, for each scheme over all L.
std::string wrong_lanes(const RateProfile& profile) {
  std::string text = "wrong verdicts that a lane decided, at all L together:";
  for (const SchemeProfile& scheme : profile.schemes) {
    if (!scheme.exists()) continue;
    std::uint64_t wrong = 0;
    for (const SchemeCounts& counts : scheme.counts) wrong += counts.wrong_by_lane;
    text += fmt::format(" {} {}", scheme.name, wrong);
  }
  return text + "\n";
}

std::string text_of(const RateProfile& profile) {
  std::string text = fmt::format(
      "\nrecomputation rate and wrong verdicts, {}, {} comparisons\n"
      "the reference alone: {} wrong\n",
      describe(profile.inputs), profile.comparisons, profile.reference_wrong);
  if (profile.undetermined > 0) {
    text += fmt::format("the truth is undetermined of {}, which count as wrong of nobody\n",
                        profile.undetermined);
  }
  const std::size_t rows = profile.schemes.front().counts.size(), told = interesting_rows(profile);
  text += to_text(by_precision(profile, told, [&](const SchemeProfile& scheme) {
    if (scheme.kind == SchemeKind::lanes_alone) {
      return Fields<SchemeCounts>{{{"wrong", "wrong", 12}, &SchemeCounts::wrong}};
    }
    return Fields<SchemeCounts>{
        {{"rate", "rate", 9, 2, "{:.2e}"},
         [&](const SchemeCounts& counts) { return rate_of(counts, profile); }},
        {{"wrong", "wrong", 10, 1}, &SchemeCounts::wrong}};
  }));
  if (told < rows) {
    text += fmt::format("from L = {} on all of them decide everything, and rightly\n",
                        profile.first_precision + static_cast<int>(told));
  }
  text += wrong_lanes(profile);
  for (const SchemeProfile& scheme : profile.schemes) {
    if (!scheme.reason.empty()) text += fmt::format("{}: {}\n", scheme.name, scheme.reason);
  }
  return text;
}

Json to_json(const ErrorProfile& profile) {
  return {{"inputs", to_string(profile.inputs)},
          {"comparisons", profile.comparisons},
          {"no_f_bound", profile.no_f_bound},
          {"no_g_bound", profile.no_g_bound},
          {"precisions", to_json(table_of(error_fields(), profile.precisions))}};
}

Json to_json(const SchemeProfile& scheme, const RateProfile& profile) {
  const Fields<RateRow> fields =
      pick(rate_fields(), {"precision", "undecided", "rate", "wrong", "wrong_by_lane"});
  return {{"scheme", scheme.name},
          {"certified", scheme.kind == SchemeKind::certified},
          {"reason", scheme.reason},
          {"precisions", to_json(table_of(fields, rows_of(scheme, profile)))}};
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
  std::string text = fmt::format("{}: {} comparisons, reference {}\n", report.scene,
                                 report.comparisons, report.reference.name());
  for (const ErrorProfile& errors : report.errors) text += text_of(errors);
  for (const RateProfile& rates : report.rates) text += text_of(rates);
  return text;
}

Table undecided_counts(const RateProfile& rates) {
  const std::size_t rows = rates.schemes.empty() ? 0 : rates.schemes.front().counts.size();
  return by_precision(rates, rows, [](const SchemeProfile& scheme) {
    if (scheme.kind == SchemeKind::lanes_alone) return Fields<SchemeCounts>{};
    return Fields<SchemeCounts>{{{"undecided"}, &SchemeCounts::undecided}};
  });
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
  const Fields<ErrorAtPrecision> fields =
      pick(error_fields(),
           {"precision", "f_error", "g_error", "f_bound", "g_bound", "f_unbounded", "g_unbounded"});
  Table table = with_inputs(fields, "", {});
  for (const ErrorProfile& profile : report.errors) {
    append(table, with_inputs(fields, to_string(profile.inputs), profile.precisions));
  }
  return to_csv(table);
}

std::string figure5_csv(const ProfileReport& report) {
  Table table = with_inputs(rate_fields(), "", {});
  for (const RateProfile& profile : report.rates) {
    const std::string inputs = to_string(profile.inputs);
    const SchemeCounts reference{.exists = true, .wrong = profile.reference_wrong};
    append(table, with_inputs(rate_fields(), inputs,
                              {{report.reference.precision(), "reference", profile.comparisons, 0,
                                reference}}));
    for (const SchemeProfile& scheme : profile.schemes) {
      append(table, with_inputs(rate_fields(), inputs, rows_of(scheme, profile)));
    }
  }
  return to_csv(table);
}

}  // namespace mixcmp::report
