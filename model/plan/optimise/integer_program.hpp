#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace mixcmp::optimise {

/// A linear program over integers: maximise a sum of columns subject to rows and bounds.
struct IntegerProgram {
  struct Column {
    std::string name;
    int lower = 0;
    int upper = 0;
  };
  struct Term {
    int column;
    double coefficient;
  };
  using Sum = std::vector<Term>;
  enum class Relation { at_most, equal, at_least };
  struct Row {
    std::string name;
    Sum sum;
    Relation relation;
    double bound;
  };

  std::vector<std::string> comments;  ///< for the reader of an LP file
  std::vector<Column> columns;
  std::vector<Row> rows;
  Sum objective;  ///< to be maximised

  int add_column(const std::string& name, int lower, int upper);
  /// Drops terms with coefficient 0. A row without any other term is not added; the caller ensures
  /// that it holds.
  void add_row(const std::string& name, Sum sum, Relation relation, double bound);
};

/// How far programs are solved. By default until an optimum is proven.
struct Effort {
  double may_lose = 0;  ///< the fraction of the largest objective that a point may lack
  int nodes = std::numeric_limits<int>::max();  ///< of the search tree
};

struct Solution {
  std::optional<std::vector<int>> point;  ///< the value of each column; none was found: none
  bool is_proven = true;                  ///< no point is better, up to Effort::may_lose
};

/// Runs CBC. Rows hold within CBC's tolerances: a caller that needs them exactly checks the point.
Solution solve(const IntegerProgram& program, const Effort& effort = {});

/// The program in the LP format, which CBC, GLPK and SCIP read.
std::string to_lp(const IntegerProgram& program);

}  // namespace mixcmp::optimise
