#include "model/plan/optimise/integer_program.hpp"

#include <fmt/format.h>

namespace mixcmp::optimise {
namespace {

using Relation = IntegerProgram::Relation;

const char* symbol(Relation relation) {
  switch (relation) {
    case Relation::at_most: return "<=";
    case Relation::equal: return "=";
    case Relation::at_least: return ">=";
  }
  return "";
}

/// Prints one term per line: the LP format limits a line to 255 characters.
std::string to_text(const IntegerProgram& program, const IntegerProgram::Sum& sum) {
  std::string text;
  for (const auto& [column, coefficient] : sum) {
    text += fmt::format("  {:+.17g} {}\n", coefficient, program.columns[column].name);
  }
  return text;
}

}  // namespace

int IntegerProgram::add_column(const std::string& name, int lower, int upper) {
  columns.push_back({name, lower, upper});
  return static_cast<int>(columns.size()) - 1;
}

void IntegerProgram::add_row(const std::string& name, Sum sum, Relation relation, double bound) {
  std::erase_if(sum, [](const Term& term) { return term.coefficient == 0; });
  if (!sum.empty()) rows.push_back({name, std::move(sum), relation, bound});
}

std::string to_lp(const IntegerProgram& program) {
  std::string text;
  for (const std::string& comment : program.comments) text += "\\ " + comment + "\n";
  text += "Maximize\n objective:\n" + to_text(program, program.objective);
  text += "Subject To\n";
  for (const IntegerProgram::Row& row : program.rows) {
    text += fmt::format(" {}:\n{}  {} {:.17g}\n", row.name, to_text(program, row.sum),
                        symbol(row.relation), row.bound);
  }
  text += "Bounds\n";
  for (const IntegerProgram::Column& column : program.columns) {
    text += fmt::format(" {} <= {} <= {}\n", column.lower, column.name, column.upper);
  }
  text += "General\n";
  for (const IntegerProgram::Column& column : program.columns) text += " " + column.name + "\n";
  return text + "End\n";
}

}  // namespace mixcmp::optimise
