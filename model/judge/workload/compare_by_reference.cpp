#include "model/judge/workload/compare_by_reference.hpp"

#include <memory>

#include "model/base/number/double.hpp"
#include "model/base/number/verdict.hpp"
#include "model/judge/emulator/emulator.hpp"
#include "model/judge/golden/fixed_evaluate.hpp"

namespace mixcmp::workload {
namespace {

/// Decides one comparison after the other in the golden model, for formats that double cannot hold.
void compare_by_golden_model(const fixed::ReferenceDatapath& reference,
                             const data::Comparisons& data, std::span<const data::Items> items,
                             std::span<std::uint8_t> greater) {
  std::vector<Bits> operands(data.input_count());
  for (std::size_t k = 0; k < items.size(); ++k) {
    data.fetch(items[k], operands);
    greater[k] = golden::evaluate_reference(reference, operands) == Verdict::greater ? 1 : 0;
  }
}

void compare_by_emulator(const emulator::Emulator& emulator, const data::Comparisons& data,
                         std::span<const data::Items> items, std::span<std::uint8_t> greater) {
  std::vector<std::vector<double>> columns(data.input_count(), std::vector<double>(items.size()));
  std::vector<const double*> pointers;
  for (const std::vector<double>& column : columns) pointers.push_back(column.data());
  std::vector<Bits> operands(data.input_count());
  for (std::size_t k = 0; k < items.size(); ++k) {
    data.fetch(items[k], operands);
    for (std::size_t input = 0; input < operands.size(); ++input) {
      columns[input][k] = to_double(data.format(), operands[input]);
    }
  }
  std::vector<Decision> decisions(items.size());
  emulator.decide(pointers, items.size(), decisions);
  for (std::size_t k = 0; k < items.size(); ++k) {
    greater[k] = decisions[k] == Decision::greater ? 1 : 0;
  }
}

}  // namespace

data::CompareItems compare_by_reference(const fixed::ReferenceDatapath& reference) {
  const FloatFormat format =
      std::visit([](const auto& made) { return made.input_format; }, reference);
  if (!fits_double(format)) {
    return [reference](const data::Comparisons& data, std::span<const data::Items> items,
                       std::span<std::uint8_t> greater) {
      compare_by_golden_model(reference, data, items, greater);
    };
  }
  return [emulator = std::make_shared<const emulator::Emulator>(reference)](
             const data::Comparisons& data, std::span<const data::Items> items,
             std::span<std::uint8_t> greater) {
    compare_by_emulator(*emulator, data, items, greater);
  };
}

}  // namespace mixcmp::workload
