#include "generator/rtl/part_decision.hpp"

#include <fmt/core.h>

#include "generator/rtl/net_names.hpp"

namespace mixcmp::rtl {
namespace {

/// Concatenates one signal of every part, delayed to `cycle`; part 0 is in the lowest bits.
Operand gathered(DatapathBuilder& datapath, const std::vector<PartDecision>& parts,
                 Signal PartDecision::*signal, int cycle) {
  std::vector<Operand> fields;
  for (const PartDecision& part : parts) fields.push_back(datapath.at(part.*signal, cycle));
  return concatenation({fields.rbegin(), fields.rend()});
}

}  // namespace

PartDecision begin_decision(DatapathBuilder& datapath, const datapath::Step& step, std::size_t part,
                            std::size_t parts, Decides decides, std::string_view what) {
  const bool alone = parts == 1;
  datapath.add(Comment{fmt::format("Cycles {} to {}: {}{}", step.start_cycle, step.ready_cycle,
                                   alone ? "" : fmt::format("part {}, ", part), what)});
  const auto output = [&](const char* name, int width) {
    const std::string wire = alone ? name : datapath.pool().unique(name + part_suffix(part, parts));
    if (!alone) datapath.add(Wire{width, wire, nullptr});
    return Signal{net(wire), wire, width, step.ready_cycle};
  };
  PartDecision decision{
      .instance =
          alone ? "decision" : datapath.pool().unique("decision" + part_suffix(part, parts)),
      .verdict = output("verdict", 2),
      .decided = {}};
  if (decides == Decides::sometimes) decision.decided = output("decided", 1);
  return decision;
}

void build_combination(DatapathBuilder& datapath, Combination combination,
                       const std::vector<PartDecision>& parts, const datapath::Step& step) {
  if (parts.size() == 1) return;
  const bool any = combination == Combination::any;
  const int count = static_cast<int>(parts.size());
  const bool reference = parts.front().decided.value == nullptr;
  const Operand verdicts = gathered(datapath, parts, &PartDecision::verdict, step.start_cycle);
  const Operand known = reference
                            ? literal(count, low_mask(count))
                            : gathered(datapath, parts, &PartDecision::decided, step.start_cycle);
  datapath.add(Comment{fmt::format("Cycles {} to {}: less if {}.", step.start_cycle,
                                   step.ready_cycle, any ? "any part is" : "all parts are")});
  const std::string decided = reference ? datapath.pool().unique("unused_decided") : "decided";
  if (reference) datapath.add(Wire{1, decided, nullptr});
  datapath.add(Instance{step.unit.module,
                        datapath.pool().unique("combination"),
                        {{"PARTS", count}, {"ANY", any ? 1 : 0}, {"CUTS", cut_mask(step)}},
                        {{"aclk", net("aclk")},
                         {"verdicts", verdicts},
                         {"known", known},
                         {"verdict", net("verdict")},
                         {"decided", net(decided)}}});
}

}  // namespace mixcmp::rtl
