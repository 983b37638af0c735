#include <array>

#include "model/comparison/data/npy.hpp"
#include "tests/fuzz/input.hpp"

using namespace mixcmp;

/// Columns by number, or the fields of a structured array by name.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::array numbered = {data::WantedColumn{.name = "a", .column = std::uint64_t{0}},
                               data::WantedColumn{.name = "b", .column = std::uint64_t{1}}};
  const std::array named = {data::WantedColumn{.name = "a", .column = "a"},
                            data::WantedColumn{.name = "b", .column = "b"}};
  const FloatFormat format = FloatFormat::parse("s24e8").value();
  const std::filesystem::path file = test::file_of(data, size);
  for (const auto& wanted : {numbered, named}) {
    const auto table = data::read_npy(file, format, wanted);
    if (!test::is_read(table)) continue;
    test::require(table->values.size() % wanted.size() == 0);
    for (const Bits bits : table->values) test::require(bits >> format.width() == 0);
  }
  return 0;
}
