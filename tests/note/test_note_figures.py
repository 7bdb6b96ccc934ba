"""In which letters figures of a note are drawn: as if each had been drawn at every size."""

from __future__ import annotations

import random
from collections.abc import Callable, Iterable

import pytest
from support.gallery import ALL, in_usual, usual

from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.views import drawing_of
from graphic_tmm.note.figures import (
    LEGIBLE,
    LETTERED,
    SPARE,
    in_hand,
    is_figure,
    least_letter,
    readable,
)
from graphic_tmm.paper.drawing import Drawing, Label, line
from graphic_tmm.scene.chapter import places

Draw = Callable[[Drawn], Iterable[Drawing]]


def tried_at_every_size(drawn: Drawn, draw: Draw) -> dict[str, Drawing]:
    """The first of all sizes in which a figure can be read; that of the largest letters if it never can."""
    sizes = [{v.name: v for v in draw(in_hand(drawn, times)) if is_figure(v)} for times in LETTERED]
    found = {}
    for name in sizes[0]:
        views = [some[name] for some in sizes]
        read = [view for view in views if least_letter([view]) >= SPARE * LEGIBLE]
        found[name] = read[0] if read else max(views, key=lambda view: least_letter([view]))
    return found


def boxes(pick: random.Random) -> Draw:
    """What draws some boxes, each with letters that grow or none, or growing itself about letters too small."""
    some = [
        (pick.uniform(5, 400), pick.uniform(5, 400), pick.choice((0, 0.5, 1, 2, -1)), pick.random())
        for _ in range(pick.randint(1, 3))
    ]

    def draw(held: Drawn) -> list[Drawing]:
        assert held.scene.letters is not None
        high = held.scene.letters[0]
        return [_box(f"box {k}", high, *one) for k, one in enumerate(some)]

    return draw


def _box(name: str, high: float, wide: float, tall: float, share: float, at: float) -> Drawing:
    if share >= 0:
        edge, size = complex(wide, tall), high * share
    else:  # its letters are too small in every size
        edge, size = complex(wide, tall) * high, 1.5
    letters = Label("abc", edge.real * at + 1j * edge.imag * at, size)
    return Drawing(
        name, "A box", strokes=(line("main", 0j, edge),), labels=(letters,) if share else ()
    )


def test_boxes_at_random_are_lettered_as_if_drawn_at_every_size() -> None:
    drawn, kept = in_usual("crank-rocker"), set()
    for seed in range(60):
        draw = boxes(random.Random(seed))
        due = tried_at_every_size(drawn, draw)
        assert {view.name: view for view in readable(drawn, draw)} == due, seed
        kept |= {view.labels[0].size for view in due.values() if view.labels}
    assert len(kept) > len(LETTERED)


@pytest.mark.slow
@pytest.mark.turns(3)
@pytest.mark.parametrize("name", ALL)
def test_figures_of_a_scene_are_lettered_as_if_drawn_at_every_size(name: str) -> None:
    for drawn in usual(name).boards:
        own = (name for name, (chapter, _) in places().items() if chapter.board == drawn.board)
        for place in drawn.scene.shown_places & {*own}:
            draw = drawing_of(place)
            due = tried_at_every_size(drawn, lambda held, draw=draw: draw(held, True))
            found = readable(drawn, lambda held, draw=draw: draw(held, True))
            assert [_still(view) for view in found] == list(map(_still, due.values())), place


def _still(view: Drawing) -> Drawing:
    """A view without what draws its parts, which is another function each time."""
    return view._replace(apart=None)
