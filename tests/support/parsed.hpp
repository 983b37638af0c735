#pragma once

#include <string>
#include <utility>
#include <vector>

#include "model/comparison/expression/parser.hpp"

/// What expressions are parsed to.
namespace mixcmp::test {

using Inputs = std::vector<std::pair<std::string, mpq_class>>;

/// The value of a node by exact rationals; square roots and functions are not evaluated.
mpq_class evaluate(const Graph& graph, NodeId id, const Inputs& inputs);

/// The value of a text.
mpq_class value_of(const std::string& text, const Inputs& inputs = {},
                   const std::vector<LetDefinition>& lets = {});

/// The mistake in a text.
Error error_of(const std::string& text, const std::vector<LetDefinition>& lets = {});

/// How many nodes have an operation.
int count(const Graph& graph, Operation operation);

}  // namespace mixcmp::test
