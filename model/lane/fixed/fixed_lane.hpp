#pragma once

#include <array>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "model/base/common/result.hpp"
#include "model/base/number/bound.hpp"
#include "model/base/number/fixed_format.hpp"
#include "model/base/number/float_format.hpp"
#include "model/base/number/lane_format.hpp"
#include "model/base/number/operand_format.hpp"
#include "model/comparison/expression/graph.hpp"
#include "model/comparison/expression/range.hpp"
#include "model/lane/function/piecewise.hpp"

/// Lanes in fixed point: operands that the scene bounds become integers when they arrive, and all
/// further arithmetic is on integers. Proofs: docs/fixed_point.md.
namespace mixcmp::fixed {

/// The kinds of Operation::convert, which has one operand and computes nothing new.
enum class Conversion {
  /// Drops low bits, the same number in every comparison.
  cut,
  /// Drops as many low bits as every other common cut in the same comparison: the fewest with which
  /// each of them fits a magnitude of W bits. Its result counts units of the operand's format, so
  /// it stands for the operand divided by a power of two.
  common_cut,
  /// Leaves the comparison undecided if the operand is outside `value`.
  limit,
  /// Keeps the low bits that hold a number within `value`. A number outside has a square that
  /// decides the part by itself, so hardware need not compute the rest of the difference.
  reach,
  /// A number without a sign as a floating-point one (function::FloatingCode): the place of its
  /// leading one, and the bits behind that.
  floating,
  /// Keeps the low bits of a number in two's complement, without a sign: where it is in its piece
  /// of a piecewise polynomial.
  place,
  /// Drops low bits of a polynomial's value. The result stands for a function of the polynomial's
  /// argument: `error` is what theorem 10 bounds.
  function_value,
};

/// One operation. Its result is an integer of `format`, in that format's units.
///
/// The magnitude of an input that arrives in floating point is truncated to the unit and, if its
/// sign bit is set, every bit is inverted. Both round down, to within a unit. Some operands leave
/// the comparison undecided: NaN, infinity, a magnitude or sign that the format does not have, and
/// a negative zero if the format is unsigned. If the input is `is_promised`, so does an operand
/// that is no multiple of the unit, and the others are converted exactly. An input that arrives in
/// fixed point loses `dropped_bits` low bits, often none, and leaves nothing undecided. So does an
/// encoding; a limit and a subtraction, or a `place`, make a function's argument of it
/// (function::FloatingEncoding).
///
/// The operands of an addition, a subtraction, a minimum and a maximum are aligned to the finer
/// unit of the two. A square root is rounded down to its own unit, whatever its operand's unit is.
/// The operand's upper bits are the address of a look-up.
struct FixedNode {
  Operation operation;
  std::array<NodeId, 2> operands = {-1, -1};
  int input = -1;  ///< for Operation::input
  /// For an input in floating point: the scene promises multiples of the unit. Hardware checks
  /// that, and converts them exactly.
  bool is_promised = false;
  /// For an input in floating point: the integer is its encoding, which grows with an operand above
  /// 0, without low bits.
  bool is_encoding = false;
  mpz_class constant;  ///< for Operation::constant: in units
  FixedFormat format;
  std::optional<Conversion> conversion = {};  ///< for Operation::convert
  int dropped_bits = 0;  ///< low bits of the exact result that are dropped: it is rounded down
  int most_dropped = 0;  ///< for Conversion::common_cut: the most bits that it drops
  function::Words words = {};  ///< for Operation::look_up
  /// For Operation::look_up, the conversions `floating`, `place` and `function_value`, and
  /// constants in their place.
  std::optional<Function> function = {};
  int power = 0;  ///< of a look_up: of t; -1 where the word is the start of a piece
  Range value;    ///< encloses the computed number: the result times its unit
  Range error;    ///< encloses the computed number less the real one

