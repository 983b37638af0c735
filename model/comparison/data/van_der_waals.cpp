#include "model/comparison/data/van_der_waals.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace mixcmp::data {
namespace {

struct Radius {
  std::string_view element;
  std::string_view angstrom;
};

constexpr std::array<Radius, 42> radii = {{
    {"H", "1.20"},  {"D", "1.20"},  {"HE", "1.40"}, {"LI", "1.82"}, {"B", "1.92"},  {"C", "1.70"},
    {"N", "1.55"},  {"O", "1.52"},  {"F", "1.47"},  {"NE", "1.54"}, {"NA", "2.27"}, {"MG", "1.73"},
    {"AL", "1.84"}, {"SI", "2.10"}, {"P", "1.80"},  {"S", "1.80"},  {"CL", "1.75"}, {"AR", "1.88"},
    {"K", "2.75"},  {"CA", "2.31"}, {"MN", "2.45"}, {"FE", "2.44"}, {"CO", "2.40"}, {"NI", "1.63"},
    {"CU", "1.40"}, {"ZN", "1.39"}, {"GA", "1.87"}, {"AS", "1.85"}, {"SE", "1.90"}, {"BR", "1.85"},
    {"KR", "2.02"}, {"MO", "2.45"}, {"PD", "1.63"}, {"AG", "1.72"}, {"CD", "1.58"}, {"I", "1.98"},
    {"XE", "2.16"}, {"PT", "1.72"}, {"AU", "1.66"}, {"HG", "1.55"}, {"TL", "1.96"}, {"PB", "2.02"},
}};

bool same_letters(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](unsigned char x, unsigned char y) {
    return std::toupper(x) == std::toupper(y);
  });
}

}  // namespace

std::optional<std::string_view> van_der_waals_radius(std::string_view element) {
  const auto found = std::find_if(radii.begin(), radii.end(), [&](const Radius& radius) {
    return same_letters(radius.element, element);
  });
  if (found == radii.end()) return std::nullopt;
  return found->angstrom;
}

std::string known_elements() {
  std::string names;
  for (const Radius& radius : radii) {
    if (!names.empty()) names += ' ';
    names += radius.element;
  }
  return names;
}

}  // namespace mixcmp::data
