#pragma once

#include <gmpxx.h>

#include <array>
#include <compare>
#include <memory>
#include <optional>
#include <string>

#include "model/comparison/expression/affine_map.hpp"
#include "model/comparison/expression/interpolation.hpp"

namespace mixcmp::inline expression {

struct Formula;

/// A function of one argument, with what it depends on otherwise. The argument may pass an affine
/// map first, as in exp(1 - x / 2).
class Function {
public:
  /// By their names in C if they have one.
  enum Kind {
    exp,
    exp2,
    expm1,
    log,
    log2,
    log1p,
    sin,
    cos,
    tan,
    atan,
    sinh,
    cosh,
    tanh,
    power,      ///< x^y; where y is below 0, of positive numbers only
    sign,       ///< -1 below 0, otherwise 1
    remainder,  ///< x - y floor(x / y), for y > 0
    table,      ///< an interpolation
    formula,    ///< an expression of one variable
  };

  /// A function that depends on nothing else.
  Function(Kind kind) : kind_(kind) {}
  static Function power_of(const mpq_class& exponent);
  static Function remainder_by(const mpq_class& divisor);
  /// `name`: that of the table's file, for messages.
  static Function through(const std::string& name, const Interpolation& interpolation);
  static Function of_formula(Formula formula);

  /// This function of the map's value.
  Function of(const AffineMap& map) const;

  Kind kind() const { return kind_; }
  const AffineMap& inner() const { return inner_; }
  /// The function of the map's value.
  Function outer() const;
  /// y.
  const mpq_class& parameter() const { return *parameter_; }
  const Interpolation& interpolation() const { return table_->interpolation; }
  const std::string& table_name() const { return table_->name; }
  /// Valid for a `formula`.
  const Formula& expression() const { return *formula_; }

  friend bool operator==(const Function& a, const Function& b) { return (a <=> b) == 0; }
  friend std::strong_ordering operator<=>(const Function& a, const Function& b);

private:
  struct Table {
    std::string name;
    Interpolation interpolation;
  };

  Kind kind_;
  AffineMap inner_;
  std::optional<mpq_class> parameter_;
  std::shared_ptr<const Table> table_;
  std::shared_ptr<const Formula> formula_;
};

/// The functions that are known by their names and smooth where they have a value.
inline constexpr std::array all_functions = {
    Function::exp,   Function::exp2, Function::expm1, Function::log, Function::log2,
    Function::log1p, Function::sin,  Function::cos,   Function::tan, Function::atan,
    Function::sinh,  Function::cosh, Function::tanh};

/// "exp"; "power" for x^y, "mod", "table".
std::string to_string(const Function& function);
/// The exponent of a power in formulas: "0.45", "(1/3)".
std::string exponent_text(const Function& power);
/// The function's value in formulas: "exp(a)", "a^0.45", "mod(a, 360)", "table(\"gamma.csv\", a)";
/// `argument` is a name.
std::string applied_text(const Function& function, const std::string& argument);

/// Whether values may differ however near two arguments are.
bool has_jumps(const Function& function);

/// The arguments at which a function has a value. Without an end it has values on all that side,
/// tan except at its poles, none of which is rational.
struct Domain {
  /// A side up to which there are values.
  struct End {
    mpq_class at;
    bool is_open = false;  ///< the end itself has no value
  };
  std::optional<End> low, high;

  bool contains(const mpq_class& argument) const;
};

Domain domain(const Function& function);
/// For messages: "a number above 0".
std::string accepted_arguments(const Function& function);

}  // namespace mixcmp::inline expression
