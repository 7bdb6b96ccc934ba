"""A composition that is given, put to use: sheets as it has them, drawn as it says."""

from __future__ import annotations

from collections.abc import Mapping, Sequence, Set
from typing import TYPE_CHECKING

from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.composition import FILE, Composition
from graphic_tmm.fitting.sizes import usual
from graphic_tmm.fitting.tried import boards_of
from graphic_tmm.language.said import said
from graphic_tmm.scene.records import Scene

if TYPE_CHECKING:
    from graphic_tmm.paper.compose.sheet import Places
    from graphic_tmm.paper.compose.sheets import Order, Shared

    Laid = Sequence[tuple[Shared, Places]]

LEAST = 0.5
"""A composition that names less of the views than this share is of something else."""
LARGER, SMALL = 1.25, 0.85
"""So much larger a plan may be than in the scene that its composition is from, where it leaves so much of its
size. The next standard μ is 1.25 to 2 times as large; a size is found in steps of 1.1."""
_MOVED = said(
    "{file}: the view '{name}' does not fit there any more: it stands at {x:.1f}, {y:.1f}"
)
_ADDED = said("{file}: the view '{name}' is not in it: it stands at {x:.1f}, {y:.1f}")


def drawn_as(
    scene: Scene,
    sizes: Mapping[str, float],
    *,
    exact: bool,
    wanted: Set[str] | None,
    mechanism: bool,
) -> tuple[Drawn, ...]:
    """Return the boards of a scene drawn in sizes that were found before: nothing is tried."""
    boards, found = boards_of(scene, mechanism=mechanism), _known(scene, sizes)
    drawn = (board.final(found, wanted, exact=exact) for board in boards)
    return tuple(one for one in drawn if one is not None)


def _known(scene: Scene, sizes: Mapping[str, float]) -> dict[str, float]:
    known = usual(scene)
    return {**known, **{name: size for name, size in sizes.items() if name in known}}


def all_fixed(scene: Scene, *, mechanism: bool) -> bool:
    """Whether a scene fixes all that it is drawn by: in whatever sizes, every figure is the same."""
    return all(
        size.fixed(scene)
        for board in boards_of(scene, mechanism=mechanism)
        for size in board.sizes.values()
    )


def larger(scene: Scene, sizes: Mapping[str, float], *, mechanism: bool) -> dict[str, float] | None:
    """Return sizes of a scene like this one in which no plan is small for a little; None if none is.

    A plan of which the longest vector would be a little longer than its size is drawn by the next standard μ:
    it is allowed to be so much longer.
    """
    found = _known(scene, sizes)
    small = {
        name: LARGER * found[name]
        for board in boards_of(scene, mechanism=mechanism)
        for name, size in board.sizes.items()
        if size.plan and not size.fixed(scene) and 0.0 < board.mm(name, found) < SMALL * found[name]
    }
    return {**found, **small} if small else None


def restored_sheets(
    wanted: Sequence[Order], names: Sequence[str], given: Composition
) -> tuple[Laid | None, tuple[str, ...]]:
    """Return sheets as a composition has them, None if it is of no use any more; and what is told of it."""
    from graphic_tmm.paper.compose.restored import restored

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
