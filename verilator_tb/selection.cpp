#include "verilator_tb/selection.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "model/base/common/counter_random.hpp"

namespace mixcmp::verilator_tb {

namespace {

std::uint64_t selected(std::uint64_t available, const Selection::Options& options) {
  if (options.only) return *options.only < available ? 1 : 0;
  const std::uint64_t left = available - std::min(options.start, available);
  return options.limit == 0 ? left : std::min(options.limit, left);
}

}  // namespace

Selection::Selection(std::uint64_t available, const Options& options)
    : available_(available),
      options_(options),
      whole_size_(selected(available, options)),
      size_(whole_size_) {}

Selection Selection::part(std::uint64_t first, std::uint64_t count) const {
  MIXCMP_CHECK(first <= size_ && count <= size_ - first);
  Selection part = *this;
  part.first_ = first_ + first;
  part.size_ = count;
  return part;
}

std::uint64_t Selection::stratum_start(std::uint64_t position) const {
  return static_cast<std::uint64_t>(Bits{available_} * position / whole_size_);
}

std::uint64_t Selection::index(std::uint64_t position) const {
  MIXCMP_CHECK(position < size_);
  const std::uint64_t in_whole = first_ + position;
  if (options_.only) return *options_.only;
  if (options_.sampling == Sampling::first) return options_.start + in_whole;
  const std::uint64_t start = stratum_start(in_whole);
  return start + counter_random(options_.seed, in_whole) % (stratum_start(in_whole + 1) - start);
}

void pack_operands(std::span<const Bits> operands, FloatFormat encoding,
                   std::span<const OperandFormat> formats, bool padding,
                   std::span<std::uint8_t> tdata) {
  std::size_t at = 0;
  Bits waiting = 0;  // the bits that are not in tdata yet
  int count = 0;     // of them, below 64
  const auto put = [&](Bits bits, int bit_count) {
    waiting |= bits << count;
    count += bit_count;
    if (count < 64) return;
    const auto word = static_cast<std::uint64_t>(waiting);
    std::memcpy(&tdata[at], &word, sizeof word);  // the host is little-endian
    at += sizeof word;
    waiting >>= 64;
    count -= 64;
  };
  for (std::size_t k = 0; k < operands.size(); ++k) {
    const Bits word = formats[k].word_of(encoding, operands[k]);
    const int width = formats[k].width(), low = std::min(width, 64);
    put(word & low_mask(low), low);
    put(word >> low, width - low);
  }
  const Bits ones = padding ? ~Bits{0} : 0;
  waiting |= ones << count;
  for (; at < tdata.size(); ++at) {
    tdata[at] = static_cast<std::uint8_t>(waiting);
    waiting = waiting >> 8 | ones << 120;
  }
}

std::vector<std::uint8_t> stimulus(const data::Comparisons& comparisons, const Selection& selection,
                                   const emit::Signature& signature, std::uint64_t first,
                                   std::uint64_t count) {
  const auto bytes = static_cast<std::size_t>(signature.tdata_bytes);
  std::vector<std::uint8_t> packed(bytes * count);
  std::vector<Bits> operands(comparisons.input_count());
  for (std::uint64_t k = 0; k < count; ++k) {
    comparisons.fetch(selection.index(first + k), operands);
    pack_operands(operands, signature.reference_format, signature.input_formats,
                  (first + k) % 2 != 0, std::span(packed).subspan(bytes * k, bytes));
  }
  return packed;
}

}  // namespace mixcmp::verilator_tb
