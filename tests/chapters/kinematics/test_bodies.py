"""A group or a leg of a kind that a room does not treat is refused by name, in every room that walks groups."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache
from types import SimpleNamespace
from typing import Any, NamedTuple, cast

import numpy as np
import pytest
from support.boards import drawn_of
from support.gallery import scene

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Angle
from graphic_tmm.chapters.diagrams.plan import sliding_leg
from graphic_tmm.chapters.engine.plan import _legs
from graphic_tmm.chapters.forces.cut_free import Figures
from graphic_tmm.chapters.forces.friction import joints
from graphic_tmm.chapters.forces.lever import _base
from graphic_tmm.chapters.forces.plan import _solve
from graphic_tmm.chapters.kinematics.accelerations import draw_accelerations
from graphic_tmm.chapters.kinematics.assembly import closures
from graphic_tmm.chapters.kinematics.bodies import Body, Positions
from graphic_tmm.chapters.kinematics.closings import Closing
from graphic_tmm.chapters.kinematics.drives import driven
from graphic_tmm.chapters.kinematics.motion import Motion, known_image, measure_absolute
from graphic_tmm.chapters.kinematics.positions import draw_frame, draw_positions
from graphic_tmm.chapters.kinematics.rows import _length
from graphic_tmm.chapters.kinematics.survey import least_angle, survey, transmission
from graphic_tmm.chapters.kinematics.velocities import draw_velocities
from graphic_tmm.chapters.structure.record import parts
from graphic_tmm.chapters.structure.table import structure_lines
from graphic_tmm.errors import StructureError
from graphic_tmm.mechanism.records import Mechanism
from graphic_tmm.mechanism.structure import Structure, dissect


class Wheel(NamedTuple):
    """A leg that no room treats."""

    link: int
    body: int
    line: Any


@dataclass
class Board:
    """A mechanism on a board whose plan of positions holds a group that no room treats."""

    mechanism: Mechanism
    structure: Structure
    draft: Draft
    positions: Positions
    velocities: Motion

    @property
    def machine(self) -> Any:
        """What chapters read of a machine."""
        pairs = driven(self.mechanism, self.structure)
        return SimpleNamespace(**vars(self), pairs=pairs, place=lambda letter: letter)


def begun() -> tuple[Mechanism, Draft, Body, Mark]:
    """A board with the frame of a crank and slider, and the angle of its crank."""
    mechanism = scene("offset-slider").mechanism
    assert mechanism is not None
    draft = Draft()
    frame = draw_frame(draft, mechanism, dissect(mechanism))
    return mechanism, draft, frame, draft.ask(Angle, "φ", "°")


def board(strange: Callable[[Closing], Closing]) -> Board:
    mechanism, draft, frame, phi = begun()
    structure = dissect(mechanism)
    positions = draw_positions(draft, mechanism, structure, frame, [phi])
    velocities = draw_velocities(draft, mechanism, structure, positions, turned=False)
    positions = replace(positions, closings=tuple(map(strange, positions.closings)))
    group = positions.closings[0].group
    return Board(mechanism, structure._replace(groups=(group,)), draft, positions, velocities)


def velocities_of(b: Board) -> object:
    mechanism, draft, frame, phi = begun()
    structure = dissect(mechanism)
    positions = draw_positions(draft, mechanism, structure, frame, [phi])
    positions = replace(positions, closings=b.positions.closings)
    return draw_velocities(draft, mechanism, structure, positions, turned=False)


def positions_of(b: Board) -> object:
    mechanism, draft, frame, phi = begun()
    return draw_positions(draft, mechanism, b.structure, frame, [phi])


def of_kind_6(closing: Closing) -> Closing:
    return closing._replace(group=closing.group._replace(kind=cast("Any", 6)))


def on_a_wheel(closing: Closing) -> Closing:
    leg = closing.legs[1]
    wheel: Any = Wheel(leg.link, leg.body, leg.line)
    return closing._replace(legs=(closing.legs[0], wheel))


@cache
def tried() -> Any:
    mechanism = scene("offset-slider").mechanism
    assert mechanism is not None
    return survey(mechanism, dissect(mechanism))


WALKS: dict[str, Callable[[Board], object]] = {
    "velocities": velocities_of,
    "accelerations": lambda b: draw_accelerations(
        b.draft, b.mechanism, b.structure, b.positions, b.velocities
    ),
    "absolute vectors": lambda b: measure_absolute(b.draft, b.velocities, b.positions),
    "least angle": lambda b: least_angle(replace(tried(), positions=b.positions)),
    "transmission": lambda b: transmission(replace(tried(), positions=b.positions), np.zeros(1)),
    "assembly": lambda b: closures(replace(tried(), positions=b.positions)),
    "rows": lambda b: _length(b.machine, "O", "B"),
    "diagrams": lambda b: sliding_leg(b.positions, "B", 0, "diagrams"),
    "engine": lambda b: _legs(b.machine, cast("Any", None), cast("Any", None)),
    "joints": lambda b: joints(b.positions.closings, driven(b.mechanism, b.structure)),
    "figures of forces": lambda b: Figures(b.machine),
    "forces": lambda b: _solve(b.machine, *cast("Any", (None, Empty(), Empty(), None, None))),
    "lever": lambda b: _base(
        b.draft, b.positions, b.velocities, driven(b.mechanism, b.structure), 2, 1
    ),
}
GROUPS: dict[str, Callable[[Board], object]] = {
    "positions": positions_of,
    "survey": lambda b: survey(b.mechanism, b.structure),
    "parts": lambda b: parts(b.structure),
    "lines": lambda b: structure_lines(b.mechanism, b.structure, "en"),
    "formula": lambda b: b.structure.formula,
}


class Empty:
    """No loads, no friction."""

    forces: tuple[()] = ()
    couples: tuple[()] = ()


@pytest.mark.parametrize("room", [*WALKS, *GROUPS])
def test_a_group_of_an_unknown_kind_is_refused_by_name(room: str) -> None:
    with pytest.raises(StructureError, match=r"group 2-3 is of a kind .* not treated here: 6"):
        (WALKS | GROUPS)[room](board(of_kind_6))


@pytest.mark.parametrize("room", WALKS)
def test_a_leg_of_an_unknown_kind_is_refused_by_name(room: str) -> None:
    with pytest.raises(StructureError, match=r"link 3 is held in a way .* not treated here: Wheel"):
        WALKS[room](board(on_a_wheel))


def test_what_a_leg_holds_on_to_is_refused_by_name() -> None:
    b = board(on_a_wheel)
    (closing,) = b.positions.closings
    for walk in (closing.at, lambda leg: known_image(b.velocities, closing, leg)):
        with pytest.raises(StructureError, match="link 3 is held"):
            walk(closing.legs[1])


def test_a_known_group_is_refused_nowhere() -> None:
    b = board(lambda closing: closing)
    assert parts(b.structure) == {"1": (1, 1, 0), "2-3": (2, 3, 0)}
    assert len(joints(b.positions.closings, driven(b.mechanism, b.structure))) == 4
    assert drawn_of(scene("offset-slider"))
