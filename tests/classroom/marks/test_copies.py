"""Hand-ins that are alike: the chance of equal figures against draws, honest classes, copies."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from support.each import each

from graphic_tmm.classroom.marks.copies import (
    FEWEST_TELLING,
    Other,
    alike,
    looks_like,
    rareness,
    rounded_alike,
)
from graphic_tmm.classroom.marks.row import MM, SPOT, Figure, Row

SLIP = 0.8


@each("grain", [0.1, 0.5, 1.0])
@each("slip", [0.2, 0.8])
def test_the_chance_that_slips_round_alike(grain: float, slip: float) -> None:
    rng = np.random.default_rng(3)
    due = rng.uniform(0, grain, 400_000)
    one, other = (
        np.floor((due + slip * rng.standard_normal(due.size)) / grain + 0.5) for _ in range(2)
    )
    assert abs(float(np.mean(one == other)) - rounded_alike(grain, slip)) < 0.004


def test_the_bound_is_above_the_chance() -> None:
    rng = np.random.default_rng(4)
    chances = rng.uniform(0.05, 0.4, 30)
    drawn = (rng.random((200_000, 30)) < chances).sum(axis=1)
    for equal in range(8, 18):
        assert np.exp(-rareness(equal, list(chances))) >= np.mean(drawn >= equal)


def row(found: np.ndarray, due: np.ndarray, kind: str = MM, grain: float = 0.5) -> Row:
    """Return a row with measured figures, (reading,) or (reading, 2)."""
    pairs = zip(found.reshape(len(due), -1), due.reshape(len(due), -1), strict=True)
    return Row(
        figures=tuple(
            Figure(
                ("velocities", f"s{k}", "1"), kind, tuple(map(float, f)), tuple(map(float, d)), 2.0,
                float(np.linalg.norm(f - d)) / SLIP, grain, SLIP,
            )
            for k, (f, d) in enumerate(pairs)
        )
    )  # fmt: skip


def read(rng: np.random.Generator, due: np.ndarray, slip: float = SLIP) -> np.ndarray:
    return np.floor((due + slip * rng.standard_normal(due.shape)) / 0.5 + 0.5) * 0.5


@pytest.mark.slow
@each("slip", [SLIP, 0.3, 0.02])
def test_honest_classes_are_not_told(slip: float, many: Callable[[int, int], int]) -> None:
    """Of hands as they are taken for, of careful ones, and of drawings by a computer."""
    rng = np.random.default_rng(5)
    for _ in range(many(20, 5)):
        due = rng.uniform(10, 90, 40)
        assert alike([row(read(rng, due, slip), due) for _ in range(30)]) == ()


@each("kind", [MM, SPOT])
def test_a_copy_is_told_and_nobody_else(kind: str) -> None:
    rng = np.random.default_rng(6)
    due = rng.uniform(10, 90, (40, 2) if kind == SPOT else 40)
    class_ = [row(read(rng, due), due, kind) for _ in range(10)]
    changed = np.array([one.found for one in class_[2].figures]).reshape(due.shape)
    changed[:2] += 1.0
    class_.append(row(changed, due, kind))
    (pair,) = alike(class_)
    assert (pair.one, pair.other, pair.equal, pair.of) == (2, 10, 38, 40)


def test_a_few_equal_readings_are_nothing() -> None:
    due = np.full(5, 40.0)
    same = row(np.full(5, 41.5), due)
    assert alike([same, same]) == ()


def test_what_was_calculated_is_not_counted() -> None:
    due = np.linspace(10, 60, 40)
    given = row(due, due)
    given = given._replace(figures=tuple(f._replace(grain=0.0, slip=0.0) for f in given.figures))
    assert alike([given, given]) == ()


@each("telling, fits", [(FEWEST_TELLING - 1, False), (FEWEST_TELLING, True), (9, True)])
def test_a_hand_in_looks_like_the_variant_that_so_many_readings_tell_and_fit(
    telling: int, fits: bool
) -> None:
    """Of twelve readings so many are due 10 mm farther in the other variant, where they were read."""
    due = np.linspace(20.0, 80.0, 12)
    other = due + np.where(np.arange(12) < telling, 10.0, 0.0)
    handed = row(other, due)
    keys = ((one.key, one.kind) for one in handed.figures)
    dues = dict(zip(keys, ((float(d),) for d in other), strict=True))
    assert looks_like(handed, {"07": dues}) == (Other("07", telling, telling) if fits else None)
    assert looks_like(row(due, due), {"07": dues}) is None
