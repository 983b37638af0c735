#include "model/judge/proof/script.hpp"

#include <fmt/core.h>

#include <utility>

#include "model/base/common/check.hpp"
#include "model/judge/proof/claims.hpp"

namespace mixcmp::proof {
namespace {

/// The lowest exponent of a rounding operator: as low as Gappa accepts, and below every exponent of
/// a format's results.
constexpr int lowest_exponent = -65000;

std::string relative_fact(const std::string& truth, const std::string& computed,
                          const error::RelativeBound& bound) {
  return fmt::format("{} -/ {} in [{}, {}]", truth, computed, dyadic(bound.low - 1),
                     dyadic(bound.high - 1));
}

std::string conjunction(const std::vector<std::string>& facts) {
  std::string text;
  for (const std::string& fact : facts) text += (text.empty() ? "" : " /\\\n  ") + fact;
  return text;
}

}  // namespace

std::string dyadic(const mpq_class& value) {
  MIXCMP_CHECK(mpz_popcount(value.get_den_mpz_t()) == 1);
  const std::size_t shift = mpz_sizeinbase(value.get_den_mpz_t(), 2) - 1;
  const std::string digits = value.get_num().get_str();
  return shift == 0 ? digits : fmt::format("{}b-{}", digits, shift);
}

std::string rounding_operator(int precision, Rounding rounding) {
  const auto direction = [&] {
    switch (rounding) {
      case Rounding::nearest_even: return "ne";
      case Rounding::toward_zero: return "zr";
    }
    MIXCMP_CHECK(false);
  };
  return fmt::format("float<{}, {}, {}>", precision, lowest_exponent, direction());
}

error::RelativeBound rounding_interval(int precision, Rounding rounding) {
  const mpq_class u(1, mpz_class(1) << precision);
  switch (rounding) {
    case Rounding::nearest_even: return {1 - u, 1 + u};
    case Rounding::toward_zero: return {1, 1 + 2 * u};
  }
  MIXCMP_CHECK(false);
}

void Script::comment(const std::string& text) {
  definitions_ += "# " + text + "\n";
}

void Script::define(const std::string& name, const std::string& expression) {
  definitions_ += fmt::format("{} = {};\n", name, expression);
}

void Script::define_operator(const std::string& name, const std::string& definition) {
  definitions_ += fmt::format("@{} = {};\n", name, definition);
}

void Script::assume(const std::string& fact) {
  assumptions_.push_back(fact);
}

void Script::assume_within(const std::string& expression, const std::string& low,
                           const std::string& high) {
  assume(fmt::format("{} in [{}, {}]", expression, low, high));
}

void Script::assume_relative(const std::string& truth, const std::string& computed,
                             const error::RelativeBound& bound) {
  assume(relative_fact(truth, computed, bound));
}

void Script::conclude(const std::string& fact) {
  conclusions_.push_back(fact);
}

void Script::conclude_relative(const std::string& truth, const std::string& computed,
                               const error::RelativeBound& bound) {
  conclude(relative_fact(truth, computed, bound));
}

void Script::hint(const std::string& from, const std::string& to) {
  hints_ += fmt::format("{} -> {};\n", from, to);
}

/// Gappa's own threshold leaves out small gains: beside "at most 2^1024" it forgets "at least
/// 2^-100".
std::string Script::text() const {
  MIXCMP_CHECK(!conclusions_.empty());
  const std::string given = assumptions_.empty() ? "" : conjunction(assumptions_) + "\n  ->\n  ";
  return fmt::format(
      "#@ -Eprecision={}\n#@ -Echange-threshold=0\n#@ -Edichotomy=0\n#@ -Eno-auto-dichotomy\n#@ "
      "-Wno-unbound-variable\n"
      "{}{{ {}{} }}\n{}",
      digits_, definitions_, given, conjunction(conclusions_), hints_);
}

namespace {

/// Scripts that prove `goal` of c, the rounded y, in both binades whose least magnitude is 1.
std::vector<std::string> scripts_of_one_rounding(int precision, Rounding rounding,
                                                 const std::string& goal) {
  const mpq_class least = 1, largest = 2 - power_of_two(1 - precision);
  std::vector<std::string> scripts;
  for (const auto& [low, high] :
       {std::pair(least, largest), std::pair<mpq_class, mpq_class>(-largest, -least)}) {
    Script script;
    script.comment("One rounding, seen from the rounded value.");
    script.define_operator("rnd", rounding_operator(precision, rounding));
    script.define("c", "rnd(y)");
    script.assume_within("c", dyadic(low), dyadic(high));
    script.conclude(goal);
    scripts.push_back(script.text());
  }
  return scripts;
}

}  // namespace

std::vector<std::string> rounding_scripts(int precision, Rounding rounding) {
  const error::RelativeBound bound = rounding_interval(precision, rounding);
  return scripts_of_one_rounding(
      precision, rounding,
      fmt::format("(c - y) / c in [{}, {}]", dyadic(1 - bound.high), dyadic(1 - bound.low)));
}

std::vector<std::string> binade_scripts(int precision, Rounding rounding) {
  const std::string most = dyadic(rounding_interval(precision, rounding).high - 1);
  return scripts_of_one_rounding(precision, rounding, fmt::format("c - y in [-{0}, {0}]", most));
}

std::string_view to_string(ExactOperation operation) {
  switch (operation) {
    case ExactOperation::convert: return "convert";
    case ExactOperation::multiply: return "multiply";
    case ExactOperation::square: return "square";
  }
  MIXCMP_CHECK(false);
}

std::string exactness_script(ExactOperation operation, int operand_precision, int precision,
                             Rounding rounding) {
  const auto result = [&] {
    switch (operation) {
      case ExactOperation::convert: return "a";
      case ExactOperation::multiply: return "a * b";
      case ExactOperation::square: return "a * a";
    }
    MIXCMP_CHECK(false);
  };
  Script script;
  script.comment(fmt::format("Nothing is rounded: operands of {} digits, results of {}.",
                             operand_precision, precision));
  script.define_operator("operand", rounding_operator(operand_precision, Rounding::nearest_even));
  script.define_operator("rnd", rounding_operator(precision, rounding));
  script.define("a", "operand(a_)");
  script.define("b", "operand(b_)");
  script.assume_within("|a|", "1b-20000", "1b20000");
  script.assume_within("|b|", "1b-20000", "1b20000");
  script.conclude(fmt::format("rnd({0}) = {0}", result()));
  return script.text();
}

}  // namespace mixcmp::proof
