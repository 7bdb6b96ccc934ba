"""What is given where lengths are to be found: what follows from these is told by them, never as a figure.

A scene may give K_v and a stroke and let the package find the lengths, and write other lengths by those it
finds ("OB + 1.25 BC"). The figures of all of these would hand the solution out. How they follow is seen by
setting other values: the mechanism is drawn with such ones too, for a scheme that nobody can measure.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product
from pathlib import Path as File

import numpy as np

from graphic_tmm.errors import TmmError
from graphic_tmm.language.numbers import number
from graphic_tmm.language.units import small
from graphic_tmm.readers.protocol import synthesis
from graphic_tmm.readers.task_sheet import Given, given_rows, sought
from graphic_tmm.scene.chapter import MECHANISM
from graphic_tmm.scene.read import judged
from graphic_tmm.scene.records import Scene
from graphic_tmm.scene.splice import set_to

SHARES = ((1.2, 0.8), (1.1, 0.9), (1.3, 1.0), (0.8, 0.9))
"""By how much K_v − 1 and the stroke are another for a scheme not to scale; the first that can be read."""
TRIED = (1.0, 1.01)
"""The same for what is seen to follow."""
EXACT = 1e-9
"""What follows by no sum of lengths to this share is not told."""


def other(scene: Scene, text: str, share: float, stroke: float) -> Scene:
    """Return a scene whose task has another K_v and another stroke, by shares."""
    task = scene.task
    assert task is not None
    text = set_to(text, ("task", "K_v"), repr(1.0 + (task.K_v - 1.0) * share))
    text = set_to(text, ("task", "stroke"), repr(task.stroke * stroke))
    made = judged(text.encode("utf-8"), File(scene.source))
    return made


def disguised(scene: Scene, text: str) -> Scene | None:
    """Return a scene with other lengths than those sought; None if none can be read."""
    for shares in SHARES:
        try:
            return other(scene, text, *shares)
        except TmmError:
            continue
    return None


def told_rows(scene: Scene, text: str, board: str = MECHANISM) -> list[Given]:
    """Return what a scene gives for a board; what follows from what is sought is told by it."""
    hidden = sought(scene)
    rows = [row for row in given_rows(scene, board) if row.symbol not in hidden]
    if scene.task is None or board != MECHANISM:
        return rows
    tried = [other(scene, text, *shares) for shares in product(TRIED, TRIED)]
    stated = {mark.name for mark in _synthesis(scene)[0]}
    tables = [{row.symbol: row.value for row in given_rows(one, board)} for one in tried]
    found = list[Given]()
    for row in rows:
        values = [table.get(row.symbol) for table in tables]
        if row.symbol in stated or len(set(values)) == 1:
            found.append(row)
        elif says := _sum(tried, values, scene.language):
            found.append(row._replace(value=says))
    return found


def _synthesis(scene: Scene) -> tuple[frozenset, dict[str, float]]:  # type: ignore[type-arg]
    found = synthesis(scene)
    assert found is not None
    own = {name for name, mark in found.lengths.items() if mark not in found.given}
    return frozenset(found.given), {
        n: small(v, scene.language)[0] for n, v in found.values().items() if n in own
    }


def _sum(tried: Sequence[Scene], values: Sequence[object], language: str) -> str:
    """Return a length as a sum of lengths sought, "480 + 1.25·BC"; "" if it is none."""
    if not all(isinstance(value, (int, float)) for value in values):
        return ""
    lengths = [_synthesis(one)[1] for one in tried]
    names = list(lengths[0])
    sides = np.array([[1.0, *(one[name] for name in names)] for one in lengths])
    due = np.array(values, dtype=np.float64)
    by = np.linalg.lstsq(sides, due, rcond=None)[0]
    if np.abs(sides @ by - due).max() > EXACT * np.abs(due).max() * len(due):
        return ""
    terms = [(by[0], ""), *zip(by[1:], names, strict=True)]
    least = 1e-6
    told = ""
    for factor, name in terms:
        if abs(factor) < (least if name else least * np.abs(due).max()):
            continue
        size = number(abs(float(f"{factor:.6g}")), language, 6)
        term = size if not name else name if size == "1" else f"{size}·{name}"
        sign = "−" if factor < 0 else "+"
        told += f" {sign} {term}" if told else term if factor > 0 else f"−{term}"
    return told
