"""From letters back to keys of the scene: which number of it a letter of the log stands for.

Nobody writes that map down. All numbers of the mechanism are changed, each by a share of its own, and the scene
is recorded again: a letter that changes by the share of one number is that number. A letter that follows from
several, as the side of a plate does, is none, and so is a number that several letters stand for.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from copy import deepcopy
from dataclasses import replace
from itertools import product
from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board.values import Number
from graphic_tmm.errors import TmmError
from graphic_tmm.mechanism.records import Guide, Link, Mechanism
from graphic_tmm.project import Project, record
from graphic_tmm.scene.declare import Path
from graphic_tmm.scene.document import Document
from graphic_tmm.scene.meaning import leaves, value_at
from graphic_tmm.scene.read import understood
from graphic_tmm.scene.records import Scene

STEP = 2.0**-12
"""Numbers are changed by one, two, three … times this share: less than a length of a mechanism is known to."""
ALIKE = 1e-9
"""Shares are the same to this: far less than a step, far more than rounding."""
IN_MM = 1000.0
"""Lengths in mm are known in m."""
OWN = frozenset({"frame", "link", "lengths", "joints", "sheet", "hand"})
"""Sections whose numbers are those of the mechanism, or of no quantity."""
WITH_UNIT = re.compile(r"([-+]?[\d.]+(?:[eE][-+]?\d+)?) ?(.*)")
"""A number of a file, and its unit."""
Letter = tuple[str, str]
"""View and letter of a mark."""


class Key(NamedTuple):
    """A number of the scene: the head of its table, its name there, its pair if it is one of two, its value.

    ``part``: which of the pair; ``rest``: what stands behind a pair in a table of its own.
    """

    table: str
    name: str
    value: float
    unit: str
    pair: tuple[float, float] | None = None
    part: int = 0
    rest: str = ""


class Meaning(NamedTuple):
    """What a letter is: a number of the scene, times ``by``; less another number first, if there is one."""

    key: Key
    by: float
    less: Key | None = None

    def data(self) -> dict[str, Any]:
        """Return it as JSON takes it."""
        key, less = self.key, self.less
        found: dict[str, Any] = {"in": key.table, "name": key.name, "unit": key.unit, "by": self.by}
        if key.pair is not None:
            found |= {"pair": list(key.pair), "part": key.part, "rest": key.rest}
        return found if less is None else found | {"less": [less.table, less.name, less.part]}


def opposite_of(name: str) -> str:
    """Return the letter whose opposite another is: ω_1 of (−ω_1); "" of all others."""
    return name[2:-1] if name.startswith("(−") else ""


def keys(scene: Scene, project: Project) -> dict[Letter, Meaning]:
    """Return what letters are in the scene; letters that are not there follow from several numbers.

    A number on which such a letter hangs is left out, too.
    """
    assert scene.mechanism is not None
    numbers = list(_numbers(scene.mechanism))
    shares = [STEP * (k + 1) for k in range(len(numbers))]
    old, new = _given(project), _changed(scene, shares)
    found: dict[Letter, int] = {}
    for letter, value in old.items():
        share = new.get(letter, value) / value - 1.0 if value else 0.0
        near = round(share / STEP) - 1
        if 0 <= near < len(shares) and abs(share - shares[near]) < ALIKE:
            found[letter] = near
    names: dict[int, set[str]] = {}
    for (_, name), k in found.items():
        names.setdefault(k, set()).add(opposite_of(name) or name)
    found = {letter: k for letter, k in found.items() if len(names[k]) == 1}
    meanings = {
        letter: Meaning(numbers[k], old[letter] / numbers[k].value) for letter, k in found.items()
    }
    own = set(found.values())
    for letter, value in old.items():
        for p, q in product(set(range(len(numbers))) - own, own) if letter not in found else ():
            less, then = (
                many[0] * numbers[p].value - many[1] * numbers[q].value
                for many in ((1.0, 1.0), (1.0 + shares[p], 1.0 + shares[q]))
            )
            if (
                less
                and abs(value / less - new.get(letter, 0.0) / then) < ALIKE
                and abs(abs(value / less) - 1.0) < ALIKE
            ):
                meanings[letter] = Meaning(numbers[p], value / less, numbers[q])
    rest = {letter: value for letter, value in old.items() if letter not in meanings}

    def free(some: set[int]) -> bool:
        """Whether numbers leave alone what no letter is."""
        alone = _changed(scene, [share if k in some else 0.0 for k, share in enumerate(shares)])
        return all(abs(alone.get(letter, v) - v) <= ALIKE * abs(v) for letter, v in rest.items())

    if not free(own):
        alone = {numbers[k] for k in own if free({k})}
        meanings = {
            letter: one
            for letter, one in meanings.items()
            if one.key in alone and (one.less is None or one.less in alone)
        }
    return _elsewhere(scene, old) | meanings


def _elsewhere(scene: Scene, old: Mapping[Letter, float]) -> dict[Letter, Meaning]:
    """Return what letters are numbers of other sections of the scene: a key of a table, a unit behind it."""
    found: list[tuple[Path, Key]] = []
    for path, _, value in leaves(scene.doc):
        key = _written(scene.doc, path, value)
        if key is not None:
            found.append((path, key))
    doc = deepcopy(scene.doc)
    for k, (path, key) in enumerate(found):
        table = value_at(doc, path[:-1])
        table[path[-1]] = _text(key.value * (1.0 + STEP * (k + 1)), key.unit)
    try:
        new = _given(record(understood(doc, scene.source)))
    except TmmError:
        return {}
    meanings: dict[Letter, Meaning] = {}
    for letter, value in old.items():
        share = new.get(letter, value) / value - 1.0 if value else 0.0
        near = round(share / STEP) - 1
        if 0 <= near < len(found) and abs(share - STEP * (near + 1)) < ALIKE:
            _, key = found[near]
            meanings[letter] = Meaning(
                key, value / (key.value / (IN_MM if key.unit == "mm" else 1.0))
            )
        elif abs(share) > ALIKE:
            return {}
    names: dict[Key, set[str]] = {}
    for (_, name), one in meanings.items():
        names.setdefault(one.key, set()).add(name)
    return {letter: one for letter, one in meanings.items() if len(names[one.key]) == 1}


def _written(doc: Document, path: Path, value: object) -> Key | None:
    """Return a number of a section, as the file has it; None of what is none, or of a mechanism's own."""
    if len(path) != 2 or path[0] in OWN or not isinstance(doc[str(path[0])], Mapping):
        return None
    text = f"{value!r} " if isinstance(value, float) else value if isinstance(value, str) else ""
    told = WITH_UNIT.fullmatch(text)
    if told is None or not float(told[1]):
        return None
    return Key(f"[{path[0]}]", str(path[1]), float(told[1]), told[2])