  friend bool operator==(const FixedNode&, const FixedNode&) = default;
};

bool is_floating_code(const FixedNode& node);
/// Whether a limit leaves encodings of some exponents.
bool is_limited_encoding(const std::vector<FixedNode>& nodes, const FixedNode& node);
/// Whether the node makes a function's argument of such encodings: it is their low bits, or they
/// less the first exponent.
bool is_code_of_encoding(const std::vector<FixedNode>& nodes, const FixedNode& node);
/// Tells whether hardware computes the node by wires alone. A check of its operand may stand beside
/// them.
bool is_wires(const FixedNode& node);
/// The operand's low bits that are no part of a look-up's address.
int piece_bits(const std::vector<FixedNode>& nodes, const FixedNode& look_up);
/// Whether value and error follow from those of the operands. They do not inside a piecewise
/// polynomial.
bool follows_operands(const FixedNode& node);
bool is_limit(const FixedNode& node);
bool is_common_cut(const FixedNode& node);
bool is_reach(const FixedNode& node);
/// Whether hardware checks that the node's operand is within its `value`.
bool is_checked(const FixedNode& node);

/// Decides by constants: greater iff n >= greater_from, less iff n <= less_to, where n is the
/// difference in its units; equal iff neither holds and nothing was rounded.
struct ConstantThresholds {
  mpz_class greater_from;
  mpz_class less_to;
  /// All comparisons whose operands fit are decided: a difference that is neither is equal. In a
  /// lane it then has no error.
  bool decides_ties = false;

  friend bool operator==(const ConstantThresholds&, const ConstantThresholds&) = default;
};

/// Decides by the norm of the errors. Let n be the difference, and n and s in their units: greater
/// iff n >= 2^shift_above s + offset_above, less iff n < -2^shift_below s.
///
/// The difference is one of two kinds. Either it is |x|^2 - s^2, a sum of squares less a square,
/// with s >= 0 as computed. Or it is |x|^2 - |y|^2, the difference of two sums of squares, and s is
/// the least power of two above |y| as computed.
struct NormThresholds {
  NodeId radius;  ///< s, or |y|^2
  /// `radius` is |y|^2: s is 2^k for the least k with |y|^2 < 4^k, both in their units.
  bool radius_is_squared = false;
  int shift_above;
  mpz_class offset_above;
  int shift_below;

  /// The exponent of s's unit, which is a power of two.
  int unit_exponent(const std::vector<FixedNode>& nodes) const;

  friend bool operator==(const NormThresholds&, const NormThresholds&) = default;
};

/// Decides by one of several constants, which is smaller if the factors of products are small:
/// greater iff n >= t, less iff n < -t, where t is the threshold of the comparison's step. With S +
/// 1 steps, the step is the least k >= 0 with -2^(m - S + k) <= w < 2^(m - S + k) for every watched
/// integer w, where m is the number of magnitude bits of its format.
struct RunningThresholds {
  std::vector<NodeId> watched;
  std::vector<mpz_class> of_steps;  ///< [step]: t, in units of the difference

  friend bool operator==(const RunningThresholds&, const RunningThresholds&) = default;
};

using Criterion = std::variant<ConstantThresholds, NormThresholds, RunningThresholds>;

/// When a lane decides one part.
struct FixedPart {
  NodeId difference;     ///< f - g, or g - f if `swapped`
  bool swapped = false;  ///< `greater` and `less` of the decision change places
  Criterion criterion;
  /// In block floating point: if operands are multiplied by t > 0, f and g are multiplied by
  /// t^degree. In fixed point with guard digits, the same holds for the numbers that are cut in
  /// common. In other lanes the degree is 0.
  mpq_class degree = 0;

  friend bool operator==(const FixedPart&, const FixedPart&) = default;
};

/// The owner of an operand of a comparison: one of its two items, or the row that is compared with
/// both.
enum class ItemRole { first, second, row };

/// An input of a lane whose operands were loaded before (see ItemSplit). It is an integer of its
/// node's format: a field of an item's or the row's word, or the upper bits of one.
struct LoadedInput {
  ItemRole role;                   ///< the owner of the word
  std::size_t field;               ///< index of the word's field
  int dropped_bits;                ///< low bits of the field that are not part of the input
  std::vector<std::size_t> flags;  ///< the word's; if one is set, the field's operands do not fit

  friend bool operator==(const LoadedInput&, const LoadedInput&) = default;
};

/// In q13 an input in [0, 100], below 2^7, counts units of 2^(7 - 13). In block13 the lane computes
/// on x / 2^e instead of each operand x that it reads. 2^e is the least power of two above all
/// their magnitudes, but e is at least `least_block_exponent`. So all are below 1 and count units
/// of 2^-13. If one operand is infinite or a NaN, the comparison is left undecided. With guard
/// digits, as in q13g3, operands have 13 + 3 bits, and affine nodes are cut to 13 bits in common
/// before any other operation reads them.
struct FixedLane {
  FixedPoint format;
  std::vector<FixedNode> nodes;  ///< in topological order
  std::vector<std::string> input_names;
  FloatFormat input_format;  ///< the format of operands that arrive in floating point
  std::vector<FixedPart> parts;
  Combination combination = Combination::all;  ///< valid only if there are several parts
  /// One per input of a lane that was split by item. Empty otherwise: operands arrive in
  /// `input_format`.
  std::vector<LoadedInput> loaded_inputs = {};
  /// One per input: the format in which it arrives. Empty: all arrive in `input_format`.
  std::vector<OperandFormat> operand_formats = {};
  /// The results of a graph without parts; empty elsewhere.
  std::vector<NodeId> outputs = {};
  /// The lane is a reference: it orders f and g as computed, equal ones as equal. A comparison
  /// whose operands do not fit is unordered.
  bool is_reference = false;

