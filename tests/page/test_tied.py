"""Ink tied to marks: with other lengths it is where Python draws it, or hidden, and nowhere else."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping
from typing import NamedTuple

import numpy as np
import pytest
from support import gallery, strangers
from support.other_lengths import drawn_alike, other
from support.scripts import run

from graphic_tmm.board.record import Construction
from graphic_tmm.board.values import Arc, Complexes, Line
from graphic_tmm.drawn import Drawn
from graphic_tmm.page.dense import Dense, dense
from graphic_tmm.page.strands import (
    BENT,
    Key,
    Moving,
    MovingFigures,
    MovingStroke,
    letter_key,
    line_key,
    strands,
)
from graphic_tmm.page.tied import Variant, holding
from graphic_tmm.page.tied_pack import FigureTies
from graphic_tmm.page.trials import values_of
from graphic_tmm.paper.drawing import Drawing, Stroke
from graphic_tmm.paper.expressions import Expressions, Node
from graphic_tmm.scene.records import Scene

SHARES = (0.02, -0.05, 0.1)
"""So much longer or shorter links are than a scene has them, at most."""
ANGLES = 12
NEAR = 0.05
"""Ink that is off by no more is where it should be, mm: of a guide the travel is found at whole degrees."""
LIVE = 0.9
"""Of each scene at least so much of the ink is live."""
LETTERS = 1e-3
"""So much may be letters that share a label where Python draws two, or the other way round."""


class Tied(NamedTuple):
    """Expressions, and by the name of a figure what is tied of it."""

    among: Expressions
    ties: Mapping[str, Mapping[Key, tuple[Variant, ...]]]


def _moving(drawn: Drawn) -> Iterator[Moving]:
    for chapter in drawn.project.chapters:
        yield from MovingFigures.of(chapter).figures(drawn)


def _dense(drawn: Drawn) -> Dense:
    found = dense(drawn)
    assert found is not None
    return found


def _tied(found: Dense) -> Tied:
    made = {one.name: strands(found, one) for one in _moving(found.drawn)}
    ties = FigureTies(found, _moving, made)
    return Tied(ties.among, ties.ties)


def _ink(drawing: Drawing) -> Mapping[Key, list[complex]]:
    met, found = Counter[object](), dict[Key, list[complex]]()
    for one in drawing.strokes:
        if isinstance(one, Stroke):
            bulges = [complex(bulge) for *_, bulge in one.path]
            if max(map(abs, bulges)) < BENT:
                found[line_key(one, met)] = [*(complex(x, y) for x, y, _ in one.path), *bulges]
    found |= {letter_key(one, met): [one.at] for one in drawing.wanted}
    return {key: places for key, places in found.items() if np.isfinite(places).all()}


def _judged(
    due: Mapping[Key, list[complex]],
    ties: Mapping[Key, tuple[Variant, ...]],
    values: Mapping[int, Complexes],
    t: int,
) -> Iterator[tuple[str, Key]]:
    """Yield of all that Python draws, or the page would, whether it is live, hidden or wrong."""
    here = {node: row[t : t + 1] for node, row in values.items()}
    for key in dict.fromkeys((*due, *ties)):
        variants = ties.get(key, ())
        holds = holding(variants, here)
        own = next((one for one, there in zip(variants, holds, strict=True) if there[0]), None)
        if own is not None:
            told = [here[node][0] for node in (*own.places, *own.bulges)]
            same = key in due and len(told) == len(due[key])
            near = same and np.abs(np.subtract(told, due[key])).max() < NEAR
            yield ("live" if near else "wrong"), key
        elif key in due:
            yield "hidden", key


RIGID = ("parallel-cranks", "rolling-centrodes", "equal-rods-89.999")
"""Scenes whose links have no other lengths: they would not be mechanisms."""
OWN = [name for name in gallery.NAMES if name not in RIGID]
OTHERS = [name for name in strangers.FILES if name not in RIGID]
AWAY = 2000.0
"""What reaches so far, mm, has flown away beside a place where the mechanism can hardly be drawn."""


def _letters(log: Construction, view: str) -> list[tuple[str, ...]]:
    """What a plan finds in its order, by what: of other lengths another pair of lines may cross best."""
    steps = (step for step in log.steps if step.it.view == view)
    return [(step.it.letter, *(mark.letter for mark in step.uses)) for step in steps]


def _outcomes(scene: Scene, own: Drawn) -> Counter[str]:
    """Return how ink of a scene follows three other sets of lengths; a stroke that is wrong fails."""
    tied = _tied(_dense(own))
    count = Counter[str]()
    for share in SHARES:
        there = _dense(drawn_alike(other(scene, share), own))
        angles = tuple(range(3, there.whole, max(there.whole // ANGLES, 1)))
        values = values_of(tied.among, there.drawn.reading, angles, there.whole)
        for moving in _moving(there.drawn):
            if _letters(there.log, moving.name) != _letters(own.construction, moving.name):
                continue
            for t, k in enumerate(angles):
                due = _ink(moving.at(k)) if k not in there.drawn.undrawn else {}
                reach = max((abs(z) for row in due.values() for z in row), default=np.inf)
                if reach < AWAY:
                    found = list(_judged(due, tied.ties[moving.name], values, t))
                    wrong = [key for how, key in found if how == "wrong"]
                    strokes = [key for key in wrong if isinstance(key, MovingStroke)]
                    assert not strokes, (share, moving.name, k, strokes[:3])
                    count.update(how for how, _ in found)
    assert count["wrong"] <= LETTERS * count.total(), count
    return count


@pytest.mark.slow
@pytest.mark.turns(3)
@pytest.mark.parametrize("name", OWN)
def test_ink_follows_other_lengths_or_is_hidden(name: str) -> None:
    count = _outcomes(gallery.scene(name), gallery.in_usual(name))
    assert count["live"] >= LIVE * count.total(), count


@pytest.mark.slow
@pytest.mark.turns(2)
@pytest.mark.parametrize("name", OTHERS)
def test_ink_of_strangers_does_so_too(name: str) -> None:
    """Where a mechanism locks, guides as long as their travel are hidden: no whole degree is its end."""
    own = strangers.mechanism_of(name)
    count = _outcomes(strangers.stranger(name), own)
    locks = len(_dense(own).drawn.undrawn) > 0
    assert count["live"] >= (0.3 if locks else LIVE) * count.total(), count


PAGE = """
import { LiveInk } from "./live/liveink.js";
const ink = new LiveInk(asked.ties, asked.marks.length, asked.marks.map((_, k) => k), (k) => asked.marks[k]);
const parts = asked.variants.map((own) => ink.expressions.nodesOf(own));
tell(asked.marks.map((_, k) => {
  const { re, im } = ink.expressions;
  return asked.variants.map((own, n) => {
    ink.at(k, parts[n]);
    const found = ink.expressions.drawn(own);
    return found === undefined ? null : [own.indexOf(found), found[1].map((node) => [re[node], im[node]])];
  });
}));
"""


def test_the_page_calculates_what_python_does() -> None:
    found = _dense(gallery.in_usual("offset-slider"))
    made = {one.name: strands(found, one) for one in _moving(found.drawn)}
    ties, reading = FigureTies(found, _moving, made), found.drawn.reading
    every = [own for figure in ties.ties.values() for own in figure.values() if own]
    wanted = {node for own in every for one in own for node in one.nodes}
    slots = {int(node.of[0]) for node in _nodes(ties.among, wanted) if node.op == "mark"}
    marks = [
        [
            _mark(reading.values[slot], k) if slot in slots else None
            for slot in range(max(slots) + 1)
        ]
        for k in range(found.whole)
    ]
    packed = [ties.pack.variants(own) for own in every]
    told = run(PAGE, {"ties": ties.data(), "marks": marks, "variants": packed})
    values = values_of(ties.among, reading, range(found.whole), found.whole, wanted)
    for n, own in enumerate(every):
        holds = holding(own, values)
        for k in range(found.whole):
            due = next((j for j, there in enumerate(holds) if there[k]), None)
            if told[k][n] is None or due is None:
                assert told[k][n] is due is None, (k, own)
                continue
            which, places = told[k][n]
            assert which == due
            places = [complex(*place) for place in places]
            np.testing.assert_allclose(places, [values[j][k] for j in own[due].places], atol=1e-9)


def _nodes(among: Expressions, wanted: set[int]) -> Iterator[Node]:
    return (among.nodes[k] for k in among.needed(wanted))


def _mark(value: object, k: int) -> object:
    """Return a mark as a page has it."""
    if isinstance(value, Line | Arc):
        return dict(zip(value._fields, (_mark(part, k) for part in value), strict=True))
    assert isinstance(value, np.ndarray)
    own = value[0, k if value.shape[1] > 1 else 0]
    return {"re": own.real, "im": own.imag} if np.iscomplexobj(value) else float(own)
