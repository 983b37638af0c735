#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "model/lane/error/relative_bound.hpp"

namespace mixcmp::proof {

/// A dyadic rational in Gappa's syntax: "-3b-17" is -3 * 2^-17.
std::string dyadic(const mpq_class& value);

/// Gappa's operator for rounding to `precision` digits, with an exponent range so wide that its end
/// does not matter.
std::string rounding_operator(int precision, Rounding rounding);

/// Theorem 1 of docs/error_bounds.md: exact result = rounded result * t, t in this interval.
error::RelativeBound rounding_interval(int precision, Rounding rounding);

/// A Gappa script: definitions, then hypotheses that imply goals.
class Script {
public:
  void comment(const std::string& text);
  void define(const std::string& name, const std::string& expression);
  void define_operator(const std::string& name, const std::string& definition);

  void assume(const std::string& fact);
  void assume_within(const std::string& expression, const std::string& low,
                     const std::string& high);
  /// Assumes truth = computed * t with t in the bound.
  void assume_relative(const std::string& truth, const std::string& computed,
                       const error::RelativeBound& bound);
  void conclude(const std::string& fact);
  void conclude_relative(const std::string& truth, const std::string& computed,
                         const error::RelativeBound& bound);
  /// Tells Gappa that both sides are equal numbers, so that a bound of the second bounds the first.
  void hint(const std::string& from, const std::string& to);

  /// Has Gappa compute with at least this many digits.
  void ask_for_digits(int digits) { digits_ = std::max(digits_, digits); }

  /// The script as Gappa reads it. Its options ask for enough digits, and forbid bisection, which
  /// would search for hours if a proof does not follow at once.
  std::string text() const;

private:
  std::string definitions_;
  std::vector<std::string> assumptions_;
  std::vector<std::string> conclusions_;
  std::string hints_;
  int digits_ = 768;
};

/// Scripts that prove theorem 1 in the binades from 1 to 2 and from -2 to -1. Exponents are
/// unbounded, so every other binade is one of these times a power of two.
std::vector<std::string> rounding_scripts(int precision, Rounding rounding);

/// Scripts that bound the error of a rounding relative to the power of two at or below the rounded
/// value.
std::vector<std::string> binade_scripts(int precision, Rounding rounding);

enum class ExactOperation { convert, multiply, square };
std::string_view to_string(ExactOperation operation);

/// A script that proves that rounding to `precision` digits changes no result on operands of
/// `operand_precision` digits.
std::string exactness_script(ExactOperation operation, int operand_precision, int precision,
                             Rounding rounding);

}  // namespace mixcmp::proof
