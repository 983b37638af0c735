#include <fmt/core.h>
#include <gtest/gtest.h>

#include <random>

#include "model/base/number/decimal.hpp"
#include "model/base/number/verdict.hpp"
#include "model/judge/golden/big_float.hpp"
#include "model/judge/golden/evaluate.hpp"
#include "model/judge/golden/separation.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/graphs.hpp"

/// Tests golden::true_verdict on comparisons that intervals cannot decide by themselves: ties and
/// zeros behind roots and roundoff, the ends of wide formats, and comparisons that stay
/// undetermined.
namespace mixcmp::test::truth_test {
namespace {

using golden::true_verdict;
using golden::verdict_within;

const FloatFormat binary64 = format_of(53, 11);
const std::optional<Verdict> undetermined;

std::vector<Bits> encode(const std::vector<std::string>& values) {
  std::vector<Bits> inputs;
  for (const std::string& value : values) {
    inputs.push_back(from_text(binary64, value).value());
  }
  return inputs;
}

std::string truth(const std::string& f, const std::string& g,
                  const std::vector<std::string>& values) {
  return std::string(to_string(true_verdict(graph_of(f, g), binary64, encode(values))));
}

TEST(Truth, KnowsTheRootOfAHiddenZero) {
  for (const char* c : {"0", "-0"}) {
    EXPECT_EQ(truth("sqrt(b / a - b / a)", "c", {"1", "3", c}), "equal");
    EXPECT_EQ(truth("sqrt(a / b * b - a)", "c", {"1", "3", c}), "equal");
    EXPECT_EQ(truth("sqrt(a - a / b * b)", "c", {"0.1", "49", c}), "equal");
    EXPECT_EQ(truth("sqrt(sqrt(a) * sqrt(a) - a + b)", "c", {"7", "0", c}), "equal");
    EXPECT_EQ(truth("sqrt(min(b / a - b / a, abs(a)))", "c", {"1", "3", c}), "equal");
    EXPECT_EQ(truth("sqrt(-max(b / a - b / a, -abs(a)))", "c", {"1", "3", c}), "equal");
  }
  EXPECT_EQ(truth("sqrt(b / a - b / a)", "c", {"3", "1", "1e-300"}), "less");
  EXPECT_EQ(truth("sqrt(b / a - b / a)", "c", {"3", "1", "-4.9e-324"}), "greater");
}

TEST(Truth, TellsAHiddenZeroFromTheSmallestNumbers) {
  EXPECT_EQ(truth("sqrt(a / b * b - a + c)", "0", {"1", "3", "4.9e-324"}), "greater");
  EXPECT_EQ(truth("sqrt(a / b * b - a + c)", "0", {"1", "3", "0"}), "equal");
  EXPECT_EQ(truth("sqrt(a / b * b - a + c)", "0", {"1", "3", "-4.9e-324"}), "unordered");
  EXPECT_EQ(truth("sqrt(a) * sqrt(a)", "a + b", {"3", "4.9e-324"}), "less");
  EXPECT_EQ(truth("sqrt(a) * sqrt(a)", "a + b", {"1.7e308", "-4.9e-324"}), "greater");
}

TEST(Truth, KnowsTiesOfRoots) {
  for (const char* a : {"2", "0.1", "3e-308", "1.7e308", "4.9e-324", "9"}) {
    EXPECT_EQ(truth("sqrt(a) * sqrt(a)", "a", {a}), "equal") << a;
    EXPECT_EQ(truth("sqrt(a) * sqrt(b)", "sqrt(a * b)", {a, "0.3"}), "equal") << a;
    EXPECT_EQ(truth("sqrt(a) / sqrt(b)", "sqrt(a / b)", {a, "0.3"}), "equal") << a;
    EXPECT_EQ(truth("1 / (sqrt(a) - 1)", "(sqrt(a) + 1) / (a - 1)", {a}), "equal") << a;
  }
  EXPECT_EQ(truth("sqrt((a + b)^2) - a - b", "0", {"0.1", "1e-17"}), "equal");
  EXPECT_EQ(truth("sqrt((a + b)^2) - a - b", "0", {"1e300", "-1e-300"}), "equal");
  EXPECT_EQ(truth("sqrt((a + b)^2) - a - b", "0", {"-0.1", "1e-17"}), "greater");
  EXPECT_EQ(truth("sqrt((a / b)^2)", "a / b", {"1", "3"}), "equal");
  EXPECT_EQ(truth("sqrt((a / b)^2)", "a / b", {"-1", "3"}), "greater");
}

TEST(Truth, KnowsTiesOfNestedRoots) {
  EXPECT_EQ(truth("sqrt(3 + 2 * sqrt(2))", "1 + sqrt(a)", {"2"}), "equal");
  EXPECT_EQ(truth("sqrt(a + b + 2 * sqrt(a * b))", "sqrt(a) + sqrt(b)", {"0.1", "0.7"}), "equal");
  EXPECT_EQ(truth("sqrt(sqrt(a))^4", "a", {"0.1"}), "equal");
  EXPECT_EQ(truth("sqrt(sqrt(sqrt(a)))^8", "a", {"5e-324"}), "equal");
  EXPECT_EQ(truth("sqrt(sqrt(5) + 2) - sqrt(sqrt(5) - 2)", "sqrt(2 * sqrt(5) - a)", {"2"}),
            "equal");
  EXPECT_EQ(truth("sqrt(sqrt(a)) * sqrt(sqrt(a)) - sqrt(a) + b", "0", {"3", "1e-300"}), "greater");
}

/// p^2 - 2 q^2 = 1 with p and q of about 100 digits: p - q sqrt(2) is 1 / (p + q sqrt(2)).
TEST(Truth, TellsADifferenceAsSmallAsItsConjugateIsLarge) {
  mpz_class p = 1, q = 0;
  for (int k = 0; k < 131; ++k) {
    const mpz_class next = 3 * p + 4 * q;
    q = 2 * p + 3 * q;
    p = next;
  }
  ASSERT_EQ(p * p - 2 * q * q, 1);
  ASSERT_GE(p.get_str().size(), 100u);
  const std::string f = p.get_str(), g = q.get_str() + " * sqrt(2)";
  EXPECT_EQ(truth(f, g, {}), "greater");
  EXPECT_EQ(truth("sqrt(" + f + " - " + g + ")", "0", {}), "greater");
  EXPECT_EQ(truth("1 / (" + f + " - " + g + ")", "0", {}), "greater");
  EXPECT_EQ(truth("sqrt(" + g + " - " + f + ")", "0", {}), "unordered");
}

/// sqrt((t^2 - 1) / 4) + sqrt((9 t^2 + 3) / 4) falls short of 2 t by 1 / (12 t^3), which is nearly
/// the least that two roots of this size can. 128, 256 and 512 digits do not tell it from a tie.
TEST(Truth, TellsTheSmallestDifferenceOfTwoRoots) {
  for (const char* t : {"1000000000000000000000000000000000000000000000000000000000000000001", "3",
                        "1000000000000001"}) {
    const std::string number = t;
    const auto root = [&](const std::string& of) { return "sqrt((" + of + ") / 4)"; };
    const std::string f = root(number + "^2 - 1") + " + " + root("9 * " + number + "^2 + 3");
    EXPECT_EQ(truth(f, "2 * " + number, {}), "less") << t;
    EXPECT_EQ(truth("2 * " + number, f, {}), "greater") << t;
  }
}

TEST(Separation, BoundsEveryConjugate) {
  using golden::Separation;
  const Separation number = golden::separation_of(mpq_class(48, 5));  // 2^4 3/5
  EXPECT_EQ(number.exponent, 4);
  EXPECT_EQ(number.numerator_bits, 2);
  EXPECT_EQ(number.denominator_bits, 3);
  EXPECT_EQ(number.least_exponent(), 1);
  const Separation root = golden::separation_of_root(number, 0);  // 2^2 sqrt(15) / 5
  EXPECT_EQ(root.exponent, 2);
  EXPECT_EQ(root.numerator_bits, 3);
  EXPECT_EQ(root.denominator_bits, 3);
  EXPECT_EQ(root.least_exponent(), 2 - 3 - 3);
  const Separation odd =
      golden::separation_of_root(golden::separation_of(mpq_class(15, 32)), 1);  // 2^-3 sqrt(2 * 15)
  EXPECT_EQ(odd.exponent, -3);
  EXPECT_EQ(odd.numerator_bits, 3);
  const Separation sum = separation_of_sum(root, odd);  // 2^-3 (32 sqrt(15) + 5 sqrt(30)) / 5
  EXPECT_EQ(sum.exponent, -3);
  EXPECT_EQ(sum.numerator_bits, 9);
  EXPECT_EQ(sum.denominator_bits, 3);
  EXPECT_EQ(sum.least_exponent(), -3 - 3 - 3 * 9) << "four conjugates";
  const Separation quotient = separation_of_quotient(root, odd);
  EXPECT_EQ(quotient.exponent, 5);
  EXPECT_EQ(quotient.numerator_bits, 3);
  EXPECT_EQ(quotient.denominator_bits, 6);
}

TEST(Separation, IsUnknownBeyondItsNumbers) {
  golden::Separation power = golden::separation_of(mpq_class(3));
  for (int k = 0; k < 64; ++k) power = separation_of_product(power, power);
  EXPECT_EQ(power.least_exponent(), std::nullopt);
  const auto sum = separation_of_sum(power, golden::separation_of(mpq_class(1)));
  EXPECT_EQ(sum.least_exponent(), std::nullopt);
}

TEST(Truth, HasNoValueWhereADivisorIsAHiddenZero) {
  EXPECT_EQ(truth("1 / (a / b * b - a)", "0", {"1", "3"}), "unordered");
  EXPECT_EQ(truth("1 / (sqrt(a) * sqrt(a) - a)", "0", {"3"}), "unordered");
  EXPECT_EQ(truth("1 / (sqrt(a) * sqrt(a) - a - b)", "0", {"3", "-4.9e-324"}), "greater");
  EXPECT_EQ(truth("1 / (sqrt(a) * sqrt(a) - a - b)", "0", {"3", "4.9e-324"}), "less");
  EXPECT_EQ(truth("1 / (a / b * b - a + c)", "0", {"1", "3", "4.9e-324"}), "greater");
  EXPECT_EQ(truth("1 / (a / b * b - a + c)", "0", {"1", "3", "-4.9e-324"}), "less");
  EXPECT_EQ(truth("0 * (1 / sqrt(b / a - b / a))", "0", {"1", "3"}), "unordered");
}

TEST(Truth, HasNoValueForNansAndInfinities) {
  EXPECT_EQ(truth("sqrt(a / b * b - a)", "c", {"1", "3", "nan"}), "unordered");
  EXPECT_EQ(truth("sqrt(a / b * b - a)", "c", {"inf", "3", "0"}), "unordered");
  EXPECT_EQ(truth("a - a", "0", {"-inf"}), "unordered");
  EXPECT_EQ(truth("min(a, b)", "0", {"nan", "-1"}), "unordered");
}

TEST(Truth, ReachesTheEndsOfWideFormats) {
  const FloatFormat wide = FloatFormat::make(24, 15).value();
  const std::vector<Bits> ends = {1, wide.largest_finite(false)};
  const auto verdict = [&](const char* f, const char* g) {
    return to_string(true_verdict(graph_of(f, g), wide, ends));
  };
  EXPECT_EQ(verdict("sqrt(a) * sqrt(b)", "sqrt(a * b)"), "equal");
  EXPECT_EQ(verdict("a / b * b", "a"), "equal");
  EXPECT_EQ(verdict("sqrt(b^2 + a) - b", "0"), "greater");
  EXPECT_EQ(verdict("sqrt((b + a)^2) - b - a", "0"), "equal");
  EXPECT_EQ(verdict("1 / (b / a * a - b)", "0"), "unordered");
  EXPECT_EQ(verdict("1 / (b / 3 * 3 - b + a)", "0"), "greater");
}

/// The sum of the roots of the inputs x1 to xn, from the first to the last or from the last.
NodeId sum_of_roots(Graph& graph, int n, bool backwards) {
  NodeId sum = -1;
  for (int k = 0; k < n; ++k) {
    const int input = backwards ? n - k : k + 1;
    const NodeId root = graph.apply(Operation::square_root, graph.input(fmt::format("x{}", input)));
    sum = k == 0 ? root : graph.apply(Operation::add, sum, root);
  }
  return sum;
}

/// A graph with f = g, whose proof needs n roots.
Graph tie_of_roots(int n) {
  Graph graph;
  const NodeId f = sum_of_roots(graph, n, false);
  graph.compare(f, sum_of_roots(graph, n, true));
  return graph;
}

std::vector<Bits> odd_operands(std::size_t count) {
  std::vector<Bits> inputs;
  for (std::size_t k = 0; k < count; ++k) {
    inputs.push_back(golden::from_rational(binary64, mpq_class(2 * k + 3, 7)));
  }
  return inputs;
}

TEST(Truth, OfAnUnprovenTieIsUndetermined) {
  EXPECT_EQ(true_verdict(tie_of_roots(6), binary64, odd_operands(6)), Verdict::equal);
  EXPECT_EQ(true_verdict(tie_of_roots(14), binary64, odd_operands(14)), undetermined);
  EXPECT_EQ(to_string(undetermined), "undetermined");
}

TEST(Truth, OfTheSameExpressionTwiceIsATie) {
  Graph graph;
  const NodeId f = sum_of_roots(graph, 14, false);
  graph.compare(f, sum_of_roots(graph, 14, false));
  EXPECT_EQ(true_verdict(graph, binary64, odd_operands(14)), Verdict::equal);
}

/// The difference of the two sides of an unproven tie.
NodeId unproven_zero(Graph& graph) {
  const NodeId f = sum_of_roots(graph, 14, false);
  return graph.apply(Operation::subtract, f, sum_of_roots(graph, 14, true));
}

TEST(Truth, OfAnUnprovenDivisorOrRadicandIsUndetermined) {
  Graph divisor;
  NodeId zero = unproven_zero(divisor);
  divisor.compare(divisor.apply(Operation::divide, divisor.constant(1), zero), divisor.constant(0));
  EXPECT_EQ(true_verdict(divisor, binary64, odd_operands(14)), undetermined);
  Graph radicand;
  zero = unproven_zero(radicand);
  radicand.compare(radicand.apply(Operation::square_root, zero), radicand.constant(-1));
  EXPECT_EQ(true_verdict(radicand, binary64, odd_operands(14)), undetermined);
  Graph beside;
  zero = unproven_zero(beside);
  beside.compare(zero, beside.constant(1));
  EXPECT_EQ(true_verdict(beside, binary64, odd_operands(14)), Verdict::less);
}

TEST(Truth, IsUnorderedBesideAnythingUndetermined) {
  Graph graph;
  const NodeId root = graph.apply(Operation::square_root, unproven_zero(graph));
  const NodeId invalid = graph.apply(Operation::square_root, graph.constant(-1));
  graph.compare(root, invalid);
  EXPECT_EQ(true_verdict(graph, binary64, odd_operands(14)), Verdict::unordered);
}

/// A proven verdict of another part decides only if it dominates.
TEST(Truth, OfSeveralPartsIsThatOfADominatingPartAlone) {
  for (const Combination combination : {Combination::all, Combination::any}) {
    const Verdict dominating = golden::dominating_verdict(combination);
    for (const int constant : {-1, 0, 1}) {
      Graph graph;
      const NodeId f = sum_of_roots(graph, 14, false);
      const NodeId g = sum_of_roots(graph, 14, true);
      graph.compare({{f, g}, {graph.constant(constant), graph.constant(0)}}, combination);
      const auto other = static_cast<Verdict>(constant + 1);
      EXPECT_EQ(true_verdict(graph, binary64, odd_operands(14)),
                other == dominating ? std::optional(dominating) : undetermined)
          << to_string(combination) << " " << constant;
    }
  }
}

TEST(Truth, WithinFewBitsIsNeverAGuess) {
  const Graph graph = graph_of("a + b^4", "b^4");
  const std::vector<Bits> inputs = encode({"4.9e-324", "1e300"});
  EXPECT_EQ(verdict_within(graph, binary64, inputs, 512), undetermined);
  EXPECT_EQ(verdict_within(graph, binary64, inputs, 8192), Verdict::greater);
}

/// Makes random rational expressions over the inputs that cancel: quotients and products that are
/// undone again, with differences, minima, magnitudes and roots of squares between them.
class Cancelling {
public:
  explicit Cancelling(std::uint64_t seed) : random_(seed) {
    for (const char* name : {"a", "b", "c"}) nodes_.push_back(graph_.input(name));
    nodes_.push_back(graph_.constant(mpq_class(1, 3)));
    for (int k = 0; k < 6; ++k) grow();
    const NodeId x = any(), y = any();
    switch (below(4)) {
      case 0:
        graph_.compare(graph_.apply(Operation::subtract, x, undone(x, y)), nodes_[below(3)]);
        break;
      case 1: graph_.compare(x, undone(x, y)); break;
      case 2:
        graph_.compare(
            graph_.apply(Operation::divide, y, graph_.apply(Operation::subtract, x, undone(x, y))),
            x);
        break;
      default: graph_.compare(x, y);
    }
  }

