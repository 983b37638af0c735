#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "model/judge/emulator/block.hpp"

/// The part of the emulator that is compiled once per instruction set.
namespace mixcmp::emulator {

enum class Kernel : std::uint8_t {
  add,
  subtract,
  multiply,
  square,
  divide,
  square_root,
  convert,
  negate,
  absolute,
  minimum,
  maximum,
  bound_magnitude,
  bound_binade,
  bound_reciprocal,
  bound_add,
  bound_multiply,
  bound_maximum,
};

/// How an exact result x is rounded to the lane's P digits, P <= 53. Hardware gives r, which is x
/// rounded to 53 digits. The sign of the error e = x - r costs extra operations.
enum class Finish : std::uint8_t {
  hardware,   ///< r itself: P = 53 to nearest, or nothing to round
  nearest,    ///< r rounded, if x = r or double rounding is known to be harmless
  watched,    ///< `nearest`, or `corrected` if r lies half way between numbers of P digits
  corrected,  ///< r rounded; e decides if r lies half way
  fused,      ///< products: rounded once, by a fused multiply-add
  truncated,  ///< toward zero, by r and e
};

struct Instruction {
  Kernel kernel;
  Finish finish = Finish::hardware;
  int result = -1;
  int a = -1;
  int b = -1;              ///< equals a for one operand
  int dropped_digits = 0;  ///< 53 - P, for lanes and bounds
  /// For bounds: a non-zero result below `smallest` becomes `smallest`, one above `largest`
  /// infinite.
  double smallest = 0;
  double largest = 0;
};

/// The magnitudes for which double can be trusted in these columns: 0 and [least, limit). Both ends
/// are powers of two.
struct TrustedRange {
  std::vector<int> columns;
  double least = 0;  ///< 0: no magnitude is too small
  double limit = 0;
  /// The columns may also hold doubles below 2^-1022.
  bool any_double = false;
  /// Mask of the lowest bits of a double, which must be 0 in each column.
  std::uint64_t zero_bits = 0;
};

/// A window of exponents that begins with the exponent of `least`. Their number is a power of two.
/// A double x is inside if (bits of x) - `least` and `outside` have no bit in common: larger
/// exponents set leading bits of the exponent field, and numbers below `least`, 0 included, set
/// them by borrowing. `outside` also holds the digits that must be 0.
struct OperandWindow {
  std::vector<int> columns;
  std::uint64_t least = 0;  ///< bits of a power of two
  std::uint64_t outside = 0;
};

enum class Sign : std::uint8_t {
  any,
  nonnegative,
  nonpositive,
};

/// An operand's range check: sign bit and magnitude, both limits inclusive.
struct OperandCheck {
  int column = -1;
  Sign sign = Sign::any;
  double least = 0;
  double greatest = std::numeric_limits<double>::infinity();
};

enum class CriterionKind : std::uint8_t {
  order,           ///< by the order of columns `first` and `second`; always decides
  magnitudes,      ///< by the distance of the encodings of `first` and `second`, which are >= 0
  signed_keys,     ///< by the distance of the encodings of `first` and `second`, of either sign
  absolute_bound,  ///< by how many encodings |`first`| exceeds `second`
  interval,        ///< `first` > 0 or `second` < 0
};

struct FloatCriterion {
  CriterionKind kind = CriterionKind::order;
  int first = -1;
  int second = -1;
  /// The lane's guard in steps of a double's last place: times 2^(53 - P), or for signed_keys,
  /// whose keys are halved, times 2^(52 - P). `magnitudes` and `signed_keys` decide if encodings
  /// differ by `guard`, which is at least 1, or more. absolute_bound decides if |first| exceeds
  /// second by more than `guard`.
  std::int64_t guard = 1;
  /// One binade below the smallest normal number of the lane. It stands for 0 when encodings are
  /// counted.
  double zero = 0;
  /// A condition of absolute_bound, by columns: bound <= |value|.
  struct Condition {
    int bound;
    int value;
  };
  std::vector<Condition> conditions;
  std::vector<OperandCheck> checks;
};

void execute(const std::vector<Instruction>& instructions, const Block& block);

/// Whether any value of the columns is outside its range. The sign bit of doubts[k] says whether a
/// value of comparison k is. `doubts` holds block.size words.
bool find_doubts(const std::vector<TrustedRange>& ranges, const Block& block,
                 std::uint64_t* doubts);

/// Whether every value of the window's columns is inside the window.
bool all_inside(const OperandWindow& window, const Block& block);

/// Writes one code of Decision per comparison.
void decide(const FloatCriterion& criterion, const Block& block, std::uint8_t* codes);

/// The instruction set that run-time dispatch chose.
const char* instruction_set();

}  // namespace mixcmp::emulator
