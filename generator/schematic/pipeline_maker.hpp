#pragma once

#include <string>
#include <vector>

#include "generator/datapath/schedule.hpp"
#include "generator/page/pipeline.hpp"
#include "model/expression/typed_graph.hpp"

namespace mixcmp::schematic {

/// Collects the boxes of a pipeline. A node without a box, such as a constant, has the number
/// `none`; it is left out wherever it is an operand.
class PipelineMaker {
public:
  static constexpr int none = -1;

  struct Box {
    std::string title;
    std::string format;   ///< of the result; may be empty
    std::string meaning;  ///< a line for the tip; may be empty
    page::UnitRole role = page::UnitRole::arithmetic;
  };

  /// An operand of the comparison, there from cycle 0 on.
  int add_input(const std::string& name, const std::string& format);
  int add(const Box& box, const datapath::Step& step, const std::vector<int>& operands);

  /// The units that all parts share are there: adds the combination of the parts' decisions, if
  /// there are several.
  page::Pipeline finish(const std::string& title, const datapath::Schedule& schedule,
                        const std::vector<int>& decisions, Combination combination);

private:
  page::Pipeline pipeline_;
};

/// The expression below a node, if it is short, else the word of its operation.
std::string title_of(const std::vector<TypedNode>& nodes, const std::vector<std::string>& inputs,
                     NodeId node);
/// The expression below a node, cut where it is too long for a tip.
std::string meaning_of(const std::vector<TypedNode>& nodes, const std::vector<std::string>& inputs,
                       NodeId node);
/// "decide", with the number of the part if there are several.
std::string decision_title(std::size_t part, std::size_t parts);

}  // namespace mixcmp::schematic
