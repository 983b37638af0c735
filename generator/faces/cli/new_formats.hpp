#pragma once

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "generator/faces/cli/options.hpp"
#include "model/comparison/expression/range.hpp"

/// The formats of a scene that `mixcmp new` writes, as its data suggest.
namespace mixcmp::cli {

struct NewFormats {
  std::string reference;
  std::map<std::string, std::string> operands =
      {};  ///< by input or pattern; others: the reference's
  /// Of all inputs in floating point, if references are in fixed point. The range of the data
  /// takes its place where there are some; else operands are drawn from it.
  std::optional<Range> range = {};
};

/// The range of an input's finite numbers in the data.
struct Numbers {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  bool are_whole = true;  ///< all of them are integers, and finite

  bool any() const { return low <= high; }
};

Numbers numbers_of(const data::Comparisons& data, std::size_t input);

/// The types of the numbers in the data's file, one per input; empty if it is text, or none.
std::vector<OperandFormat> types_of_data(const LoadedScene& loaded);

bool are_integers(const std::vector<OperandFormat>& types);
/// Floats of at most 24 digits.
bool are_single(const std::vector<OperandFormat>& types);

/// The narrowest integers that hold all numbers of the data; none if some are not whole, or beyond
/// 64 bits.
std::optional<OperandFormat> narrowest_integers(const LoadedScene& loaded);

/// Formats in which the data may arrive as integers, the best first: as in the file, then the
/// narrowest that holds all numbers. Empty if some number is not whole.
std::vector<NewFormats> integer_formats(const LoadedScene& loaded);

/// Whether lanes, references and `optimise` can take the integers in which a scene's operands
/// arrive.
Result<Done> check_integers(const scene::Scene& scene);

bool arrive_as_integers(const scene::Scene& scene);

}  // namespace mixcmp::cli
