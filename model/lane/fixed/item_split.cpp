#include "model/lane/fixed/item_split.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "model/base/common/check.hpp"

namespace mixcmp::fixed {
namespace {

/// The operands from which a node is computed: none (only constants), those of one role, or of
/// several.
struct Reads {
  std::optional<ItemRole> role = {};
  bool several = false;

  bool is_of_one() const { return role.has_value() && !several; }
};

Reads joined(const Reads& a, const Reads& b) {
  const bool differ = a.role && b.role && a.role != b.role;
  return {a.role ? a.role : b.role, a.several || b.several || differ};
}

/// [role]: the parts of all lanes for which an operand matters.
using Affected = std::array<std::set<std::pair<std::size_t, std::size_t>>, 3>;

/// A loader under construction.
struct Loading {
  /// The properties that all formats of one column's operand share, so that a coarser one is the
  /// upper bits of a finer one: the power of two that bounds the operand, and whether it is signed.
  /// Units differ. An operand with a promised grid is checked against that: it shares no other's
  /// bits. Encodings share bits only with encodings.
  struct Operand {
    int column;
    int top;
    bool is_signed;
    std::optional<int> grid_exponent;  ///< of an operand with a promised grid
    bool is_encoding;

    friend auto operator<=>(const Operand&, const Operand&) = default;
  };

  ItemLoader& made;
  std::map<Operand, FixedNode> finest = {};
  std::map<NodeId, Affected> affected = {};  ///< [input of the loader]
};

/// The nodes that a criterion reads, for renumbering.
std::vector<NodeId*> nodes_of(FixedPart& part) {
  std::vector<NodeId*> nodes = {&part.difference};
  if (auto* norm = std::get_if<NormThresholds>(&part.criterion)) nodes.push_back(&norm->radius);
  if (auto* running = std::get_if<RunningThresholds>(&part.criterion)) {
    for (NodeId& id : running->watched) nodes.push_back(&id);
  }
  return nodes;
}

class Splitter {
public:
  Splitter(const std::vector<const FixedLane*>& lanes, const std::vector<ItemInput>& inputs,
           const std::vector<std::string>& columns, const std::vector<std::string>& row_columns)
      : inputs_(inputs),
        split_{.items = empty_loader(*lanes.front(), columns),
               .rows = empty_loader(*lanes.front(), row_columns),
               .lanes = {}} {
    note_formats(*lanes.front());
    for (const FixedLane* lane : lanes) note_finest(*lane);
    for (const FixedLane* lane : lanes) split_.lanes.push_back(split_lane(*lane));
  }

  ItemSplit run() {
    make_flags();
    return std::move(split_);
  }

private:
  static ItemLoader empty_loader(const FixedLane& lane, const std::vector<std::string>& columns) {
    return {.lane = {.format = lane.format,
                     .nodes = {},
                     .input_names = columns,
                     .input_format = lane.input_format,
                     .parts = {}},
            .flags = {}};
  }

  /// Gives the loaders' columns the formats of the inputs that they hold.
  void note_formats(const FixedLane& lane) {
    if (lane.operand_formats.empty()) return;
    for (FixedLane* loader : {&split_.items.lane, &split_.rows.lane}) {
      loader->operand_formats.assign(loader->input_names.size(), OperandFormat(lane.input_format));
    }
    for (std::size_t input = 0; input < inputs_.size(); ++input) {
      FixedLane& loader = loading_of(inputs_[input].role).made.lane;
      loader.operand_formats[static_cast<std::size_t>(inputs_[input].column)] =
          lane.operand_formats[input];
    }
  }

  Loading& loading_of(ItemRole role) { return role == ItemRole::row ? rows_ : items_; }
  Loading& loading_of(const FixedNode& input) { return loading_of(inputs_[input.input].role); }

  Loading::Operand operand_of(const FixedNode& input) const {
    const FixedFormat& format = input.format;
    return {inputs_[input.input].column, format.unit_exponent + format.magnitude_bits(),
            format.is_signed,
            input.is_promised ? std::optional(format.unit_exponent) : std::nullopt,
            input.is_encoding};
  }

  void note_finest(const FixedLane& lane) {
    for (const FixedNode& node : lane.nodes) {
      if (node.operation != Operation::input) continue;
      std::map<Loading::Operand, FixedNode>& known = loading_of(node).finest;
      FixedNode& finest = known.emplace(operand_of(node), node).first->second;
      if (node.format.width > finest.format.width) finest = node;
      finest.input = inputs_[node.input].column;
    }
  }

