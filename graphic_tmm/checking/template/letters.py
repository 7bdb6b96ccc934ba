"""A picture of the plans that a template asks for: it shows which segment is called what.

Where a plan is drawn in other positions, too, one of these is shown: who is to draw a plan shall not copy it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from graphic_tmm.checking.cells import pointed, points
from graphic_tmm.checking.overlay import plan_view
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.paper.drawing import Drawing, Sheet
from graphic_tmm.paper.lettering.letters import escape
from graphic_tmm.paper.packing import bounds
from graphic_tmm.paper.views import captioned
from graphic_tmm.scene.captions import captions

GAP = 12.0
"""Between plans, and about them, mm: the letters at their rims stand clear. Chosen by eye."""
APART = 10.0
"""Points so far apart, mm, have room for their letters."""
FORMAT = "A4"
"""The format whose pens and letters the picture has."""


def letters_sheet(made: DrawnScene, places: Mapping[str, str]) -> Sheet | None:
    """Return the plans side by side, each in one position; None where no plan has letters.

    ``places``: the position that is asked for, by plan.
    """
    language = made.scene.language
    words, there = captions(language), points(made)
    views = []
    for plan, place in places.items():
        clear: dict[str, float] = {}
        for name in dict.fromkeys(name for p, _, name in there if p == plan):
            clear[name] = _clear(
                [0j, *(z for (p, _, n), z in there.items() if (p, n) == (plan, name))]
            )
        if plan not in pointed() or not clear:
            continue
        name = max(clear, key=lambda name: (name != place, clear[name]))
        title = f"{words.get(plan, plan)}, {words['position']} {escape(name)}"
        views.append(captioned(plan_view(made, plan, name, (), title), title))
    return _beside(views, made.scene.title, language) if views else None


def _clear(spots: Sequence[complex]) -> float:
    """Return how clear of one another points stand: their distances to the nearest, `APART` at most, mm."""
    far = [
        min((abs(one - two) for j, two in enumerate(spots) if j != k), default=0.0)
        for k, one in enumerate(spots)
    ]
    return sum(min(one, APART) for one in far)


def _beside(views: list[Drawing], title: str, language: str) -> Sheet:
    """Return a paper as large as views side by side are."""
    moved, right, high = [], GAP, 0.0
    for view in views:
        left, low, end, top = bounds(view)
        moved.append(view.moved(complex(right - left, GAP - low)))
        right += end - left + GAP
        high = max(high, top - low)
    return Sheet("letters", title, FORMAT, right, high + 2.0 * GAP, tuple(moved), language)
