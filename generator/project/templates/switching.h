// @NAME@: which of its plans to load, decided by what the loaded one counts.
//
@PROVENANCE@
//
@PLANS_TEXT@
//
// To be called after each reading of the counters, in seconds or fractions of a second:
//
//   struct @PREFIX@_switching state = @GUARD@_SWITCHING_START;    // plan 1 is loaded
//   ...
//   if (@PREFIX@_next_plan(&state, comparisons, recomputations) != loaded) // load it
//
// @COMPARISONS_TEXT@
// Both count since the last call, and from 0 after a reconfiguration.

#ifndef @GUARD@_SWITCHING_H
#define @GUARD@_SWITCHING_H

#include <stdint.h>

#define @GUARD@_PLANS @PLANS@
#define @GUARD@_RECONFIGURATION_SECONDS @RECONFIGURATION_SECONDS@

struct @PREFIX@_switching {
  int loaded;                      // plan_1.toml is 1
  double ahead_seconds[@PLANS@];   // how far each plan would be ahead of the loaded one
};

#define @GUARD@_SWITCHING_START {1, {0}}

// The plan to load. It is another one than before if that would by now have gained the seconds of a
// reconfiguration.
static inline int @PREFIX@_next_plan(
    struct @PREFIX@_switching *state, uint64_t comparisons, uint64_t recomputations) {
  // Recomputation rates that a plan counts on known data, and the seconds that each plan takes for
  // a comparison there.
  static const struct {
    double rate;
    double seconds[@PLANS@];
  } points[] = {
@C_POINTS@
  };
  // Those of plan k are from first[k - 1] to before first[k].
  static const int first[] = {@FIRST_POINTS@};
  // Comparisons that a plan's counters count as one.
  static const int comparisons_of_word[] = {@COMPARISONS_OF_WORD@};

  const int loaded = state->loaded - 1;
  if (comparisons == 0) return state->loaded;
  const double count = (double)(comparisons * (uint64_t)comparisons_of_word[loaded]);
  const double rate = (double)recomputations / count;
  int high = first[loaded];
  while (high < first[loaded + 1] && points[high].rate <= rate) ++high;
  int low = high - 1;
  if (high == first[loaded]) low = high;
  if (high == first[loaded + 1]) high = low;
  const double part =
      low == high ? 0 : (rate - points[low].rate) / (points[high].rate - points[low].rate);

  double seconds[@PLANS@];
  for (int k = 0; k < @PLANS@; ++k) {
    seconds[k] = points[low].seconds[k] + part * (points[high].seconds[k] - points[low].seconds[k]);
  }
  int best = loaded;
  for (int k = 0; k < @PLANS@; ++k) {
    const double ahead = state->ahead_seconds[k] + count * (seconds[loaded] - seconds[k]);
    state->ahead_seconds[k] = ahead > 0 ? ahead : 0;
    if (state->ahead_seconds[k] > state->ahead_seconds[best]) best = k;
  }
  if (state->ahead_seconds[best] < @GUARD@_RECONFIGURATION_SECONDS) return state->loaded;
  for (int k = 0; k < @PLANS@; ++k) state->ahead_seconds[k] = 0;
  state->loaded = best + 1;
  return state->loaded;
}

#endif
