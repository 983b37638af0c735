#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "generator/present/report/plot.hpp"
#include "generator/present/table/table.hpp"
#include "model/base/number/lane_format.hpp"
#include "model/plan/profile/profile.hpp"

namespace mixcmp::report {

/// The results of one run of `profile`.
struct ProfileReport {
  std::string scene;
  LaneFormat reference;
  std::uint64_t comparisons = 0;
  std::vector<profile::ErrorProfile> errors;
  std::vector<profile::RateProfile> rates;
};

std::string to_text(const ProfileReport& report);
nlohmann::ordered_json to_json(const ProfileReport& report);

/// The undecided comparisons of each scheme with a bound, at every precision.
table::Table undecided_counts(const profile::RateProfile& rates);

/// CSV with the columns inputs, precision, f_error, g_error, f_bound, g_bound. A bound that does
/// not exist is empty.
std::string figure4_csv(const ProfileReport& report);
/// CSV with the columns inputs, precision, system, comparisons, undecided, rate, wrong,
/// wrong_by_lane. The reference without lanes has its own precision and nothing undecided. Systems
/// that do not exist have no rows.
std::string figure5_csv(const ProfileReport& report);

/// The paper's figures: relative errors with their proven bounds, and recomputation rates.
Picture figure4(const ProfileReport& report);
Picture figure5(const ProfileReport& report);

}  // namespace mixcmp::report