  const Graph& graph() const { return graph_; }
  std::vector<Bits> operands(FloatFormat format) {
    std::vector<Bits> inputs;
    const auto special = special_encodings(format);
    for (int k = 0; k < 3; ++k) {
      const bool reuse = k > 0 && below(4) == 0;
      inputs.push_back(reuse           ? inputs.front()
                       : below(5) == 0 ? special[below(static_cast<int>(special.size()))]
                                       : random_encoding(format, random_));
    }
    return inputs;
  }

private:
  int below(int end) { return static_cast<int>(random_() % static_cast<unsigned>(end)); }
  NodeId any() { return nodes_[below(static_cast<int>(nodes_.size()))]; }

  /// A node that equals x wherever it has a value (behind an even root: |x|).
  NodeId undone(NodeId x, NodeId y) {
    switch (below(4)) {
      case 0: return graph_.apply(Operation::multiply, graph_.apply(Operation::divide, x, y), y);
      case 1: return graph_.apply(Operation::subtract, graph_.apply(Operation::add, x, y), y);
      case 2: return graph_.apply(Operation::divide, graph_.apply(Operation::multiply, x, y), y);
      default: return graph_.apply(Operation::square_root, graph_.apply(Operation::square, x));
    }
  }

  void grow() {
    static constexpr std::array binary = {Operation::add,      Operation::subtract,
                                          Operation::multiply, Operation::divide,
                                          Operation::minimum,  Operation::maximum};
    static constexpr std::array unary = {Operation::negate, Operation::absolute, Operation::square};
    switch (below(4)) {
      case 0: nodes_.push_back(undone(any(), any())); break;
      case 1: nodes_.push_back(graph_.apply(unary[below(3)], any())); break;
      default: nodes_.push_back(graph_.apply(binary[below(6)], any(), any()));
    }
  }

