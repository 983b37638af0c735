#pragma once

#include "model/scene/sections.hpp"
#include "model/scene/variant.hpp"

/// Which formulation of the comparison is taken: [comparison] as it is written, a [[variant]], or a
/// move that mixcmp finds by itself.
namespace mixcmp::scene {

/// Reads [comparison] or the chosen [[variant]], and checks the other variants for mistakes. Notes
/// name the lets that no formulation uses; `graphs` gets the graph of each formulation.
Result<ComparisonSpec> read_formulation(const Formulations& formulations,
                                        std::span<const LetDefinition> lets,
                                        std::vector<std::string>& notes,
                                        std::vector<Graph>& graphs);

/// Refuses constants that the reference's format cannot hold at all, and sums that a fused
/// reference cannot add; notes constants that the format only approximates.
Result<Done> check_reference_holds(const settings::Settings& settings, const Graph& graph,
                                   const ReferenceSpec& reference, std::vector<std::string>& notes);

/// Reads [reference]. If no reference can compute [comparison], the first move that has one
/// replaces it, with a note: roots of integers have no exact reference, squares have.
Result<ReferenceSpec> read_possible_reference(const settings::Settings& settings,
                                              const Formulations& formulations,
                                              std::span<const Graph> graphs,
                                              const InputDeclarations& declared,
                                              ComparisonSpec& comparison,
                                              std::vector<std::string>& notes);

/// Replaces the comparison by the move that comparison.variant names. Returns the names of all
/// variants or, in a scene without [[variant]], of all moves whose reference adds no kind of
/// exceptional event. `operand_formats`: one for each input.
Result<std::vector<std::string>> settle_move(const settings::Settings& settings,
                                             const Formulations& formulations,
                                             const ReferenceSpec& reference,
                                             const InputDeclarations& declared,
                                             std::span<const OperandFormat> operand_formats,
                                             ComparisonSpec& comparison,
                                             std::vector<std::string>& notes);

}  // namespace mixcmp::scene
