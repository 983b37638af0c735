#include "model/comparison/data/points.hpp"

#include <array>
#include <utility>
#include <vector>

#include "model/base/number/exact.hpp"
#include "model/comparison/data/csv.hpp"

namespace mixcmp::data {

Result<Interpolation> read_points(const std::filesystem::path& path, int degree) {
  const FloatFormat format = FloatFormat::make(53, 11).value();
  const std::array columns = {WantedColumn{.name = "x", .column = std::uint64_t{0}},
                              WantedColumn{.name = "y", .column = std::uint64_t{1}}};
  MIXCMP_TRY(table, read_csv(path, format, columns));
  std::array<std::vector<mpq_class>, 2> coordinates;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (std::size_t column = 0; column < columns.size(); ++column) {
      const Bits bits = table.at(row, column);
      if (format.is_nan(bits) || format.is_infinite(bits)) {
        return Error{.file = path.string(),
                     .line = table.lines[row],
                     .field = columns[column].name,
                     .message = "a point of a table is not finite",
                     .received = format.is_nan(bits) ? "nan" : "an infinity",
                     .accepted = "finite numbers"};
      }
      coordinates[column].push_back(to_rational(format, bits));
    }
  }
  auto made = Interpolation::through(std::move(coordinates[0]), std::move(coordinates[1]), degree);
  if (made.ok()) return made;
  Error error = made.error();
  error.file = path.string();
  return error;
}

}  // namespace mixcmp::data
