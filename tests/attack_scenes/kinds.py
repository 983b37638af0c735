"""The kinds of scenes, and how one is drawn from its seed.

A kind sets the subject of its scenes; the rest of each scene is drawn at random.
"""

import dataclasses

from .draft import DEVICES, Draft
from .expressions import name
from .rows import FixedFormat
from .scene import item_column


def fold(draft):
    draft.sides = draft.rng.choice(("products", "products", "products", "any", "quotients"))
    interval = draft.rng.choice((2, 2, 2, 2, 3, 3, 3, 4, 4, 5, 6, 7, 8, 9, 12, 16, 17, 32, 64))
    draft.scene.set("reference", initiation_interval=interval)
    if draft.chance(0.3):  # squares of logic by serial units, where look-up tables have four inputs
        draft.scene.set("reference", multipliers="logic")
        draft.scene.set("system", device=draft.rng.choice(("ice40-hx8k", "ice40-up5k", "ecp5-85k")),
                        target_mhz=draft.rng.choice((20, 60, 95, 200)))


def fused(draft):
    draft.sides = "products"
    draft.scene.set("reference", sums="fused")


def formats(draft):
    """Precisions around powers of two, and so few exponents that special values are frequent."""
    rng = draft.rng
    draft.formats(wide=0.35)
    if draft.chance(0.5):
        precision = rng.choice((11, 12, 15, 16, 17))
        draft.scene.set("reference", format=f"s{precision}e{rng.choice((2, 3, 3, 4))}")
        lane = rng.choice((4, 5, 7, 8, 9, 11))
        draft.scene.set("reduced", format=f"s{lane}e{rng.choice((2, 3, 4))}")
    elif draft.chance(0.3):
        named = rng.choice(("binary16", "binary32", "binary64", "binary128"))
        draft.scene.set("reference", format=named)
        draft.scene.set("reduced", format=f"s{rng.randint(4, 11)}e{rng.randint(3, 8)}")
    draft.lane_options(0.3)


def roundings(draft):
    draft.scene.set("reduced", rounding="toward_zero")
    draft.lane_options(0.5)
    draft.reference_options(0.1)


def fixed(draft):
    draft.sides = draft.rng.choice(("polynomials", "polynomials", "homogeneous", "norms"))
    draft.wants_ranges = True
    draft.scene.set("reduced", format=f"q{draft.rng.randint(2, min(14, draft.precision()))}")
    if draft.sides == "norms" and draft.chance(0.7):
        draft.scene.set("reduced", error_bound="norm")
    elif draft.chance(0.3):
        draft.scene.set("reduced", error_bound=draft.rng.choice(("constant", "running")))
    if draft.chance(0.3):
        draft.scene.set("reduced", multipliers=draft.rng.choice(("logic", "memory")))


def guarded(draft):
    """Fixed point with guard digits, of ranges or blocks."""
    draft.sides = draft.rng.choice(("homogeneous", "homogeneous", "norms"))
    form = draft.rng.choice(("q", "block"))
    draft.wants_ranges = form == "q"
    digits = draft.rng.randint(3, 8)
    guard = draft.rng.randint(1, min(6, draft.precision() - digits))
    draft.scene.set("reduced", format=f"{form}{digits}g{guard}")


def block(draft):
    draft.sides = draft.rng.choice(("homogeneous", "homogeneous", "norms"))
    draft.scene.set("reduced", format=f"block{draft.rng.randint(2, min(14, draft.precision()))}")
    if draft.chance(0.3):
        draft.scene.set("reduced", multipliers=draft.rng.choice(("logic", "memory")))


