"""How a value was taken is told where the file leaves it open: numbers without a unit, weights for masses."""

from __future__ import annotations

import tomllib
from typing import Any

import pytest
from support.scenes import slider_crank

from graphic_tmm.scene.read import understood
from graphic_tmm.scene.vary import changed

SCENE = slider_crank(
    'speed = 20\n[effects]\ngravity = true\ng = "9.8 m/s^2"\n[[load]]\nlink = 3\npoint = "B"\n'
    'force = "1 kN"\ndirection = "180 deg"\n[forces]\n',
    points=", S2 = [0.15, 0]",
    of_rod='mass = 2\nJ = 0.02\ncentre = "S2"\n',
    of_slider='mass = 3\ncentre = "B"\n',
)


def _remarks(**values: Any) -> list[str]:
    doc = changed(tomllib.loads(SCENE), {key: value for key, value in values.items()}, "scene")
    return [
        line
        for line in understood(doc, "scene").remarks
        if line.partition(":")[0].split(" (")[0] in values
    ]


def test_usual_numbers_are_taken_without_a_word() -> None:
    assert understood(tomllib.loads(SCENE), "scene").remarks == ()


@pytest.mark.parametrize(
    ("key", "value", "line"),
    [
        ("drive.speed", 600, '600 rad/s = 5730 rpm; write "600 rpm" if that is meant'),
        ("link 2, points.B", [300, 0], '300 m = 300000 mm; write "300 mm" if'),
        ("link 2, points.B", [0.35, 5e-5], ""),
        ("link 2, points.S2", [5e-5, 0], '5e-05 m = 0.05 mm; write "5e-05 mm" if'),
        ("drive.zero", 1.5708, '1.5708 deg = 0.02742 rad; write "1.5708 rad" if'),
        ("drive.zero", 2.5, ""),
        ("drive.zero", 90, ""),
        ("link 2, mass", 2500, '2500 kg = 2500000 g; write "2500 g" if'),
        ("link 2, J", 180, '180 kg*m^2 = 1800000 kg*cm^2; write "180 kg*cm^2" if'),
        ("effects.g", 9810, '9810 m/s^2 = 9810000 mm/s^2; write "9810 mm/s^2" if'),
        ("scales.mu_l", 5, '5 m/mm = 5000 mm/mm; write "5 mm/mm" if'),
        ("link 2, mass", "196 N", "is a weight: m = G/g = 20 kg, with g = 9.8 m/s²"),
        ("link 2, mass", "0,196 кН", "is a weight: m = G/g = 20 kg, with g = 9.8 m/s²"),
        ("link 2, mass", "20 kgf", ""),
    ],
)
def test_a_value_that_leaves_it_open(key: str, value: Any, line: str) -> None:
    told = _remarks(**{key: value})
    assert len(told) == bool(line), told
    assert not line or line in told[0]


def test_what_the_remark_says_to_write_is_taken_without_a_word() -> None:
    for key, value in (
        ("drive.speed", "600 rpm"),
        ("drive.speed", "600 rad/s"),
        ("link 2, mass", "20 kg"),
    ):
        assert not _remarks(**{key: value})


def test_keys_of_one_kind_are_told_in_one_line() -> None:
    told = _remarks(
        **{
            "link 1, points.A": [100, 0],
            "link 2, points.B": [350, 0],
            "link 2, points.S2": [150, 0],
        }
    )
    assert told == [
        'link 1, points.A (and 2 more keys): 100 without a unit is 100 m = 100000 mm; write "100 mm" if '
        'that is meant, else "100 m"'
    ]


def test_pressures_in_megapascals_and_forces_in_kilonewtons() -> None:
    from graphic_tmm.scene.bare import taken

    assert 'write "0.6 MPa"' in next(taken([0.1, 0.6, 0.3], "pressure"))
    assert not list(taken([1e5, 6e5, 0], "pressure"))
    assert 'write "2.5 kN"' in next(taken(2.5, "force"))
    assert 'write "7.85 g/cm^3"' in next(taken(7.85, "density"))
