#include "model/cost/estimated/cost_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <sstream>
#include <vector>

#include "model/base/common/cases.hpp"
#include "model/base/common/check.hpp"
#include "model/base/common/file.hpp"
#include "model/base/number/dyadic.hpp"
#include "model/base/number/exact.hpp"
#include "model/base/settings/bound_name.hpp"
#include "model/cost/estimated/table_luts.hpp"
#include "model/lane/fixed/square_tables.hpp"

namespace mixcmp::estimated {
namespace {

/// LUTs of a unit with p digits: fixed + linear p + square p^2. docs/theory.md has the source.
struct Fit {
  double fixed, linear, square;

  double operator()(double p) const { return fixed + linear * p + square * p * p; }
};

constexpr Fit addition = {45, 17.7, 0};
constexpr Fit multiplication = {-10, 6, 2.35};
constexpr Fit squaring = {0, -1.5, 2.5};
constexpr Fit division = {20, 9, 1};
constexpr Fit square_root = {5, 4, 0.45};
constexpr Fit conversion = {37, 0.85, 0};
constexpr Fit selection = {10, 3.5, 0};
constexpr Fit aligned_term = {40, 6, 0};  ///< of a fused sum, without its product
constexpr Fit rounded_sum = {60, 4, 0};   ///< of a fused sum, without its terms
constexpr Fit comparison = {18, 1.1, 0};
constexpr Fit ulp_distance = {8, 1.8, 0};
constexpr Fit bound_decision = {11, 0.37, 0};
constexpr Fit interval_decision = {6.5, 0.56, 0};
/// LUTs of an addition for each digit by which its operands exceed its result.
constexpr double dropped_digit = 13;
/// The fraction of a multiplier that remains if one factor is a constant.
constexpr double constant_share = 0.5;

bool is_constant(const TypedGraph& graph, NodeId id) {
  return graph.nodes[id].operation == Operation::constant;
}

/// Whether the node is a power of two of either sign: as a factor it only adds to the exponent.
bool is_scale(const TypedGraph& graph, NodeId id) {
  return is_constant(graph, id) && is_power_of_two(mpq_class(abs(graph.nodes[id].value)));
}

double fused_luts(const TypedNode& node, Products products) {
  const int digits = node.format.precision();
  double luts = rounded_sum(digits);
  for (const FusedTerm& term : node.terms) {
    luts += aligned_term(digits);
    if (!term.is_product() || products == Products::left_out) continue;
    luts += term.is_square() ? squaring(digits) : multiplication(digits);
  }
  return luts;
}

double node_luts(const TypedGraph& graph, const TypedNode& node, Products products) {
  const int operand = node.operand_format.precision(), result = node.format.precision();
  const double dropped = dropped_digit * std::max(operand - result, 0);
  switch (node.operation) {
    case Operation::input:
    case Operation::constant:
    case Operation::negate:
    case Operation::absolute: return 0;
    case Operation::convert: return conversion(result);
    case Operation::add:
    case Operation::subtract: return addition(result) + dropped;
    case Operation::multiply: {
      if (is_scale(graph, node.operands[0]) || is_scale(graph, node.operands[1])) {
        return conversion(result);
      }
      const bool half =
          is_constant(graph, node.operands[0]) || is_constant(graph, node.operands[1]);
      return multiplication(operand) * (half ? constant_share : 1);
    }
    case Operation::square: return squaring(operand);
    case Operation::divide: return division(operand);
    case Operation::square_root: return square_root(operand);
    case Operation::minimum:
    case Operation::maximum: return selection(operand);
    case Operation::fused_sum: return fused_luts(node, products);
    case Operation::function:
    case Operation::look_up: break;
  }
  MIXCMP_CHECK(false);
}

bool is_product(const TypedNode& node) {
  return node.operation == Operation::multiply || node.operation == Operation::square;
}

/// Whether the node is a product without a power of two as a factor.
bool multiplies(const TypedGraph& graph, const TypedNode& node) {
  return is_product(node) && !is_scale(graph, node.operands[0]) &&
         (node.operation == Operation::square || !is_scale(graph, node.operands[1]));
}

/// The number of multipliers that cover a product of factors of these bits.
int covering(int a, int b, const devices::MultiplierSize& size) {
  const auto tiles = [](int bits, int width) { return (bits + width - 1) / width; };
  return std::min(tiles(a, size.a_bits) * tiles(b, size.b_bits),
                  tiles(a, size.b_bits) * tiles(b, size.a_bits));
}

double graph_luts(const TypedGraph& graph, Products products) {
  double luts = 0;
  for (const TypedNode& node : graph.nodes) {
    if (products == Products::left_out && is_product(node)) continue;
    luts += node_luts(graph, node, products);
  }
  return luts;
}

double bound_luts(const error::BoundNode& node, int digits) {
  switch (node.operation) {
    case error::BoundOperation::constant:
    case error::BoundOperation::binade: return 0;
    case error::BoundOperation::magnitude: return 5;
    case error::BoundOperation::reciprocal: return 10;
    case error::BoundOperation::add: return 14 + 10 * digits;
    case error::BoundOperation::multiply: return 23 + 6 * digits;
    case error::BoundOperation::maximum: return 12 + 2 * digits;
  }
  MIXCMP_CHECK(false);
}

struct CriterionLuts {
  int precision;

