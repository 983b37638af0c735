// @BUILD_TOP@: its counters, as software reads them over AXI4-Lite.
//
@PROVENANCE@

#ifndef @NAME@_COUNTERS_H
#define @NAME@_COUNTERS_H

#include <stdint.h>

// Where the counters of each kind begin, in bytes behind the port's base address, and how many
// there are.
@KINDS@
@IF GROUPED@
// So many lanes form a group in lock step. Comparisons, recomputations and stalls are counted for
// each group: comparisons in words of one for each lane, recomputations one by one. The share of
// comparisons that is recomputed is
//   recomputations / (comparisons * @NAME@_LANES_PER_GROUP).
#define @NAME@_LANES_PER_GROUP @LANES_PER_GROUP@

@END@
// Counts wrap at so many bits.
#define @NAME@_COUNTER_BITS @COUNTER_BITS@

// Reads counter k of the kind at `offset`. `base`: where the port is mapped, aligned to 4 bytes.
// The low word comes first: it makes the port keep the high word that belongs to it. So no two
// threads may read at once.
static inline uint64_t @BUILD_TOP@_count(
    const volatile void *base, uint32_t offset, uint32_t k) {
  const volatile uint32_t *const word = (const volatile uint32_t *)base + offset / 4 + 2 * k;
  const uint64_t low = word[0];
  const uint64_t high = word[1];
  return high << 32 | low;
}

// What was counted between two reads, whether or not the counter wrapped once.
static inline uint64_t @BUILD_TOP@_counted(uint64_t before, uint64_t after) {
  return (after - before) & (UINT64_MAX >> (64 - @NAME@_COUNTER_BITS));
}

#endif
