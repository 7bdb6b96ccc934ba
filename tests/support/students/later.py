"""Mistakes that were written down by one who had not seen the check: a third hearing of what students do."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from support.students.early import HALF, TWICE, stem, taking
from support.students.kinds import (
    EVERYWHERE,
    KIND,
    POSITION,
    AtStep,
    Kind,
    Variant,
    letters_of,
    others,
    word,
)
from support.students.later_givens import GIVENS
from support.students.later_tables import TABLES
from support.students.loads import G
from support.students.records import POLES, A, P, Step, V
from support.students.tools import Tools

FACTOR = "factor|times"
UNITS = rf"{FACTOR}|unit|\bmm\b|\bcm\b|10"

# operands ----------------------------------------------------------------------------------------------------


def taking_one(role: str, *names: str) -> Any:
    """Return variants that take another of some names for an operand."""

    def variants(step: Step, tools: Tools) -> Iterator[Variant]:
        for name in others(names, step.takes[role]):
            yield {role: name}, (word(name),)

    return variants


def _to_another_point(step: Step, tools: Tools) -> Iterator[Variant]:
    for letter in others(letters_of(tools, step.plan, step.position), step.takes["end"]):
        if letter != step.takes["start"]:
            yield {"end": letter}, (word(letter),)


def _from_another_point(step: Step, tools: Tools) -> Iterator[Variant]:
    """Measure what does not start at the pole from there, or from another point: n2b from a, not from n2."""
    due = step.takes["start"]
    if due != POLES[step.plan]:
        for letter in others([*letters_of(tools, step.plan, step.position), POLES[step.plan]], due):
            if letter != step.takes["end"]:
                yield {"start": letter}, (word(letter),)


def _by_another_link(names: tuple[str, ...]) -> Any:
    """Return variants of laying off by the direction of another link."""

    def variants(step: Step, tools: Tools) -> Iterator[Variant]:
        how, of = step.takes["way"]
        if stem(step.name).startswith(names) and of not in ("x", "y"):
            for link in others([name for name in tools.machine.links if len(name) == 2], of):
                yield {"way": (how, link)}, (word(link),)

    return variants


def _arcs(step: Step, tools: Tools) -> Iterator[Variant]:
    by, about = step.takes["by"], step.takes.get("about")
    if about:
        yield {"by": about, "about": by}, (rf"{word(by)}|{word(about)}",)


def _interval(step: Step, tools: Tools) -> Iterator[Variant]:
    """The distance that the interval has on the t-axis."""
    interval = tools.given["L"] / tools.machine.positions
    yield {"reach": interval}, ("interval|H_|pole distance",)


def _with_dwell(step: Step, tools: Tools) -> Iterator[Variant]:
    for name in ("rise", "fall"):
        yield {name: step.takes[name] + tools.given["dwell"]}, (word(name) + "|Φ",)


OPERANDS: tuple[Kind, ...] = (
    AtStep("measured to another point", ("operand", "table"), ("read",), _to_another_point),
    AtStep("relative vector from another point", ("operand", "start", "table"), ("read",),
           _from_another_point),
    AtStep("component along another link", ("operand", "direction"), ("laid",),
           _by_another_link(("n", "k"))),
    AtStep("crank's vector by another link", ("operand", "direction"), ("laid",),
           _by_another_link(("p", "π"))),
    AtStep("arcs exchanged", ("exchanged", "operand", "given"), ("meeting",), _arcs),
    AtStep("couple with ω for ε", ("operand",), ("couple",), taking("ω_?2|omega_?2", of="omega2")),
    AtStep("couple with the mass for J", ("operand", "given"), ("couple",), taking_one("J", "m2")),
    AtStep("inertia along another acceleration", ("direction", "operand"), ("inertia",),
           taking_one("end", "a", "b", "s2")),
    AtStep("force put at another point", ("operand",), ("arm",), taking_one("at", "A", "B", "S2")),
    AtStep("force put at another point of the lever", ("operand", "start"), ("arm of the lever",),
           taking_one("at", "a", "b", "s2")),
    AtStep("tangential reaction with another link", ("operand",), ("tangential",),
           taking_one("link", "OA")),
    AtStep("couple on the lever with another link", ("operand",), ("couple on the lever",),
           taking_one("link", "OA")),
    AtStep("reaction along another link", ("operand", "direction"), ("ray of polygon",),
           _by_another_link(("R12n",))),
    AtStep("interval for the pole distance", ("operand", "given", "factor"), ("chord",), _interval,
           (EVERYWHERE,)),
    AtStep("pressure angle with the stroke for r0", ("operand", "given"), ("pressure",),
           taking_one("radius", "stroke"), (EVERYWHERE,)),
    AtStep("pressure angle by S", ("operand",), ("pressure",), taking(of="S"), (EVERYWHERE,)),
    AtStep("laws of rise and return exchanged", ("exchanged", "operand", "given"), ("law",),
           taking("law|sine", rise="cosine", fall="sine"), (EVERYWHERE,)),
    AtStep("phase angle with the dwell", ("given", "operand", "factor"), ("phase",), _with_dwell,
           (EVERYWHERE,)),
)  # fmt: skip

# something of the position before ----------------------------------------------------------------------------


def _before(step: Step, tools: Tools) -> Iterator[Variant]:
    if any(k in tools.machine.accelerated or step.plan != A for k in range(step.position)):
        yield {"ago": 1}, ()


def _link_before(step: Step, tools: Tools) -> Iterator[Variant]:
    """A link that changes, as long as it was."""
    link = step.takes["link"]
    if step.position and (P, link) in tools.pages[step.position].lengths:
        yield {"then": 1}, (rf"{word(link)}|previous|before",)


def _rate_before(step: Step, tools: Tools) -> Iterator[Variant]:
    if step.position:
        yield {"ago": 1}, ()


BEFORE: tuple[Kind, ...] = (
    AtStep("measured on the plan before", ("previous", "table"), ("read",), _before, (POSITION,)),
    AtStep("rate from the segment before", ("previous", "table"), ("rate",), _before, (POSITION,)),
    AtStep("link as long as before", ("previous",), ("rate", "normal"), _link_before, (POSITION,)),
    AtStep("Coriolis with the rate before", ("previous",), ("Coriolis",), _rate_before,
           (POSITION,)),
    AtStep("S of the position before", ("previous", "table"), ("ordinate",), taking(ago=1),
           (EVERYWHERE, POSITION)),
)  # fmt: skip

# factors, powers, scales, what is left out -------------------------------------------------------------------


def _rpm(step: Step, tools: Tools) -> Iterator[Variant]:
    """The number of turns per minute, half of ω (πn/60), or twice (2πn/30)."""
    for by in (30 / np.pi, 0.5, 2.0):
        yield {"omega": step.takes["omega"] * by}, (rf"rpm|{FACTOR}|ω_?1|omega",)


def _crank_for_scale(step: Step, tools: Tools) -> Iterator[Variant]:
    """Make pa as long as OA is drawn, whatever μ the assignment wants."""
    if step.plan == V:
        yield {"factor": tools.mu[V] / (tools.given["omega"] * tools.mu[P])}, (FACTOR + "|μ|scale",)


def strengths(*factors: float, words: str = FACTOR, names: tuple[str, ...] = ("",)) -> Any:
    """Return variants that multiply what is due."""

    def variants(step: Step, tools: Tools) -> Iterator[Variant]:
        if stem(step.name).startswith(names):
            for by in factors:
                yield {"factor": step.takes["factor"] * by}, (words,)

    return variants


def _mu_once(step: Step, tools: Tools) -> Iterator[Variant]:
    yield {"factor": 1 / tools.mu[V]}, (rf"μ|scale|power|square|{FACTOR}",)


def _other_power(step: Step, tools: Tools) -> Iterator[Variant]:
    yield {"power": 3 - step.takes["power"]}, ()


def _other_scale(step: Step, tools: Tools) -> Iterator[Variant]:
    own = step.takes["mu"]
    for mu in ("D.dS", "D.ddS") if own.startswith("D.") else (V, A):
        if mu != own:
            yield {"mu": mu}, ()


def _as_in_the_plan(step: Step, tools: Tools) -> Iterator[Variant]:
    """Carry the path over with the dividers, in the scale of the plan of positions."""
    yield {"factor": tools.mu["S"] / tools.mu[P]}, (rf"μ|scale|{FACTOR}",)


STRENGTHS: tuple[Kind, ...] = (
    AtStep("ω1 from n amiss", ("factor", "given", "table"), ("speed",), _rpm, (EVERYWHERE, KIND)),
    AtStep("pa as long as the crank", ("factor", "scale"), ("speed",), _crank_for_scale,
           (EVERYWHERE,)),
    AtStep("cm for m", ("factor", "scale", "table"), ("speed", "normal"),
           strengths(100.0, 0.01, words=UNITS), (EVERYWHERE,)),
    AtStep("μ not squared", ("scale", "factor", "power"), ("normal",), _mu_once, (EVERYWHERE, KIND)),
    AtStep("length left out", ("left out", "power"), ("rate", "normal", "speed"), taking(power=0),
           (EVERYWHERE,)),
    AtStep("v²/l² for v²/l", ("power",), ("normal",), taking(power=-2), (EVERYWHERE, KIND)),
    AtStep("rate by the length squared", ("power",), ("rate",), taking(power=-2)),
    AtStep("rate in rpm or degrees", ("factor", "table"), ("rate",),
           strengths(30 / np.pi, 180 / np.pi, words=rf"rpm|degree|{FACTOR}"), (EVERYWHERE, KIND)),
    AtStep("rate halved or doubled", ("factor", "table"), ("rate",), strengths(0.5, 2.0)),
    AtStep("Coriolis with ω²", ("power",), ("Coriolis",), taking(power=2)),
    AtStep("component laid off in another scale", ("factor", "scale"), ("laid",),
           strengths(0.5, 2.0, names=("n", "k", "p", "π"))),
    AtStep("weight for mass in inertia", ("factor", "operand"), ("inertia",),
           strengths(G, words=rf"\bg\b|weight|9\.8|{FACTOR}"), (EVERYWHERE, KIND)),
    AtStep("mass divided by g", ("factor", "power"), ("weight",),
           taking(rf"\bg\b|{FACTOR}|power", g=1 / G), (EVERYWHERE, KIND)),
    AtStep("mm for m in a moment", ("factor", "scale"), ("arm",), strengths(1000.0, words=UNITS),
           (EVERYWHERE, KIND)),
    AtStep("mm for m under a moment", ("factor", "scale"), ("tangential", "balance"),
           strengths(0.001, words=UNITS), (EVERYWHERE,)),
    AtStep("degrees for radians", ("factor",), ("phase",),
           taking(rf"degree|radian|π|{FACTOR}", radian=1.0), (EVERYWHERE,)),
    AtStep("2π for π in the phase", ("factor",), ("phase",),
           taking(rf"π|{TWICE}|{HALF}", radian=np.pi / 90), (EVERYWHERE,)),
    AtStep("derivative halved or doubled", ("factor", "scale"), ("derivative",),
           strengths(0.5, 2.0), (EVERYWHERE,)),
    AtStep("φ squared in the wrong derivative", ("power",), ("derivative",), _other_power,
           (EVERYWHERE,)),
    AtStep("scale of another diagram or plan", ("scale",), ("derivative", "inertia"), _other_scale,
           (EVERYWHERE,)),
    AtStep("S in the scale of the plan", ("scale", "factor"), ("ordinate",), _as_in_the_plan,
           (EVERYWHERE,)),
)  # fmt: skip

# directions, senses, starts ----------------------------------------------------------------------------------


def _across_the_guide(step: Step, tools: Tools) -> Iterator[Variant]:
    how, of = step.takes["way"]
    if how == "along" and of in ("x", "y"):
        yield {"way": ("square", of)}, ()


def _along_the_crank(step: Step, tools: Tools) -> Iterator[Variant]:
    if step.name == "pa":
        yield {"way": ("along", step.takes["way"][1])}, ()


SENSES: tuple[Kind, ...] = (
    AtStep("across the guide", ("direction",), ("ray",), _across_the_guide),
    AtStep("pa along the crank", ("direction",), ("laid",), _along_the_crank),
    AtStep("weight upwards", ("sense",), ("weight",), taking(sense=-1.0), (EVERYWHERE, KIND)),
    AtStep("moment with the other sign", ("sense",), ("arm", "arm of the lever"),
           taking(sense=-1.0)),
    AtStep("couple with the other sign", ("sense",), ("couple on the lever",), taking(sense=-1.0)),
    AtStep("couple taken off the moments", ("sense",), ("sum",), taking(couple=-1.0)),
    AtStep("balance the other way", ("sense", "table"), ("balance",), taking(sense=1.0)),
    AtStep("S counted the other way", ("sense", "table"), ("ordinate",), taking(sense=-1.0),
           (EVERYWHERE,)),
    AtStep("S counted from O", ("start", "operand"), ("ordinate",), taking(start=0.0), (EVERYWHERE,)),
    AtStep("chords with the other slope", ("sense", "table"), ("chord",), taking(sense=-1.0),
           (EVERYWHERE,)),
    AtStep("ordinates left at the middles", ("previous", "table", "start"), ("chord",), taking(end=True),
           (EVERYWHERE,)),
    AtStep("offset on the other side", ("sense", "mirrored"), ("pressure",), taking(offset=-1.0),
           (EVERYWHERE,)),
    AtStep("return drawn as the rise", ("mirrored", "wrong end", "table"), ("law",),
           taking(turned=True), (EVERYWHERE,)),
    AtStep("legs of the pressure angle exchanged", ("exchanged", "operand"), ("pressure",),
           taking(legs=-1), (EVERYWHERE,)),
)  # fmt: skip

CRANK: tuple[Kind, ...] = (
    AtStep("crank counted from below", ("crank",), ("crank",), taking(first=-np.pi / 2),
           (EVERYWHERE,)),
    AtStep("crank counted by the compass", ("crank", "sense"), ("crank",),
           taking(turn=-1, first=-np.pi / 2), (EVERYWHERE,)),
    AtStep("circle divided into twelve", ("crank",), ("crank",), taking(part=2 / 3), (EVERYWHERE,)),
)  # fmt: skip

LATER = (*OPERANDS, *BEFORE, *STRENGTHS, *SENSES, *CRANK, *GIVENS, *TABLES)
