#include "model/plan/optimise/rates.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "model/base/common/file.hpp"
#include "model/base/common/quote.hpp"
#include "model/base/settings/bound_name.hpp"

namespace mixcmp::optimise {
namespace {

constexpr const char* header =
    "inputs,precision,scheme,comparisons,undecided,rate,wrong,wrong_by_lane";

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
  return fields;
}

template <class Integer>
bool read_number(const std::string& text, Integer& target) {
  const auto end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, target);
  return read.ec == std::errc() && read.ptr == end && !text.empty();
}

struct Row {
  RateKey key;
  Rate rate;
};

/// Parses a line into `row`; returns the field at fault, if there is one.
std::optional<std::string> read_row(const std::vector<std::string>& fields, Row& row) {
  if (fields.size() < 5) return "row";
  const auto inputs = LaneInputs::parse(fields[0], settings::limits::lane_precision.least,
                                        settings::limits::reference_precision.most);
  if (!inputs.ok()) return "inputs";
  row.key.inputs = *inputs;
  if (!read_number(fields[1], row.key.precision)) return "precision";
  const auto bound = settings::parse_bound(fields[2]);
  if (!bound.ok()) return "scheme";
  row.key.bound = *bound;
  if (!read_number(fields[3], row.rate.comparisons) || row.rate.comparisons == 0) {
    return "comparisons";
  }
  const bool counted = read_number(fields[4], row.rate.undecided);
  if (!counted || row.rate.undecided > row.rate.comparisons) return "undecided";
  return std::nullopt;
}

Error unreadable(const std::filesystem::path& path, int number, std::string field,
                 const std::string& line) {
  return {.file = path.string(),
          .line = number,
          .field = std::move(field),
          .message = "cannot be read",
          .received = in_quotes(line),
          .accepted = header};
}

}  // namespace

double Rate::value() const {
  if (is_exact) return 0;
  constexpr double rule_of_three = 3;
  const auto total = static_cast<double>(comparisons);
  if (undecided == 0) return std::min(1.0, rule_of_three / total);
  return static_cast<double>(undecided) / total;
}

Rates Rates::of(const std::vector<profile::RateProfile>& profiles) {
  Rates rates;
  for (const profile::RateProfile& profile : profiles) {
    if (rates.pairs_.empty() && profile.pairs) {
      rates.pairs_.push_back({1, std::make_shared<performance::PairwiseFlow>(profile.pairs)});
    }
    for (const profile::SchemeProfile& scheme : profile.schemes) {
      if (!scheme.bound) continue;  // lanes without a bound recompute nothing
      for (std::size_t k = 0; k < scheme.counts.size(); ++k) {
        if (!scheme.counts[k].exists) continue;
        const int precision = profile.first_precision + static_cast<int>(k);
        rates.rates_[{profile.inputs, *scheme.bound, precision}] = {scheme.counts[k].undecided,
                                                                    profile.comparisons};
      }
    }
  }
  return rates;
}

Result<Rates> Rates::read(const std::filesystem::path& path) {
  MIXCMP_TRY(text, read_file(path));
  std::istringstream stream(text);
  std::string line;
  const auto next_line = [&] {
    const bool read = static_cast<bool>(std::getline(stream, line));
    if (line.ends_with('\r')) line.pop_back();
    return read;
  };
  next_line();
  if (line != header) {
    return Error{.file = path.string(),
                 .line = 1,
                 .field = {},
                 .message = "not a table of recomputation rates",
                 .received = in_quotes(line),
                 .accepted = std::string("figure5.csv of mixcmp profile: ") + header};
  }
  Rates rates;
  for (int number = 2; next_line(); ++number) {
    Row row;
    const std::vector<std::string> fields = split(line);
    if (fields.size() > 3 && fields[2] == "reference") {
      Origin origin;
      const bool read = read_number(fields[1], origin.reference_precision) &&
                        read_number(fields[3], origin.comparisons);
      if (!read) return unreadable(path, number, "reference", line);
      rates.origin_ = origin;
      continue;
    }
    if (fields.size() > 2 && fields[2] == "lanes_alone") continue;
    if (const auto field = read_row(fields, row)) return unreadable(path, number, *field, line);
    if (!rates.rates_.emplace(row.key, row.rate).second) {
      return Error{.file = path.string(),
                   .line = number,
                   .field = {},
                   .message = "a second row for the same inputs, bound and precision",
                   .received = in_quotes(line),
                   .accepted = "one row for each"};
    }
  }
  return rates;
}

void Rates::raise_to(const Rates& other) {
  for (const auto& [key, rate] : other.rates_) {
    const auto [place, added] = rates_.emplace(key, rate);
    if (!added && rate.value() > place->second.value()) place->second = rate;
  }
  if (other.reported_share().value_or(-1) > reported_share().value_or(-1)) pairs_ = other.pairs_;
}

Rates Rates::mixed_with(const Rates& other, double of_other) const {
  constexpr std::uint64_t comparisons = 1'000'000'000'000'000;
  Rates mixed;
  for (const auto& [key, rate] : rates_) {
    const auto found = other.rates_.find(key);
    if (found == other.rates_.end()) continue;
    const double value = rate.value() + of_other * (found->second.value() - rate.value());
    mixed.rates_[key] = {static_cast<std::uint64_t>(std::llround(value * comparisons)),
                         comparisons};
  }
  if (pairs_.empty() || other.pairs_.empty()) return mixed;
  for (const PairsOfSet& each : pairs_) {
    mixed.pairs_.push_back({(1 - of_other) * each.part, each.flow});
  }
  for (const PairsOfSet& each : other.pairs_) {
    mixed.pairs_.push_back({of_other * each.part, each.flow});
  }
  return mixed;
}

std::optional<double> Rates::reported_share() const {
  if (pairs_.empty()) return std::nullopt;
  double share = 0;
  for (const PairsOfSet& each : pairs_) share += each.part * each.flow->reported_share();
  return share;
}

std::optional<double> Rates::cycles_per_pair(const performance::PairwiseEngine& engine) const {
  if (pairs_.empty()) return std::nullopt;
  double cycles = 0;
  for (const PairsOfSet& each : pairs_) {
    cycles += each.part * each.flow->cycles(engine) / each.flow->pairs();
  }
  return cycles;
}

void Rates::assume_nothing_reported(const performance::ItemSet& set) {
  auto pairs = std::make_shared<performance::PairwiseData>(performance::PairwiseData{.set = set});
  pairs_ = {{1, std::make_shared<performance::PairwiseFlow>(std::move(pairs))}};
}

std::optional<Rate> Rates::find(const RateKey& key) const {
  auto found = rates_.find(key);
  if (found == rates_.end() && key.bound.is_fixed_point()) {
    found = std::find_if(rates_.begin(), rates_.end(), [&](const auto& known) {
      return known.first.bound == key.bound && known.first.precision == key.precision;
    });
  }
  return found == rates_.end() ? std::nullopt : std::optional(found->second);
}

std::vector<RateKey> Rates::keys() const {
  std::vector<RateKey> keys;
  for (const auto& [key, rate] : rates_) keys.push_back(key);
  return keys;
}

}  // namespace mixcmp::optimise