  /// The rest of a lane. Its loaded inputs have no flags yet.
  FixedLane split_lane(const FixedLane& lane) {
    MIXCMP_CHECK(!lane.format.is_block);
    const std::vector<Reads> reads = reads_of(lane);
    FixedLane rest = lane;
    rest.nodes.clear();
    rest.input_names.clear();
    rest.operand_formats.clear();
    std::vector<NodeId> new_id(lane.nodes.size(), -1);
    for (const NodeId id : nodes_left(lane, reads)) {
      FixedNode node = lane.nodes[id];
      if (reads[id].is_of_one()) {
        node = loaded(lane, id, *reads[id].role, rest);
      } else {
        for (int k = 0; k < arity(node.operation); ++k) node.operands[k] = new_id[node.operands[k]];
      }
      rest.nodes.push_back(std::move(node));
      new_id[id] = static_cast<NodeId>(rest.nodes.size()) - 1;
    }
    for (FixedPart& part : rest.parts) {
      for (NodeId* id : nodes_of(part)) *id = new_id[*id];
    }
    note_affected(lane);
    return rest;
  }

  /// A checked node counts as read by several roles, so it stays in the lane of the pair: its check
  /// belongs to a part, not to an item.
  std::vector<Reads> reads_of(const FixedLane& lane) const {
    std::vector<Reads> reads;
    for (const FixedNode& node : lane.nodes) {
      Reads now;
      if (node.operation == Operation::input) now.role = inputs_[node.input].role;
      for (int k = 0; k < arity(node.operation); ++k) now = joined(now, reads[node.operands[k]]);
      now.several = now.several || is_checked(node) || is_common_cut(node);
      reads.push_back(now);
    }
    return reads;
  }

  /// The nodes of the rest of the lane, in order: those that its parts need and that do not belong
  /// to one item, and the nodes that these read.
  std::vector<NodeId> nodes_left(const FixedLane& lane, const std::vector<Reads>& reads) const {
    std::vector<bool> needed(lane.nodes.size(), false);
    for (FixedPart part : lane.parts) {
      for (const NodeId* id : nodes_of(part)) needed[*id] = true;
    }
    for (auto id = static_cast<NodeId>(lane.nodes.size()); id-- > 0;) {
      if (!needed[id] || reads[id].is_of_one()) continue;
      const FixedNode& node = lane.nodes[id];
      for (int k = 0; k < arity(node.operation); ++k) needed[node.operands[k]] = true;
    }
    std::vector<NodeId> left;
    for (NodeId id = 0; id < static_cast<NodeId>(lane.nodes.size()); ++id) {
      if (needed[id]) left.push_back(id);
    }
    return left;
  }

  /// The node that stands for a field of a word.
  FixedNode loaded(const FixedLane& lane, NodeId id, ItemRole role, FixedLane& rest) {
    Loading& loading = loading_of(role);
    const NodeId made =
        is_input(lane, id) ? finest_input(lane.nodes[id]) : loader_node(loading, lane, id);
    std::vector<NodeId>& fields = loading.made.lane.outputs;
    auto field = std::find(fields.begin(), fields.end(), made);
    if (field == fields.end()) field = fields.insert(fields.end(), made);
    FixedNode node = lane.nodes[id];
    node.operation = Operation::input;
    node.operands = {-1, -1};
    node.conversion = {};
    node.dropped_bits = 0;
    node.is_promised = node.is_encoding = false;  // the loader has made it
    node.input = static_cast<int>(rest.loaded_inputs.size());
    rest.loaded_inputs.push_back(
        {.role = role,
         .field = static_cast<std::size_t>(field - fields.begin()),
         .dropped_bits = loading.made.lane.nodes[made].format.width - node.format.width,
         .flags = {}});
    return node;
  }

  static bool is_input(const FixedLane& lane, NodeId id) {
    return lane.nodes[id].operation == Operation::input;
  }

