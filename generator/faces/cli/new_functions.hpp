#pragma once

#include <map>
#include <string>

#include "generator/faces/cli/new_formats.hpp"
#include "model/comparison/expression/range.hpp"

/// The formats of a scene with functions, which only fixed point has, for `mixcmp new`.
namespace mixcmp::cli {

/// The range of each input, where there are no data: a place in which the user writes the one that
/// hardware meets. Logarithms have bounds there, and so have most functions.
Range assumed_range();

/// The formats in which operands arrive, by input: those of the data's file or, from text, binary32
/// or, if that would not keep a whole number of the data, binary64.
std::map<std::string, std::string> function_operands(const LoadedScene& loaded);

/// "q36": the fewest bits, of several choices, with which references err by less than 2^-24 of the
/// larger side of the comparison. If none has so small an error, as beside a logarithm of numbers
/// near 0, the most bits that the functions' tables allow. Errors are those of references with
/// that many bits.
Result<std::string> function_reference(const LoadedScene& loaded);

}  // namespace mixcmp::cli
