"""A setting: how accurately a scene is drawn; and what of a scene changes with it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from graphic_tmm.board.hand import HANDS, Hand
from graphic_tmm.chapters.engine.task import ASKED as ENGINE
from graphic_tmm.chapters.flywheel.task import ASKED as FLYWHEEL
from graphic_tmm.chapters.forces.task import ASKED as FORCES
from graphic_tmm.chapters.forces.task import ForcesOrder
from graphic_tmm.chapters.indicator.task import Gas, IndicatorOrder
from graphic_tmm.drawn import hand_of
from graphic_tmm.mechanism.records import Row
from graphic_tmm.scene.records import Scene

ALL = ("all",)


OWN = "scene"
"""The hand that a scene names, with the ruler that it names."""
EACH_SLIP = ("prick", "compass", "swing", "reading", "digits")
"""The five slips of a hand."""
GRID = ("exact", "cad", "careful", "student")
"""The named hands, from the most exact on."""


@dataclass(frozen=True)
class Setting:
    """How a scene is drawn.

    ``hand``: what the hand is called, ``who`` with ruler, seed and number of drawings; ``enlarged``: how many
    times larger than the scene asks for; ``pole``: how many times farther the poles of its diagrams.
    """

    scene: Scene
    hand: str
    who: Hand
    enlarged: float = 1.0
    pole: float = 1.0

    def by(self, name: str, who: Hand) -> Setting:
        """Return the same, drawn by another hand."""
        return replace(self, hand=name, who=who)


def named(name: str, scene: Scene, trials: int) -> Hand:
    """Return a hand by its name, with the scene's seed; the exact one reads without a ruler.

    A hand that leaves nothing to chance draws once.
    """
    hand = hand_of(scene) if name == OWN else HANDS[name]
    return hand._replace(seed=scene.seed, trials=trials if hand.slips else 1)


def whole(scene: Scene) -> Scene:
    """Return the scene with its plans of accelerations and of forces at all positions of the row.

    Diagrams are judged by the plans of accelerations, so these are drawn with them.
    """
    sheets = scene.sheets
    if "diagrams" in scene.called:
        first = replace(sheets[0], place=(*sheets[0].place, "accelerations"))
        sheets = (first, *sheets[1:])
    row = replace(scene.row, accelerations=ALL)
    found = replace(scene, row=row, main=None, sheets=sheets)
    forces = FORCES.of(scene)
    return found if forces is None else FORCES.put(found, replace(forces, positions=ALL))


def at_count(scene: Scene, count: int) -> Scene | None:
    """Return the scene with another number of positions in its row.

    Positions that the scene names keep their places in the turn; None if one of them is not a position of the
    new row. What is given position by position is taken to be straight between them.
    """
    row = scene.row
    if count == row.count:
        return scene
    accelerations = _renamed(row.accelerations, row, count)
    main = _renamed((scene.main,) if scene.main is not None else (), row, count)
    given, flywheel, engine = FORCES.of(scene), FLYWHEEL.of(scene), ENGINE.of(scene)
    forces = _forces(given, row, count) if given is not None else None
    if accelerations is None or main is None or (forces is None and given is not None):
        return None
    if flywheel is not None and flywheel.indicator is not None:
        flywheel = replace(flywheel, indicator=_indicator(flywheel.indicator, count))
    if engine is not None:
        engine = replace(engine, indicator=_indicator(engine.indicator, count))
    return replace(
        scene,
        row=replace(row, count=count, accelerations=accelerations),
        main=main[0] if main else None,
    ).asking(forces=forces, flywheel=flywheel, engine=engine)


def _renamed(names: Sequence[str], row: Row, count: int) -> tuple[str, ...] | None:
    """Return how positions are called in a row of another count; None if one of them is not there."""
    if tuple(names) == ALL:
        return ALL
    found = []
    for name in names:
        if not name.isdigit():
            return None
        place = (int(name) - row.first) * count
        if place % row.count:
            return None
        found.append(str(place // row.count + row.first))
    return tuple(found)


def _forces(order: ForcesOrder, row: Row, count: int) -> ForcesOrder | None:
    positions = _renamed(order.positions, row, count)
    if positions is None:
        return None
    loads = tuple(
        replace(load, size=spread(load.size, count)) if isinstance(load.size, tuple) else load
        for load in order.loads
    )
    gas = _indicator(order.gas, count) if order.gas is not None else None
    return replace(order, positions=positions, loads=loads, gas=gas)


def _indicator(order: IndicatorOrder, count: int) -> IndicatorOrder:
    shaft = _gas(order.shaft, count) if order.shaft is not None else None
    return replace(order, cover=_gas(order.cover, count), shaft=shaft)


def _gas(gas: Gas, count: int) -> Gas:
    return replace(gas, pressures=spread(gas.pressures, count)) if gas.pressures else gas


def spread(values: Sequence[float], count: int) -> tuple[float, ...]:
    """Return values of a closed row at ``count`` even positions, straight between those given.

    >>> spread((0.0, 2.0), 4)
    (0.0, 1.0, 2.0, 1.0)
    """
    closed = [*values, values[0]]
    at = np.arange(count) * (len(values) / count)
    return tuple(float(x) for x in np.interp(at, np.arange(len(closed)), closed))
