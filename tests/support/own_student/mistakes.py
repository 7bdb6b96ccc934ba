"""What people do wrongly when they draw plans: from how the method is taught, and what is marked in red.

`kinds.txt` has a line of each kind: where it is made, of what family it is, which words a teacher would
accept as its name (a pattern), a knob of the construction or what is done to the table, who can make it,
and whether in one position.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from .measured import Figure

MACHINES = {
    "all": "sc fb frc rpr six header",
    "linked": "sc fb frc",
    "slot": "rpr six header",
}
WAYS = {
    "lengths": ("mm", "mm and rates", "mm and values"),
    "rates": ("mm and rates", "mm and values"),
    "no values": ("mm", "mm and rates"),
    "mm, points": ("mm", "points"),
    "any": ("mm", "mm and rates", "mm and values", "points"),
    "points": ("points",),
}
DRAWN = ("positions", "velocities", "accelerations")
Figures = list[Figure]


class Truth(NamedTuple):
    """What is wrong: in which plan, at which of these segments, in which position (none: all)."""

    name: str
    plan: str
    segments: tuple[str, ...]
    position: int | None
    family: str
    words: str


class Kind(NamedTuple):
    """A kind of mistake: as its line in `kinds.txt`; ``only``: in which positions it is made, if in one."""

    name: str
    plan: str
    segments: tuple[str, ...]
    family: str
    words: str
    knobs: Mapping[str, Any]
    table: str
    machines: tuple[str, ...]
    ways: tuple[str, ...]
    single: bool
    only: tuple[int, ...]

    @property
    def scene_mu(self) -> bool:
        """Whether it is only wrong in the scale factors of the task."""
        return self.family == "copy"

    def truth(self, place: int | None, segments: Sequence[str] = ()) -> Truth:
        """Return what is wrong, where it was done in a position."""
        return Truth(
            self.name, self.plan, tuple(segments or self.segments), place, self.family, self.words
        )


def _setting(text: str) -> tuple[str, Any]:
    knob, _, value = text.partition("=")
    try:
        return knob, float(value)
    except ValueError:
        return knob, value


def kinds() -> tuple[Kind, ...]:
    """Return all kinds of mistakes, as they are written down."""
    found = []
    for line in (Path(__file__).parent / "kinds.txt").read_text(encoding="utf-8").splitlines()[1:]:
        name, plan, segments, family, words, what, machines, ways, where = line.split("; ")
        table = what.removeprefix("table ") if what.startswith("table ") else ""
        knobs = {} if table else dict(_setting(one) for one in what.split(", "))
        only = tuple(map(int, where.removeprefix("one of ").split())) if "of" in where else ()
        who = tuple(MACHINES.get(machines, machines).split())
        segment_names = tuple(segments.split())
        found.append(
            Kind(
                name,
                plan,
                segment_names,
                family,
                words,
                knobs,
                table,
                who,
                WAYS[ways],
                where != "all",
                only,
            )
        )
    return tuple(found)


def amiss(
    kind: Kind, figures: Figures, rng: np.random.Generator, place: int | None
) -> tuple[Figures, Truth]:
    """Return figures as a kind of mistake in the table leaves them, and what is wrong."""
    what, _, by = kind.table.partition(" ")
    if kind.table.startswith("plan "):
        return _plan(kind, figures, place), kind.truth(place)
    if what == "copy":
        return _copy(figures, float(by)), kind.truth(None)
    return TABLES[what](kind, figures, rng)


def _changed(kind: Kind, mm: float) -> float:
    """Return what is written for one length, mm."""
    what, _, by = kind.table.removeprefix("plan ").partition(" ")
    if what == "times":
        return round(mm * float(by), 2)
    if what == "plus":
        return mm + float(by)
    shown = f"{mm:g}"
    if mm < 10 or shown[0] == shown[1]:
        return mm + 20
    return float(shown[1] + shown[0] + shown[2:])


def _row(kind: Kind, figures: Figures, rng: np.random.Generator) -> tuple[Figures, Truth]:
    """Write one row amiss; its quantity is calculated from the wrong length."""
    plain = [i for i, one in enumerate(figures) if one.plan == kind.plan and (one.mm or 0) >= 15]
    i = int(rng.choice(plain))
    one = figures[i]
    assert one.mm is not None
    mm = _changed(kind, one.mm)
    value = one.value * mm / one.mm if one.value is not None else None
    return [*figures[:i], one._replace(mm=mm, value=value), *figures[i + 1 :]], kind.truth(
        one.position, [one.segment]
    )


def _plan(kind: Kind, figures: Figures, place: int | None) -> Figures:
    """Write all lengths of a plan amiss."""
    return [
        one._replace(mm=_changed(kind, one.mm))
        if one.plan == kind.plan and one.mm is not None and place in (None, one.position)
        else one
        for one in figures
    ]


def _columns(kind: Kind, figures: Figures, rng: np.random.Generator) -> tuple[Figures, Truth]:
    """Write two segments of a position in each other's column."""
    pairs = [
        (i, j)
        for i, a in enumerate(figures)
        for j, b in enumerate(figures[:i])
        if a.plan == b.plan == kind.plan
        and a.position == b.position
        and min(a.mm or 0, b.mm or 0) > 8
        and abs((a.mm or 0) - (b.mm or 0)) > 15
    ]
    if not pairs:
        raise ValueError(f"{kind.name} does not show")
    i, j = pairs[int(rng.integers(len(pairs)))]
    a, b = figures[i], figures[j]
    out = list(figures)
    out[i], out[j] = a._replace(mm=b.mm, value=b.value), b._replace(mm=a.mm, value=a.value)
    return out, kind.truth(a.position, [a.segment, b.segment])


