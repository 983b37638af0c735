#include "model/comparison/data/sphere_family.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <optional>

#include "model/base/common/nearest.hpp"
#include "model/base/common/quote.hpp"
#include "model/comparison/data/sphere_pair_maker.hpp"

namespace mixcmp::data {
namespace {

using Member = SpherePairMaker::Row (SpherePairMaker::*)();

struct Kind {
  const char* name;
  Member make;
};

constexpr Kind kinds[] = {
    {"uniform", &SpherePairMaker::uniform},
    {"tangent", &SpherePairMaker::tangent},
    {"coincident", &SpherePairMaker::coincident},
    {"nested", &SpherePairMaker::nested},
    {"offset_1e2", &SpherePairMaker::offset<2>},
    {"offset_1e4", &SpherePairMaker::offset<4>},
    {"offset_1e6", &SpherePairMaker::offset<6>},
    {"offset_1e8", &SpherePairMaker::offset<8>},
    {"offset_1e10", &SpherePairMaker::offset<10>},
    {"offset_1e12", &SpherePairMaker::offset<12>},
    {"smallest", &SpherePairMaker::smallest},
    {"largest", &SpherePairMaker::largest},
    {"scales", &SpherePairMaker::scales},
    {"mixed_scales", &SpherePairMaker::mixed_scales},
    {"zero_radii", &SpherePairMaker::zero_radii},
    {"negative_radii", &SpherePairMaker::negative_radii},
    {"grid", &SpherePairMaker::grid},
    {"infinities_and_nans", &SpherePairMaker::infinities_and_nans},
    {"counterexample", &SpherePairMaker::counterexample},
};

constexpr std::string_view near_tie_prefix = "near_tie_";
constexpr int first_near_tie = 4, last_near_tie = 52;

/// The precision L of the family "near_tie_L"; none for other families.
std::optional<int> near_tie_precision(std::string_view name) {
  if (!name.starts_with(near_tie_prefix)) return std::nullopt;
  const std::string_view digits = name.substr(near_tie_prefix.size());
  int precision = 0;
  const auto [end, error] = std::from_chars(digits.begin(), digits.end(), precision);
  const bool plain = error == std::errc() && end == digits.end() && !digits.starts_with('0');
  if (!plain || precision < first_near_tie || precision > last_near_tie) return std::nullopt;
  return precision;
}

Error too_large(const std::string& name, FloatFormat format) {
  return {.field = "data.family",
          .message = fmt::format("{} has numbers beyond the largest of {}", name, format.name()),
          .received = fmt::format("\"{}\"", name),
          .accepted = "a family of smaller numbers, or a reference of more exponent bits"};
}

Error too_narrow(const std::string& name, FloatFormat format, int precision) {
  return {.field = "data.family",
          .message = fmt::format("{} needs operands of {} digits", name, precision),
          .received = fmt::format("{}, a reference of {}", format.name(), format.precision()),
          .accepted = fmt::format("a reference of {} digits or more", precision)};
}

}  // namespace

std::vector<std::string> sphere_family_names() {
  std::vector<std::string> names;
  for (const Kind& kind : kinds) names.emplace_back(kind.name);
  for (int precision = first_near_tie; precision <= last_near_tie; ++precision) {
    names.push_back(fmt::format("{}{}", near_tie_prefix, precision));
  }
  return names;
}

std::string accepted_sphere_families(std::string_view received) {
  const std::string first = nearest(received, sphere_family_names());
  std::vector<std::string> listed;
  if (!first.empty()) listed.push_back(first + " (the nearest)");
  for (const Kind& kind : kinds) {
    if (kind.name != first) listed.emplace_back(kind.name);
  }
  return fmt::format("{}, {}{} to {}{}", fmt::join(listed, ", "), near_tie_prefix, first_near_tie,
                     near_tie_prefix, last_near_tie);
}

Result<Table> sphere_family(const SphereFamily& family, FloatFormat format) {
  const auto kind = std::find_if(std::begin(kinds), std::end(kinds),
                                 [&](const Kind& known) { return known.name == family.name; });
  const std::optional<int> precision = near_tie_precision(family.name);
  if (kind == std::end(kinds) && !precision) {
    return Error{.field = "data.family",
                 .message = "not a family of sphere pairs",
                 .received = in_quotes(family.name),
                 .accepted = accepted_sphere_families(family.name)};
  }
  const bool counterexample = family.name == "counterexample";
  const int digits = counterexample ? SpherePairMaker::first_counterexample : precision.value_or(0);
  if (digits > format.precision()) return too_narrow(family.name, format, digits);
  Table table{.format = format, .columns = {"cxi", "cxj", "cyi", "cyj", "czi", "czj", "ri", "rj"}};
  table.values.reserve(table.columns.size() * family.count);
  for (std::uint64_t row = 0; row < family.count; ++row) {
    SpherePairMaker maker(format, row, RowRandom(family.seed, stream_of(family.name), row));
    const auto pair = precision ? maker.near_tie(*precision) : (maker.*kind->make)();
    if (maker.overflowed()) return too_large(family.name, format);
    table.values.insert(table.values.end(), pair.begin(), pair.end());
  }
  return table;
}

}  // namespace mixcmp::data
