"""A composition that is given, put to use: sheets as it has them, drawn as it says."""

from __future__ import annotations

from collections.abc import Mapping, Sequence, Set

from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.composition import FILE, Composition
from graphic_tmm.fitting.scales import usual
from graphic_tmm.fitting.tried import Board, Mechanism, Part
from graphic_tmm.language.said import said
from graphic_tmm.paper.compose.restored import restored
from graphic_tmm.paper.compose.sheet import Places
from graphic_tmm.paper.compose.sheets import Order, Shared
from graphic_tmm.project import own_boards
from graphic_tmm.scene.records import Scene

LEAST = 0.5
"""A composition that names less of the views than this share is of something else."""
_MOVED = said(
    "{file}: the view '{name}' does not fit there any more: it stands at {x:.1f}, {y:.1f}"
)
_ADDED = said("{file}: the view '{name}' is not in it: it stands at {x:.1f}, {y:.1f}")

Laid = Sequence[tuple[Shared, Places]]


def drawn_as(
    scene: Scene,
    sizes: Mapping[str, float],
    *,
    exact: bool,
    wanted: Set[str] | None,
    mechanism: bool,
) -> tuple[Drawn, ...]:
    """Return the boards of a scene drawn in sizes that were found before: nothing is tried."""
    known = usual(scene)
    found = {**known, **{name: size for name, size in sizes.items() if name in known}}
    boards: list[Board] = [Mechanism(scene)] if mechanism else []
    boards += [Part(scene, board) for board in own_boards(scene)]
    drawn = (board.final(found, wanted, exact=exact) for board in boards)
    return tuple(one for one in drawn if one is not None)


def restored_sheets(
    wanted: Sequence[Order], names: Sequence[str], given: Composition
) -> tuple[Laid | None, tuple[str, ...]]:
    """Return sheets as a composition has them, None if it is of no use any more; and what is told of it."""
    number = {name: k for k, name in enumerate(names)}
    orders = [sheet.order for sheet in given.sheets]
    formats = [wanted[s.order].format for s in given.sheets if s.order < len(wanted)]
    needed = {k for k, order in enumerate(wanted) if not order.spared}
    if not needed <= set(orders) <= set(range(len(wanted))) or formats != [
        s.format for s in given.sheets
    ]:
        says = said("{file} is of other sheets than the scene orders: composed anew", file=FILE)
        return None, (says,)
    there = {name for sheet in given.sheets for name in sheet.views if name in number}
    if len(there) < LEAST * len(number):
        says = said("{file} names few of the views that are drawn: composed anew", file=FILE)
        return None, (says,)
    gone = [name for sheet in given.sheets for name in sheet.views if name not in number]
    found = restored(
        wanted,
        [
            (sheet.order, {number[v]: at for v, at in sheet.views.items() if v in number})
            for sheet in given.sheets
        ],
    )
    if found is None:
        says = said("what {file} says does not fit any more: composed anew", file=FILE)
        return None, (says,)
    told = [said("{file}: there is no view '{name}'", file=FILE, name=name) for name in gone]
    at = {k: z for _, places in found.sheets for k, z in places.items()}
    for keys, says in ((found.moved, _MOVED), (found.added, _ADDED)):
        for k in keys:
            told.append(said(says, file=FILE, name=names[k], x=at[k].real, y=at[k].imag))
    return found.sheets, tuple(told)