  /// The node of the loader that computes the same from its columns as `id` does. Equal
  /// computations share one node.
  NodeId loader_node(Loading& loading, const FixedLane& lane, NodeId id) {
    FixedNode node = lane.nodes[id];
    if (node.operation == Operation::input) return upper_bits(loading, finest_input(node), node);
    for (int k = 0; k < arity(node.operation); ++k) {
      node.operands[k] = loader_node(loading, lane, node.operands[k]);
    }
    return add_once(loading, std::move(node));
  }

  NodeId finest_input(const FixedNode& input) {
    Loading& loading = loading_of(input);
    return add_once(loading, loading.finest.at(operand_of(input)));
  }

  /// The loader's node for the operand of `input` in the format of `input`: `finest`, or its upper
  /// bits.
  static NodeId upper_bits(Loading& loading, NodeId finest, const FixedNode& input) {
    const int dropped = loading.made.lane.nodes[finest].format.width - input.format.width;
    if (dropped == 0) return finest;
    FixedNode cut = input;
    cut.operation = Operation::convert;
    cut.operands = {finest, -1};
    cut.input = -1;
    cut.is_promised = cut.is_encoding = false;
    cut.conversion = Conversion::cut;
    cut.dropped_bits = dropped;
    return add_once(loading, std::move(cut));
  }

  static NodeId add_once(Loading& loading, FixedNode node) {
    std::vector<FixedNode>& nodes = loading.made.lane.nodes;
    const auto known = std::find(nodes.begin(), nodes.end(), node);
    if (known != nodes.end()) return static_cast<NodeId>(known - nodes.begin());
    nodes.push_back(std::move(node));
    return static_cast<NodeId>(nodes.size()) - 1;
  }

  /// Notes, for each loaded operand, the parts of this lane for which it matters.
  void note_affected(const FixedLane& lane) {
    const std::size_t number = split_.lanes.size();
    for (std::size_t part = 0; part < lane.parts.size(); ++part) {
      for (const NodeId id : fan_in(lane, lane.parts[part].difference)) {
        const FixedNode& node = lane.nodes[id];
        if (node.operation != Operation::input || is_read_as_it_arrives(lane, node)) continue;
        const auto role = static_cast<std::size_t>(inputs_[node.input].role);
        loading_of(node).affected[finest_input(node)][role].emplace(number, part);
      }
    }
  }

  void make_flags() {
    for (Loading* loading : {&items_, &rows_}) make_flags(*loading);
  }

  /// One flag for all operands that matter for the same parts.
  void make_flags(Loading& loading) {
    std::vector<std::vector<NodeId>>& flags = loading.made.flags;
    std::map<Affected, std::size_t> known;
    std::map<NodeId, std::size_t> flag_of;  // [input of the loader]
    for (const auto& [input, affected] : loading.affected) {
      const auto flag = known.emplace(affected, flags.size()).first->second;
      if (flag == flags.size()) flags.emplace_back();
      flags[flag].push_back(input);
      flag_of[input] = flag;
    }
    for (FixedLane& lane : split_.lanes) {
      for (LoadedInput& loaded : lane.loaded_inputs) {
        if (&loading_of(loaded.role) == &loading) note_flags(loading.made.lane, flag_of, loaded);
      }
    }
  }

  static void note_flags(const FixedLane& loader, const std::map<NodeId, std::size_t>& flag_of,
                         LoadedInput& loaded) {
    std::set<std::size_t> flags;
    for (const NodeId id : fan_in(loader, loader.outputs[loaded.field])) {
      const auto flag = flag_of.find(id);
      if (flag != flag_of.end()) flags.insert(flag->second);
    }
    loaded.flags.assign(flags.begin(), flags.end());
  }

  const std::vector<ItemInput>& inputs_;
  ItemSplit split_;
  Loading items_{split_.items};
  Loading rows_{split_.rows};
};

}  // namespace

ItemSplit split_by_item(const std::vector<const FixedLane*>& lanes,
                        const std::vector<ItemInput>& inputs,
                        const std::vector<std::string>& columns,
                        const std::vector<std::string>& row_columns) {
  return Splitter(lanes, inputs, columns, row_columns).run();
}

std::vector<LoadedFlag> flags_read(const FixedLane& lane) {
  std::set<LoadedFlag> flags;
  for (const LoadedInput& loaded : lane.loaded_inputs) {
    for (const std::size_t flag : loaded.flags) flags.insert({loaded.role, flag});
  }
  return {flags.begin(), flags.end()};
}

}  // namespace mixcmp::fixed
