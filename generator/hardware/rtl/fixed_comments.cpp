#include <fmt/core.h>

#include "generator/hardware/rtl/fixed_nodes.hpp"
#include "model/base/number/dyadic.hpp"
#include "model/comparison/expression/text.hpp"

/// The comments in front of a lane's nodes.
namespace mixcmp::rtl {

using fixed::FixedNode;

/// The comment of a table's word.
std::string FixedNodes::describe_words(NodeId id, const std::string& format) const {
  const FixedNode& node = lane_.nodes[id];
  const std::string& argument = names_[node.operands[0]];
  if (node.function->kind() == Function::sign) {
    return fmt::format("{}: {} where {} is 0 or more, otherwise {}.", names_[id],
                       node.words[0].get_str(), argument, node.words[1].get_str());
  }
  const FixedNode& read = lane_.nodes[node.operands[0]];
  const bool is_code = fixed::is_code_of_encoding(lane_.nodes, read);
  const std::string& real =
      is_code ? datapath_.port(lane_.nodes[lane_.nodes[read.operands[0]].operands[0]].input)
              : argument;
  const std::string word = node.power < 0 ? "the start of the piece that holds the argument of " +
                                                to_string(*node.function)
                                          : fmt::format("the coefficient of t^{} in {}", node.power,
                                                        applied_text(*node.function, real));
  const int bits = node.words.address_bits();
  const std::string upper = bits == 1 ? "upper bit" : fmt::format("{} upper bits", bits);
  return fmt::format(
      "{}: {}, in {}; its address is the {} of {}, and the words follow from the last address down "
      "to 0.",
      names_[id], word, format, upper, argument);
}

/// Adds the comment of a node, with `more` behind it.
void FixedNodes::describe(NodeId id, const std::string& more) {
  const FixedNode& node = lane_.nodes[id];
  const auto text = [&](int k) {
    if (k >= arity(node.operation)) return std::string();
    const FixedNode& source = lane_.nodes[node.operands[k]];
    const bool constant = source.operation == Operation::constant;
    return constant ? to_text(source.value.low) : names_[node.operands[k]];
  };
  const std::string format = node.format.name();
  if (describe_encoding(id)) return;
  if (fixed::is_limit(node)) {
    return datapath_.add(
        Comment{fmt::format("{} from {} to {}, {}; elsewhere the lane is undecided.", text(0),
                            to_text(node.value.low), to_text(node.value.high), format)});
  }
  if (fixed::is_reach(node)) {
    return datapath_.add(Comment{fmt::format(
        "{} in {}, unless it is so far from 0 that it decides by itself.", text(0), format)});
  }
  if (node.operation == Operation::look_up) {
    return datapath_.describe(schedule_.steps[id], describe_words(id, format));
  }
  if (fixed::is_floating_code(node)) {
    return datapath_.describe(
        schedule_.steps[id],
        fmt::format(
            "{} as a floating-point number: the place of its leading one, {} bits behind.", text(0),
            function::FloatingCode{lane_.nodes[node.operands[0]].format.width}.fraction_bits()));
  }
  if (node.conversion == fixed::Conversion::place) {
    return datapath_.add(
        Comment{fmt::format("t, {}'s place in its piece: the low bits, {}.", text(0), format)});
  }
  if (node.conversion == fixed::Conversion::function_value) {
    return datapath_.add(Comment{fmt::format("{}, rounded down to {}.", text(0), format)});
  }
  const bool is_input = node.operation == Operation::input;
  const bool is_cut = fixed::is_common_cut(node);
  if (node.operation == Operation::input && node.is_promised) {
    return datapath_.describe(
        schedule_.steps[id],
        fmt::format("{} exactly, in {}; the scene promises multiples of {}.",
                    datapath_.port(node.input), format, to_text(node.format.unit())));
  }
  const bool rounds =
      is_input || is_cut || node.dropped_bits > 0 || node.operation == Operation::square_root;
  const std::string scaled = lane_.format.is_block ? " / 2^(1 + the largest exponent)" : "";
  const std::string what = is_input ? datapath_.port(node.input) + scaled
                           : is_cut ? fmt::format("{} / 2^{}", text(0), common_drop_.name)
                                    : multiple(id) + formula(node.operation, text(0), text(1));
  datapath_.describe(
      schedule_.steps[id],
      fmt::format("{}, {} {}.{}", what, rounds ? "rounded down to" : "exact in", format, more));
}

/// The power of two that a product has as a further factor: "2 * ", or nothing.
std::string FixedNodes::multiple(NodeId id) const {
  const FixedNode& node = lane_.nodes[id];
  if (node.operation != Operation::multiply) return {};
  const auto unit = [&](int k) { return lane_.nodes[node.operands[k]].format.unit_exponent; };
  const int places = node.format.unit_exponent - node.dropped_bits - unit(0) - unit(1);
  return places == 0 ? "" : to_text(power_of_two(places)) + " * ";
}

/// Describes the nodes that make a function's argument of an operand's encoding.
bool FixedNodes::describe_encoding(NodeId id) {
  const FixedNode& node = lane_.nodes[id];
  const int fraction_bits = -node.format.unit_exponent;
  if (node.is_encoding) {
    datapath_.describe(schedule_.steps[id],
                       fmt::format("{}'s encoding with {} bits of the fraction.",
                                   datapath_.port(node.input), fraction_bits));
    return true;
  }
  if (fixed::is_limited_encoding(lane_.nodes, node)) {
    const FloatFormat& format = lane_.input_format;
    const function::FloatingEncoding encodings = {.fraction_bits = fraction_bits,
                                                  .exponent_bits = format.exponent_bits(),
                                                  .exponent_of_0 = -format.bias()};
    const auto number = [&](const mpq_class& end, int further) {
      return to_text(encodings.number(floor_of(end / node.format.unit()) + further));
    };
    datapath_.add(Comment{fmt::format(
        "{} of numbers from {} to below {}; elsewhere the lane is undecided.",
        names_[node.operands[0]], number(node.value.low, 0), number(node.value.high, 1))});
    return true;
  }
  if (!fixed::is_code_of_encoding(lane_.nodes, node)) return false;
  const int exponent_bits = node.format.width - fraction_bits;
  if (node.operation == Operation::subtract) {
    datapath_.describe(
        schedule_.steps[id],
        fmt::format("{} less the exponent {}: {} bits of an exponent, {} of the fraction.",
                    names_[node.operands[0]], to_text(lane_.nodes[node.operands[1]].value.low),
                    exponent_bits, fraction_bits));
  } else {
    datapath_.add(Comment{fmt::format("The exponent's {} low bits and {} bits of the fraction.",
                                      exponent_bits, fraction_bits)});
  }
  return true;
}

}  // namespace mixcmp::rtl
