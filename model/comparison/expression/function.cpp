#include "model/comparison/expression/function.hpp"

#include <fmt/core.h>

#include <utility>

#include "model/base/common/check.hpp"
#include "model/comparison/expression/formula.hpp"
#include "model/comparison/expression/text.hpp"

namespace mixcmp::inline expression {
namespace {

/// The most characters of a formula in messages and comments.
constexpr std::size_t most_text = 60;

}  // namespace

Function Function::power_of(const mpq_class& exponent) {
  Function function = power;
  function.parameter_ = exponent;
  return function;
}

Function Function::remainder_by(const mpq_class& divisor) {
  MIXCMP_CHECK(divisor > 0);
  Function function = remainder;
  function.parameter_ = divisor;
  return function;
}

Function Function::through(const std::string& name, const Interpolation& interpolation) {
  Function function = table;
  function.table_ = std::make_shared<const Table>(Table{name, interpolation});
  return function;
}

Function Function::of_formula(Formula formula) {
  Function function = Function::formula;
  function.formula_ = std::make_shared<const Formula>(std::move(formula));
  return function;
}

Function Function::of(const AffineMap& map) const {
  Function function = *this;
  function.inner_ = map.then(inner_);
  return function;
}

Function Function::outer() const {
  Function function = *this;
  function.inner_ = {};
  return function;
}

std::strong_ordering operator<=>(const Function& a, const Function& b) {
  if (a.kind_ != b.kind_) return a.kind_ <=> b.kind_;
  if (a.inner_.factor != b.inner_.factor) return cmp(a.inner_.factor, b.inner_.factor) <=> 0;
  if (a.inner_.offset != b.inner_.offset) return cmp(a.inner_.offset, b.inner_.offset) <=> 0;
  if (a.parameter_) return cmp(*a.parameter_, *b.parameter_) <=> 0;
  if (a.formula_ && a.formula_ != b.formula_) return *a.formula_ <=> *b.formula_;
  if (a.table_ == b.table_) return std::strong_ordering::equal;
  return a.table_->interpolation <=> b.table_->interpolation;
}

std::string to_string(const Function& function) {
  switch (function.kind()) {
    case Function::exp: return "exp";
    case Function::exp2: return "exp2";
    case Function::expm1: return "expm1";
    case Function::log: return "log";
    case Function::log2: return "log2";
    case Function::log1p: return "log1p";
    case Function::sin: return "sin";
    case Function::cos: return "cos";
    case Function::tan: return "tan";
    case Function::atan: return "atan";
    case Function::sinh: return "sinh";
    case Function::cosh: return "cosh";
    case Function::tanh: return "tanh";
    case Function::power: return "power";
    case Function::sign: return "sign";
    case Function::remainder: return "mod";
    case Function::table: return "table";
    case Function::formula: return "formula";
  }
  MIXCMP_CHECK(false);
}

/// "x", "-x", "2 * x", "-x / 3 + 1" for a name x.
std::string text_of(const AffineMap& map, const std::string& name) {
  const auto& [factor, offset] = map;
  std::string text = name;
  if (abs(factor.get_num()) != 1) text = mpz_class(abs(factor.get_num())).get_str() + " * " + text;
  if (factor.get_den() != 1) text += " / " + factor.get_den().get_str();
  if (factor < 0) text = "-" + text;
  if (offset == 0) return text;
  return fmt::format("{} {} {}", text, offset < 0 ? "-" : "+", to_text(abs(offset)));
}

std::string exponent_text(const Function& power) {
  const std::string exponent = to_text(power.parameter());
  return exponent.find('/') == std::string::npos ? exponent : fmt::format("({})", exponent);
}

std::string applied_text(const Function& function, const std::string& argument) {
  const std::string name = to_string(function), inner = text_of(function.inner(), argument);
  if (function.kind() == Function::power) {
    const bool is_name = function.inner().is_identity();
    return fmt::format("{}^{}", is_name ? inner : "(" + inner + ")", exponent_text(function));
  }
  if (function.kind() == Function::remainder) {
    return fmt::format("{}({}, {})", name, inner, to_text(function.parameter()));
  }
  if (function.kind() == Function::table) {
    const int degree = function.interpolation().degree();
    return fmt::format("{}(\"{}\", {}{})", name, function.table_name(), inner,
                       degree == 1 ? "" : fmt::format(", {}", degree));
  }
  if (function.kind() == Function::formula) {
    const Formula& formula = function.expression();
    const std::string atom = inner == argument ? inner : "(" + inner + ")";
    return to_text(formula.nodes, {atom}, formula.value(), most_text);
  }
  return fmt::format("{}({})", name, inner);
}

bool has_jumps(const Function& function) {
  return function.kind() == Function::sign || function.kind() == Function::remainder;
}

bool Domain::contains(const mpq_class& argument) const {
  if (high && (high->is_open ? argument >= high->at : argument > high->at)) return false;
  return !low || (low->is_open ? argument > low->at : argument >= low->at);
}

namespace {

Domain domain_without_map(const Function& function) {
  const Function::Kind kind = function.kind();
  if (kind == Function::log || kind == Function::log2) return {.low = {{0, true}}};
  if (kind == Function::log1p) return {.low = {{-1, true}}};
  if (kind == Function::table) {
    const std::vector<mpq_class>& knots = function.interpolation().knots();
    return {.low = {{knots.front()}}, .high = {{knots.back()}}};
  }
  if (kind == Function::formula) {
    const std::optional<Range>& arguments = function.expression().arguments;
    return arguments ? Domain{.low = {{arguments->low}}, .high = {{arguments->high}}} : Domain{};
  }
  if (kind != Function::power) return {};
  const mpq_class& exponent = function.parameter();
  if (exponent.get_den() == 1 && exponent > 0) return {};
  return {.low = {{0, exponent < 0}}};
}

}  // namespace

Domain domain(const Function& function) {
  Domain found = domain_without_map(function);
  const AffineMap& inner = function.inner();
  for (std::optional<Domain::End>* end : {&found.low, &found.high}) {
    if (*end) (*end)->at = ((*end)->at - inner.offset) / inner.factor;
  }
  if (inner.factor < 0) std::swap(found.low, found.high);
  return found;
}

std::string accepted_arguments(const Function& function) {
  const Domain accepted = domain(function);
  if (!accepted.low) return "a number";
  const std::string low = to_text(accepted.low->at);
  if (accepted.high) return fmt::format("a number {}..{}", low, to_text(accepted.high->at));
  return fmt::format("a number {} {}", accepted.low->is_open ? "above" : "of at least", low);
}

}  // namespace mixcmp::inline expression
