#include "generator/hardware/rtl/range_checks.hpp"

#include <algorithm>
#include <map>

#include "model/base/common/check.hpp"

namespace mixcmp::rtl {
namespace {

using error::RangeCheck;
using error::RequiredSign;

int sign_parameter(RequiredSign sign) {
  switch (sign) {
    case RequiredSign::any: return 0;
    case RequiredSign::nonnegative: return 1;
    case RequiredSign::nonpositive: return 2;
  }
  MIXCMP_CHECK(false);
}

Signal build_check(DatapathBuilder& builder, const RangeCheck& check, FloatFormat format,
                   const datapath::Step& step) {
  const std::string& port = builder.port(check.input);
  const std::string name = builder.pool().unique(port + "_out_of_range");
  const int magnitude_bits = format.width() - 1;
  Signal flag = builder.declare(name, 1, step.ready_cycle);
  builder.add_unit(step, "check_" + port,
                   {{"EXPONENT_BITS", format.exponent_bits()},
                    {"PRECISION", format.precision()},
                    {"SIGN", sign_parameter(check.sign)},
                    {"LEADING_BITS", check.leading_bits},
                    {"LEAST", Literal{magnitude_bits, check.least}},
                    {"GREATEST", Literal{magnitude_bits, check.greatest}}},
                   {{"x", net(port)}, {"fails", flag.value}});
  return flag;
}

/// One flag per check; an empty Signal for a check of only the sign.
std::vector<Signal> build_magnitude_checks(DatapathBuilder& builder, const error::Lane& lane,
                                           const datapath::Schedule& schedule) {
  std::vector<Signal> flags;
  bool told = false;
  for (std::size_t k = 0; k < lane.checks.size(); ++k) {
    flags.push_back({});
    if (lane.checks[k].leading_bits == 0) continue;
    if (!told) {
      builder.add(
          Comment{"The error bound is proven for operands in these ranges. Others leave the "
                  "comparison undecided."});
    }
    told = true;
    flags.back() =
        build_check(builder, lane.checks[k], lane.graph.input_format, schedule.checks[k]);
  }
  return flags;
}

/// Builds the checks part by part. Parts with the same checks share one flag.
class PartChecks {
public:
  PartChecks(DatapathBuilder& builder, const error::Lane& lane, const datapath::Schedule& schedule)
      : builder_(builder),
        lane_(lane),
        magnitudes_(build_magnitude_checks(builder, lane, schedule)) {}

  Signal build(std::size_t part) {
    const std::vector<std::size_t>& checks = lane_.parts[part].checks;
    const auto known = built_.find(checks);
    if (known != built_.end()) return known->second;
    return built_[checks] = gather(checks, part_suffix(part, lane_.parts.size()));
  }

private:
  Signal gather(const std::vector<std::size_t>& checks, const std::string& suffix) {
    std::vector<Signal> flags;
    for (const std::size_t check : checks) {
      if (magnitudes_[check].value != nullptr) flags.push_back(magnitudes_[check]);
    }
    const Signal signs = build_signs(checks, suffix);
    if (signs.value != nullptr) flags.push_back(signs);
    if (flags.empty()) return {};
    if (flags.size() == 1) return flags.front();
    int cycle = 0;
    for (const Signal& flag : flags) cycle = std::max(cycle, flag.cycle);
    const std::string name = builder_.pool().unique("out_of_range" + suffix);
    const Operand any = builder_.any_at(flags, cycle);
    builder_.add(Wire{1, name, any});
    return {net(name), name, 1, cycle};
  }

  /// Builds a flag that is set if an operand has a wrong sign, for checks of only the sign.
  Signal build_signs(const std::vector<std::size_t>& checks, const std::string& suffix) {
    std::vector<Operand> wrong;
    for (const std::size_t index : checks) {
      const RangeCheck& check = lane_.checks[index];
      if (check.leading_bits > 0 || check.sign == RequiredSign::any) continue;
      const Operand sign = bit(builder_.port(check.input), lane_.graph.input_format.width() - 1);
      wrong.push_back(check.sign == RequiredSign::nonnegative ? sign : inverted(sign));
    }
    if (wrong.empty()) return {};
    const std::string name = builder_.pool().unique("wrong_sign" + suffix);
    builder_.add(Comment{"The bound's proof needs the signs of these inputs to be as declared."});
    builder_.add(Wire{1, name, any_of(std::move(wrong))});
    return {net(name), name, 1, 0};
  }

  DatapathBuilder& builder_;
  const error::Lane& lane_;
  std::vector<Signal> magnitudes_;
  std::map<std::vector<std::size_t>, Signal> built_;
};

}  // namespace

std::vector<Signal> build_range_checks(DatapathBuilder& builder, const error::Lane& lane,
                                       const datapath::Schedule& schedule) {
  PartChecks checks(builder, lane, schedule);
  std::vector<Signal> flags;
  for (std::size_t part = 0; part < lane.parts.size(); ++part) flags.push_back(checks.build(part));
  return flags;
}

}  // namespace mixcmp::rtl