  std::mt19937_64 random_;
  Graph graph_;
  std::vector<NodeId> nodes_;
};

/// The verdict by exact rational arithmetic, which shares nothing with golden::true_verdict: every
/// root here is that of a square.
class Rationals {
public:
  Rationals(const Graph& graph, FloatFormat format, const std::vector<Bits>& inputs)
      : graph_(graph), format_(format), inputs_(inputs), values_(graph.nodes().size()) {}

  Verdict verdict() {
    if (!compute(graph_.f()) || !compute(graph_.g())) return Verdict::unordered;
    const int order = cmp(values_[graph_.f()], values_[graph_.g()]);
    return order < 0 ? Verdict::less : order > 0 ? Verdict::greater : Verdict::equal;
  }

private:
  /// Whether the node has a value; the value is then in values_.
  bool compute(NodeId id) {
    const Node& node = graph_.nodes()[id];
    mpq_class& y = values_[id];
    for (int k = 0; k < arity(node.operation); ++k) {
      if (!compute(node.operands[k])) return false;
    }
    const auto& a = values_[std::max(node.operands[0], 0)];
    const auto& b = values_[std::max(node.operands[1], 0)];
    switch (node.operation) {
      case Operation::input: {
        const Bits bits = inputs_[node.input];
        if (format_.is_nan(bits) || format_.is_infinite(bits)) return false;
        y = golden::to_rational(format_, bits);
        break;
      }
      case Operation::constant: y = node.value; break;
      case Operation::negate: y = -a; break;
      case Operation::absolute: y = abs(a); break;
      case Operation::add: y = a + b; break;
      case Operation::subtract: y = a - b; break;
      case Operation::multiply: y = a * b; break;
      case Operation::square: y = a * a; break;
      case Operation::divide:
        if (b == 0) return false;
        y = a / b;
        break;
      case Operation::square_root:
        if (a < 0) return false;
        y = mpq_class(sqrt(a.get_num()), sqrt(a.get_den()));
        EXPECT_EQ(y * y, a);
        break;
      case Operation::minimum: y = std::min(a, b); break;
      case Operation::maximum: y = std::max(a, b); break;
      case Operation::convert:
      case Operation::fused_sum: return false;
      case Operation::function:
      case Operation::look_up: break;
    }
    return true;
  }

