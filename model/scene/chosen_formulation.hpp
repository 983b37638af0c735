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

/// Reads [reference]. A comparison that no reference can compute as it is written is replaced by
/// the first move that one can compute, which a note names: roots and quotients of integers have no
/// exact reference, their squares and products have.
Result<ReferenceSpec> read_possible_reference(const settings::Settings& settings,
                                              const Formulations& formulations,
                                              std::span<const Graph> graphs,
                                              const InputDeclarations& declared,
                                              ComparisonSpec& comparison,
                                              std::vector<std::string>& notes);

/// Puts the move that comparison.variant names into the place of its comparison. Returns the names
/// of all variants or, in a scene without [[variant]], of all moves. Moves are those which the
/// reference can compute without an exceptional event that the reference of [comparison] is free
/// of. `operand_formats`: one for each input.
Result<std::vector<std::string>> settle_move(const settings::Settings& settings,
                                             const Formulations& formulations,
                                             const ReferenceSpec& reference,
                                             const InputDeclarations& declared,
                                             std::span<const OperandFormat> operand_formats,
                                             ComparisonSpec& comparison,
                                             std::vector<std::string>& notes);

}  // namespace mixcmp::scene
