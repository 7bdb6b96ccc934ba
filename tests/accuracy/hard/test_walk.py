"""Digits that are said to be left, judged by the same log run at 50 digits: never more than there are."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from hard.test_hard_change_points import CASES
from judges.test_random_drives import WAYS, random_of
from support import drives, gallery
from support.digits_left import judged, scene_of
from support.hard_mechanisms import coulisse, slider_crank, weighed
from support.loaded import weighed as loaded
from support.mechanisms import sample

import graphic_tmm
from graphic_tmm.accuracy.hard.walk import MOST, walk
from graphic_tmm.errors import SceneError


@pytest.mark.parametrize("name", ["windrower", "lever", "locomobile"])
def test_digits_said_to_be_left_are_left(name: str) -> None:
    """And not too many are given away: some three, of which shaking by 64 units is nearly two."""
    found = judged(walk(gallery.scene(name)), every=5)
    assert found.said.size > 300
    assert found.away.min() >= 0.0, found.names[int(found.away.argmin())]
    assert np.median(found.away) < 3.5
    assert found.lost == found.missing == 0
    assert not found.gone


@pytest.mark.slow
@pytest.mark.parametrize("name", CASES)
def test_digits_close_to_change_points_are_left_or_left_out(name: str) -> None:
    """What cannot be drawn there can at 50 digits only where the machine cannot tell that it may."""
    walked = walk(scene_of(weighed(CASES[name][0])))
    found = judged(walked)
    assert found.away.min() >= 0.0, found.names[int(found.away.argmin())]
    assert found.lost > 50
    assert not found.gone
    assert found.said.size > 2000
    for _, angle in found.drawn:
        near = walked.nearest(angle)
        assert near is not None
        assert near.kind == "sharp"
        assert walked.span.apart(near.at, angle) < 1e-6


@pytest.mark.slow
def test_digits_of_random_mechanisms_up_to_where_they_lock(many: Callable[[int, int], int]) -> None:
    missing, count = 0, many(30, 9)
    for k, one in enumerate(sample(count, seed=7000, dyads=(1, 3))):
        found = judged(walk(scene_of(loaded(one, k), one.phi)), every=3)
        assert found.away.min() >= 0.0, (k, found.names[int(found.away.argmin())])
        assert not found.drawn
        assert not found.gone
        missing += found.missing
    assert missing > 33 * count


def test_a_figure_that_is_all_but_zero_has_few_digits_and_is_called_small() -> None:
    """The slider's speed at 10⁻⁹° off its dead centre, of an angle that is known to 1e-14 of itself."""
    found = walk(scene_of(weighed(slider_crank(0.1, 0.3))))
    row = next(k for k, one in enumerate(found.results) if one.letter == "v_B")
    at, close, far = (found.index(180.0 + off) for off in (0.0, 1e-9, 10.0))
    assert found.digits[row, close] < 4.0 < 10.0 < found.digits[row, far]
    assert found.small[row, close]
    assert not found.small[row, far]
    # there itself it is nothing, to the digits of what it is computed from
    assert found.digits[row, at] > 10.0


def test_each_hard_place_is_approached_from_both_sides() -> None:
    found = walk(scene_of(weighed(coulisse(0.1, 0.3))))
    assert found.places
    for place in found.places:
        off = (found.row - place.at + 180.0) % 360.0 - 180.0
        for due in (1e-9, -1e-9, 1e-3, -10.0):
            assert np.abs(off - due).min() < 1e-12
    assert found.digits.max() <= MOST


def test_a_scene_without_a_mechanism_is_refused() -> None:
    with pytest.raises(SceneError, match="walks the drive of a mechanism"):
        walk(gallery.scene("cam"))


@pytest.mark.parametrize("text", [drives.BOOM, drives.SLIDER, drives.RACK])
def test_digits_along_a_length_are_left(text: str) -> None:
    found = judged(walk(drives.scene(text)), every=3)
    assert found.said.size > 200
    assert found.away.min() >= 0.0, found.names[int(found.away.argmin())]
    assert np.median(found.away) < 3.5
    assert not found.drawn


@pytest.mark.slow
@pytest.mark.parametrize("kind", WAYS)
def test_digits_of_random_drives_up_to_where_they_lock(
    kind: str, many: Callable[[int, int], int]
) -> None:
    """Where figures touch, and only there, they may miss each other at 50 digits."""
    for seed in range(1, many(9, 4)):
        walked = walk(graphic_tmm.read(random_of(kind, seed, forces=True)[1]))
        found = judged(walked, every=7)
        assert found.away.min() >= 0.0, (seed, found.names[int(found.away.argmin())])
        assert not found.drawn, seed
        for _, at in found.gone:
            near = walked.nearest(at)
            assert near is not None
            assert near.times > 1e6
            assert walked.span.apart(near.at, at) < 1e-9 * walked.span.offs[0]