  const Graph& graph_;
  FloatFormat format_;
  const std::vector<Bits>& inputs_;
  std::vector<mpq_class> values_;
};

/// The verdict by 8192 digits rounded to nearest, with numbers below 2^-4096 taken for exact zeros:
/// no number made of a few inputs of three digits and four roots comes closer to zero.
class ManyDigits {
public:
  ManyDigits(const Graph& graph, FloatFormat format, const std::vector<Bits>& inputs)
      : graph_(graph), format_(format), inputs_(inputs), values_(graph.nodes().size(), digits()) {}

  Verdict verdict() {
    if (!compute(graph_.f()) || !compute(graph_.g())) return Verdict::unordered;
    BigFloat difference = digits();
    mpfr_sub(difference.get(), at(graph_.f()), at(graph_.g()), MPFR_RNDN);
    clear_noise(difference.get());
    const int sign = mpfr_sgn(difference.get());
    return sign < 0 ? Verdict::less : sign > 0 ? Verdict::greater : Verdict::equal;
  }

private:
  using BigFloat = golden::BigFloat;
  static BigFloat digits() { return BigFloat(8192); }
  mpfr_ptr at(NodeId id) { return values_[static_cast<std::size_t>(id)].get(); }

  static void clear_noise(mpfr_ptr x) {
    if (mpfr_zero_p(x) == 0 && mpfr_get_exp(x) < -4096) mpfr_set_zero(x, 1);
  }

