"""Tables on the sheet: links, pairs and formula of structure; segments and quantities by positions."""

from __future__ import annotations

import math
from collections.abc import Sequence

from graphic_tmm.captions import CAPTIONS, LINK_NAMES
from graphic_tmm.captions.symbols import symbol
from graphic_tmm.equations import quantity
from graphic_tmm.mechanism.records import Link, Mechanism
from graphic_tmm.mechanism.structure import Pair, Structure
from graphic_tmm.paper.blocks import breakable, fewest
from graphic_tmm.paper.drawing import Drawing, Within
from graphic_tmm.paper.ink_plans import markup
from graphic_tmm.paper.layout import settled
from graphic_tmm.paper.letters import escape
from graphic_tmm.tables.columns import Column
from graphic_tmm.words import fixed, unit

SIZE = 3.5


def link_role(mechanism: Mechanism, structure: Structure, link: Link) -> str:
    """Return what a link is by its pairs: crank, rocker, coupler, slider, stone ... (a key of LINK_NAMES)."""
    frame = mechanism.frame.number
    if link.number == frame:
        return "frame"
    if link.number == structure.driver:
        return "crank"
    pairs = [pair for pair in structure.pairs if link.number in pair.links]
    slides_on = [
        pair.links[1] for pair in pairs if pair.kind == "P" and pair.links[0] == link.number
    ]
    if slides_on:
        return "slider" if frame in slides_on else "stone"
    owns = any(pair.kind == "P" and pair.links[1] == link.number for pair in pairs)
    turns_on_frame = any(pair.kind == "R" and frame in pair.links for pair in pairs)
    if owns:
        return "slotted rocker" if turns_on_frame else "link"
    return "rocker" if turns_on_frame else "coupler"


def link_name(mechanism: Mechanism, structure: Structure, link: Link, language: str) -> str:
    """Return the name the scene gives to a link, or that of its role."""
    return link.name or LINK_NAMES[language][link_role(mechanism, structure, link)]


def link_table(mechanism: Mechanism, structure: Structure, language: str) -> Drawing:
    """Return the table of links."""
    words = CAPTIONS[language]
    frame = mechanism.frame
    rows = [
        [
            str(link.number),
            escape(link_name(mechanism, structure, link, language)),
            words["fixed" if link is frame else "movable"],
        ]
        for link in sorted((*mechanism.links, frame), key=lambda link: (link is frame, link.number))
    ]
    heads = [words["number"], words["link"], words["mobility"]]
    align = ["centre", "left", "left"]
    again = words["continued"]
    return breakable(
        "table-links", words["links"], heads, rows, again=again, size=SIZE, align=align
    )


def pair_table(mechanism: Mechanism, structure: Structure, language: str) -> Drawing:
    """Return the table of kinematic pairs."""
    words = CAPTIONS[language]
    rows = []
    for pair in structure.pairs:
        name = pair_name(pair, mechanism)
        joined = ",".join(str(k) for k in sorted(pair.links))
        index = f"{words[pair.kind + ' index']}_{{{escape(name)}}}({joined})"
        rows.append([escape(name), joined, words[f"kind {pair.kind}"], index])
    heads = [words["letter"], words["joined"], words["kind"], words["index"]]
    again = words["continued"]
    return breakable("table-pairs", words["pairs"], heads, rows, again=again, size=SIZE)


def structure_lines(structure: Structure, language: str) -> tuple[str, ...]:
    """Return mobility, formula of structure, and the kind of each group, as lines of lettering."""
    words = CAPTIONS[language]
    groups = [words["group"].format(name=g.name, kind=g.kind) for g in structure.groups]
    n, p = structure.moving, len(structure.pairs)
    mobility = f"n = {n}, p_5 = {p}, p_4 = 0, W = 3·{n} − 2·{p} = {structure.mobility}"
    return (mobility, f"{words['formula']}: {structure.formula}", *groups)


def pair_name(pair: Pair, mechanism: Mechanism) -> str:
    """Return a pair's letter; a guide of the frame is named y-y, one on a moving link by the stone's letter."""
    if pair.kind == "R":
        return pair.name
    if pair.links[1] == mechanism.frame.number:
        return f"{pair.name}-{pair.name}"
    letters = mechanism.by_number[pair.links[0]].points
    return next(iter(letters), pair.name)


def result_table(
    plan: str,
    columns: Sequence[Column],
    names: Sequence[str],
    language: str,
    *,
    upright: bool = False,
) -> Drawing:
    """Return the table of a plan: rows of segments (mm and quantity) and rates, columns of positions.

    ``upright``: a row for each position instead. A table that no sheet holds whole is broken into blocks, or
    turned the other way, whichever gives fewer.
    """
    words = CAPTIONS[language]
    shown = [k for k in range(len(names)) if any(c.value[k] is not None for c in columns)]
    rows = []
    for column in columns:
        letter = words.get(column.letter) or markup(symbol(column.letter, language))
        if any(x is not None for x in column.mm):
            cells = [fixed(column.mm[k], 1, language) for k in shown]
            rows.append([letter, unit("mm", language), *cells])
            letter = quantity(column.letter) if plan in ("velocities", "accelerations") else letter
        places = _decimals(column.value)
        cells = [fixed(column.value[k], places, language) for k in shown]
        rows.append([letter, unit(column.unit, language), *cells])
    heads = [words["value"], words["unit"], *(escape(names[k]) for k in shown)]
    name, title, again = f"table-{plan}", words[f"table {plan}"], words["continued"]

    def lying() -> Drawing:
        align = ["left", "left", *["centre"] * len(shown)]
        return breakable(name, title, heads, rows, again=again, lead=2, size=SIZE, align=align)

    def standing() -> Drawing:
        first, *others = (list(column) for column in zip(heads, *rows, strict=True))
        align = ["centre"] * len(first)
        return breakable(
            name, title, first, others, again=again, lead=1, over=1, size=SIZE, align=align
        )

    usual, other = (standing, lying) if upright else (lying, standing)
    made = usual()

    def apart(within: Within) -> list[Drawing]:
        return fewest(within, settled(made, within), settled(other(), within))

    return made._replace(apart=apart)


def _decimals(row: Sequence[float | None]) -> int:
    """Return how many decimals give the largest figure of a row three significant digits."""
    largest = max((abs(x) for x in row if x is not None), default=0.0)
    return max(0, 2 - math.floor(math.log10(largest))) if largest > 0 else 0
