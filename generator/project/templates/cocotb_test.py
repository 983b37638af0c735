@PROVENANCE@
"""The test of @TOP@ for cocotb (1.6 and later): the vectors of the Verilog test bench.

@IF UNGROUPED@
Comparison k goes to lane k modulo @LANES@, with tag k. Each result must leave once, on its lane,
@END@
@IF GROUPED@
Comparison k goes to lane k modulo @LANES@. @LANES_PER_GROUP@ lanes each form a group in lock step,
whose comparisons enter and leave in words with one tag. Each result must leave once, on its lane,
@END@
with the verdict and the flags that the golden model of mixcmp has computed. Run it by the Makefile
beside it.
"""

import os
import random

import cocotb
from cocotb.clock import Clock
from cocotb.triggers import FallingEdge, ReadOnly

LANES = @LANES@
@IF GROUPED@
LANES_PER_GROUP = @LANES_PER_GROUP@
# The tag of a word is that of its first comparison.
COMPARISONS_PER_TAG = @COMPARISONS_PER_TAG@
@END@
REFETCH_STREAMS = @REFETCH_STREAMS@
TDATA_BITS = @TDATA_BITS@
TAG_BITS = @TAG_BITS@
TAG_FIELD = 8 * ((TAG_BITS + 7) // 8)
IN_ORDER = @IN_ORDER@
REFETCHED = @REFETCHES@
TIME_OUT_CYCLES = 5000
UNDECIDED = 8


def read_vectors():
    """The (expected word, operands) of each comparison."""
    vectors = []
    with open(os.environ["MIXCMP_VECTORS"], encoding="ascii") as lines:
        for line in lines:
            if not line.startswith("//"):
                expected, operands = line.split("_")
                vectors.append((int(expected, 16), int(operands, 16)))
    return vectors


def field(signal, index, width):
    """Field `index` of a vector of fields; x or z in it is an error."""
    text = str(signal.value)
    high = len(text) - index * width
    return int(text[high - width : high], 2)


def packed(fields, width):
    """A vector of fields, the first one lowest."""
    return sum(value << (k * width) for k, value in enumerate(fields))


def matches(word, expected):
    """Whether a result is the expected one. If it is undecided, its verdict means nothing."""
    return (word | 3) == (expected | 3) if expected & UNDECIDED else word == expected


class Bench:
    """Drives all lanes, and checks what leaves them."""

    def __init__(self, dut, vectors, offers, takes):
        """`offers` and `takes`: the shares of cycles with an offer and with tready."""
        self.dut = dut
        self.vectors = vectors
        self.offers = offers
        self.takes = takes
        self.random = random.Random(1)
        self.next = list(range(LANES))  # the next comparison of each lane, or the offered one
        self.offered = [None] * LANES
        self.inside = [[] for _ in range(LANES)]
        self.left = set()
        self.requests = [[] for _ in range(REFETCH_STREAMS)]

    def tag(self, index):
@IF GROUPED@
        index //= COMPARISONS_PER_TAG
@END@
        ones = ((1 << TAG_BITS) - 1) >> 30 << 30
        return (ones | index) & ((1 << TAG_BITS) - 1)

    def oldest(self):
        """All comparisons before this one have left."""
        waiting = [index for lane in self.inside for index in lane]
        return min(waiting + self.next)

    def drive(self):
        """Sets the inputs of this cycle."""
        first = self.oldest()
@IF UNGROUPED@
        for lane in range(LANES):
            index = self.next[lane]
            fits = index < len(self.vectors) and index - first < 1 << min(TAG_BITS, 30)
            if self.offered[lane] is None and fits and self.random.random() < self.offers:
                self.offered[lane] = index
        ready = [self.random.random() < self.takes for _ in range(LANES)]
@END@
@IF GROUPED@
        for lane in range(0, LANES, LANES_PER_GROUP):
            lanes = slice(lane, lane + LANES_PER_GROUP)
            word = self.next[lanes]
            tags = word[-1] // COMPARISONS_PER_TAG - first // COMPARISONS_PER_TAG
            fits = word[0] < len(self.vectors) and tags < 1 << min(TAG_BITS, 30)
            if self.offered[lane] is None and fits and self.random.random() < self.offers:
                self.offered[lanes] = word
        ready = []
        for _ in range(0, LANES, LANES_PER_GROUP):
            ready += [self.random.random() < self.takes] * LANES_PER_GROUP
@END@
        valid = [index is not None for index in self.offered]
        operands = [0 if k is None else self.vectors[k][1] for k in self.offered]
        tags = [0 if k is None else self.tag(k) for k in self.offered]
        self.dut.s_axis_tvalid.value = packed(valid@OF_GROUPS@, 1)
        self.dut.s_axis_tdata.value = packed(operands, TDATA_BITS)
        self.dut.s_axis_tuser.value = packed(tags@OF_GROUPS@, TAG_BITS)
        self.dut.m_axis_tready.value = packed(ready@OF_GROUPS@, 1)
        if REFETCHED:
            answers = [self.vectors[queue[0]][1] if queue else 0 for queue in self.requests]
            self.dut.s_refetch_tvalid.value = packed([bool(q) for q in self.requests], 1)
            self.dut.s_refetch_tdata.value = packed(answers, TDATA_BITS)
            self.dut.m_refetch_tready.value = (1 << REFETCH_STREAMS) - 1
        return ready

    def sample(self, ready):
        """Takes what is transferred in this cycle; whether anything is."""
        moved = False
        for lane in range(LANES):
            if self.offered[lane] is not None and field(self.dut.s_axis_tready, @STREAM_OF_LANE@, 1):
                self.inside[lane].append(self.offered[lane])
                self.offered[lane] = None
                self.next[lane] += LANES
                moved = True
            if field(self.dut.m_axis_tvalid, @STREAM_OF_LANE@, 1) and ready[lane]:
                self.receive(lane)
                moved = True
        for stream in range(REFETCH_STREAMS if REFETCHED else 0):
            self.sample_refetch(stream)
        return moved

    def receive(self, lane):
        tag = field(self.dut.m_axis_tuser, @STREAM_OF_LANE@, TAG_BITS)
        word = field(self.dut.m_axis_tdata, lane, 8)
@IF UNGROUPED@
        matching = [index for index in self.inside[lane] if self.tag(index) == tag]
@END@
@IF GROUPED@
        place = lane % LANES_PER_GROUP
        matching = [index for index in self.inside[lane] if self.tag(index - place) == tag]
@END@
        assert matching, f"lane {lane}: a result with tag {tag:x}, which is not inside"
        index = matching[0]
        if IN_ORDER:
            assert index == self.inside[lane][0], f"lane {lane}: comparison {index} overtook"
        self.inside[lane].remove(index)
        self.left.add(index)
        expected = self.vectors[index][0]
        assert matches(word, expected), (
            f"comparison {index}, lane {lane}: expected {expected:02x}, got {word:02x}"
        )

    def sample_refetch(self, stream):
        queue = self.requests[stream]
        if queue and field(self.dut.s_refetch_tready, stream, 1):
            queue.pop(0)
        if field(self.dut.m_refetch_tvalid, stream, 1):
            tag = field(self.dut.m_refetch_tdata, stream, TAG_FIELD)
            inside = [k for lane in self.inside for k in lane if self.tag(k) == tag]
            assert inside, f"refetch stream {stream}: a refetch of tag {tag:x}, which is not inside"
            queue.append(inside[0])

    async def run(self):
        idle = 0
        while len(self.left) < len(self.vectors):
            await FallingEdge(self.dut.aclk)
            ready = self.drive()
            await ReadOnly()
            idle = 0 if self.sample(ready) else idle + 1
            assert idle < TIME_OUT_CYCLES, (
                f"time-out: {len(self.vectors) - len(self.left)} comparisons have not left"
            )


async def reset(dut):
    for name in ("s_axis_tvalid", "s_axis_tdata", "s_axis_tuser", "m_axis_tready"):
        getattr(dut, name).value = 0
    if REFETCHED:
        for name in ("m_refetch_tready", "s_refetch_tvalid", "s_refetch_tdata"):
            getattr(dut, name).value = 0
@IF COUNTER_PORT@
    for name in ("arvalid", "araddr", "rready", "awvalid", "awaddr", "wvalid", "bready"):
        getattr(dut, "s_axi_" + name).value = 0
@END@
    dut.aresetn.value = 0
    cocotb.start_soon(Clock(dut.aclk, 10, "ns").start())
    for _ in range(3):
        await FallingEdge(dut.aclk)
    dut.aresetn.value = 1


@cocotb.test()
async def every_comparison_at_full_rate(dut):
    await reset(dut)
    await Bench(dut, read_vectors(), offers=1, takes=1).run()


@cocotb.test()
async def every_comparison_with_gaps_and_backpressure(dut):
    await reset(dut)
    await Bench(dut, read_vectors(), offers=0.5, takes=0.5).run()
