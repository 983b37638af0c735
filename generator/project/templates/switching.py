@PROVENANCE@
"""@NAME@: which of its plans to load, decided by what the loaded one counts.

@PLANS_TEXT@

To be called after each reading of the counters, in seconds or fractions of a second:

    switching = Switching()                                        # plan 1 is loaded
    ...
    if switching.next_plan(comparisons, recomputations) != loaded: # load it

@COMPARISONS_TEXT@
Both count since the last call, and from 0 after a reconfiguration.
"""

RECONFIGURATION_SECONDS = @RECONFIGURATION_SECONDS@
# Recomputation rates that each plan counts on known data, and the seconds that all plans take for a
# comparison there.
POINTS = (
@PYTHON_POINTS@
)
# Comparisons that each plan's counters count as one.
COMPARISONS_OF_WORD = (@COMPARISONS_OF_WORD@,)


class Switching:
    """The state of the rule: the number of the loaded plan, and how far each would be ahead."""

    def __init__(self):
        self.loaded = 1
        self.ahead_seconds = [0.0] * @PLANS@

    def next_plan(self, comparisons, recomputations):
        """The plan to load: another one than before if that would by now have gained the seconds
        of a reconfiguration."""
        if comparisons == 0:
            return self.loaded
        loaded = self.loaded - 1
        count = float(comparisons * COMPARISONS_OF_WORD[loaded])
        seconds = _seconds_at(recomputations / count, POINTS[loaded])
        best = loaded
        for k in range(@PLANS@):
            ahead = self.ahead_seconds[k] + count * (seconds[loaded] - seconds[k])
            self.ahead_seconds[k] = max(0.0, ahead)
            if self.ahead_seconds[k] > self.ahead_seconds[best]:
                best = k
        if self.ahead_seconds[best] >= RECONFIGURATION_SECONDS:
            self.ahead_seconds = [0.0] * @PLANS@
            self.loaded = best + 1
        return self.loaded


def _seconds_at(rate, points):
    """The seconds of each plan between two points, or at the outer one."""
    if rate < points[0][0]:
        return points[0][1]
    for (low, low_seconds), (high, high_seconds) in zip(points, points[1:]):
        if rate < high:
            part = (rate - low) / (high - low)
            return [a + part * (b - a) for a, b in zip(low_seconds, high_seconds)]
    return points[-1][1]
