#pragma once

#include <string>

#include "generator/software/float_filter.hpp"
#include "model/comparison/data/comparisons.hpp"

namespace mixcmp::software {

/// The columns of the data that the software reads, each once.
struct SoftwareColumns {
  std::vector<std::size_t> inputs;     ///< one per column of the data file: an input that reads it
  std::vector<std::size_t> of_inputs;  ///< one per input: index into the data file's columns
};
SoftwareColumns software_columns(const data::Comparisons& data);

/// Tells whether software_source has loops for data of this form. Comparisons of other data are
/// written out as rows.
bool has_software_loops(data::Pairing pairing);

/// Prints a program, one C++20 file for a POSIX system, that measures itself
/// (generator/software/program/harness.hpp says how to call it). It computes the scene's comparison
/// on doubles. For each filter it also computes it on floats, and on doubles if the filter does not
/// decide. A compiler can vectorise its loops. It must be compiled without contraction of
/// multiply-adds and without -ffast-math.
std::string software_source(const scene::Scene& scene, const data::Comparisons& data,
                            const FloatFilters& filters);

}  // namespace mixcmp::software
