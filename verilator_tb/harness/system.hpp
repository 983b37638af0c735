#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

/// The numbers of the system under test. The source with its model defines those that its kind of
/// harness reads (system_model.hpp, which is generated), so that the harness itself is compiled
/// only once for all systems.
namespace mixcmp::harness::system {

extern const int lanes;
extern const int counter_bits;             ///< 0: there are no counters
extern const std::size_t counted_answers;  ///< references whose answers are counted

/// Counters of one name on the AXI4-Lite port.
struct MappedCounters {
  int count;
  int offset;           ///< the address of the first one
  std::uint8_t* bytes;  ///< where the harness stores what it reads
  std::size_t size;
};
extern const std::span<const MappedCounters> counter_map;
extern const int counter_address_bits;

// Systems of streams.
extern const int refetch_streams;
extern const int lanes_per_group;
extern const int groups;
extern const int tdata_bytes;  ///< of the operands of one lane
extern const int slots;
extern const bool in_order;

// Engines.
extern const int item_bytes;
extern const int index_bits;
extern const int output_streams;
extern const int report_bytes;  ///< pairwise: of a stream's tdata
extern const int flag_bits;     ///< pairwise: of a bitmap in a report
extern const int row_bytes;     ///< arg-min

// Systems of streams and arg-min engines.
extern const int tag_bits;

}  // namespace mixcmp::harness::system
