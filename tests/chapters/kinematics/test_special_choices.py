"""Where special points of other legs have their images: of plates on rods, guides and cylinders."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from support.boards import drawn_of
from support.gallery import PLATES, SHEETS
from support.plates import machine

from graphic_tmm.chapters.kinematics.closings import PinLeg, PlateClosing
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.kinematics.special_choices import special_choices
from graphic_tmm.drawn import Drawn
from graphic_tmm.scene.read import read

MACHINES = {
    "three rods": (4, {}),
    "a guide": (0, {"guides": 1}),
    "two guides": (2, {"guides": 2}),
    "a leg on a rod": (2, {"before": True}),
    "a dyad behind": (4, {"behind": True}),
}


def drawn(name: str, folder: Path) -> Drawn:
    if name in PLATES:
        return drawn_of(read(SHEETS / name / "scene.toml"), exact=True)
    seed, how = MACHINES[name]
    path = folder / "scene.toml"
    path.write_text(machine(seed, **how).text, "utf-8")  # type: ignore[arg-type]
    return drawn_of(read(path), exact=True)


@pytest.mark.parametrize("name", [*MACHINES, *PLATES])
def test_they_move_square_to_both_legs_as_their_pins_let_them(name: str, tmp_path: Path) -> None:
    """A velocity of a point on the line of a leg has along it what the pivot of the leg has."""
    of = drawn(name, tmp_path)
    made = KINEMATICS_PLAN.on(of.project)
    choices = {one.plan: one for one in special_choices(of)}
    assert made.velocities is not None
    one = choices["velocities"]
    assert one.point in one.hanging
    assert one.others.shape == (2, len(of.names))
    closing = next(k for k in made.positions.closings if isinstance(k, PlateClosing))
    pairs = [p for p in ((0, 1), (0, 2), (1, 2)) if set(p) != {*closing.branch.crossing}]
    compared = 0
    for pair, found in zip(pairs, one.others, strict=True):
        for leg in (closing.legs[k] for k in pair):
            if not isinstance(leg, PinLeg) or leg.rod:
                continue
            base = made.velocities.images.by_letter[leg.body][leg.letter]
            way = of.reading[closing.pin(leg)] - of.reading[leg.pivot]
            off = ((found - of.reading[base]) * way.conjugate()).real / np.abs(way)
            there = np.isfinite(off)
            assert np.abs(off[there]).max(initial=0.0) < 1e-8 * max(1.0, np.nanmax(np.abs(found)))
            compared += int(there.sum())
    assert compared > 0
