#pragma once

#include <string>
#include <vector>

#include "generator/hardware/datapath/schedule.hpp"
#include "generator/present/page/pipeline.hpp"
#include "model/comparison/expression/typed_graph.hpp"

namespace mixcmp::schematic {

/// Collects the boxes of a datapath: first those of its nodes, in their order, then those of its
/// decisions. A node without a box, such as a constant, has the number `none`; it is left out
/// wherever it is an operand.
class PipelineMaker {
public:
  static constexpr int none = -1;

  struct Box {
    std::string title;
    std::string format = {};   ///< of the result; may be empty
    std::string meaning = {};  ///< a line for the tip; may be empty
    page::UnitRole role = page::UnitRole::arithmetic;
  };

  /// `nodes` and `inputs` are for texts only, so the nodes' formats are of no importance.
  PipelineMaker(std::vector<TypedNode> nodes, std::vector<std::string> inputs,
                const datapath::Schedule& schedule)
      : nodes_(std::move(nodes)), inputs_(std::move(inputs)), schedule_(schedule) {}

  /// The expression below a node, if it is short, else the word of its operation.
  std::string title_of(NodeId node) const;
  /// The expression below a node, cut where it is too long for a tip.
  std::string meaning_of(NodeId node) const;
  const std::string& name_of(int input) const { return inputs_[static_cast<std::size_t>(input)]; }

  /// An operand of the comparison, there from cycle 0 on.
  int add_input(int input, const std::string& format);
  int add(const Box& box, const datapath::Step& step, const std::vector<int>& operands);
  /// Takes `box` as that of the next node.
  void add_node(int box) { boxes_.push_back(box); }
  /// Adds the next node's box, which has its meaning.
  void add_node(const std::string& title, const std::string& format,
                const std::vector<int>& operands);
  /// Adds the box that decides the next part.
  void add_decision(const std::string& format, const std::string& meaning,
                    const std::vector<int>& operands);

  /// The boxes of the nodes that a step reads.
  std::vector<int> read_by(const datapath::Step& step) const;

  /// All parts are decided: adds the combination of their decisions, if there are several.
  page::Pipeline finish(const std::string& title, Combination combination);

private:
  std::vector<TypedNode> nodes_;
  std::vector<std::string> inputs_;
  const datapath::Schedule& schedule_;
  std::vector<int> boxes_;      ///< [node]
  std::vector<int> decisions_;  ///< [part]
  page::Pipeline pipeline_;
};

}  // namespace mixcmp::schematic
