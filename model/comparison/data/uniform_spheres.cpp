#include "model/comparison/data/uniform_spheres.hpp"

#include <cstdint>

#include "model/base/number/exact.hpp"
#include "model/comparison/data/philox.hpp"

namespace mixcmp::data {
namespace {

constexpr std::uint32_t low_word(std::uint64_t value) {
  return static_cast<std::uint32_t>(value);
}
constexpr std::uint32_t high_word(std::uint64_t value) {
  return static_cast<std::uint32_t>(value >> 32);
}

/// limit * u / 2^53.
mpq_class fraction_of(double limit, std::uint32_t high, std::uint32_t low) {
  const std::uint64_t u = (std::uint64_t{high} << 32 | low) >> 11;
  mpq_class value = mpq_class(limit) * mpz_class(static_cast<unsigned long>(u));
  mpq_div_2exp(value.get_mpq_t(), value.get_mpq_t(), 53);
  return value;
}

}  // namespace

Table uniform_spheres(const UniformSpheres& spheres, FloatFormat format) {
  Table table{.format = format, .columns = {"cx", "cy", "cz", "r"}};
  table.values.reserve(4 * spheres.count);
  const PhiloxKey key = {low_word(spheres.seed), high_word(spheres.seed)};
  for (std::uint64_t n = 0; n < spheres.count; ++n) {
    const auto xy = philox({low_word(n), high_word(n), 0, 0}, key);
    const auto zr = philox({low_word(n), high_word(n), 1, 0}, key);
    for (const mpq_class& value :
         {fraction_of(spheres.side, xy[0], xy[1]), fraction_of(spheres.side, xy[2], xy[3]),
          fraction_of(spheres.side, zr[0], zr[1]), fraction_of(spheres.radius_max, zr[2], zr[3])}) {
      table.values.push_back(from_rational(format, value));
    }
  }
  return table;
}

}  // namespace mixcmp::data
