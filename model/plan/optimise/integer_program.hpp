#pragma once

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

/// Runs CBC: returns the value of each column at the largest objective, or none if the program is
/// infeasible. Rows hold within CBC's tolerances. A caller that needs them exactly checks the
/// point.
std::optional<std::vector<int>> solve(const IntegerProgram& program);

/// The program in the LP format, which CBC, GLPK and SCIP read.
std::string to_lp(const IntegerProgram& program);

}  // namespace mixcmp::optimise
