#include "model/comparison/data/pdb.hpp"
#include "tests/fuzz/input.hpp"

using namespace mixcmp;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const FloatFormat format = FloatFormat::parse("s24e8").value();
  const auto table = data::read_pdb(test::file_of(data, size), format);
  if (!test::is_read(table)) return 0;
  test::require(table->values.size() == 4 * table->labels.size());
  for (const Bits bits : table->values) {
    test::require(bits >> format.width() == 0 && !format.is_nan(bits) && !format.is_infinite(bits));
  }
  return 0;
}
