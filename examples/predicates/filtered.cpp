// The predicates in software: in double where a bound on the roundings proves the sign, else in
// GMP's integers. Prints how many comparisons were made again, and the rate of one thread. The
// coordinates are doubles: GMP gets them times the power of two that makes all of them integers.
//   filtered orient2d|orient3d|incircle|insphere SIMPLICES.csv ATOMS.csv VERDICTS.csv
// VERDICTS.csv: i, j and verdict of every comparison.
#include <gmpxx.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace {

/// A double, and the same expression with every term's magnitude. A vertex as seen from the point
/// is rounded once. Fewer than 25 roundings lie on the way of any term, which change it by less
/// than 26 * 2^-53 of its magnitude (Higham, Accuracy and Stability of Numerical Algorithms,
/// lemma 3.1). The limit of 64 * 2^-53 also covers the roundings of `magnitude`.
struct Filtered {
  double value, magnitude;
  Filtered(double x, double y) : value(x), magnitude(y) {}
};
Filtered operator*(Filtered a, Filtered b) {
  return {a.value * b.value, a.magnitude * b.magnitude};
}
Filtered operator+(Filtered a, Filtered b) {
  return {a.value + b.value, a.magnitude + b.magnitude};
}
Filtered operator-(Filtered a, Filtered b) {
  return {a.value - b.value, a.magnitude + b.magnitude};
}

/// A vertex as seen from the point.
template <class N>
struct Vertex {
  N x, y, z;
};

template <class N>
N norm(const Vertex<N>& v) {
  return v.x * v.x + v.y * v.y + v.z * v.z;
}

/// The part of the vertices a and b in a determinant of more rows.
template <class N>
N minor2(const Vertex<N>& a, const Vertex<N>& b) {
  return a.x * b.y - b.x * a.y;
}

template <class N>
N minor3(const Vertex<N>& a, const Vertex<N>& b, const Vertex<N>& c) {
  return a.z * minor2(b, c) - b.z * minor2(a, c) + c.z * minor2(a, b);
}

/// The determinants of Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast Robust
/// Geometric Predicates (1997). `v`: the simplex as seen from the point.
struct Orient2d {
  static constexpr std::size_t dimensions = 2;
  template <class N>
  static N determinant(const std::vector<Vertex<N>>& v) {
    return minor2(v[0], v[1]);
  }
};

struct Orient3d {
  static constexpr std::size_t dimensions = 3;
  template <class N>
  static N determinant(const std::vector<Vertex<N>>& v) {
    return minor3(v[0], v[1], v[2]);
  }
};

struct Incircle {
  static constexpr std::size_t dimensions = 2;
  template <class N>
  static N determinant(const std::vector<Vertex<N>>& v) {
    return norm(v[0]) * minor2(v[1], v[2]) + norm(v[1]) * minor2(v[2], v[0]) +
           norm(v[2]) * minor2(v[0], v[1]);
  }
};

struct Insphere {
  static constexpr std::size_t dimensions = 3;
  template <class N>
  static N determinant(const std::vector<Vertex<N>>& v) {
    return norm(v[3]) * minor3(v[0], v[1], v[2]) - norm(v[2]) * minor3(v[3], v[0], v[1]) +
           norm(v[1]) * minor3(v[2], v[3], v[0]) - norm(v[0]) * minor3(v[1], v[2], v[3]);
  }
};

using Rows = std::vector<std::vector<double>>;

Rows read(const char* path) {
  std::ifstream file(path);
  std::string line, cell;
  if (!std::getline(file, line)) {
    std::fprintf(stderr, "%s: cannot be read\n", path);
    std::exit(1);
  }
  Rows rows;
  while (std::getline(file, line)) {
    std::istringstream cells(line);
    rows.emplace_back();
    while (std::getline(cells, cell, ','))
      rows.back().push_back(std::strtod(cell.c_str(), nullptr));
  }
  return rows;
}

