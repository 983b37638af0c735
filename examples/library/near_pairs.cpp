/// Which of a thousand points lie nearer than 1/8 to each other? Prints how many comparisons each
/// precision leaves to a reference, and writes the Verilog of a system in the precision given.

#include <cstdlib>
#include <iostream>
#include <mixcmp/mixcmp.hpp>
#include <random>
#include <string>
#include <vector>

namespace {

using mixcmp::api::Answer;
using mixcmp::api::Profile;
using mixcmp::api::Scene;
using mixcmp::api::System;
using mixcmp::api::Verdict;

constexpr const char* scene_text = R"(
[comparison]
name = "near_pairs"
f = "(ax - bx)^2 + (ay - by)^2"
g = "r^2"

[inputs]
"a*" = { range = [0, 1] }
"b*" = { range = [0, 1] }
r = { range = [0, 1] }

[reference]
format = "s53e8"

[reduced]
format = "s12e8"

[system]
lanes = 4
references = 1
)";

/// Operands of the comparisons of all pairs, in the order of the scene's inputs: ax, bx, ay, by, r.
std::vector<double> all_pairs(std::size_t points, double radius) {
  std::mt19937_64 random(1);
  std::vector<double> x(points), y(points);
  for (std::size_t k = 0; k < points; ++k) {
    x[k] = static_cast<double>(random() >> 11) * 0x1p-53;
    y[k] = static_cast<double>(random() >> 11) * 0x1p-53;
  }
  std::vector<double> rows;
  for (std::size_t i = 0; i < points; ++i) {
    for (std::size_t j = i + 1; j < points; ++j) {
      rows.insert(rows.end(), {x[i], x[j], y[i], y[j], radius});
    }
  }
  return rows;
}

void print_profile(const Profile& profile) {
  for (const mixcmp::api::Scheme& scheme : profile.schemes) {
    if (scheme.name != "relative") continue;
    for (const mixcmp::api::Counts& counts : scheme.counts) {
      std::cout << counts.precision << " digits: " << counts.undecided << " of "
                << profile.comparisons << " recomputed, " << counts.wrong_by_lane
                << " decided wrongly\n";
    }
  }
}

void run(const std::string& format, const std::string& folder) {
  const Scene scene = Scene::from_text(scene_text, {"reduced.format=" + format});
  const std::vector<double> rows = all_pairs(1000, 0.125);
  print_profile(mixcmp::api::profile(scene.with_operands(rows),
                                     {.first_precision = 8, .last_precision = 12}));
  const System system(scene);
  std::size_t near = 0, recomputed = 0;
  for (const Answer answer : system.emulate(rows)) {
    near += answer.verdict() == Verdict::less;
    recomputed += answer.is_recomputed();
  }
  std::cout << system.top() << ": " << near << " pairs are near, " << recomputed
            << " comparisons recomputed\n";
  system.write(folder);
  std::cout << system.files().size() << " files in " << folder << "\n";
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: near_pairs FORMAT FOLDER, such as: near_pairs s12e8 rtl\n";
    return EXIT_FAILURE;
  }
  try {
    run(argv[1], argv[2]);
  } catch (const mixcmp::api::Error& error) {
    std::cerr << "near_pairs: " << error.what() << "\n";
    return EXIT_FAILURE;
  }
}
