"""A mistake planted in an honest drawing is named; none is named by force."""

from __future__ import annotations

from collections.abc import Callable, Iterable

import pytest
from support.gallery import exact
from support.trials import Planted, planted, plants, readings, usual

from graphic_tmm.checking.cells import cells
from graphic_tmm.checking.judging.judge import judge
from graphic_tmm.checking.mistakes.catalogue import CATALOGUE
from graphic_tmm.checking.mistakes.likely import Alternatives, likely
from graphic_tmm.checking.records import WRONG

SCENES = (
    "engine",
    "crank-rocker",
    "shaper",
    "offset-slider",
    "accelerating-crank",
    "slider-diagrams",
)
"""Scenes of which some have every mistake; the benchmark of hands plants in all scenes of the package."""
USUAL = ("crank-rocker", "shaper", "slider-diagrams")
"""Of them those that the suite has time for: a rocker, a stone, diagrams."""
PART = ", one "
"""What a label of a mistake says that befalls one position or one reading only."""


def total(found: Iterable[tuple[str, Planted]], part: bool) -> Planted:
    return sum((one for label, one in found if (PART in label) == part), Planted())


@pytest.mark.slow
@pytest.mark.parametrize("kind", range(len(USUAL)), ids=USUAL)
def test_a_planted_mistake_is_named_first(kind: int, many: Callable[[int, int], int]) -> None:
    """With ``--measured`` in the other scenes, too."""
    others = [name for name in SCENES if name not in USUAL]
    for name in (USUAL[kind], *others[kind : kind + many(1, 0)]):
        found = planted(name, 1).items()
        whole, part = total(found, False), total(found, True)
        assert whole.seen >= 10
        assert whole.first >= 0.9 * whole.seen
        assert whole.some >= 0.95 * whole.seen
        assert part.seen >= 5
        assert part.first >= 0.9 * part.seen


@pytest.mark.slow
def test_every_mistake_of_the_catalogue_is_planted_somewhere() -> None:
    names = {called for name in (*SCENES, "lever") for _, called, _ in plants(name)}
    assert {mistake.name for mistake in CATALOGUE} <= names


@pytest.mark.slow
def test_an_inertia_force_that_is_not_reversed_is_named_first() -> None:
    one = total(planted("lever", 1, only="inertia not reversed").items(), False)
    assert one.first == one.seen == 1


@pytest.mark.slow
def test_honest_wrong_readings_are_not_explained_by_force() -> None:
    due = cells(exact("engine"))
    rows = [t for t in readings(due, due) if t.plan == "velocities" and t.mm is not None]
    off = [
        t._replace(mm=(t.mm or 0.0) + 17.3 + 3.1 * k) if k % 9 == 0 else t
        for k, t in enumerate(rows)
    ]
    by = usual("engine", "student")
    judged = judge(exact("engine"), off, by)
    told = likely(Alternatives(exact("engine")), judged, by.spread, "en")
    count = sum(one.verdict == WRONG for one in judged)
    assert count > 3
    assert all(len(one.lines) < count for one in told if one.name != "another segment")