  /// Whether the node has a value; the value is then in values_.
  bool compute(NodeId id) {
    const Node& node = graph_.nodes()[id];
    for (int k = 0; k < arity(node.operation); ++k) {
      if (!compute(node.operands[k])) return false;
    }
    const mpfr_ptr y = at(id), a = at(std::max(node.operands[0], 0)),
                   b = at(std::max(node.operands[1], 0));
    switch (node.operation) {
      case Operation::input:
        mpfr_set_q(y, golden::to_rational(format_, inputs_[node.input]).get_mpq_t(), MPFR_RNDN);
        break;
      case Operation::constant: mpfr_set_q(y, node.value.get_mpq_t(), MPFR_RNDN); break;
      case Operation::negate: mpfr_neg(y, a, MPFR_RNDN); break;
      case Operation::absolute: mpfr_abs(y, a, MPFR_RNDN); break;
      case Operation::add: mpfr_add(y, a, b, MPFR_RNDN); break;
      case Operation::subtract: mpfr_sub(y, a, b, MPFR_RNDN); break;
      case Operation::multiply: mpfr_mul(y, a, b, MPFR_RNDN); break;
      case Operation::square: mpfr_sqr(y, a, MPFR_RNDN); break;
      case Operation::divide:
        if (mpfr_zero_p(b)) return false;
        mpfr_div(y, a, b, MPFR_RNDN);
        break;
      case Operation::square_root:
        if (mpfr_sgn(a) < 0) return false;
        mpfr_sqrt(y, a, MPFR_RNDN);
        break;
      case Operation::minimum: mpfr_min(y, a, b, MPFR_RNDN); break;
      case Operation::maximum: mpfr_max(y, a, b, MPFR_RNDN); break;
      case Operation::convert:
      case Operation::fused_sum: return false;
      case Operation::function:
      case Operation::look_up: break;
    }
    clear_noise(y);
    return true;
  }