def bounds(draft):
    """Each form of bound of a lane in floating point."""
    rng = draft.rng
    bound = rng.choice(("relative", "running", "running", "constant", "profiled"))
    if bound == "profiled":
        draft.scene.set("reduced", bound="profiled", relative_error_f=rng.choice(("0.1", "0x1p-6")),
                        relative_error_g="0.01")
        return
    draft.scene.set("reduced", error_bound=bound)
    if bound == "running":
        draft.scene.set("reduced", bound_digits=rng.choice((1, 1, 2, 3, 4, 5, 8)))
    draft.sides = {"relative": "positive", "running": "any", "constant": "polynomials"}[bound]
    draft.wants_ranges = bound != "running" or draft.chance(0.3)
    if draft.wants_ranges and draft.chance(0.3):  # as few exponent bits as the ranges allow
        draft.scene.set("reduced", format=draft.scene.get("reduced", "format").partition("e")[0])
    if bound != "relative":
        draft.scene.set("reduced", inputs=rng.choice(("rounded", "exact", draft.precision() - 1)))


def groups(draft):
    draft.groups()
    draft.system_options(0.15)


def second_tier(draft):
    draft.sides = draft.rng.choice(("polynomials", "norms"))
    draft.wants_ranges = True
    rng, most = draft.rng, draft.precision()
    if draft.chance(0.6):
        draft.scene.set("reduced", format=f"q{rng.randint(2, 6)}")
    draft.scene.set("second_tier", format=f"q{rng.randint(6, min(most, 16))}",
                    count=rng.choice((1, 1, 2)))
    if draft.chance(0.4):
        draft.groups()


def beats(draft):
    if draft.chance(0.5):
        draft.scene.set("reference", initiation_interval=draft.rng.choice((4, 8, 16, 32)))
    draft.scene.set("system", request_beats=1)
    while draft.scene.get("system", "request_beats") == 1:
        draft.beats()
        if draft.scene.get("reference", "initiation_interval", 1) == 2:
            break
    if draft.chance(0.5):
        draft.scene.set("system", operand_memory="block")


def memories(draft):
    draft.scene.set("system", operand_memory="block")
    draft.system_options(0.1)


def refetched(draft):
    draft.scene.set("system", operands="refetched")
    draft.system_options(0.12)


def in_order(draft):
    draft.scene.set("system", order="in_order")
    draft.system_options(0.12)


def counters(draft):
    draft.scene.set("system", counters=draft.rng.choice(("axi_lite", "axi_lite", "none")))
    draft.system_options(0.1)


def devices(draft):
    rng = draft.rng
    draft.sides = rng.choice(("any", "products", "quotients"))
    draft.scene.set("system", device=rng.choice(DEVICES),
                    target_mhz=rng.choice((1, 50, 100, 250, 400, 900)))
    for section in ("reference", "reduced"):
        if draft.chance(0.5):
            draft.scene.set(section, multipliers="logic")


def engine_lanes(draft):
    """Lanes that an engine's expressions allow."""
    rng = draft.rng
    style = rng.choice(("float", "block", "fixed"))
    if style == "block":
        draft.scene.set("reduced", format=f"block{rng.randint(3, 9)}")
        draft.sides = rng.choice(("homogeneous", "norms"))
    elif style == "fixed":
        draft.scene.set("reduced", format=f"q{rng.randint(3, 9)}")
        draft.sides = rng.choice(("polynomials", "norms"))
        draft.wants_ranges = True


