#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace mixcmp::harness {

/// A port of a verilated model seen as bits: CData, SData, IData, QData and VlWide alike store
/// theirs from the lowest byte up (the host is little-endian, as is every machine we run on).
/// A port the system lacks is null and is never touched.
class Port {
public:
  Port() = default;
  template <class Storage>
  explicit Port(Storage& storage) : bytes_(reinterpret_cast<std::uint8_t*>(&storage)) {}

  std::uint8_t* bytes(std::size_t offset) { return bytes_ + offset; }
  const std::uint8_t* bytes(std::size_t offset) const { return bytes_ + offset; }

  bool bit(std::size_t index) const { return (bytes_[index / 8] >> (index % 8) & 1) != 0; }
  void set_bit(std::size_t index, bool value) { set_field(index, 1, value ? 1 : 0); }

  /// `width` bits from bit `offset` up, width <= 64.
  std::uint64_t field(std::size_t offset, int width) const {
    std::uint64_t value = 0;
    if (offset % 8 == 0 && width % 8 == 0) {
      std::memcpy(&value, bytes(offset / 8), static_cast<std::size_t>(width / 8));
      return value;
    }
    for (int done = 0; done < width;) {
      const int shift = static_cast<int>((offset + done) % 8);
      const int count = std::min(8 - shift, width - done);
      const std::uint64_t part = bytes_[(offset + done) / 8] >> shift & ((1u << count) - 1);
      value |= part << done;
      done += count;
    }
    return value;
  }

  void set_field(std::size_t offset, int width, std::uint64_t value) {
    if (offset % 8 == 0 && width % 8 == 0) {
      std::memcpy(bytes(offset / 8), &value, static_cast<std::size_t>(width / 8));
      return;
    }
    for (int done = 0; done < width;) {
      const int shift = static_cast<int>((offset + done) % 8);
      const int count = std::min(8 - shift, width - done);
      const unsigned mask = ((1u << count) - 1) << shift;
      std::uint8_t& byte = bytes_[(offset + done) / 8];
      byte = static_cast<std::uint8_t>((byte & ~mask) |
                                       (static_cast<unsigned>(value >> done << shift) & mask));
      done += count;
    }
  }

private:
  std::uint8_t* bytes_ = nullptr;
};

/// The AXI4-Lite port on which software reads the counters; null ports in systems without it.
struct CounterBus {
  Port awaddr, awvalid, awready, wdata, wstrb, wvalid, wready, bresp, bvalid, bready;
  Port araddr, arvalid, arready, rdata, rresp, rvalid, rready;
};

/// The ports of a generated system's top; each per-lane port is a vector, lane 0 lowest.
struct Ports {
  Port aclk, aresetn;
  Port s_axis_tvalid, s_axis_tready, s_axis_tdata, s_axis_tuser;
  Port m_axis_tvalid, m_axis_tready, m_axis_tdata, m_axis_tuser;
  Port comparisons, recomputations, stalls, answers;
  CounterBus bus;
  Port m_refetch_tvalid, m_refetch_tready, m_refetch_tdata;
  Port s_refetch_tvalid, s_refetch_tready, s_refetch_tdata;
};

/// The ports of a pairwise engine; m_axis and the counter of reports are vectors of the streams'.
struct PairwisePorts {
  Port aresetn;
  Port s_axis_tvalid, s_axis_tready, s_axis_tdata, s_axis_tuser, s_axis_tlast;
  Port m_axis_tvalid, m_axis_tready, m_axis_tdata, m_axis_tuser, m_axis_tlast;
  Port reports, recomputations, busy_cycles, stalled_cycles, answers;
  CounterBus bus;
};

/// The ports of an arg-min engine; the first three counters are vectors of the lanes'.
struct ArgMinPorts {
  Port aresetn;
  Port s_candidate_tvalid, s_candidate_tready, s_candidate_tdata, s_candidate_tlast;
  Port s_axis_tvalid, s_axis_tready, s_axis_tdata, s_axis_tuser, s_axis_tlast;
  Port m_axis_tvalid, m_axis_tready, m_axis_tdata, m_axis_tuser, m_axis_tlast;
  Port overrun;
  Port comparisons, recomputations, stalls, answers;
  Port rows, stalled_cycles;
  CounterBus bus;
};

}  // namespace mixcmp::harness