  const Graph& graph_;
  FloatFormat format_;
  const std::vector<Bits>& inputs_;
  std::vector<BigFloat> values_;
};

/// Four roots of random operands among sums, products and quotients.
Graph graph_of_roots(std::mt19937_64& random) {
  static constexpr std::array binary = {Operation::add,    Operation::subtract, Operation::multiply,
                                        Operation::divide, Operation::add,      Operation::maximum};
  Graph graph;
  std::vector<NodeId> nodes;
  for (const char* name : {"a", "b", "c"}) nodes.push_back(graph.input(name));
  const auto any = [&] { return nodes[random() % nodes.size()]; };
  for (int k = 0; k < 8; ++k) {
    if (k % 2 == 0) {
      nodes.push_back(graph.apply(Operation::square_root, any()));
    } else {
      nodes.push_back(graph.apply(binary[random() % binary.size()], any(), any()));
    }
  }
  const NodeId x = any(), y = nodes.back();
  switch (random() % 4) {
    case 0:
      graph.compare(graph.apply(Operation::square, x), graph.apply(Operation::square, y));
      break;
    case 1:
      graph.compare(graph.apply(Operation::multiply, graph.apply(Operation::divide, x, y), y), x);
      break;
    default: graph.compare(x, y);
  }
  return graph;
}

TEST(Truth, OfRootsIsThatOfManyDigits) {
  const FloatFormat format = format_of(3, 3);
  std::mt19937_64 random(11);
  std::array<int, 4> seen = {};
  for (int trial = 0; trial < 3000; ++trial) {
    const Graph graph = graph_of_roots(random);
    std::vector<Bits> inputs;
    for (std::size_t k = 0; k < graph.inputs().size(); ++k) {
      const bool again = k > 0 && random() % 4 == 0;
      const Bits bits = format.magnitude(random_encoding(format, random));
      inputs.push_back(again                                             ? inputs.front()
                       : format.is_infinite(bits) || format.is_nan(bits) ? Bits{5}
                                                                         : bits);
    }
    const Verdict expected = ManyDigits(graph, format, inputs).verdict();
    ++seen[static_cast<std::size_t>(expected)];
    ASSERT_EQ(to_string(true_verdict(graph, format, inputs)), to_string(expected))
        << "trial " << trial;
  }
  for (const int count : seen) EXPECT_GT(count, 100);
}

struct RationalCase {
  const char* name;
  int precision, exponent_bits;
};

class RationalTruth : public testing::TestWithParam<RationalCase> {};

TEST_P(RationalTruth, IsThatOfExactRationals) {
  const FloatFormat format = format_of(GetParam().precision, GetParam().exponent_bits);
  int told = 0;
  std::array<int, 4> seen = {};
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    Cancelling expression(seed);
    for (int trial = 0; trial < 4; ++trial) {
      const std::vector<Bits> inputs = expression.operands(format);
      const auto truth = true_verdict(expression.graph(), format, inputs);
      const Verdict exact = Rationals(expression.graph(), format, inputs).verdict();
      if (!truth) continue;
      ++told;
      ++seen[static_cast<std::size_t>(exact)];
      ASSERT_EQ(to_string(truth), to_string(exact)) << "seed " << seed << ", trial " << trial;
    }
  }
  EXPECT_GE(told, 1590) << "of 1600";
  for (const int count : seen) EXPECT_GT(count, 100);
}

INSTANTIATE_TEST_SUITE_P(Formats, RationalTruth,
                         testing::Values(RationalCase{"tiny", 3, 3},
                                         RationalCase{"binary16", 11, 5},
                                         RationalCase{"binary64", 53, 11},
                                         RationalCase{"wide", 40, 13}),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace mixcmp::test::truth_test
