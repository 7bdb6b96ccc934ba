"""Planetary orders: what is no train is a clear error."""

from __future__ import annotations

import random
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from support import train_oracle as oracle
from support.boards import in_usual_size
from support.each import each
from support.scenes import calling

from graphic_tmm.chapters.trains.motion import motion_of
from graphic_tmm.chapters.trains.plan import PLANETARY_PLAN
from graphic_tmm.chapters.trains.record import BESIDE
from graphic_tmm.chapters.trains.refusals import scheme_of
from graphic_tmm.chapters.trains.table import ratio_lines
from graphic_tmm.chapters.trains.task import ASKED, Limits, PlanetaryTask, module_ratio
from graphic_tmm.chapters.trains.tooth_search import choose, search
from graphic_tmm.errors import StructureError
from graphic_tmm.readers.findings import warnings
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene

C7 = PlanetaryTask("ring", 0.008, 302.0, ratio=4.55, tolerance=0.003, teeth=(25, None, None))
TWO = replace(C7, scheme="external-internal", teeth=(), ratio=12.0)
NAN = float("nan")


@each(
    "change, says",
    [
        ({"scheme": "planet"}, 'no scheme "planet"'),
        ({"module": 0.0}, "module = 0: a number greater than 0"),
        ({"module": NAN}, "module = nan"),
        ({"module_2": 0.008}, "a single row has one module"),
        ({"alpha": 0.0}, "alpha = .*: a number greater than 0 and less than 45"),
        ({"alpha": NAN}, "alpha = .*: a number greater than 0 and less than 45"),
        ({"ha": -1.0}, "ha = .*: a number greater than 0"),
        ({"c": -0.1}, "c = .*: a number 0 to 5"),
        ({"speed": 0.0}, "the driving shaft turns at 0.0"),
        ({"speed": float("inf")}, "the driving shaft"),
        ({"driving": "4"}, 'the train has no "4": its members are 1, 3, H'),
        ({"driving": "3"}, '3 drives: one of the others stands, "1", "H"'),
        ({"fixed": "1"}, '1 drives: one of the others stands, "3", "H"'),
        ({"fixed": "4"}, 'the train has no "4"'),
        ({"driving": ("1", "H")}, "2 drive, but the angular velocity of 1 is given"),
        (
            {"speed": (10.0, -2.0), "fixed": "3"},
            "two shafts of a differential drive: leave fixed out",
        ),
        ({"speed": (10.0, -2.0)}, "a differential has no ratio"),
        (
            {"speed": (10.0, -2.0), "ratio": None, "teeth": (25, 32, 89), "behind": ((15, 25),)},
            "behind a differential no pair is drawn",
        ),
        ({"ratio": 0.0}, "a ratio of 0 is none"),
        ({"ratio": NAN}, "ratio = nan: a number"),
        ({"ratio": None}, "neither a ratio nor all tooth numbers"),
        ({"tolerance": -0.1}, "tolerance = -0.1: a number 0 to 0.5"),
        ({"tolerance": 1.0}, "tolerance = 1: "),
        ({"tolerance": NAN}, "tolerance = nan: "),
        ({"teeth": (25, 32)}, "wheels 1, 2, 3, not 2"),
        ({"teeth": (25.5, 32, 89)}, "teeth = 25.5: a whole number"),
        ({"teeth": (25, True, 89)}, "teeth = True: a whole number"),
        ({"teeth": (25, 32, -89)}, "teeth = -89: a whole number"),
        ({"satellites": ()}, "no number of satellites"),
        ({"satellites": (0,)}, "satellites = 0: a whole number 1 to 49"),
        ({"satellites": (2.5,)}, "satellites = 2.5: a whole number"),
        ({"limits": Limits(least=60, most=50)}, "from 60 to 50"),
        ({"limits": Limits(most=10**9)}, "a whole number 1 to 1000"),
        ({"limits": Limits(difference=0)}, "difference = 0: a whole number"),
        ({"mu_l": 0.0}, "mu_l = 0: "),
        ({"mu_v": -1.0}, "mu_v = -1: "),
        ({"pole": 0.0}, "pole = 0: "),
    ],
)
def test_what_is_no_train_is_refused(change: dict[str, Any], says: str) -> None:
    for act in (scheme_of, search, choose):
        with pytest.raises(StructureError, match=f"planetary: .*{says}"):
            act(replace(C7, **change))


