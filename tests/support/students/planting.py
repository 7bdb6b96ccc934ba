"""Drawings with mistakes planted: readings of a student, and the truth about them."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from typing import Any, NamedTuple

import numpy as np

from support.another_hand import Rows
from support.students.drawing import Student
from support.students.kinds import KIND, POSITION, AtGiven, AtStep, AtTable, Kind
from support.students.places import Place, own_places, taking_given
from support.students.records import Hand, Mind, Operands, Step
from support.students.writing import ALL, rows_of

VISIBLE = 5.0
"""A mistake shows if it moves a reading by so many standard deviations of what the hand scatters there."""
TRIES = 12


class Truth(NamedTuple):
    """What was planted: kind, families (none: outside), where, words of a good name, how many readings show it.

    ``places``: plan and segment of the step, or of what is first read that shows it; a plan with "": anywhere
    in it, ("", ""): anywhere. ``position``: "" for everywhere.
    """

    kind: str
    families: tuple[str, ...]
    places: frozenset[Place]
    position: str
    words: tuple[str, ...]
    moved: int

    @property
    def shown(self) -> bool:
        """Whether any reading shows it."""
        return self.moved > 0


class Planted(NamedTuple):
    """A drawing: of which machine, how it was read, which seed; its readings, what is wrong with it."""

    machine: str
    mode: str
    seed: int
    rows: Rows
    truths: tuple[Truth, ...]
    ruler: float = 0.5


def numbers(cells: list[str]) -> np.ndarray:
    return np.array([float(cells[k]) if cells[k] else np.nan for k in (0, 1, 3, 4)])


@cache
def scatter(machine: str, mode: str, ruler: float) -> dict[tuple[str, str, str], np.ndarray]:
    """Return how far the honest hand scatters each reading; not less than it was rounded by."""
    found: dict[tuple[str, str, str], list[np.ndarray]] = {}
    for seed in range(9000, 9020):
        rows = rows_of(Student(ALL[machine], Hand(ruler=ruler), seed).draw(), mode)
        for key, cells in rows.items():
            found.setdefault(key, []).append(numbers(cells))
    least = np.array([0.3 * ruler, 0.0, 0.3 * ruler, 0.3 * ruler])
    return {
        key: np.maximum(
            np.std(each, axis=0), np.maximum(least, 2e-4 * np.abs(np.mean(each, axis=0)))
        )
        for key, each in found.items()
    }


def moved(one: Planted, due: Rows) -> list[tuple[str, str, str]]:
    """Return the readings that a mistake moves visibly, in the order of drawing."""
    by, unsigned = scatter(one.machine, one.mode, one.ruler), without_sign(one.rows)
    found = []
    for key, cells in due.items():
        now = one.rows.get(key)
        off = None
        if now and key in by:
            wanted = numbers(cells)
            if (key[0], key[2]) in unsigned:
                wanted[:2] = np.abs(wanted[:2])
            off = np.abs(numbers(now) - wanted)
        if off is None or np.any(off > VISIBLE * by[key]):
            found.append(key)
    return found


def without_sign(rows: Rows) -> set[Place]:
    """Return the segments of which no figure is negative: their readings may tell sizes alone."""
    names = {(plan, name) for plan, _, name in rows}
    negative = {
        (plan, name)
        for (plan, _, name), cells in rows.items()
        if np.nanmin([0.0, *numbers(cells)[:2]]) < 0
    }
    return names - negative


def mind_of(step: Step, takes: Operands, position: int | None, kind: AtStep | None = None) -> Mind:
    """Return a mind that takes something else at a step; ``kind``: at every step where it can be made."""

    def mind(one: Step) -> Operands:
        if position is not None and one.position != position:
            return {}
        if kind is not None and one.kind == step.kind and one.plan == step.plan:
            return {name: value for name, value in takes.items() if name in one.takes}
        return takes if (one.plan, one.name, one.kind) == (step.plan, step.name, step.kind) else {}

    return mind


def plant(kind: Kind, machine: str, seed: int, mode: str, ruler: float = 0.5) -> Planted | None:
    """Draw a mechanism with a mistake of a kind, one that shows if one can be found; None if there is none."""
    rng = np.random.default_rng(seed)
    honest = Student(ALL[machine], Hand(ruler=ruler), seed).draw()
    due, last = rows_of(honest, mode), None
    for _ in range(TRIES):
        one = _once(kind, machine, seed, mode, rng, honest, due, ruler)
        if one is not None and one.truths[0].shown:
            return one
        last = one or last
    return last


def _once(
    kind: Kind, machine: str, seed: int, mode: str, rng: np.random.Generator, honest: Student,
    due: Rows, ruler: float,
) -> Planted | None:  # fmt: skip
    if isinstance(kind, AtTable):
        return _tabled(kind, machine, seed, mode, rng, honest, due, ruler)
    made = _mistaken(kind, machine, seed, rng, honest, ruler)
    if made is None:
        return None
    drawn, places, position, words = made
    rows = rows_of(drawn, mode)
    if rows.keys() != due.keys():
        return None  # it could not be drawn to its end
    one = Planted(machine, mode, seed, rows, (), ruler)
    first = moved(one, due)
    shown = [(key[0], key[2]) for key in first if key[1] == (position or first[0][1])][:1]
    families = kind.families
    truth = Truth(kind.name, families, frozenset({*places, *shown}), position, words, len(first))
    return one._replace(truths=(truth,))


def _mistaken(
    kind: AtStep | AtGiven, machine: str, seed: int, rng: np.random.Generator, honest: Student,
    ruler: float,
) -> tuple[Student, set[Place], str, tuple[str, ...]] | None:  # fmt: skip
    hand = Hand(ruler=ruler)
    with np.errstate(all="ignore"):
        if isinstance(kind, AtGiven):
            variants = list(kind.variants(dict(ALL[machine].given), rng, honest))
            if not variants:
                return None
            given, words = variants[rng.integers(len(variants))]
            drawn = Student(ALL[machine], hand, seed, given=given).draw()
            return drawn, taking_given(honest.steps, given), "", words
        chosen = choose(kind, rng, honest)
        if chosen is None:
            return None
        step, takes, words, position, every = chosen
        mind = mind_of(step, takes, position, kind if every else None)
        try:
            drawn = Student(ALL[machine], hand, seed, mind).draw()
        except (KeyError, ArithmeticError):
            return None  # what he takes is not there yet, or has no direction
    places = own_places(step)
    if every:
        places |= {
            place for one in honest.steps if one.kind == step.kind for place in own_places(one)
        }
    return drawn, places, "" if position is None else str(position), words


def choose(
    kind: AtStep, rng: np.random.Generator, honest: Student
) -> tuple[Step, Operands, tuple[str, ...], int | None, bool] | None:
    """Choose a step, what is taken there, and how far the mistake reaches."""
    at = [(step, *variant) for step in honest.steps if step.kind in kind.of
          for variant in kind.variants(step, honest)]  # fmt: skip
    if not at:
        return None
    names = sorted({(step.plan, step.name) for step, _, _ in at})
    name = names[rng.integers(len(names))]
    own = [one for one in at if (one[0].plan, one[0].name) == name]
    step, takes, words = own[rng.integers(len(own))]
    reach = kind.reach[rng.integers(len(kind.reach))]
    return step, takes, words, step.position if reach == POSITION else None, reach == KIND


def _tabled(
    kind: AtTable, machine: str, seed: int, mode: str, rng: np.random.Generator, honest: Student,
    due: Rows, ruler: float,
) -> Planted | None:  # fmt: skip
    if mode not in kind.modes or (machine == "fol" and kind.name.startswith("μ")):
        return None
    written = kind.change(due, rng, honest)
    if written is None:
        return None
    one = Planted(machine, mode, seed, written.rows, (), ruler)
    places = {(written.plan, name) for name in written.segments} or {(written.plan, "")}
    truth = Truth(
        kind.name, kind.families, frozenset(places), written.position, written.words,
        len(moved(one, due)),
    )  # fmt: skip
    return one._replace(truths=(truth,))


def honest_drawings(machine: str, mode: str, seeds: range, **hand: Any) -> Iterator[Planted]:
    """Yield drawings without a mistake, by a hand with its instruments."""
    for seed in seeds:
        drawn = Student(ALL[machine], Hand(**hand), seed).draw()
        yield Planted(machine, mode, seed, rows_of(drawn, mode), (), hand.get("ruler", 0.5))
