"""What is recorded of structure: the mobility of a mechanism, of its groups and of its driving link."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from graphic_tmm.board.formula import formula
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.structure import PARTS, REPLACING, STRUCTURE
from graphic_tmm.chapters.structure.replacing import Replaced, replace
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.structure import Structure, dissect
from graphic_tmm.mechanism.wheels import Rolling
from graphic_tmm.project import Bench, Plan
from graphic_tmm.scene.chapter import Recorded, aside

"""The place of the tables."""


@formula(
    why=said(
        "A link has three freedoms in the plane; a pair of class 5 takes two of them, one of class 4 one."
    )
)
def mobility(n: Number, p5: Number, p4: Number) -> Number:
    """3·{n} − 2·{p5} − {p4}"""


class Mobility(NamedTuple):
    """Mobility as calculated (Number): of the mechanism; of its parts by the numbers of their links: 1, 2-3.

    ``replaced``: its higher pairs in the replacing linkage; ``replacing``: W of that ("") and of its groups.
    """

    whole: Mark
    parts: Mapping[str, Mark]
    replaced: tuple[Replaced, ...]
    replacing: Mapping[str, Mark]


MOBILITY: Recorded[Mobility] = Recorded(aside("structure"))


def parts(structure: Structure) -> dict[str, tuple[int, int, int]]:
    """Return how many links, lower and higher pairs each part has, by the numbers of its links.

    A part is a driving link, or a group. A rod counts as a link that moves in its cylinder: both together are
    one link of a group.
    """
    found = {one.name: (1, 1, 0) for one in structure.driven}
    return found | {
        one.name: (1, 1, 1) if isinstance(one, Rolling) else (len(one.links), one.pairs, 0)
        for one in structure.attached
    }


def record_mobility(bench: Bench) -> Mobility | None:
    """Calculate W of the mechanism and, as a check of its dissection, of each part; None if nobody asks."""
    assert bench.scene.mechanism is not None
    if not bench.wanted & {STRUCTURE, PARTS, REPLACING}:
        return None
    structure, draft = dissect(bench.scene.mechanism), bench.draft
    draft.open(STRUCTURE)
    none = draft.take(Number, "p_4", float(len(structure.wheels)))
    marks = {len(structure.wheels): none}

    def w(letter: str, index: str, links: int, pairs: int, higher: int) -> Mark:
        n = draft.take(Number, f"n{index}", float(links))
        p5 = draft.take(Number, f"p_5{index}", float(pairs))
        if higher not in marks:
            marks[higher] = draft.take(Number, "p_4", float(higher))
        return draft.draw(mobility, letter, n, p5, marks[higher])

    whole = w("W", "", structure.moving, len(structure.pairs), len(structure.wheels))
    own = {name: w(f"W_{name}", "", *size) for name, size in parts(structure).items()}
    if REPLACING not in bench.wanted or not structure.wheels:
        return Mobility(whole, own, (), {})
    replaced = tuple(replace(draft, KINEMATICS_PLAN.on(bench).positions))
    more, size = len(replaced), (structure.moving, len(structure.pairs))
    replacing = {"": w("W′", "′", size[0] + more, size[1] + 2 * more, 0)}
    replacing |= {one.name: w(f"W_{one.name}", "", 2, 3, 0) for one in replaced}
    return Mobility(whole, own, replaced, replacing)


def _record(bench: Bench) -> Structure:
    """Return the structure; it leaves no step."""
    assert bench.scene.mechanism is not None
    return dissect(bench.scene.mechanism)


STRUCTURE_PLAN: Recorded[Structure] = Recorded(STRUCTURE)

PLAN = Plan(record=_record, aside=record_mobility)