def split_lanes(draft, step):
    """The lanes as two kinds, in multiples of `step`."""
    rng, lanes = draft.rng, draft.scene.get("system", "lanes")
    if lanes == step or not draft.chance(0.3):
        return
    first = step * rng.randint(1, lanes // step - 1)
    other = draft.scene.get("reduced", "format").rstrip("0123456789") + str(rng.randint(3, 9))
    if draft.is_float():
        other = f"s{rng.randint(4, 9)}e6"
    del draft.scene.sections["system"]["lanes"]
    draft.scene.sections["lanes"] = [{"count": first}, {"count": lanes - first, "format": other}]


def pairwise(draft):
    rng = draft.rng
    group = rng.choice((1, 2, 3, 4))
    draft.scene.set("data", pairs=rng.choice(("all", "all", "cross")))
    draft.scene.set("system", lanes=group * rng.choice((1, 2, 3)))
    draft.scene.set("engine", kind="pairwise", capacity=rng.choice((13, 16, 40)),
                    lanes_per_group=group)
    groups_of_lanes = draft.scene.get("system", "lanes") // group
    if groups_of_lanes > 1 and draft.chance(0.5):
        draft.scene.set("engine", report_streams=rng.randint(2, groups_of_lanes))
    report = rng.sample(("less", "equal", "greater", "unordered"), rng.randint(1, 4))
    report_as = rng.choice(("pairs", "pairs", "bitmap", "count"))
    draft.scene.set("engine", report_as=report_as,
                    report=report[:1] if report_as == "bitmap" else report)
    engine_lanes(draft)
    if draft.scene.get("reduced", "format")[0] == "q" and draft.chance(0.5):
        draft.scene.set("second_tier", format=f"q{rng.randint(8, draft.precision())}")
    split_lanes(draft, group)
    if draft.chance(0.2):
        draft.scene.set("reference", initiation_interval=rng.choice((2, 3, 4, 8)))


def arg_min(draft):
    draft.scene.set("data", pairs="arg_min")
    draft.scene.set("system", lanes=draft.rng.choice((1, 2, 3, 4)))
    draft.scene.set("engine", kind="arg_min", tag_bits=draft.rng.choice((1, 8, 16, 33)))
    engine_lanes(draft)
    split_lanes(draft, 1)
    if draft.chance(0.3):
        draft.scene.set("reference", initiation_interval=draft.rng.choice((2, 3, 4, 8)))


def pairs(draft):
    """Pairs of tables' rows as streams, without an engine."""
    draft.scene.set("data", pairs=draft.rng.choice(("all", "cross", "arg_min")))
    engine_lanes(draft)
    draft.system_options(0.1)


def parts(draft):
    """Several parts, by lists or by an index."""
    rng = draft.rng
    draft.sides = rng.choice(("any", "choices", "products"))
    if draft.chance(0.4):
        count = rng.choice((2, 3, 4))
        k = ("index", "k")
        draft.leaves = [("element", vector, k) for vector in ("p", "q", "s")] + [name("a")]
        draft.scene.index = ("k", 0, count - 1)
        draft.draw_parts(rng.choice((1, 1, 2)))
        draft.scene.combine = rng.choice(("all", "any"))
    else:
        draft.draw_parts(rng.choice((2, 2, 3, 4, 5)))
    draft.reference_options(0.15)


def mixed(draft):
    """Lanes and references of several kinds."""
    rng = draft.rng
    draft.sides = rng.choice(("any", "polynomials"))
    draft.wants_ranges = draft.sides == "polynomials"
    lanes = []
    for _ in range(rng.choice((2, 2, 3))):
        form = f"s{rng.randint(4, 11)}e{rng.randint(3, 8)}"
        if draft.wants_ranges and draft.chance(0.5):
            form = f"q{rng.randint(3, 10)}"
        table = {"count": rng.choice((1, 1, 2)), "format": form}
        if form[0] == "s" and draft.chance(0.4):
            table["inputs"] = "rounded"
        lanes.append(table)
    draft.scene.sections["system"].pop("lanes")
    draft.scene.sections["lanes"] = lanes
    if draft.chance(0.6):
        draft.scene.sections["system"].pop("references")
        draft.scene.sections["references"] = [
            {"count": 1, "initiation_interval": rng.choice((1, 2, 3, 4, 8))},
            {"count": 1, "multipliers": "logic", "initiation_interval": rng.choice((1, 2, 5))}]


def limited(draft):
    """Subexpressions within limits."""
    draft.sides = "polynomials"
    draft.wants_ranges = True
    draft.scene.set("reduced", format=f"q{draft.rng.randint(3, min(12, draft.precision()))}")
    draft.draw_parts()
    draft.limits()


def quotients(draft):
    draft.sides = "quotients"
    draft.reference_options(0.1)


def choices(draft):
    draft.sides = "choices"
    draft.lane_options(0.15)
    draft.reference_options(0.15)


def vectors(draft):
    draft.sides = "vectors"
    draft.reference_options(0.15)


def undecided(draft):
    """Lanes without a reference."""
    draft.scene.set("system", references=0)


def fixed_format(rng):
    bits, is_signed = rng.randint(2, 12), rng.random() < 0.6
    behind = rng.randint(1, bits - 1) if rng.random() < 0.4 else 0
    prefix = "" if is_signed else "u"
    name = f"{prefix}q{bits - behind - is_signed}.{behind}" if behind else f"{prefix}int{bits}"
    return FixedFormat(name, bits, behind, is_signed)


def promised_grids(draft, names):
    """A range and a grid for each input. In one of six the grid is nearly the range or coarser. One
    column of six arrives in fixed point instead."""
    rng, arriving, forms = draft.rng, {}, {}
    for word in names:
        column = item_column(word)[0] if draft.scene.pairs else word
        form = fixed_format(rng)
        if column not in arriving:
            arriving[column] = form if rng.random() < 1 / 6 else None
        coarser = form.bits + rng.randint(-2, 3) if rng.random() < 1 / 6 else 0
        promised = dataclasses.replace(form, is_promised=True, coarser=max(0, coarser))
        forms[word] = arriving[column] or promised
    return forms


def integers(draft):
    """Operands in fixed point, with lanes that are exact and lanes that are not."""
    rng = draft.rng
    draft.sides = rng.choice(("polynomials", "homogeneous", "norms"))
    if draft.chance(0.3):
        pairwise(draft)
        draft.scene.sections.pop("lanes", None)
        draft.scene.sections.pop("second_tier", None)
        lanes = 4 * draft.scene.get("engine", "lanes_per_group")
        draft.scene.sections["system"].setdefault("lanes", lanes)
    form = fixed_format(rng)
    draft.fixed = lambda names: dict.fromkeys(names, form)
    short = f"q{rng.randint(2, max(2, form.bits - 1))}"
    lanes = rng.choice(("exact", "q24", short, short, short))
    draft.scene.set("reference", format="s53e11", initiation_interval=1)
    draft.scene.sections["reduced"] = {"format": lanes}
    if draft.chance(0.3):
        draft.scene.set("reduced", multipliers=rng.choice(("logic", "memory")))
    draft.scene.set("system", references=rng.choice((0, 1, 2)))


def grids(draft):
    """Operands in floating point with promised grids, one per input, and lanes that rely on them.
    Items i and j of a column may have different grids. Some inputs arrive in fixed point."""
    integers(draft)
    draft.fixed = lambda names: promised_grids(draft, names)
    draft.scene.set("reduced", format=draft.rng.choice(("exact", "exact", "q24", "q9")))
    if draft.scene.get("reduced", "format") == "q24":
        draft.scene.set("reduced", error_bound="grid")
    draft.scene.set("system", references=draft.rng.choice((1, 1, 2)))


def references(draft):
    """References that round nothing, or that compute in fixed point."""
    rng, scene = draft.rng, draft.scene
    if draft.chance(0.5):
        form = "exact"
        draft.sides = rng.choice(("dyadic", "dyadic", "choices"))
        scene.widest = f"s{rng.choice((11, 11, 12))}e{rng.choice((4, 5, 5, 6))}"
        draft.wants_ranges = draft.chance(0.3)
        lane = f"s{rng.randint(4, 9)}e{rng.randint(3, 8)}"
    else:
        form = f"q{rng.choice((2, 3, 5, 8, 12, 16, 20, 24, 47, 48))}"
        draft.sides = rng.choice(("polynomials", "norms", "homogeneous"))
        scene.widest = f"s{rng.choice((11, 12, 17, 24))}e{rng.choice((5, 6, 8))}"
        draft.wants_ranges = True
        lane = rng.choice((f"s{rng.randint(4, 9)}e6", f"q{rng.randint(2, 9)}"))
    if draft.chance(0.3):  # promised multiples
        bits = rng.randint(2, 10)
        promised = FixedFormat("", bits, rng.randint(0, 4), True, is_promised=True,
                               arrives_in=scene.widest)
        draft.fixed = lambda names: dict.fromkeys(names, promised)
        draft.wants_ranges = False
    elif form != "exact" and draft.chance(0.3):
        bits = rng.randint(2, 12)
        whole = FixedFormat(f"int{bits}", bits)
        draft.fixed = lambda names: dict.fromkeys(names, whole)
        scene.widest, lane = "s53e11", f"q{rng.randint(2, 6)}"
    scene.set("reference", format=form)
    scene.sections["reduced"] = {"format": lane}
    engine = rng.choice(("none", "none", "none", "pairwise"))
    if engine == "pairwise":
        scene.set("data", pairs="all")
        scene.set("system", lanes=2)
        scene.set("engine", kind="pairwise", capacity=16, lanes_per_group=rng.choice((1, 2)))
    elif draft.chance(0.3):
        scene.set("system", operands="refetched")
    elif draft.chance(0.3):
        scene.set("system", order="in_order")
    if engine == "none":
        draft.draw_parts(rng.choice((1, 1, 2)))


def functions(draft):
    """Functions of linear expressions, in streams and engines; operands in floating point, in fixed
    point or on grids."""
    rng, scene = draft.rng, draft.scene
    engine = rng.choice((None, None, None, None, pairwise, arg_min))
    if engine:
        engine(draft)
        lanes = scene.lane_count()
        for section in ("lanes", "second_tier"):
            scene.sections.pop(section, None)
        scene.set("system", lanes=lanes)
    draft.sides = "functions"
    scene.widest = rng.choice(("s24e8", "s24e8", "s11e5", "s8e8"))
    if draft.chance(0.35):
        draft.draw_leaves()
        words = [leaf[1] for leaf in draft.leaves]
        form = fixed_format(rng)
        forms = promised_grids(draft, words) if draft.chance(0.4) else dict.fromkeys(words, form)
        draft.ranges = {word: one.ends for word, one in forms.items()}
        draft.fixed = lambda names: {word: forms.get(word) or forms[word[:-1] + "i"]
                                     for word in names}  # an arg-min's j is i
        scene.widest = "s53e11"
    scene.set("reference", format=f"q{rng.randint(10, 36)}")
    scene.sections["reduced"] = {"format": f"q{rng.randint(2, 12)}"}
    if draft.chance(0.3):
        scene.set("reduced", multipliers=rng.choice(("logic", "memory")))
    if draft.chance(0.1) and not engine:
        scene.set("second_tier", format=f"q{rng.randint(13, 16)}", count=1)
    elif draft.chance(0.25) and not engine:
        scene.sections["system"].pop("lanes")
        scene.sections["lanes"] = [{"count": 1, "format": f"q{rng.randint(2, 12)}"}
                                   for _ in range(2)]
    draft.draw_parts(rng.choice((1, 1, 1, 2)))
    if draft.fixed:
        draft.ranges = {}  # the formats tell them


KINDS = (fold, fused, formats, roundings, fixed, guarded, block, bounds, groups, second_tier, beats,
         memories, refetched, in_order, counters, devices, pairwise, arg_min, pairs, parts, mixed,
         limited, quotients, choices, vectors, undecided,
         integers, grids, references, functions)
NAMES_OF_KINDS = tuple(kind.__name__ for kind in KINDS)
SPREAD = 7  # share in percent of each other option


def kind_of(seed):
    return NAMES_OF_KINDS[seed % len(KINDS)]


def drawn(seed):
    """The scene of a seed, whatever was drawn before."""
    draft = Draft(seed, kind_of(seed))
    KINDS[seed % len(KINDS)](draft)
    share = SPREAD / 100
    draft.reference_options(share)
    draft.lane_options(share)
    draft.system_options(share)
    return draft.finished()