  double operator()(const error::UlpDistanceCriterion& criterion) const {
    return criterion.guard_ulp == 0 ? comparison(precision) : ulp_distance(precision);
  }
  double operator()(const error::AbsoluteBoundCriterion& criterion) const {
    double luts = bound_decision(precision) * static_cast<double>(1 + criterion.conditions.size());
    for (const error::BoundNode& node : criterion.bound.nodes) {
      luts += bound_luts(node, criterion.bound.format.precision);
    }
    return luts;
  }
  double operator()(const error::IntervalCriterion&) const { return interval_decision(precision); }
};

Error bad_area(const std::filesystem::path& path, int line, const std::string& field,
               const std::string& received, const std::string& accepted) {
  return {.file = path.string(),
          .line = line,
          .field = field,
          .message = "is not usable",
          .received = "\"" + received + "\"",
          .accepted = accepted};
}

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields(1);
  for (const char c : line) {
    if (c == ',') {
      fields.emplace_back();
    } else if (c != '\r') {
      fields.back() += c;
    }
  }
  return fields;
}

template <class Number>
bool read_number(const std::string& text, Number& number) {
  const char* const end = text.data() + text.size();
  const auto [stop, failed] = std::from_chars(text.data(), end, number);
  return failed == std::errc() && stop == end;
}

int multipliers_of(const TypedGraph& graph, const devices::MultiplierSize& size) {
  int count = 0;
  for (const TypedNode& node : graph.nodes) {
    const int digits = node.operand_format.precision();
    int products = multiplies(graph, node) ? 1 : 0;
    for (const FusedTerm& term : node.terms) products += term.is_product() ? 1 : 0;
    count += products * covering(digits, digits, size);
  }
  return count;
}

}  // namespace

double lane_luts(const error::Lane& lane, Products products) {
  const int precision = lane.graph.arithmetic.format.precision();
  double luts = graph_luts(lane.graph, products);
  for (const error::LanePart& part : lane.parts) {
    luts += std::visit(CriterionLuts{precision}, part.criterion);
  }
  return luts;
}

/// LUTs for each bit of a shifter by 0 to `most` places: two places per LUT.
double shift_luts(int most) {
  return most == 0 ? 0 : 0.5 * std::bit_width(static_cast<unsigned>(most));
}

int table_luts(const fixed::FixedNode& look_up) {
  std::vector<Bits> words;
  for (std::size_t address = 0; address < look_up.words.size(); ++address) {
    const mpz_class& word = look_up.words[address];
    words.push_back(to_bits(word < 0 ? word + shifted_left(1, look_up.format.width) : word));
  }
  return table_luts(words, look_up.format.width);
}

/// - A sum takes a LUT per bit.
/// - A root takes a sum for each bit of its result.
/// - An operand takes a shifter, two places per LUT, and a compare of its exponent; in block
///   floating point also its share of the search for the largest exponent.
/// - A common cut takes a shifter, two places per LUT; a floating code also a count of zeros.
/// - A table takes what `table_luts` says.
/// - A square that is read from a memory takes the sum that makes its operand's magnitude.
/// - Products of logic and limits have factors that are fitted to mapped lanes.
double lane_luts(const fixed::FixedLane& lane, Products products) {
  const double exponent = lane.input_format.exponent_bits();
  double luts = 0;
  for (NodeId id = 0; id < static_cast<NodeId>(lane.nodes.size()); ++id) {
    const fixed::FixedNode& node = lane.nodes[id];
    const int width = node.format.width;
    switch (node.operation) {
      case Operation::constant: break;
      case Operation::convert:
        luts += fixed::is_limit(node)   ? 1 + 0.1 * width
                : fixed::is_reach(node) ? 1
                : fixed::is_floating_code(node)
                    ? width * (1 + shift_luts(lane.nodes[node.operands[0]].format.width - 1))
                    : width * shift_luts(node.most_dropped);
        break;
      case Operation::input:
        if (fixed::is_read_as_it_arrives(lane, node)) break;
        luts += 2.0 * width + exponent * (lane.format.is_block ? 4 : 1);
        break;
      case Operation::square:
        if (products == Products::squares_in_memory) {
          luts += fixed::magnitude_bits(lane, id);
          break;
        }
        [[fallthrough]];
      case Operation::multiply:
        if (products != Products::left_out) luts += 0.25 * width * width;
        break;
      case Operation::square_root: luts += 0.5 * width * (width + 5); break;
      case Operation::look_up: luts += table_luts(node); break;
      default: luts += width; break;
    }
  }
  for (const fixed::FixedPart& part : lane.parts) {
    luts += 2.0 * lane.nodes[part.difference].format.width;
    if (const auto* running = std::get_if<fixed::RunningThresholds>(&part.criterion)) {
      luts += static_cast<double>(running->of_steps.size() * running->watched.size());
      luts += digits_of(running->of_steps.back());
    }
  }
  return luts;
}

