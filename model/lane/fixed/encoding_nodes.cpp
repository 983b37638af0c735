#include <algorithm>
#include <string>
#include <tuple>

#include "model/base/common/memo.hpp"
#include "model/base/number/dyadic.hpp"
#include "model/lane/fixed/function_error.hpp"
#include "model/lane/fixed/graph_builder.hpp"
#include "model/lane/fixed/node_enclosure.hpp"
#include "model/lane/function/taylor.hpp"
#include "model/lane/function/value_range.hpp"

/// Functions of operands that are read as their encodings. Proof: docs/fixed_point.md, theorem 10.
namespace mixcmp::fixed {
namespace {

using function::Interval;

/// An encoding has as few bits as move values by so many units of W bits. Two give the fastest
/// plans of examples/functions.
constexpr int moved_units = 2;

/// An encoding costs a range check, and tables for each exponent. It pays if the operand in fixed
/// point moves values by more than this many times `moved_units`.
constexpr int worth_an_encoding = 4;

Range values_at(const Function& function, const Range& numbers) {
  return function::value_on(function, numbers).range();
}

bool has_bounded_values_in(const Function& function, const Range& numbers) {
  return function::has_value_in(function, numbers) &&
         function::value_on(function, numbers).is_bounded();
}

/// The unit of values that have `bits` bits.
mpq_class unit_of(const Range& values, int bits) {
  const mpq_class greatest = absolute(values).high;
  return greatest == 0 ? mpq_class(0)
                       : power_of_two(static_cast<int>(floor_log2(greatest)) + 1 - bits);
}

/// Whether the same error moves a function's values more in the lowest binade than in the highest.
bool is_steeper_near_zero(const Function& function, const Range& numbers, const Range& error) {
  const auto movement = [&](const Range& range) {
    const auto moved = moved_by(function, range, error);
    return moved ? std::optional(absolute(*moved).high) : std::nullopt;
  };
  const auto low = movement({numbers.low, std::min<mpq_class>(2 * numbers.low, numbers.high)});
  const auto high = movement({std::max<mpq_class>(numbers.high / 2, numbers.low), numbers.high});
  return high && (!low || *low > *high);
}

/// The encodings of a range: with whole binades, whose ends are cheaper to check, unless the
/// function has larger values there, or none.
EncodedRange checked_range(const Function& function, const EncodedRange& declared) {
  const EncodedRange whole = declared.with_whole_binades();
  if (!has_bounded_values_in(function, whole.numbers())) return declared;
  const auto unit = [&](const EncodedRange& range) {
    return unit_of(values_at(function, range.numbers()), 0);
  };
  return unit(whole) > unit(declared) ? declared : whole;
}

/// Encodings, and by how much the loss of low bits moves a function's values.
struct MovedRange {
  EncodedRange range;
  std::optional<Range> moved;
};

MovedRange search_fewest_bits(const Function& function, FloatFormat format, int most,
                              const Range& numbers, const mpq_class& movement) {
  const auto with = [&](int fraction_bits) {
    const EncodedRange range =
        checked_range(function, EncodedRange::of(format, fraction_bits, most, numbers));
    return MovedRange{range, range.moved_by(function)};
  };
  MovedRange found = with(most);
  for (int below = 0, enough = most; found.moved && enough - below > 1;) {
    const int bits = (below + enough) / 2;
    MovedRange fewer = with(bits);
    if (fewer.moved && absolute(*fewer.moved).high <= movement) {
      found = std::move(fewer);
      enough = bits;
    } else {
      below = bits;
    }
  }
  return found;
}

/// The encodings of numbers with the fewest bits of the fraction, of `most`, whose loss moves the
/// function's values by no more than `movement`. Equal calls are answered from memory.
MovedRange with_fewest_bits(const Function& function, FloatFormat format, int most,
                            const Range& numbers, const mpq_class& movement) {
  using Key = std::tuple<Function, std::string, int, std::string, std::string, std::string>;
  static Memo<Key, MovedRange> known;
  const Key key{function,
                format.name(),
                most,
                numbers.low.get_str(62),
                numbers.high.get_str(62),
                movement.get_str(62)};
  return *known.of(key,
                   [&] { return search_fewest_bits(function, format, most, numbers, movement); });
}

}  // namespace

/// The positive operands of `declared`, if the function has a value at each of them. If 0 is in the
/// declared range but has no value, a lane leaves small operands undecided: a share of 2^-W
/// of the range for logarithms, which grow slowly, of 2^-(W / 2) for powers, as `balanced_distance`
/// does for operands in fixed point.
std::optional<Range> FixedGraphBuilder::encoded_numbers(const Function& function,
                                                        const Range& declared) const {
  Range numbers = declared;
  const Domain accepted = domain(function);
  const bool excludes_zero = accepted.low && accepted.low->at == 0 && accepted.low->is_open;
  const bool is_table = function.kind() == Function::table;
  if (has_jumps(function) || is_table || numbers.high <= 0) return std::nullopt;
  if (numbers.low <= 0 && excludes_zero && !options_.is_reference) {
    const int bits = options_.format.bits;
    const auto top = static_cast<int>(floor_log2(numbers.high));
    const bool is_power = function.kind() == Function::power;
    numbers.low = power_of_two(top - (is_power ? (bits + 1) / 2 : bits));
  }
  const mpq_class least = power_of_two(input_format_.min_exponent());
  const mpq_class most = power_of_two(input_format_.max_exponent());
  // Subnormal numbers have no encoding, and are left undecided.
  if (numbers.low > 0) numbers.low = std::max(numbers.low, least);
  const bool are_normal =
      least <= numbers.low && numbers.low <= numbers.high && numbers.high <= most;
  return are_normal && has_bounded_values_in(function, numbers) ? std::optional(numbers)
                                                                : std::nullopt;
}

/// A function that is steep near 0, of an operand that it reads as its encoding. None if that helps
/// little, or where the operand has no such encoding.
std::optional<FixedNode> FixedGraphBuilder::of_encoding(const Applied& applied, int further) {
  const Node& node = graph_.nodes()[applied.node];
  const FixedPoint& format = options_.format;
  if (node.operation != Operation::input || !format.is_plain() ||
      graph_.limits().contains(applied.node)) {
    return std::nullopt;
  }
  const auto input = static_cast<std::size_t>(node.input);
  const OperandFormat arriving = options_.operand_formats.empty() ? OperandFormat(input_format_)
                                                                  : options_.operand_formats[input];
  if (arriving.floating() == nullptr || nodes_[known_[applied.node]].is_promised) {
    return std::nullopt;
  }
  const Range& declared = *options_.ranges[input];
  const auto numbers = encoded_numbers(applied.function, declared);
  if (!numbers) return std::nullopt;
  const mpq_class unit = unit_of(values_at(applied.function, *numbers), format.bits + further);
  const Range& error = nodes_[known_[applied.node]].error;
  if (!is_steeper_near_zero(applied.function, *numbers, error)) return std::nullopt;
  const auto fixed = moved_by(applied.function, declared, error);
  if (unit == 0 || (fixed && absolute(*fixed).high <= worth_an_encoding * moved_units * unit)) {
    return std::nullopt;
  }
  const auto [range, moved] =
      with_fewest_bits(applied.function, input_format_, arriving.floating()->fraction_bits(),
                       *numbers, moved_units * unit);
  if (!moved) return std::nullopt;
  const Range values = values_at(applied.function, range.numbers());
  const auto piecewise = function::approximate(
      applied.function, {range.encoding().format(), range.encoding()}, range.first_code(),
      range.last_code(), unit_exponent_for(values, absolute(*moved).high, format.bits + further),
      options_.products);
  if (!piecewise) return std::nullopt;
  const NodeId argument = encoded_argument(applied.function, node.input, range);
  return value_of(applied.function, *piecewise, argument, values, *moved);
}

/// The argument's code: the low bits of an operand's encoding, or the encoding less the first.
NodeId FixedGraphBuilder::encoded_argument(const Function& function, int input,
                                           const EncodedRange& range) {
  FixedNode operand{
      .operation = Operation::input, .input = input, .is_encoding = true, .constant = {}};
  operand.dropped_bits = input_format_.fraction_bits() - range.fraction_bits;
  operand.format = {.width = input_format_.width() - operand.dropped_bits,
                    .unit_exponent = -range.fraction_bits};
  const mpq_class unit = operand.format.unit();
  operand.value = {0, operand.format.largest() * unit};
  FixedNode checked = conversion(Conversion::limit, add(std::move(operand)));
  checked.value = {range.least * unit, range.greatest * unit};
  checked.format = format_of(checked.value, -range.fraction_bits);
  const NodeId encoding = add(std::move(checked));

  const function::FloatingEncoding floating = range.encoding();
  const int first = range.first_exponent();
  const bool is_low_bits = first % (1 << floating.exponent_bits) == 0;
  FixedNode code = is_low_bits
                       ? conversion(Conversion::place, encoding)
                       : exactly(Operation::subtract, encoding, exact_constant(first, 0, first));
  code.format = floating.format();
  code.value = {range.first_code() * unit, range.last_code() * unit};
  code.error = {0, 0};
  code.function = function;
  return add(std::move(code));
}

}  // namespace mixcmp::fixed