def _positions(kind: Kind, figures: Figures, rng: np.random.Generator) -> tuple[Figures, Truth]:
    """Write the whole plan of a position as that of the next, and the other way round."""
    there = sorted({one.position for one in figures if one.plan == kind.plan})
    k = int(rng.choice(there[:-1]))
    j = there[there.index(k) + 1]
    other = {k: j, j: k}
    moved = [
        one._replace(position=other.get(one.position, one.position))
        if one.plan == kind.plan
        else one
        for one in figures
    ]
    return moved, kind.truth(k)


def _sign(kind: Kind, figures: Figures, rng: np.random.Generator) -> tuple[Figures, Truth]:
    """Write an angular velocity with the other sign."""
    rows = [
        i
        for i, one in enumerate(figures)
        if one.segment in kind.segments and abs(one.value or 0) > 1
    ]
    i = int(rng.choice(rows))
    out = list(figures)
    out[i] = out[i]._replace(value=-(out[i].value or 0))
    return out, kind.truth(out[i].position, [out[i].segment])


def _copied(kind: Kind, figures: Figures, rng: np.random.Generator) -> tuple[Figures, Truth]:
    """Write one segment of a position with the figures of the position before."""
    by = {(one.plan, one.segment, one.position): one for one in figures if one.spot is None}
    rows = [
        (i, before)
        for i, one in enumerate(figures)
        if one.plan == kind.plan
        and one.mm is not None
        and (before := by.get((one.plan, one.segment, one.position - 1))) is not None
        and abs((before.mm or 0) - one.mm) > 15
    ]
    if not rows:
        raise ValueError(f"{kind.name} does not show")
    i, before = rows[int(rng.integers(len(rows)))]
    out = list(figures)
    out[i] = out[i]._replace(mm=before.mm, value=before.value)
    return out, kind.truth(out[i].position, [out[i].segment])


def _copy(figures: Figures, factor: float) -> Figures:
    """Measure everything on a copy; quantities by the scale factors of the task."""

    def shrunk(one: Figure) -> Figure:
        if one.plan not in DRAWN or (one.mm is None and one.spot is None):
            return one
        if one.spot is not None:
            return one._replace(spot=one.spot * factor)
        value = one.value * factor if one.value is not None else None
        return one._replace(mm=round((one.mm or 0) * factor, 1), value=value)

    return [shrunk(one) for one in figures]


TABLES: Mapping[str, Callable[[Kind, Figures, np.random.Generator], tuple[Figures, Truth]]] = {
    "digits": _row,
    "times": _row,
    "plus": _row,
    "columns": _columns,
    "positions": _positions,
    "sign": _sign,
    "copied": _copied,
}
KINDS = kinds()
