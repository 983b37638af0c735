#include "model/judge/emulator/criterion_code.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <variant>

#include "model/base/common/check.hpp"
#include "model/base/number/bound_format.hpp"
#include "model/base/number/double.hpp"

namespace mixcmp::emulator {
namespace {

constexpr int double_bias = 1023;

double bound_as_double(BoundFormat format, Bits bound) {
  if (bound == format.infinity()) return std::numeric_limits<double>::infinity();
  return bound_value(format, bound).get_d();
}

Kernel kernel_of(error::BoundOperation operation) {
  switch (operation) {
    case error::BoundOperation::magnitude: return Kernel::bound_magnitude;
    case error::BoundOperation::binade: return Kernel::bound_binade;
    case error::BoundOperation::reciprocal: return Kernel::bound_reciprocal;
    case error::BoundOperation::add: return Kernel::bound_add;
    case error::BoundOperation::multiply: return Kernel::bound_multiply;
    case error::BoundOperation::maximum: return Kernel::bound_maximum;
    case error::BoundOperation::constant: break;
  }
  MIXCMP_CHECK(false);
}

/// The error of a product is lost below 2^-1074. Products of bounds with few digits have no error.
/// For other bounds the exponents must be small enough to keep the error.
bool is_safe(BoundFormat format) {
  constexpr int error_free_digits = 26, free_exponent_bits = 9;
  return format.precision <= error_free_digits || format.exponent_bits <= free_exponent_bits;
}

void add_bound_node(Code& code, const error::BoundNode& node, BoundFormat format,
                    int first_column) {
  const int column = code.layout.columns++;
  if (node.operation == error::BoundOperation::constant) {
    const Bits bound = encode_bound(format, node.constant);
    code.layout.constants.emplace_back(column, bound_as_double(format, bound));
    return;
  }
  const auto operand = [&](int k) { return node.operands[k] + first_column; };
  const bool of_value = arity(node.operation) == 0;
  const double above_one = 2 - std::ldexp(1, 1 - format.precision);
  code.bounds.push_back({.kernel = kernel_of(node.operation),
                         .result = column,
                         .a = of_value ? node.value : operand(0),
                         .b = of_value ? node.value : operand(1),
                         .dropped_digits = double_digits - format.precision,
                         .smallest = std::ldexp(1, 1 - format.bias()),
                         .largest = std::ldexp(above_one, format.bias())});
}

/// Sets the guard to `guard` ulps times 2^power. A guard that exceeds every difference becomes the
/// largest integer: the lane then never decides.
void set_guard(FloatCriterion& criterion, FloatFormat format, Bits guard, int power) {
  constexpr Bits never = std::numeric_limits<std::int64_t>::max();
  const auto zero_exponent = static_cast<std::uint64_t>(double_bias - format.bias());
  criterion.guard = static_cast<std::int64_t>(guard <= never >> power ? guard << power : never);
  criterion.zero = std::bit_cast<double>(zero_exponent << (double_digits - 1));
}

bool add(Code& code, const error::Lane& lane, const error::AbsoluteBoundCriterion& criterion) {
  if (!is_safe(criterion.bound.format)) return false;
  const int first_column = code.layout.columns;
  for (const error::BoundNode& node : criterion.bound.nodes) {
    add_bound_node(code, node, criterion.bound.format, first_column);
  }
  code.criterion.kind = CriterionKind::absolute_bound;
  code.criterion.first = criterion.difference;
  code.criterion.second = code.layout.columns - 1;
  const FloatFormat format = lane.graph.arithmetic.format;
  set_guard(code.criterion, format, criterion.guard_ulp, double_digits - format.precision());
  for (const error::BoundCondition& condition : criterion.conditions) {
    code.criterion.conditions.push_back({first_column + condition.bound, condition.value});
  }
  return true;
}

bool add(Code& code, const error::Lane& lane, const error::UlpDistanceCriterion& criterion) {
  const FloatFormat format = lane.graph.arithmetic.format;
  if (format.precision() == double_digits) return false;  // keys need the last bit
  if (criterion.guard_ulp == 0) return true;              // the order of exact f and g
  code.criterion.kind =
      criterion.nonnegative ? CriterionKind::magnitudes : CriterionKind::signed_keys;
  const int halved = criterion.nonnegative ? 0 : 1;
  set_guard(code.criterion, format, criterion.guard_ulp,
            double_digits - format.precision() - halved);
  return true;
}

bool add(Code& code, const error::Lane&, const error::IntervalCriterion& criterion) {
  code.criterion.kind = CriterionKind::interval;
  code.criterion.first = criterion.minimum;
  code.criterion.second = criterion.maximum;
  return true;
}

Sign sign_of(error::RequiredSign sign) {
  switch (sign) {
    case error::RequiredSign::any: return Sign::any;
    case error::RequiredSign::nonnegative: return Sign::nonnegative;
    case error::RequiredSign::nonpositive: return Sign::nonpositive;
  }
  MIXCMP_CHECK(false);
}

/// The magnitude of an encoding; infinity for a NaN's. Encodings order magnitudes, so limits on
/// leading bits are limits on magnitudes: those of the encodings that continue with zeros and with
/// ones.
double magnitude_limit(FloatFormat format, Bits encoding) {
  const Bits magnitude = std::min(encoding, format.infinity(false));
  return to_double(format, magnitude);
}

OperandCheck operand_check(const error::RangeCheck& check, int column, FloatFormat format) {
  OperandCheck result{.column = column, .sign = sign_of(check.sign)};
  if (check.leading_bits == 0) return result;
  const int rest = format.width() - 1 - check.leading_bits;
  result.least = magnitude_limit(format, check.least << rest);
  result.greatest = magnitude_limit(format, ((check.greatest + 1) << rest) - 1);
  return result;
}

/// Adds the range checks; false if a check reads an operand that the graph does not.
bool add_checks(Code& code, const error::Lane& lane) {
  for (const error::RangeCheck& check : lane.checks) {
    const auto reads = [&](const auto& input) { return input.second == check.input; };
    const auto input = std::find_if(code.layout.inputs.begin(), code.layout.inputs.end(), reads);
    if (input == code.layout.inputs.end()) return false;
    code.criterion.checks.push_back(operand_check(check, input->first, lane.graph.input_format));
  }
  return true;
}

}  // namespace

bool add_criterion(Code& code, const error::Lane& lane) {
  if (!add_checks(code, lane)) return false;
  return std::visit([&](const auto& criterion) { return add(code, lane, criterion); },
                    lane.criterion());
}

std::vector<NodeId> values_as_encodings(const error::Lane& lane) {
  if (std::holds_alternative<error::UlpDistanceCriterion>(lane.criterion())) {
    return {lane.graph.f(), lane.graph.g()};
  }
  std::vector<NodeId> values;
  const auto* criterion = std::get_if<error::AbsoluteBoundCriterion>(&lane.criterion());
  if (criterion == nullptr) return values;
  for (const error::BoundNode& node : criterion->bound.nodes) {
    if (node.value >= 0) values.push_back(node.value);
  }
  return values;
}

}  // namespace mixcmp::emulator