@each(
    "change, says",
    [
        ({"scheme": "3K", "ratio": 20.0}, "teeth of scheme .3K. are given, not sought"),
        ({"scheme": "3K", "driving": "H"}, "its members are 1, 3, 5"),
        ({"scheme": "3K", "teeth": (24, 30, 84, 18, 73)}, "73 − 18 = 55 is another distance"),
        ({"scheme": "3K", "teeth": (24, 30, 84, 30, 84)}, "a shaft stands"),
        ({"scheme": "internal", "teeth": (None, 20)}, "not sought: give all tooth numbers"),
        ({"scheme": "3K", "teeth": ()}, "not sought: give all tooth numbers"),
        (
            {"scheme": "3K", "driving": "1", "fixed": "5", "behind": ((15, 25),)},
            "ring 3 has no shaft",
        ),
        ({"scheme": "external", "teeth": (36, 45), "moment": 20.0}, "leave moment out"),
        ({"scheme": "external", "teeth": (36, 45), "behind": ((15, 25),)}, "leave behind out"),
        ({"scheme": "internal", "teeth": (36, 45)}, "36 − 45 = −9.* no distance of the axes"),
    ],
)
def test_what_the_scheme_has_not_is_refused(change: dict[str, Any], says: str) -> None:
    order = replace(C7, ratio=None, teeth=(24, 30, 84, 18, 72))
    with pytest.raises(StructureError, match=f"planetary: .*{says}"):
        choose(replace(order, **change))


@pytest.mark.parametrize("scheme", oracle.MESHES)
def test_the_usual_motion_of_a_scheme_needs_no_key(scheme: str, tmp_path: Path) -> None:
    """What a scene leaves out: the sun drives and the usual wheel stands; an arm drives, its sun stands."""
    teeth = oracle.random_teeth(random.Random(1), scheme)
    said = f'scheme = "{scheme}"\nmodule = "5 mm"\nspeed = "100 rpm"\nteeth = {list(teeth)}\n'
    held = 'fixed = "H"\n' if scheme != "3K" else ""
    usual, plain = (
        _order(read(calling(tmp_path, f"[planetary]\n{said}{more}", sheet="")))
        for more in ("", held)
    )
    motion = motion_of(usual)
    single = len(teeth) == 2
    assert (motion.first, motion.fixed) == (
        ("H", "1") if single else ("1", "3" if scheme in ("ring", "3K") else "4")
    )
    assert usual.satellites == ((1,) if single else (3,))
    if held:
        assert motion_of(plain)[:2] == ({"1": usual.speed}, "H")


def _order(scene: Scene) -> PlanetaryTask:
    order = ASKED.of(scene)
    assert order is not None
    return order


def test_modules_without_a_simple_ratio_are_refused() -> None:
    assert module_ratio(replace(TWO, module_2=0.01)) == module_ratio(TWO) * 5 / 4
    with pytest.raises(StructureError, match="no simple ratio: take standard ones"):
        scheme_of(replace(TWO, module_2=0.00812345678))


def test_schemes_know_their_wheels() -> None:
    scheme = scheme_of(C7)
    assert (scheme.wheels, scheme.opposed) == (("1", "2", "3"), True)
    scheme = scheme_of(replace(C7, scheme="internal-internal", teeth=()))
    assert (scheme.wheels, scheme.opposed) == (("1", "2", "3", "4"), False)


def test_a_segment_too_short_to_be_read_is_no_shaft_that_stands(tmp_path: Path) -> None:
    """U = 10000: the ruler reads 0 of the driven shaft, which moves: no ratio is measured."""
    text = (
        '[planetary]\nscheme = "internal-internal"\nmodule = "5 mm"\nspeed = "1440 rpm"\ndriving = "H"\n'
        'teeth = [100, 99, 100, 101]\n[[sheet]]\nplace = ["planetary"]\n'
    )
    head = 'title = "T"\nlanguage = "en"\n'
    drawn = in_usual_size(read(calling(tmp_path, text, sheet="", head=head))).boards[0]
    made = PLANETARY_PLAN.on(drawn)
    told = warnings(drawn, "en")
    assert any("too short to be read" in one for one in told)
    assert not any("stands" in one for one in told)
    assert not any("no room" in one for one in told)
    lines = ratio_lines(drawn.construction, drawn.reading, made, "en")
    assert lines
    assert not any("—" in one or "′" in one or "ΔU" in one for one in lines)
    most = BESIDE.on(drawn).most
    assert most is not None
    assert drawn.value(most) == 1.0
