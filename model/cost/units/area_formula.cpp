#include "model/cost/units/area_formula.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include "model/base/common/check.hpp"

namespace mixcmp::units {
namespace {

using Column = std::vector<double>;

constexpr std::size_t most_terms = 30;
/// So many measured units support one term.
constexpr std::size_t units_per_term = 3;
constexpr std::size_t folds = 5;
/// Added to an amount before errors are divided by it: small units decide little.
constexpr double small_amount = 10;
/// Wider literals are constants of a scene, of which single bits say nothing.
constexpr int most_single_bits = 32;
/// A column whose rest is smaller than this part of it depends on those chosen before.
constexpr double dependence = 1e-7;

double dot(const Column& a, const Column& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

void subtract(Column& from, double times, const Column& column) {
  for (std::size_t k = 0; k < from.size(); ++k) from[k] -= times * column[k];
}

/// Chooses columns one by one. Each step makes the others orthogonal to the chosen one (modified
/// Gram-Schmidt), so that the error that a column would explain is one product.
class ForwardSelection {
public:
  ForwardSelection(std::vector<Column> columns, Column target)
      : columns_(std::move(columns)),
        original_(columns_),
        rest_(std::move(target)),
        target_(rest_) {
    for (const Column& column : columns_) squares_.push_back(dot(column, column));
  }

  /// Takes the best column; false if none explains anything.
  bool step() {
    std::size_t best = columns_.size();
    double most = 0;
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      const double length = dot(columns_[c], columns_[c]);
      if (squares_[c] == 0 || length <= dependence * squares_[c]) continue;
      const double product = dot(columns_[c], rest_);
      const double explained = product * product / length;
      if (explained > most) most = explained, best = c;
    }
    if (best == columns_.size() || most <= 1e-12 * dot(target_, target_)) return false;
    take(best);
    return true;
  }

  const std::vector<std::size_t>& chosen() const { return chosen_; }

  /// The coefficients of the chosen columns, by solving the triangular system backwards.
  Column coefficients() const {
    const std::size_t count = chosen_.size();
    Column result(count);
    for (std::size_t k = count; k-- > 0;) {
      double right = along_[k];
      for (std::size_t later = k + 1; later < count; ++later) {
        right -= dot(basis_[k], original_[chosen_[later]]) * result[later];
      }
      result[k] = right / dot(basis_[k], original_[chosen_[k]]);
    }
    return result;
  }

private:
  void take(std::size_t best) {
    Column unit = columns_[best];
    const double length = std::sqrt(dot(unit, unit));
    for (double& value : unit) value /= length;
    for (Column& column : columns_) subtract(column, dot(unit, column), unit);
    along_.push_back(dot(unit, rest_));
    subtract(rest_, along_.back(), unit);
    squares_[best] = 0;
    chosen_.push_back(best);
    basis_.push_back(std::move(unit));
  }

  std::vector<Column> columns_, original_;
  Column rest_, target_;
  std::vector<double> squares_;
  std::vector<std::size_t> chosen_;
  std::vector<Column> basis_;
  Column along_;
};

/// Amounts, and columns of terms, each divided by the unit's whole amount.
struct Samples {
  const std::vector<Unit>& units;
  const std::vector<double>& amounts;
  const std::vector<double>& whole;
  const std::vector<Term>& terms;

  double weight(std::size_t unit) const { return 1 / (whole[unit] + small_amount); }
  ForwardSelection selection(const std::vector<std::size_t>& of) const {
    std::vector<Column> columns(terms.size());
    Column target;
    for (const std::size_t unit : of) target.push_back(amounts[unit] * weight(unit));
    for (std::size_t t = 0; t < terms.size(); ++t) {
      for (const std::size_t unit : of) {
        columns[t].push_back(value(terms[t], units[unit]) * weight(unit));
      }
    }
    return {std::move(columns), std::move(target)};
  }
  Formula formula(const ForwardSelection& selection) const {
    Formula result{.terms = {}, .coefficients = selection.coefficients()};
    for (const std::size_t term : selection.chosen()) result.terms.push_back(terms[term]);
    return result;
  }
};

std::size_t largest_formula(std::size_t units) {
  return std::min(most_terms, std::max<std::size_t>(1, units / units_per_term));
}

/// The number of terms with the least error on units that were left out.
std::size_t best_length(const Samples& samples) {
  const std::size_t units = samples.units.size();
  Column errors(largest_formula(units), 0.0);
  for (std::size_t fold = 0; fold < std::min(folds, units); ++fold) {
    std::vector<std::size_t> learnt, left_out;
    for (std::size_t k = 0; k < units; ++k) (k % folds == fold ? left_out : learnt).push_back(k);
    if (learnt.empty()) continue;
    ForwardSelection selection = samples.selection(learnt);
    Formula formula;
    for (double& error : errors) {
      if (selection.step()) formula = samples.formula(selection);
      for (const std::size_t unit : left_out) {
        const double off = formula.of(samples.units[unit]) - samples.amounts[unit];
        error += std::pow(off * samples.weight(unit), 2);
      }
    }
  }
  return static_cast<std::size_t>(std::min_element(errors.begin(), errors.end()) - errors.begin()) +
         1;
}

/// What is known of one parameter over all units.
struct Spread {
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();
  int literal_bits = 0;