  friend bool operator==(const FixedLane&, const FixedLane&) = default;
};

struct FixedOptions {
  FixedPoint format = {.bits = 13};
  /// None: norms if there are any, else constants. `norm` is for parts of the form of theorem 4,
  /// `running` for parts with products. With either, at least one part must have that form; other
  /// parts have constants. With `grid` some input has a grid, and nothing is rounded.
  std::optional<BoundKind> bound = {};
  /// One per input; a lane needs them all. In block floating point they are optional: an input
  /// whose range has no negative numbers needs no sign.
  std::vector<std::optional<Range>> ranges;
  /// One per input, or none: the promised grid, a power of two. Only lanes with the bound `grid`
  /// rely on it.
  std::vector<std::optional<mpq_class>> grids = {};
  /// One per input, or none: all operands arrive in the lane's input format.
  std::vector<OperandFormat> operand_formats = {};
  /// How hardware multiplies; the tables of functions of the least area depend on it. Results of
  /// references must not, so they leave it as it is.
  function::ProductKind products = function::ProductKind::embedded;
  /// Makes a reference. The bound is then `constant`.
  bool is_reference = false;

  /// The grid on which the lane relies; null: it relies on none of this input.
  const mpq_class* relied_grid(std::size_t input) const;
};

/// The formats of operands that arrive in floating point, one per input; an input in fixed point
/// counts as one in `input_format`. Empty if none has another format, or if the lane reads values
/// that were converted before.
std::vector<OperandFormat> arriving_formats(const FixedLane& lane);

/// Makes the lane of a comparison whose operands arrive in `input_format`, unless the options say
/// otherwise. Errors name the input without a range, the operation that fixed point does not have,
/// the reason why f and g are not homogeneous, or the requested bound that no part has.
Result<FixedLane> fixed_lane(const Graph& graph, FloatFormat input_format,
                             const FixedOptions& options);

/// Whether the divisor of a quotient is a constant other than zero.
bool divides_by_constant(const Graph& graph, NodeId quotient);

/// The format in which an input arrives.
OperandFormat operand_format(const FixedLane& lane, int input);

/// The fixed-point format in which the input `node` arrives; null if it arrives in floating point.
const FixedFormat* arriving_fixed(const FixedLane& lane, const FixedNode& node);

/// Whether a node is an input that needs no conversion: it is a field of a word, it arrives in
/// fixed point, or it is an encoding.
bool is_read_as_it_arrives(const FixedLane& lane, const FixedNode& node);

/// Whether the lane decides every comparison, also those of equal sides: its differences have no
/// error, it has no limits, and all its operands arrive in fixed point.
bool is_exact(const FixedLane& lane);

/// Whether all differences that the lane decides have no error.
bool rounds_nothing(const FixedLane& lane);

/// The inputs that the lane reads, in the order of its nodes.
std::vector<int> inputs_read(const FixedLane& lane);

/// The operands of the common cuts, in the order of the cuts. All of them precede all common cuts.
std::vector<NodeId> cut_in_common(const FixedLane& lane);

/// The most bits that the common cuts drop; 0 if there are none.
int most_dropped_in_common(const FixedLane& lane);

/// A node and all nodes that it depends on. A common cut depends on the operands of all common
/// cuts.
std::set<NodeId> fan_in(const FixedLane& lane, NodeId node);

/// In block floating point, the least e by whose power 2^e operands are divided: a binade above the
/// smallest normal number.
int least_block_exponent(FloatFormat input_format);

/// The nodes that a criterion reads besides the difference.
std::vector<NodeId> read_by(const Criterion& criterion);

/// Whether any input is `is_promised`.
bool relies_on_grids(const FixedLane& lane);

/// Whether any part is decided by a norm.
bool has_norm(const FixedLane& lane);

/// Whether any part is decided by thresholds that follow magnitudes.
bool has_running(const FixedLane& lane);

/// When the lane decides, for a report: "certified: where f - g >= 8 s + 14 or ...".
std::string describe_criterion(const FixedLane& lane);

}  // namespace mixcmp::fixed
