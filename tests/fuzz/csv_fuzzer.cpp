#include <array>

#include "model/comparison/data/csv.hpp"
#include "tests/fuzz/input.hpp"

using namespace mixcmp;

/// A column by name and one by number.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::array wanted = {data::WantedColumn{.name = "a", .column = "a"},
                             data::WantedColumn{.name = "b", .column = std::uint64_t{1}}};
  const FloatFormat format = FloatFormat::parse("s24e8").value();
  const auto table = data::read_csv(test::file_of(data, size), format, wanted);
  if (!test::is_read(table)) return 0;
  test::require(table->values.size() == table->lines.size() * wanted.size());
  for (const Bits bits : table->values) test::require(bits >> format.width() == 0);
  return 0;
}
