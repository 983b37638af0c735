#include "model/comparison/data/uniform_table.hpp"

#include <fmt/format.h>

#include <utility>

#include "model/base/number/dyadic.hpp"
#include "model/base/number/exact.hpp"
#include "model/comparison/data/row_random.hpp"

namespace mixcmp::data {
namespace {

/// Draws for one number before its column counts as empty.
constexpr int most_draws = 1000;

std::string text_of(const UniformNumbers& numbers) {
  const std::string range = fmt::format("[{:g}, {:g}]", numbers.low.get_d(), numbers.high.get_d());
  return numbers.grid ? fmt::format("{}, multiples of {:g}", range, numbers.grid->get_d()) : range;
}

bool contains(const UniformNumbers& numbers, const mpq_class& value) {
  if (value < numbers.low || value > numbers.high) return false;
  return !numbers.grid || mpq_class(value / *numbers.grid).get_den() == 1;
}

class ColumnDrawer {
public:
  ColumnDrawer(const UniformColumn& column, const UniformTable& table, FloatFormat format)
      : numbers_(column.numbers),
        table_format_(format),
        format_(column.rounded_to.value_or(format)),
        seed_(table.seed),
        stream_(stream_of(column.name) + table.which) {
    if (!numbers_.grid) return;
    first_ = ceiling_of(numbers_.low / *numbers_.grid);
    count_ = floor_of(numbers_.high / *numbers_.grid) - first_ + 1;
  }

  std::optional<Bits> draw(std::uint64_t row) const {
    RowRandom random(seed_, stream_, row);
    for (int k = 0; k < most_draws; ++k) {
      const Bits bits = from_rational(format_, number(random));
      if (!format_.is_finite(bits) || !contains(numbers_, to_rational(format_, bits))) continue;
      return format_ == table_format_ ? bits : converted(table_format_, format_, bits);
    }
    return std::nullopt;
  }

private:
  mpq_class number(RowRandom& random) const {
    constexpr int digits = 53;
    if (!numbers_.grid) {
      mpq_class share(mpz_class(random.integer(64) >> (64 - digits)));
      mpq_div_2exp(share.get_mpq_t(), share.get_mpq_t(), digits);
      return numbers_.low + (numbers_.high - numbers_.low) * share;
    }
    // A product of so many more bits than the count has is as likely to be any of them.
    const int bits = static_cast<int>(mpz_sizeinbase(count_.get_mpz_t(), 2)) + 64;
    const mpz_class index = random.integer(bits) * count_ >> bits;
    return (first_ + index) * *numbers_.grid;
  }

  const UniformNumbers& numbers_;
  FloatFormat table_format_;
  FloatFormat format_;  ///< to which numbers are rounded
  std::uint64_t seed_;
  std::uint32_t stream_;
  mpz_class first_, count_;  ///< the multiples of the grid: first_ * grid is the least
};

}  // namespace

Result<Table> uniform_table(const UniformTable& uniform, FloatFormat format) {
  Table table{.format = format, .columns = {}};
  std::vector<ColumnDrawer> drawers;
  for (const UniformColumn& column : uniform.columns) {
    table.columns.push_back(column.name);
    drawers.emplace_back(column, uniform, format);
  }
  table.values.reserve(drawers.size() * uniform.count);
  for (std::uint64_t row = 0; row < uniform.count; ++row) {
    for (std::size_t k = 0; k < drawers.size(); ++k) {
      const std::optional<Bits> number = drawers[k].draw(row);
      if (!number) {
        return Error{.field = "data.items",
                     .message = fmt::format("{} has no number to draw for the column {}",
                                            uniform.columns[k].rounded_to.value_or(format).name(),
                                            table.columns[k]),
                     .received = text_of(uniform.columns[k].numbers),
                     .accepted = "a range that contains some of the format's numbers"};
      }
      table.values.push_back(*number);
    }
  }
  return table;
}

}  // namespace mixcmp::data
