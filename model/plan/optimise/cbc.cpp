#include <Cbc_C_Interface.h>

#include <cmath>
#include <limits>
#include <memory>

#include "model/base/common/check.hpp"
#include "model/plan/optimise/integer_program.hpp"

namespace mixcmp::optimise {
namespace {

using Relation = IntegerProgram::Relation;

struct DeleteModel {
  void operator()(Cbc_Model* model) const { Cbc_deleteModel(model); }
};
using Model = std::unique_ptr<Cbc_Model, DeleteModel>;

char sense(Relation relation) {
  switch (relation) {
    case Relation::at_most: return 'L';
    case Relation::equal: return 'E';
    case Relation::at_least: return 'G';
  }
  MIXCMP_CHECK(false);
}

void add_columns(Cbc_Model* model, const IntegerProgram& program) {
  std::vector<double> objective(program.columns.size(), 0.0);
  for (const auto& [column, coefficient] : program.objective) objective[column] += coefficient;
  for (std::size_t k = 0; k < program.columns.size(); ++k) {
    const IntegerProgram::Column& column = program.columns[k];
    Cbc_addCol(model, column.name.c_str(), column.lower, column.upper, objective[k], 1, 0, nullptr,
               nullptr);
  }
}

void add_rows(Cbc_Model* model, const IntegerProgram& program) {
  for (const IntegerProgram::Row& row : program.rows) {
    std::vector<int> columns;
    std::vector<double> coefficients;
    for (const auto& [column, coefficient] : row.sum) {
      columns.push_back(column);
      coefficients.push_back(coefficient);
    }
    Cbc_addRow(model, row.name.c_str(), static_cast<int>(columns.size()), columns.data(),
               coefficients.data(), sense(row.relation), row.bound);
  }
}

Model make_model(const IntegerProgram& program, const Effort& effort) {
  Model model(Cbc_newModel());
  Cbc_setLogLevel(model.get(), 0);
  // Programs are small, and most take a fraction of the time without these. Of the cuts only those
  // by rounding pay: without them some proofs that no plan has one lane more take many nodes.
  for (const char* step : {"preprocess", "heuristics", "cuts"}) {
    Cbc_setParameter(model.get(), step, "off");
  }
  Cbc_setParameter(model.get(), "mixedIntegerRoundingCuts", "on");
  // CBC's depth-first search does not count its nodes.
  if (effort.nodes != Effort().nodes) Cbc_setParameter(model.get(), "depthMiniBab", "-1000");
  Cbc_setAllowableGap(model.get(), 0);
  Cbc_setAllowableFractionGap(model.get(), effort.may_lose);
  Cbc_setMaximumNodes(model.get(), effort.nodes);
  add_columns(model.get(), program);
  add_rows(model.get(), program);
  Cbc_setObjSense(model.get(), -1);  // maximise
  return model;
}

}  // namespace

Solution solve(const IntegerProgram& program, const Effort& effort) {
  const Model model = make_model(program, effort);
  Cbc_solve(model.get());
  // A search that is cut short without a point is also called infeasible.
  Solution solution{.point = {}, .is_proven = Cbc_isNodeLimitReached(model.get()) == 0};
  if (Cbc_isProvenInfeasible(model.get())) return solution;
  MIXCMP_CHECK(!solution.is_proven || Cbc_isProvenOptimal(model.get()));
  const double* best = Cbc_bestSolution(model.get());
  if (best == nullptr) return solution;
  solution.point.emplace();
  for (std::size_t k = 0; k < program.columns.size(); ++k) {
    solution.point->push_back(static_cast<int>(std::lround(best[k])));
  }
  return solution;
}

}  // namespace mixcmp::optimise