/// The least k that makes 2^k times each number an integer.
int binary_digits(const Rows& rows) {
  int digits = 0;
  for (const auto& row : rows) {
    for (const double x : row) {
      while (std::ldexp(x, digits) != std::nearbyint(std::ldexp(x, digits))) ++digits;
    }
  }
  return digits;
}

/// A coordinate as seen from the point's, rounded.
Filtered rounded(double x, double from) {
  return {x - from, std::fabs(x - from)};
}

/// The exact difference, in units of 2^-digits.
struct Exactly {
  int digits;
  mpz_class operator()(double x, double from) const {
    return mpz_class(std::ldexp(x, digits)) - mpz_class(std::ldexp(from, digits));
  }
};

/// Sets `vertices` to those of the simplex, of two or three coordinates, as seen from the point.
template <class N, class Seen>
void look(const std::vector<double>& simplex, const std::vector<double>& point,
          std::size_t dimensions, const Seen& seen, std::vector<Vertex<N>>& vertices) {
  vertices.clear();
  for (std::size_t k = 0; k < simplex.size(); k += dimensions) {
    vertices.push_back({seen(simplex[k], point[0]), seen(simplex[k + 1], point[1]),
                        dimensions == 3 ? seen(simplex[k + 2], point[2]) : seen(0, 0)});
  }
}

/// The signs of all comparisons, and how many of them GMP found.
struct Signs {
  std::vector<int> all;
  std::size_t again = 0;
};

template <class Predicate>
Signs signs_of(const Rows& simplices, const Rows& points) {
  Signs signs;
  signs.all.reserve(simplices.size() * points.size());
  std::vector<Vertex<Filtered>> near;
  std::vector<Vertex<mpz_class>> exact;
  const Exactly exactly{std::max(binary_digits(simplices), binary_digits(points))};
  for (const auto& simplex : simplices) {
    for (const auto& point : points) {
      look(simplex, point, Predicate::dimensions, rounded, near);
      const Filtered d = Predicate::determinant(near);
      if (std::fabs(d.value) > 0x1p-47 * d.magnitude) {
        signs.all.push_back(d.value > 0 ? 1 : -1);
        continue;
      }
      look(simplex, point, Predicate::dimensions, exactly, exact);
      signs.all.push_back(sgn(Predicate::determinant(exact)));
      ++signs.again;
    }
  }
  return signs;
}

const std::map<std::string, Signs (*)(const Rows&, const Rows&)> predicates = {
    {"orient2d", signs_of<Orient2d>},
    {"orient3d", signs_of<Orient3d>},
    {"incircle", signs_of<Incircle>},
    {"insphere", signs_of<Insphere>}};

}  // namespace

int main(int count, char** words) {
  if (count != 5 || !predicates.contains(words[1])) {
    std::fprintf(stderr,
                 "usage: filtered orient2d|orient3d|incircle|insphere SIMPLICES.csv "
                 "ATOMS.csv VERDICTS.csv\n");
    return 1;
  }
  const Rows simplices = read(words[2]), points = read(words[3]);
  Signs signs;
  double seconds = 1e9;
  for (int round = 0; round < 5; ++round) {
    const auto begin = std::chrono::steady_clock::now();
    signs = predicates.at(words[1])(simplices, points);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    seconds = std::min(seconds, taken.count());
  }
  std::ofstream verdicts(words[4]);
  verdicts << "i,j,verdict\n";
  for (std::size_t k = 0; k < signs.all.size(); ++k) {
    const int sign = signs.all[k];
    verdicts << k / points.size() << ',' << k % points.size() << ','
             << (sign > 0   ? "greater"
                 : sign < 0 ? "less"
                            : "equal")
             << '\n';
  }
  std::printf("%zu comparisons, %zu again in integers, %.1f M/s\n", signs.all.size(), signs.again,
              1e-6 * static_cast<double>(signs.all.size()) / seconds);
  return verdicts.flush() ? 0 : 1;
}
