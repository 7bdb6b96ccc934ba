"""Centres of mechanisms with a plate on three legs, held against velocities."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from support.plates import machine

import graphic_tmm as tmm
from graphic_tmm.chapters.centres.record import CENTRES_PLAN
from graphic_tmm.project import record
from graphic_tmm.scene.read import read

KINDS = {
    "plain": (4, {}),
    "a guide": (0, {"guides": 1}),
    "two guides": (2, {"guides": 2}),
    "three guides": (1, {"guides": 3}),
    "before": (2, {"before": True}),
    "behind": (4, {"behind": True}),
    "along it": (5, {"slots": 1, "guides": 1}),
    "two along it": (6, {"slots": 2, "before": True}),
    "three along it": (2, {"slots": 3}),
}
AT = np.arange(5.0, 360.0, 35.0)


@pytest.mark.parametrize("kind", KINDS)
def test_what_is_in_a_centre_stands_still(kind: str, tmp_path: Path) -> None:
    """Where a centre with the frame is finite, velocities of a link's points are ω times the arms, square."""
    seed, how = KINDS[kind]
    one = machine(seed, **how)  # type: ignore[arg-type]
    path = tmp_path / "scene.toml"
    path.write_text(f"{one.text}\n[centres]\npositions = [3, 9]\n", "utf-8")
    moved = tmm.motion(path, AT, plans=["positions", "velocities", "centres"], exact=True)
    compared = 0
    for (letter, link), place in moved.places.items():
        centre = moved.centres.get(f"P{link}0")
        if centre is None or link == 0:
            continue
        due = 1j * moved.omega[link] * (place - centre)
        speed = moved.velocities[letter, link]
        there = np.isfinite(centre) & np.isfinite(speed)
        assert np.abs(speed - due)[there].max(initial=0.0) < 1e-6, (letter, link)
        compared += int(there.sum())
    assert compared > 4 * AT.size


@pytest.mark.parametrize("kind", KINDS)
def test_no_centre_is_lost(kind: str, tmp_path: Path) -> None:
    """Two legs on one body cross in the plate's centre with it: lines lead on from there to all others."""
    seed, how = KINDS[kind]
    path = tmp_path / "scene.toml"
    text = machine(seed, **how).text  # type: ignore[arg-type]
    path.write_text(f"{text}\n[centres]\npositions = [3, 9]\n", "utf-8")
    assert not CENTRES_PLAN.on(record(read(path))).lost
