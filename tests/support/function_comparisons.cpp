#include "tests/support/function_comparisons.hpp"

#include <cmath>
#include <limits>

#include "tests/support/graphs.hpp"

namespace mixcmp::test {

Graph FunctionComparison::graph() const {
  return graph_of(parts, Combination::all);
}

std::vector<OperandFormat> FunctionComparison::operand_formats() const {
  std::vector<OperandFormat> made;
  for (const char* format : formats) made.push_back(*OperandFormat::parse(format));
  return made;
}

Result<fixed::FixedLane> FunctionComparison::lane(FloatFormat format, int bits,
                                                  bool is_reference) const {
  std::vector<std::optional<Range>> known(ranges.begin(), ranges.end());
  if (!formats.empty()) known.assign(known.size(), std::nullopt);
  const auto bound = is_reference ? std::optional(BoundKind::constant) : std::nullopt;
  return fixed::fixed_lane(graph(), format,
                           {.format = {.bits = bits},
                            .bound = bound,
                            .ranges = known,
                            .operand_formats = operand_formats(),
                            .is_reference = is_reference});
}

namespace {

/// Powers, quotients, tables of points and functions that jump.
std::vector<FunctionComparison> further_comparisons() {
  return {
      {"Gamma", {{"a^(5/12)", "b"}}, {{0, 1}, {0, 1}}},
      // The pieces of its tables shrink towards 0, where it has a value.
      {"PowerToZero", {{"a^0.9", "b"}}, {{0, 3}, {0, 3}}},
      {"GammaOfASum", {{"(a + b)^0.45", "c"}}, {{0, 1}, {0, 1}, {0, 2}}},
      {"CubeRootOfADifference", {{"(a - b)^(1/3)", "c"}}, {{0, 1}, {-1, 0}, {0, 1}}},
      {"ReciprocalPower", {{"(a * b)^-1.5", "c"}}, {{1, 2}, {mpq_class(1, 2), 1}, {0, 3}}},
      {"HighPower", {{"a^20", "b"}}, {{-1, 1}, {0, 1}}},
      {"Quotient", {{"a / b", "c"}}, {{-1, 1}, {mpq_class(1, 2), 2}, {-2, 2}}},
      {"QuotientByDecades", {{"a / b", "c"}}, {{0, 1}, {mpq_class(1, 1000), 3}, {0, 1000}}},
      {"InverseRootOfDecades", {{"a^-0.5", "b"}}, {{mpq_class(1, 100), 30}, {0, 10}}},
      {"QuotientByASum", {{"a / (b + c)", "a * b"}}, {{0, 1}, {1, 2}, {0, 3}}},
      {"QuotientByNegatives", {{"a * b / (b - 3)", "a"}}, {{-1, 1}, {0, 2}}},
      {"QuotientTouchingZero", {{"1 / (a - b)", "a"}}, {{4, 20}, {0, 4}}},
      {"Measured", {{"table('measured.csv', a)", "b"}}, {{-6, 9}, {-2, 4}}},
      {"MeasuredBeyondItsEnds",
       {{"table('measured.csv', a - b)", "c"}},
       {{-6, 8}, {-1, 3}, {-2, 4}}},
      {"MeasuredSmoothly", {{"table('measured.csv', a, 3)", "b + c"}}, {{-4, 4}, {-1, 3}, {-1, 1}}},
      {"Wrap", {{"abs(mod(a - b + 3.25, 6.5) - 3.25)", "c"}}, {{-3, 3}, {-3, 3}, {0, 3}}},
      {"WrapOfRoundedArguments", {{"mod(a * b, 0.7)", "c"}}, {{-1, 2}, {0, 2}, {0, 1}}},
      {"WrapOfOnePeriod", {{"mod(a, 8)", "b"}}, {{17, 23}, {0, 8}}},
      {"Sign", {{"sign(a) * b", "c * sign(b)"}}, {{}, {}, {}}, {"int5", "q1.4", "q0.6"}, 0},
      {"Angle", {{"atan2(a, b)", "c"}}, {{}, {}, {}}, {"q0.4", "q0.4", "q2.6"}, 0},
      {"AngleToTheRight", {{"atan2(a, b)", "c"}}, {{}, {}, {}}, {"int8", "uint8", "q2.6"}, 0},
      {"AnglesOfIntegers", {{"atan2(a, b)", "c"}}, {{}, {}, {}}, {"int6", "int6", "q2.6"}, 0},
      {"WrapOfIntegers", {{"mod(a - b, 360)", "c"}}, {{}, {}, {}}, {"int10", "int10", "uint9"}},
      {"WrapOfRadians",
       {{"mod(a - b + 3.14159265358979, 6.28318530717959)", "c"}},
       {{}, {}, {}},
       {"q2.8", "q2.8", "q3.8"}},
  };
}

/// Functions that are known by their names.
std::vector<FunctionComparison> named_comparisons() {
  const mpq_class near_one(15, 16), small(1, 64);
  return {
      {"Metropolis", {{"u", "exp(-d)"}}, {{0, 1}, {0, 10}}},
      {"MetropolisOfBothSigns", {{"u", "exp(-d)"}}, {{0, 1}, {-3, 3}}},
      {"LogOfAffine", {{"log(3 - a / 3)", "b"}}, {{0, mpq_class(35, 4)}, {-2, 2}}},
      {"LogOfAffineTouchingZero", {{"log(2 - 2 * a)", "b"}}, {{-1, 1}, {-9, 2}}},
      {"Exp2", {{"exp2(a)", "b"}}, {{-4, 4}, {0, 20}}},
      {"Expm1", {{"expm1(a)", "b"}}, {{-1, 1}, {-1, 2}}},
      {"LogTouchingZero", {{"log(a)", "b"}}, {{0, 1}, {-10, 0}}},
      {"Log2TouchingZero", {{"log2(a)", "b - c"}}, {{0, 100}, {0, 8}, {0, 8}}},
      {"LogOfDecades",
       {{"a * log(b)", "log2(3 * b) - c"}},
       {{0, 16}, {mpq_class(1, 8192), 1}, {0, 100}}},
      {"LogOfMore", {{"log(a)", "b"}}, {{1, 100}, {0, 5}}},
      {"LogOfNearlyOne", {{"log(a)", "b"}}, {{1, mpq_class(65, 64)}, {-2, 2}}},
      {"LogOfOne", {{"log(a)", "b"}}, {{1, 1}, {-2, 2}}},
      {"Log2OfOne", {{"log2(a)", "b"}}, {{1, 1}, {-2, 2}}},
      {"LogOfDifference", {{"log(a - b)", "c"}}, {{2, 4}, {0, 1}, {-1, 2}}},
      {"Log1pNearItsEnd", {{"log1p(a)", "b"}}, {{-near_one, 1}, {-3, 1}}},
      {"Log1pTouchingItsEnd", {{"log1p(a)", "b"}}, {{-1, 1}, {-3, 1}}},
      {"Sin", {{"sin(a)", "b"}}, {{-4, 4}, {-1, 1}}},
      {"SinOfTwo", {{"sin(a + b)", "sin(a) * cos(b) - sin(b)"}}, {{0, 3}, {0, 3}}},
      {"CosNearItsTop", {{"cos(a)", "1 - b^2"}}, {{-small, small}, {-small, small}}},
      {"TanNearItsPole", {{"tan(a)", "b"}}, {{0, mpq_class(25, 16)}, {0, 90}}},
      {"Tan", {{"tan(a)", "b"}}, {{-1, 1}, {-2, 2}}},
      {"Atan", {{"atan(a)", "b"}}, {{-20, 20}, {-2, 2}}},
      {"AtanOfSums", {{"atan(a - b) + 1", "atan(a)"}}, {{0, 3}, {0, 3}}},
      {"Hyperbolic", {{"cosh(a)^2 - sinh(a)^2", "b"}}, {{-2, 2}, {0, 2}}},
      {"TanhOfLogistic", {{"2 / 3 * tanh(a / 2) + 0.3", "b"}}, {{-6, 6}, {-1, 1}}},
      {"ExpOfSin", {{"exp(sin(a))", "b"}}, {{-3, 3}, {0, 3}}},
      {"Softplus", {{"log(1 + exp(a))", "b"}}, {{-5, 5}, {0, 5}}},
      {"SoftplusByLog1p", {{"log1p(exp(-abs(a))) + max(a, 0)", "b"}}, {{-5, 5}, {0, 5}}},
      {"Gaussian", {{"exp(-(a - b)^2 / 2)", "c"}}, {{0, 2}, {0, 2}, {0, 1}}},
      {"OfConstants", {{"a + exp(1) - cos(0)", "log2(3) * b"}}, {{-1, 1}, {-1, 1}}, {}, 0},
      {"OfConstantsOnly", {{"exp(1)", "cos(1) + sin(0)"}}, {}, {}, 0},
      {"TwiceTheSame", {{"exp(a) * exp(a)", "exp(a) + exp(b)"}}, {{-1, 1}, {-1, 1}}},
      {"BothSides", {{"exp(a)", "exp(b)"}}, {{-1, 1}, {-1, 1}}},
      {"InChoices", {{"min(exp(a), b)", "max(log1p(b), sin(a))"}}, {{-1, 1}, {0, 2}}},
      {"InProducts", {{"exp(a) * (b - 0.5) * sin(b)", "a^2"}}, {{-1, 1}, {0, 2}}},
      {"InRoots", {{"sqrt(exp(a) + 1)", "cosh(b)"}}, {{-1, 1}, {0, 2}}},
      {"InNorms", {{"exp(a)^2 + b^2", "(a - b)^2"}}, {{-1, 1}, {0, 2}}},
      {"Within", {{"log(within(a - b, 0.25, 2))", "b"}}, {{0, 3}, {0, 3}}},
      {"WithinPole", {{"tan(within(a, -1.5, 1.5))", "b"}}, {{-3, 3}, {-4, 4}}},
      {"Parts", {{"exp(a)", "b"}, {"log(b + 1)", "a"}}, {{-1, 1}, {0, 3}}},
      {"SmallIntegers", {{"exp(a / 16)", "b / 64"}}, {{-128, 127}, {0, 1023}}, {"int8", "uint10"}},
      {"Fractions", {{"log2(a + 1)", "b"}}, {{0, 63}, {-8, 7}}, {"uint6", "q3.4"}},
      {"WideProducts", {{"atan(a * b / 65536)", "c / 8"}}, {{}, {}, {}}, {"int8", "int10", "q4.2"}},
      {"WideSquares",
       {{"exp(-(a^2 + b^2) / 1000)", "c / 256"}},
       {{}, {}, {}},
       {"int8", "int8", "uint8"}},
  };
}

/// Expressions of one number, which are one table, and products of many binades.
std::vector<FunctionComparison> formula_comparisons() {
  const mpq_class thousandth(1, 1000), hundredth(1, 100);
  return {
      {"Logistic", {{"1 / (1 + exp(-a))", "b"}}, {{-8, 8}, {0, 1}}},
      {"SquareOfSin", {{"sin((a - b) / 2)^2 * 3 + 1", "c"}}, {{-3, 3}, {-3, 3}, {0, 5}}},
      {"Bell", {{"a * exp(-a^2 / 2) + cos(a)^2", "b"}}, {{-4, 4}, {-1, 2}}},
      {"RootOfOneNumber", {{"sqrt(2 + sin(a)) * b", "sqrt(a^2 + 1)"}}, {{-3, 3}, {0, 2}}},
      {"FormulaWithADomain", {{"log(1 - exp(-a))", "b"}}, {{mpq_class(1, 2), 8}, {-2, 0}}},
      {"RootWithADomain", {{"sqrt(a^2 - 1) - log(a)", "b"}}, {{2, 8}, {0, 8}}},
      {"SharedTable", {{"exp(a) * b", "1 / (1 + exp(a))"}}, {{-2, 2}, {0, 1}}},
      {"FormulaOfIntegers", {{"1 / (1 + exp(-a / 16))", "b"}}, {{}, {}}, {"int8", "q0.8"}},
      {"FormulasInParts",
       {{"1 / (1 + exp(-a))", "b"}, {"1 / (2 + cos(b))", "c"}},
       {{-4, 4}, {0, 1}, {0, 1}}},
      {"QuotientOfDecades", {{"exp(-a / b)", "c"}}, {{thousandth, 1000}, {hundredth, 100}, {0, 1}}},
      {"ProductOfDecades",
       {{"atan(a^2 * sqrt(b) / 5)", "c"}},
       {{hundredth, 50}, {thousandth, 70}, {0, 2}}},
      {"LogarithmOfDecades",
       {{"log(1 + a / b)", "c + log(b)"}},
       {{thousandth, 10}, {hundredth, 50}, {0, 8}}},
  };
}

}  // namespace

std::vector<FunctionComparison> function_comparisons() {
  std::vector<FunctionComparison> all = named_comparisons();
  for (const auto& further : {further_comparisons(), formula_comparisons()}) {
    all.insert(all.end(), further.begin(), further.end());
  }
  return all;
}

double hard_operand(const Range& range, std::mt19937_64& random) {
  const double low = range.low.get_d(), high = range.high.get_d();
  const double inside = low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
  const double step = std::ldexp(1, std::ilogb(high - low + 1) - static_cast<int>(random() % 16));
  const double stepped = std::nearbyint(inside / step) * step;
  switch (random() % 16) {
    case 0: return std::nextafter(stepped, random() % 2 == 0 ? -1e300 : 1e300);
    case 1:
    case 2:
    case 3: return stepped;
    case 4: return random() % 2 == 0 ? low : high;
    case 5: return std::ldexp(inside, -static_cast<int>(random() % 60));
    case 6: return 3 * inside;
    case 7: return -inside;
    case 8: {
      constexpr double infinity = std::numeric_limits<double>::infinity();
      const double specials[] = {infinity, -infinity, std::nan(""), 1e30, -1e30, 0.0, -0.0};
      return specials[random() % 7];
    }
    default: return inside;
  }
}

}  // namespace mixcmp::test
