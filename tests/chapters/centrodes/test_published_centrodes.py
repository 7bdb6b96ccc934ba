"""Centrodes that books name as curves: circles, hyperbolas, ellipses.

Sources: Мещерский И. В., Задачи по теоретической механике, section 17 (told from memory, numbers not verified);
F. van Schooten, Exercitationum mathematicarum libri quinque, Leiden 1657, as the museum of machines in Modena
tells it (www.mmlab.unimore.it: iperbolografo, ellissografo ad antiparallelogramma): the place where bars of a
crossed four-bar meet goes along a hyperbola on a long bar, along an ellipse on a short one. The answers are
curves, which is why they can be held to all digits.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from support.published_mechanisms import four_bar, slider_crank

import graphic_tmm


def centrodes(scene: dict[str, Any], at: Any) -> tuple[Any, Any]:
    """P_20 at many places of the crank: on the frame, and in the axes of the coupler from A along AB, m."""
    found = graphic_tmm.motion(graphic_tmm.read(scene), at, plans=["centrodes"], exact=True).columns
    return found["x20"] + 1j * found["y20"], found["xi20"] + 1j * found["eta20"]


def test_a_rod_as_long_as_its_crank() -> None:
    """OA = AB = r: a circle of 2r about O, on which one of r about A rolls inside."""
    r = 0.1
    scene = slider_crank(
        r, r, "2 rad/s", centrodes={"link": 2},
        drive={"from": "-80 deg", "to": "80 deg", "positions": 9},
    )  # fmt: skip
    fixed, moving = centrodes(scene, np.arange(-79.0, 80.0, 6.0))
    assert np.abs(np.abs(fixed) - 2 * r).max() < 1e-9 * r
    assert np.abs(np.abs(moving) - r).max() < 1e-9 * r


def test_a_crossed_four_bar_on_a_long_link() -> None:
    """AB = OD = 110, OA = BD = 70 mm: hyperbolas with the foci O, D and A, B; their vertices 70 mm apart."""
    short, long = 0.07, 0.11
    scene = four_bar(
        (short, long, short), long + 0j, "2 rad/s", "right", centrodes={"link": 2},
        drive={"from": "20 deg", "to": "160 deg", "positions": 15},
    )  # fmt: skip
    fixed, moving = centrodes(scene, np.arange(21.0, 160.0, 4.0))
    there = np.isfinite(fixed) & (np.abs(fixed) < 10.0)
    assert there.sum() > 20
    for curve in (fixed[there], moving[there]):
        apart = np.abs(np.abs(curve) - np.abs(curve - long))
        assert (np.abs(apart - short) / np.abs(curve)).max() < 1e-9


def test_a_crossed_four_bar_on_a_short_link() -> None:
    """OD = AB = 70, OA = BD = 110 mm: ellipses with the foci O, D and A, B; the sum of distances is 110 mm."""
    short, long = 0.07, 0.11
    scene = four_bar(
        (long, short, long), short + 0j, "2 rad/s", "right", centrodes={"link": 2},
        drive={"from": "20 deg", "to": "160 deg", "positions": 15},
    )  # fmt: skip
    for curve in centrodes(scene, np.arange(21.0, 160.0, 4.0)):
        away = np.abs(curve) + np.abs(curve - short)
        assert np.abs(away - long).max() < 1e-9 * long