int embedded_multipliers(const error::Lane& lane, const devices::MultiplierSize& size) {
  return multipliers_of(lane.graph, size);
}

int embedded_multipliers(const fixed::ReferenceDatapath& reference,
                         const devices::MultiplierSize& size) {
  return std::visit(
      Cases{[&](const TypedGraph& graph) { return multipliers_of(graph, size); },
            [&](const fixed::FixedLane& lane) { return embedded_multipliers(lane, size); }},
      reference);
}

int embedded_multipliers(const fixed::FixedLane& lane, const devices::MultiplierSize& size) {
  int count = 0;
  for (const fixed::FixedNode& node : lane.nodes) {
    const bool square = node.operation == Operation::square;
    if (!square && node.operation != Operation::multiply) continue;
    const int a = lane.nodes[node.operands[0]].format.width;
    count += covering(a, square ? a : lane.nodes[node.operands[1]].format.width, size);
  }
  return count;
}

int memory_blocks(const fixed::FixedLane& lane, const devices::MemoryBlock& block) {
  std::int64_t blocks = 0;
  for (const fixed::SquareTable& table : fixed::square_tables(lane, block.read_ports, block.bits)) {
    blocks += fixed::blocks_of(table, block.bits);
  }
  return static_cast<int>(blocks);
}

double reference_luts(const fixed::ReferenceDatapath& reference, Products products) {
  return std::visit(Cases{[&](const TypedGraph& graph) {
                            const int digits = graph.arithmetic.format.precision();
                            return graph_luts(graph, products) +
                                   static_cast<double>(graph.parts.size()) * comparison(digits);
                          },
                          [&](const fixed::FixedLane& lane) { return lane_luts(lane, products); }},
                    reference);
}

namespace {

/// The schemes that a file of areas may name, besides every bound in fixed point.
std::vector<std::string> usual_schemes() {
  std::vector<std::string> names = {"reference", "lanes_alone"};
  for (const Bound& bound : counted_bounds()) names.push_back(to_string(bound));
  return names;
}

bool is_scheme(const std::string& name) {
  const std::vector<std::string> names = usual_schemes();
  if (std::find(names.begin(), names.end(), name) != names.end()) return true;
  const auto bound = settings::parse_bound(name);
  return bound.ok() && bound->is_fixed_point();
}

}  // namespace

Result<MeasuredAreas> MeasuredAreas::read(const std::filesystem::path& path) {
  const Result<std::string> content = read_file(path);
  if (!content.ok()) {
    Error error = content.error();
    error.field = "--areas";
    return error;
  }
  std::istringstream file(*content);
  std::string text;
  const std::string header = "scheme,precision,luts";
  std::getline(file, text);
  if (fields_of(text) != fields_of(header)) return bad_area(path, 1, "header", text, header);
  MeasuredAreas areas;
  for (int line = 2; std::getline(file, text); ++line) {
    const std::vector<std::string> fields = fields_of(text);
    int precision = 0;
    double luts = 0;
    if (fields.size() != 3) return bad_area(path, line, "line", text, header);
    if (!is_scheme(fields[0])) {
      return bad_area(path, line, "scheme", fields[0],
                      fmt::format("{}", fmt::join(usual_schemes(), ", ")));
    }
    if (!read_number(fields[1], precision)) {
      return bad_area(path, line, "precision", fields[1], "an integer");
    }
    if (!read_number(fields[2], luts) || !(luts > 0) || !std::isfinite(luts)) {
      return bad_area(path, line, "luts", fields[2], "a positive number");
    }
    const std::pair key{fields[0], fields[0] == "reference" ? 0 : precision};
    if (!areas.luts_.emplace(key, luts).second) {
      return bad_area(path, line, "scheme, precision", text, "one line each");
    }
  }
  if (areas.luts_.empty()) return bad_area(path, 1, "lines", "only the header", "an area or more");
  return areas;
}

std::optional<double> MeasuredAreas::of(const std::string& scheme, int precision) const {
  const auto found = luts_.find({scheme, precision});
  if (found == luts_.end()) return std::nullopt;
  return found->second;
}

std::optional<double> MeasuredAreas::reference() const {
  return of("reference", 0);
}

}  // namespace mixcmp::estimated
