"""What goes wrong outside any grammar of one mistake: no name is right, "no known mistake" is.

A report may tell instruments or slips of single readings where that is what happened.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from support.another_hand import Rows
from support.students.early_tables import number_in, picked, segments
from support.students.kinds import AtGiven, AtStep, AtTable, Kind, Variant, Written
from support.students.records import POLES, A, Step
from support.students.tools import Tools

LINKS = ("OA", "AB", "CB", "BC", "CD", "B", "C", "stroke", "r0", "e", "H_V", "H_a")


def _another_variant(
    given: dict[str, Any], rng: np.random.Generator, tools: Tools
) -> Iterator[Variant]:
    """The assignment of another student: every length is another."""
    names = [name for name in LINKS if name in given]
    yield (
        {name: given[name] * (1 + rng.choice([-1, 1]) * rng.uniform(0.06, 0.15)) for name in names},
        (),
    )


def _another_point(step: Step, tools: Tools) -> Iterator[Variant]:
    """A plan drawn for a point of the link that the scene does not have."""
    yield {"shape": complex(step.takes["shape"]) * 0.55 + 0.25 + 0.3j}, ()


def _gradian(step: Step, tools: Tools) -> Iterator[Variant]:
    """A protractor of 400 parts, read the other way from an odd zero."""
    yield {"part": -0.9, "first": 0.29, "turn": 1}, ()


def _own_guide(step: Step, tools: Tools) -> Iterator[Variant]:
    """A guide beside O; where its height is given, that would be a given misread."""
    if step.takes.get("low") == 0.0:
        yield {"low": step.takes["low"] + 13.0}, ()


def _odd_ray(step: Step, tools: Tools) -> Iterator[Variant]:
    """A ray after a triangle that had slipped: by an angle of no meaning."""
    yield {"off": 23.0}, ()
    yield {"off": -17.0}, ()


def _constant(step: Step, tools: Tools) -> Iterator[Variant]:
    """The same in every position, whatever the speed."""
    yield {"square": 0, "power": 0, "factor": 17.0 * tools.mu[A]}, ()


def whole(rows: Rows, segments_: frozenset[str] = frozenset()) -> Written:
    return Written(rows, "", segments_, "")


def scaled(rows: Rows, keys: list[Any], by: list[float]) -> Rows:
    changed = {key: list(cells) for key, cells in rows.items()}
    for key, factor in zip(keys, by, strict=True):
        for cell in (0, 1, 3, 4):
            if changed[key][cell]:
                changed[key][cell] = f"{float(changed[key][cell]) * factor:.4g}"
    return changed


def _two_slips(rows: Rows, rng: np.random.Generator, tools: Tools) -> Written | None:
    """Two slips of the ruler that have nothing to do with one another."""
    keys = [key for key, cells in rows.items() if cells[0] and float(cells[0]) > 25.0]
    if len(keys) < 2:
        return None
    two = [keys[k] for k in rng.choice(len(keys), 2, replace=False)]
    by = [1 + rng.choice([-1, 1]) * rng.uniform(9, 14) / float(rows[key][0]) for key in two]
    return Written(scaled(rows, two, by), "", frozenset(key[2] for key in two), "")


def _second_student(rows: Rows, rng: np.random.Generator, tools: Tools) -> Written | None:
    """Half of the readings by somebody with another μ."""
    by = rng.choice([0.8, 1.25, 1.6])
    keys = [key for key in rows if rng.random() < 0.5]
    return whole(scaled(rows, keys, [by] * len(keys)))


def _guessed(rows: Rows, rng: np.random.Generator, tools: Tools) -> Written | None:
    """One segment guessed instead of drawn."""
    plan, name = picked(rng, segments(rows))
    keys = [key for key in rows if (key[0], key[2]) == (plan, name)]
    by = list(rng.uniform(0.4, 1.7, len(keys)))
    return Written(scaled(rows, keys, by), plan, frozenset({name}), "")


def _trembling(rows: Rows, rng: np.random.Generator, tools: Tools) -> Written | None:
    """A whole plan drawn in a moving bus: everything 12 % off at random."""
    plan = picked(rng, sorted({key[0] for key in rows}))
    keys = [key for key in rows if key[0] == plan]
    return Written(
        scaled(rows, keys, list(1 + 0.12 * rng.standard_normal(len(keys)))), plan, frozenset(), ""
    )


def _trend(rows: Rows, rng: np.random.Generator, tools: Tools) -> Written | None:
    """Readings that were made to fit: each 4 % more than the one before."""
    plan, name = picked(rng, segments(rows))
    keys = [
        key for key in rows if (key[0], key[2]) == (plan, name) and number_in(rows[key]) is not None
    ]
    by = [1.04 ** (k + 2) for k in range(len(keys))]
    return Written(scaled(rows, keys, by), plan, frozenset({name}), "")


def _neighbour(rows: Rows, rng: np.random.Generator, tools: Tools) -> Written | None:
    """Some positions from a sheet drawn with other lengths."""
    chosen = {str(k) for k in rng.choice(8, 3, replace=False)}
    keys = [key for key in rows if key[1] in chosen]
    return whole(scaled(rows, keys, [float(rng.uniform(0.8, 1.25)) for _ in keys]))


def at_pole(step: Step) -> bool:
    return step.takes["start"] == POLES.get(step.plan)


OUTSIDE: tuple[Kind, ...] = (
    AtGiven("lengths of another variant", (), _another_variant),
    AtStep("another point of the link", (), ("image",), _another_point, ("everywhere",)),
    AtStep("gradian", (), ("crank",), _gradian, ("everywhere",)),
    AtStep("another guide", (), ("meeting",), _own_guide, ("everywhere",)),
    AtStep("slipped triangle", (), ("ray",), _odd_ray),
    AtStep("formula of his own", (), ("normal",), _constant, ("everywhere",)),
    AtTable("two slips of the ruler", (), _two_slips, ("mm", "both")),
    AtTable("second student with another μ", (), _second_student),
    AtTable("guessed segment", (), _guessed),
    AtTable("trembling plan", (), _trembling),
    AtTable("made to fit", (), _trend),
    AtTable("positions of another sheet", (), _neighbour),
)