def _text(value: float, unit: str) -> object:
    return f"{value!r} {unit}" if unit else value


def _given(project: Project) -> dict[Letter, float]:
    return {
        mark.key: float(np.asarray(value).item())
        for mark, value in project.given.items()
        if mark.kind is Number and np.asarray(value).size == 1
    }


def _changed(scene: Scene, shares: list[float]) -> Mapping[Letter, float]:
    """Return what is given by a scene whose numbers are changed; nothing where it cannot be recorded."""
    assert scene.mechanism is not None
    left = iter(shares)
    try:
        return _given(record(replace(scene, mechanism=_by(scene.mechanism, lambda _: next(left)))))
    except TmmError:
        return {}


def _numbers(mechanism: Mechanism) -> Iterator[Key]:
    """Yield the numbers of a mechanism that are not nothing, in the order in which they are changed."""
    found: list[Key] = []

    def entered(key: Key) -> float:
        found.append(key)
        return 0.0

    _by(mechanism, entered)
    yield from found


Share = Callable[[Key], float]


def _by(mechanism: Mechanism, share: Share) -> Mechanism:
    """Return a mechanism each of whose numbers is changed by a share of it."""
    frame = _link(mechanism.frame, "[frame]", "", share)
    guides = tuple(_guide(one, share) for one in frame.guides)
    frame = replace(frame, guides=guides)
    named = {one.name: one for one in guides}
    links = []
    for link in mechanism.links:
        made = _link(link, f"[[link]]\nnumber = {link.number}", "points.", share)
        slides = tuple(
            replace(one, guide=named.get(one.guide.name, one.guide))
            if one.on == frame.number
            else one
            for one in made.slides
        )
        links.append(replace(made, slides=slides))
    drive = mechanism.drive
    speed = drive.speed
    if speed and not drive.rates:
        speed *= 1.0 + share(Key("[drive]", "speed", abs(speed), ""))
    return replace(mechanism, frame=frame, links=tuple(links), drive=replace(drive, speed=speed))


def _link(link: Link, table: str, before: str, share: Share) -> Link:
    points = {
        name: _pair(table, f"{before}{name}", at, "", share) for name, at in link.points.items()
    }
    mass, inertia = link.mass, link.inertia
    if mass:
        mass *= 1.0 + share(Key(table, "mass", mass, "kg"))
    if inertia and link.rod is None:
        inertia *= 1.0 + share(Key(table, "J", inertia, "kg*m^2"))
    return replace(link, points=points, mass=mass, inertia=inertia)


def _guide(guide: Guide, share: Share) -> Guide:
    rest = f', angle = "{guide.angle!r} deg" }}'
    return replace(guide, through=_pair("[frame]", guide.name, guide.through, rest, share))


def _pair(table: str, name: str, at: complex, rest: str, share: Share) -> complex:
    pair = (at.real, at.imag)
    changed = [
        x * (1.0 + share(Key(table, name, x, "mm", pair, k, rest))) if x else x
        for k, x in enumerate(pair)
    ]
    return complex(*changed)