  bool varies() const { return least < most; }
  bool is_flag() const { return literal_bits == 0 && least >= 0 && most <= 1; }
  bool is_size() const { return literal_bits == 0 && !is_flag(); }
  bool starts_at_one() const { return is_size() && least == 1; }
};

std::vector<Spread> spreads_of(const std::vector<Unit>& units) {
  std::vector<Spread> spreads(units.front().parameters.size());
  for (const Unit& unit : units) {
    for (std::size_t p = 0; p < spreads.size(); ++p) {
      const double size = unit.parameters[p].size();
      spreads[p].least = std::min(spreads[p].least, size);
      spreads[p].most = std::max(spreads[p].most, size);
      spreads[p].literal_bits = std::max(spreads[p].literal_bits, unit.parameters[p].literal_bits);
    }
  }
  return spreads;
}

constexpr double most_address_bits = 10;

/// Lists the terms of one template.
class TermList {
public:
  explicit TermList(const std::vector<Unit>& units)
      : names_(units.front().parameters), spreads_(spreads_of(units)) {
    for (std::size_t p = 0; p < spreads_.size(); ++p) {
      if (spreads_[p].varies() && names_[p].name != exponent_of_limit) varying_.push_back(p);
    }
  }

  std::vector<Term> list() {
    terms_.push_back({});
    for (const std::size_t p : varying_) add_sizes(p);
    for (std::size_t p = 0; p < spreads_.size(); ++p) add_bits(p);
    return std::move(terms_);
  }

private:
  static Factor size(std::size_t p) { return {.parameter = p}; }

  void add_sizes(std::size_t p) {
    terms_.push_back({size(p)});
    for (const std::size_t q : varying_) {
      if (q >= p && !(q == p && spreads_[p].is_flag())) terms_.push_back({size(p), size(q)});
      if (spreads_[q].is_size()) {
        terms_.push_back({size(p), {.parameter = q, .kind = Factor::Kind::log}});
      }
    }
    if (spreads_[p].is_flag()) add_flagged_products(p);
    if (spreads_[p].starts_at_one()) add_sizes_of_many(p);
    if (names_[p].name.ends_with("_BITS") && spreads_[p].most <= most_address_bits) add_powers(p);
  }

  void add_flagged_products(std::size_t flag) {
    for (const std::size_t p : varying_) {
      for (const std::size_t q : varying_) {
        if (q < p || !spreads_[p].is_size() || !spreads_[q].is_size()) continue;
        terms_.push_back({size(flag), size(p), size(q)});
      }
    }
  }

  void add_sizes_of_many(std::size_t p) {
    const Factor many = {.parameter = p, .kind = Factor::Kind::many};
    terms_.push_back({many});
    for (const std::size_t q : varying_) terms_.push_back({many, size(q)});
  }

  void add_powers(std::size_t p) {
    const Factor power = {.parameter = p, .kind = Factor::Kind::power};
    terms_.push_back({power});
    for (const std::size_t q : varying_) terms_.push_back({power, size(q)});
  }

  void add_bits(std::size_t p) {
    if (spreads_[p].literal_bits > most_single_bits) return;
    for (int bit = 0; bit < spreads_[p].literal_bits; ++bit) {
      const Factor factor = {.parameter = p, .kind = Factor::Kind::bit, .index = bit};
      terms_.push_back({factor});
      for (const std::size_t q : varying_) {
        if (spreads_[q].literal_bits == 0) terms_.push_back({factor, size(q)});
      }
    }
  }

  const std::vector<Parameter>& names_;
  std::vector<Spread> spreads_;
  std::vector<std::size_t> varying_;
  std::vector<Term> terms_;
};

}  // namespace

double Factor::of(const Unit& unit) const {
  const Parameter& of = unit.parameters[parameter];
  switch (kind) {
    case Kind::size: return of.size();
    case Kind::log: return std::log2(std::max(of.size(), 1.0));
    case Kind::power: return std::exp2(of.size());
    case Kind::bit: return of.bit(index) ? 1 : 0;
    case Kind::many: return of.size() > 1 ? 1 : 0;
  }
  MIXCMP_CHECK(false);
}

double value(const Term& term, const Unit& unit) {
  double product = 1;
  for (const Factor& factor : term) product *= factor.of(unit);
  return product;
}

std::string to_string(const Term& term, const Unit& unit) {
  std::string text;
  for (const Factor& factor : term) {
    const std::string& name = unit.parameters[factor.parameter].name;
    if (!text.empty()) text += "*";
    switch (factor.kind) {
      case Factor::Kind::size: text += name; break;
      case Factor::Kind::log: text += "lg(" + name + ")"; break;
      case Factor::Kind::power: text += "2^" + name; break;
      case Factor::Kind::bit: text += fmt::format("{}[{}]", name, factor.index); break;
      case Factor::Kind::many: text += "(" + name + ">1)"; break;
    }
  }
  return text.empty() ? "1" : text;
}

double Formula::of(const Unit& unit) const {
  double sum = 0;
  for (std::size_t k = 0; k < terms.size(); ++k) sum += coefficients[k] * value(terms[k], unit);
  return sum;
}

std::vector<Term> possible_terms(const std::vector<Unit>& units) {
  MIXCMP_CHECK(!units.empty());
  return TermList(units).list();
}

Formula fit(const std::vector<Unit>& units, const std::vector<double>& amounts,
            const std::vector<double>& whole) {
  MIXCMP_CHECK(units.size() == amounts.size() && units.size() == whole.size());
  const std::vector<Term> terms = possible_terms(units);
  const Samples samples{units, amounts, whole, terms};
  std::vector<std::size_t> all(units.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  ForwardSelection selection = samples.selection(all);
  const std::size_t length = best_length(samples);
  while (selection.chosen().size() < length && selection.step()) {
  }
  return samples.formula(selection);
}

}  // namespace mixcmp::units
