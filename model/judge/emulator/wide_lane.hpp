#pragma once

#include <array>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "model/base/number/verdict.hpp"
#include "model/lane/fixed/fixed_lane.hpp"

namespace mixcmp::emulator {

/// An integer of 128 bits, in two's complement.
__extension__ using Wide = __int128;

/// A lane in fixed point, computed in integers of 128 bits, one comparison after the other. It
/// serves the lanes that doubles cannot compute (make_fixed_code).
class WideLane {
public:
  /// None if some integer may have more than 125 bits of magnitude.
  static std::optional<WideLane> make(const fixed::FixedLane& lane);

  /// `operands` has one column per input, with as many doubles as there are decisions.
  void decide(std::span<const double* const> operands, std::span<Decision> decisions) const;

private:
  struct Node {
    Operation operation;
    std::optional<fixed::Conversion> conversion;
    std::array<NodeId, 2> operands;
    int input;
    FixedFormat format;
    std::array<int, 2> shifts =
        {};  ///< of the operands before the operation, to the left; negative: to the right
    int dropped_bits;
    bool arrives_fixed = false;             ///< an input that arrives in fixed point
    std::optional<int> exponent_bias = {};  ///< of an input that is read as its encoding
    bool is_promised = false;               ///< an input of promised multiples of the unit
    Wide constant = 0;
    Wide low = 0, high = 0;        ///< of Conversion::limit
    int argument_bits = 0;         ///< of Conversion::floating: the operand's width
    int piece_bits = 0;            ///< of Operation::look_up
    std::vector<Wide> words = {};  ///< of Operation::look_up
  };
  struct Constant {
    Wide greater_from, less_to;
    Decision otherwise;
  };
  struct Norm {
    NodeId radius;
    bool radius_is_squared;
    int shift_above;
    Wide offset_above;
    int shift_below;
  };
  struct Running {
    std::vector<NodeId> watched;
    std::vector<Wide> of_steps;
  };
  struct Part {
    NodeId difference;
    bool swapped;
    std::variant<Constant, Norm, Running> criterion;
  };
  class Maker;
  class Run;

  std::vector<Node> nodes_;
  std::vector<Part> parts_;
  std::vector<int> inputs_read_;
  std::vector<NodeId> cut_in_common_;
  Combination combination_ = Combination::all;
  int format_bits_ = 0;                      ///< magnitude bits of every integer after a common cut
  std::optional<int> least_block_exponent_;  ///< in block floating point
};

}  // namespace mixcmp::emulator
