"""All places of a plate by its locus: against the search along the plate's angle, as near as the curve is."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from support.boards import usual_part
from support.gallery import ROOT
from support.plates import machine
from support.turns import in_turn

from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.kinematics.task import POSITIONS
from graphic_tmm.chapters.loci.record import LOCI_PLAN, TRACING
from graphic_tmm.chapters.loci.task import LOCI
from graphic_tmm.errors import TmmError
from graphic_tmm.project import own_boards, record
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene

NEAR = 0.02
"""A curve through 36 points is off its locus by less of what is drawn; where it is grazed, that is along it."""


def own(text: str) -> str:
    """Return a scene that asks for the places of its plate alone."""
    head = text[: text.index("[[sheet]]")] if "[[sheet]]" in text else text
    return f'{head}\n[loci]\nat = 2\n\n[[sheet]]\nplace = ["loci"]\n'


def written(text: str, folder: Path) -> Scene:
    file = folder / "scene.toml"
    file.write_text(text, "utf-8")
    return read(file)


def shipped(name: str) -> str:
    return own((ROOT / "sheets" / name / "scene.toml").read_text("utf-8"))


@pytest.mark.parametrize("name", ["swinging-screen", "landing-gear", "tipper-hoist"])
def test_places_are_those_of_the_tracing(name: str, tmp_path: Path) -> None:
    check(written(shipped(name), tmp_path))


@pytest.mark.parametrize("seed", in_turn(range(40), 6))
@pytest.mark.parametrize("guides", [0, 1, 2])
def test_places_of_random_plates(seed: int, guides: int, tmp_path: Path) -> None:
    text = own(machine(seed, guides=guides).text)
    try:
        positions = record(written(text, tmp_path), wanted={POSITIONS})
    except TmmError:  # at another of its places after a turn: it is not drawn
        return
    (plate,) = KINEMATICS_PLAN.on(positions).tried.positions.closings
    row = np.array(positions.coordinates, dtype=float)
    there = np.flatnonzero(np.isfinite(plate.branch.near(row)[1]))
    at = positions.names[there[len(there) // 2]]
    check(written(text.replace("[loci]\nat = 2", f"[loci]\nat = {at}"), tmp_path))


def check(scene: Scene) -> None:
    """Every place keeps the plate's lengths to the hand's own figures, and its own is that of the mechanism."""
    drawn = usual_part(LOCI, scene)
    made = LOCI_PLAN.on(drawn)
    reading, mu = drawn.reading, drawn.value(made.mu)
    whole = made.size / mu
    pins = np.array([[reading[mark].flat[0] for mark in place] for place in made.places])
    there = np.isfinite(pins).all(axis=1)
    assert there[made.own]
    of = made.loosened
    for place in pins[there]:
        b, c, f = place
        assert abs(abs(c - b) * mu - of.apart) < 1e-9
        assert abs(abs(f - b) * mu - abs(of.off)) < 1e-9
    positions = record(scene, wanted={POSITIONS})
    plans = KINEMATICS_PLAN.on(positions)
    index = positions.names.index(made.at)
    row = np.array([[positions.coordinates[index]]])
    closing = next(c for c in plans.tried.positions.closings if c.group == made.closing.group)
    due = plans.tried.at(row, [*closing.points, closing.legs[0].pivot])
    spots = [complex(due[mark].flat[0]) for mark in closing.points]
    pivot = complex(due[closing.legs[0].pivot].flat[0])
    for place, spot in zip(pins[made.own], spots, strict=True):
        assert abs(place - (spot - pivot) / mu) < NEAR * whole
    traced = reading[TRACING.on(drawn)].flat[0]
    assert abs(traced * mu - abs(spots[2] - pivot)) <= 0.05 * mu + 1e-9


def test_what_is_refused_names_the_remedy(tmp_path: Path) -> None:
    text = shipped("landing-gear").replace("[loci]\nat = 2", "[loci]\nplate = 3")
    with pytest.raises(TmmError, match="link 3 is no plate on three legs; there is 2"):
        usual_part(LOCI, written(text, tmp_path))
    text = shipped("crank-rocker")
    with pytest.raises(TmmError, match=r"three legs|тремя поводками"):
        usual_part(LOCI, written(text, tmp_path))


def test_a_scene_without_it_records_nothing(tmp_path: Path) -> None:
    plain = shipped("landing-gear").replace("[loci]\nat = 2\n", "").replace('"loci"', '"positions"')
    assert LOCI not in own_boards(written(plain, tmp_path))
