#include "generator/rtl/range_checks.hpp"

#include <algorithm>

#include "model/common/check.hpp"

namespace mixcmp::gen {
namespace {

using namespace rtl;
using model::FloatFormat;
using model::RangeCheck;
using model::RequiredSign;

int sign_parameter(RequiredSign sign) {
  switch (sign) {
    case RequiredSign::any: return 0;
    case RequiredSign::nonnegative: return 1;
    case RequiredSign::nonpositive: return 2;
  }
  MIXCMP_CHECK(false);
}

/// The sign bits that must not be set, nor those inverted that must.
Signal build_sign_checks(DatapathBuilder& builder, const model::Lane& lane) {
  std::vector<Operand> wrong;
  for (const RangeCheck& check : lane.checks) {
    if (check.leading_bits > 0 || check.sign == RequiredSign::any) continue;
    const Operand sign = bit(builder.port(check.input), lane.graph.input_format.width() - 1);
    wrong.push_back(check.sign == RequiredSign::nonnegative ? sign : inverted(sign));
  }
  if (wrong.empty()) return {};
  const std::string name = builder.pool().unique("wrong_sign");
  builder.add(Comment{"The bound's proof needs the signs of these inputs to be as declared."});
  builder.add(Wire{1, name, any_of(std::move(wrong))});
  return {net(name), name, 1, 0};
}

Signal build_check(DatapathBuilder& builder, const RangeCheck& check, FloatFormat format,
                   const Step& step) {
  const std::string& port = builder.port(check.input);
  const std::string name = builder.pool().unique(port + "_out_of_range");
  const int magnitude_bits = format.width() - 1;
  builder.add(Wire{1, name, nullptr});
  builder.add(Instance{step.unit.module,
                       builder.pool().unique("check_" + port),
                       {{"EXPONENT_BITS", format.exponent_bits()},
                        {"PRECISION", format.precision()},
                        {"SIGN", sign_parameter(check.sign)},
                        {"LEADING_BITS", check.leading_bits},
                        {"LEAST", Literal{magnitude_bits, check.least}},
                        {"GREATEST", Literal{magnitude_bits, check.greatest}},
                        {"CUTS", cut_mask(step)}},
                       {{"aclk", net("aclk")}, {"x", net(port)}, {"fails", net(name)}}});
  return {net(name), name, 1, step.ready_cycle};
}

std::vector<Signal> build_magnitude_checks(DatapathBuilder& builder, const model::Lane& lane,
                                           const Schedule& schedule) {
  std::vector<Signal> flags;
  for (std::size_t k = 0; k < lane.checks.size(); ++k) {
    if (lane.checks[k].leading_bits == 0) continue;
    if (flags.empty()) {
      builder.add(
          Comment{"What is proven and what is left out hold for operands in these ranges."});
    }
    flags.push_back(
        build_check(builder, lane.checks[k], lane.graph.input_format, schedule.checks[k]));
  }
  return flags;
}

}  // namespace

Signal build_range_checks(DatapathBuilder& builder, const model::Lane& lane,
                          const Schedule& schedule) {
  std::vector<Signal> flags = build_magnitude_checks(builder, lane, schedule);
  const Signal signs = build_sign_checks(builder, lane);
  if (signs.value != nullptr) flags.push_back(signs);
  if (flags.empty()) return {};
  if (flags.size() == 1) return flags.front();
  int cycle = 0;
  for (const Signal& flag : flags) cycle = std::max(cycle, flag.cycle);
  const std::string name = builder.pool().unique("out_of_range");
  const Operand any = builder.any_at(flags, cycle);
  builder.add(Wire{1, name, any});
  return {net(name), name, 1, cycle};
}

}  // namespace mixcmp::gen
