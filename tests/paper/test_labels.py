"""Places for letters: no label on a label, leaders where a label stands away, lines broken under letters."""

from __future__ import annotations

import itertools

import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

from graphic_tmm.paper.drawing import Bezier, Label, Stroke, Wanted, arc, circle, line
from graphic_tmm.paper.labels import box, interrupt, leaders, place, shape

spots = st.builds(complex, st.integers(0, 60), st.integers(0, 60))
clouds = st.lists(spots, min_size=1, max_size=8, unique=True)


@settings(max_examples=60, deadline=None)
@given(clouds)
def test_no_label_stands_on_a_label(points: list[complex]) -> None:
    wanted = [Wanted(f"a_{k}", z, 3.5) for k, z in enumerate(points)]
    labels = place(wanted, [line("main", 0j, 60 + 60j)])
    for a, b in itertools.combinations(map(box, labels), 2):
        assert a.intersection(b).area == 0.0


def test_a_label_keeps_off_a_main_line_and_close_to_its_point() -> None:
    heavy = line("main", -50 + 0j, 50 + 0j)
    (label,) = place([Wanted("B", 0j, 5.0, 1.0)], [heavy])
    assert box(label).distance(shape(heavy)) > 0.3
    assert box(label).distance(shapely.Point(0, 0)) < 4.0


def test_a_preferred_direction_is_kept_where_there_is_room() -> None:
    (label,) = place([Wanted("7", 10 + 10j, 3.5, 1.0, toward=-1 + 0j)], [])
    assert box(label).centroid.x < 8.0


def test_a_label_that_stands_away_gets_a_leader() -> None:
    far = Label("s_2", 20 + 0j, 3.5)
    (leader,) = leaders([Wanted("s_2", 0j, 3.5)], [far])
    (x0, _, _), (x1, _, _) = leader.path
    assert (round(x0, 6), x1 < 20) == (1.0, True)
    assert leaders([Wanted("s_2", 0j, 3.5)], [Label("s_2", 2 + 0j, 3.5)]) == ()


def test_thin_lines_are_broken_at_letters_and_nothing_else_is() -> None:
    label = Label("O", -2 - 2j, 5.0)
    thin, heavy = line("thin", -30 + 0j, 30 + 0j), line("main", -30 + 1j, 30 + 1j)
    made = interrupt([thin, heavy], [label])
    pieces = [stroke for stroke in made if isinstance(stroke, Stroke) and stroke.pen == "thin"]
    assert len(pieces) == 2
    assert heavy in made
    for piece in pieces:
        assert shape(piece).distance(box(label)) > 0.3
    assert interrupt([thin], []) == (thin,)


def test_arcs_and_curves_have_their_shape() -> None:
    quarter = shape(arc("thin", 0j, 10.0, 0.0, 90.0))
    assert abs(quarter.length - 15.708) < 0.1
    assert abs(shape(circle("thin", 5 + 0j, 2.0)).length - 12.566) < 0.1
    smooth = shape(Bezier("thin", (0j, 1 + 0j, 2 + 0j, 3 + 0j)))
    assert abs(smooth.length - 3.0) < 1e-9
