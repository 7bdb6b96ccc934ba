"""A setting: how accurately a scene is drawn; and what of a scene changes with it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from graphic_tmm.board.hand import EXACT, HANDS, Hand
from graphic_tmm.mechanism.loads import ForcesOrder
from graphic_tmm.mechanism.orders import Gas, IndicatorOrder
from graphic_tmm.mechanism.records import Row
from graphic_tmm.scene.records import Scene

ALL = ("all",)


@dataclass(frozen=True)
class Setting:
    """How a scene is drawn.

    ``hand``: the name of who draws, ``who`` with seed and trials; ``enlarged``: how many times larger than the
    scene asks for; ``drawings``: how often the whole is drawn, to tell how the hand scatters.
    """

    scene: Scene
    hand: str
    who: Hand
    enlarged: float = 1.0
    drawings: int = 1

    def drawn_by(self, name: str) -> Setting:
        """Return the same, drawn by a named hand; the exact one has no ruler here."""
        return replace(self, hand=name, who=named(name, self.scene))


def named(name: str, scene: Scene) -> Hand:
    """Return a named hand with the scene's seed; the exact one reads without rounding."""
    return (EXACT if name == "exact" else HANDS[name])._replace(seed=scene.seed)


def whole(scene: Scene) -> Scene:
    """Return the scene with its plans of accelerations and of forces at all positions of the row."""
    forces = replace(scene.forces, positions=ALL) if scene.forces is not None else None
    row = replace(scene.row, accelerations=ALL)
    return replace(scene, forces=forces, row=row, main=None)


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
    forces = _forces(scene.forces, row, count) if scene.forces is not None else None
    if accelerations is None or main is None or (forces is None and scene.forces is not None):
        return None
    flywheel, engine = scene.flywheel, scene.engine
    if flywheel is not None and flywheel.indicator is not None:
        flywheel = replace(flywheel, indicator=_indicator(flywheel.indicator, count))
    if engine is not None:
        engine = replace(engine, indicator=_indicator(engine.indicator, count))
    return replace(
        scene,
        row=replace(row, count=count, accelerations=accelerations),
        main=main[0] if main else None,
        forces=forces,
        flywheel=flywheel,
        engine=engine,
    )


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
