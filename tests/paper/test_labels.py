"""Places for letters: no label on a label, leaders where a label stands away, lines broken under letters."""

from __future__ import annotations

import cmath
import itertools
import math
import random

import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st
from support.each import each
from support.examples import most

from graphic_tmm.paper.drawing import Bezier, Label, Stroke, Wanted, arc, circle, line
from graphic_tmm.paper.labels import interrupt, leaders, place
from graphic_tmm.paper.shapes import box, shape

spots = st.builds(complex, st.integers(0, 60), st.integers(0, 60))
clouds = st.lists(spots, min_size=1, max_size=8, unique=True)


@settings(max_examples=most(60), deadline=None)
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


def field(seed: int, count: int) -> tuple[list[Wanted], list[Stroke]]:
    """Points close to each other, each with a label of one to three letters; lines of two kinds among them."""
    chance = random.Random(seed)

    def spot() -> complex:
        return complex(chance.uniform(0, 70), chance.uniform(0, 50))

    wanted = [
        Wanted("abc"[: chance.randint(1, 3)] + f"_{{{k}}}", spot(), 3.5) for k in range(count)
    ]
    lines = [
        line(chance.choice(("thin", "thin", "medium")), spot(), spot()) for _ in range(count // 2)
    ]
    return wanted, lines


@each("seed", range(12))
def test_no_leader_is_read_as_a_minus(seed: int) -> None:
    """None is short, and none stands level with the letters of its label."""
    wanted, lines = field(seed, 30)
    labels = place(wanted, lines)
    rows = zip(wanted, labels, strict=True)
    drawn = leaders(wanted, labels)
    frames = [
        box(k) for one, k in rows if box(k).distance(shapely.Point(one.at.real, one.at.imag)) > 3.2
    ]
    assert len(drawn) == len(frames)
    for leader, frame in zip(drawn, frames, strict=True):
        (x0, y0, _), (x1, y1, _) = leader.path
        low, high = frame.bounds[1], frame.bounds[3]
        band = (low + high) / 2
        level = abs(y1 - y0) < math.tan(math.radians(20)) * abs(x1 - x0)
        length = math.hypot(x1 - x0, y1 - y0)
        assert length >= 5.9
        assert not (level and abs(y1 - band) < 2.0 and length < 8.0)


@each("seed", range(12))
def test_labels_of_a_crowded_field_stand_apart_and_off_heavy_lines(seed: int) -> None:
    wanted, lines = field(100 + seed, 30)
    labels = place(wanted, lines)
    boxes = [box(label) for label in labels]
    assert all(a.disjoint(b) for a, b in itertools.combinations(boxes, 2))
    ink = interrupt([*lines, *leaders(wanted, labels)], labels)
    thin = [shape(stroke) for stroke in ink if stroke.pen == "thin"]
    assert all(a.disjoint(b) for a in boxes for b in thin)
    heavy = [shape(stroke) for stroke in ink if stroke.pen == "medium"]
    assert not any(a.intersects(b) for a in boxes for b in heavy)


@each("seed", range(12))
def test_no_leader_passes_another_label_so_that_one_breaks_the_other(seed: int) -> None:
    wanted, lines = field(200 + seed, 14)
    labels = place(wanted, lines)
    for one, own in zip(wanted, labels, strict=True):
        for leader in leaders([one], [own]):
            others = [box(label) for label in labels if label is not own]
            assert all(shape(leader).distance(other) > 0.4 for other in others), own.text


@each("seed", (0, 10, 11, 14, 19, 37, 42))
def test_about_a_slender_polygon_a_letter_without_room_is_placed_first(seed: int) -> None:
    """Placed once, in the order wanted, a leader passes another letter in each of these (7 of 60 drawings)."""
    pick = random.Random(seed)
    corners = [0j, 60 - 10j, 60 - 12j, -2j, 0j]
    wanted = []
    for k in range(9):
        along = pick.choice((0.0, 1.0, 3.0, 58.0, 60.0))
        at = along * (1 - 1j / 6) - pick.choice((0, 1, 2)) * 1j
        wanted.append(Wanted(str(k), at, 3.5, 0.5))
    for _ in range(8):
        at = pick.uniform(0, 60) * (1 - 1j / 6) - pick.choice((0, 2)) * 1j
        wanted.append(Wanted(r"\bar{R}_{03}^{n}", at, 5.0, 0.5))
    labels = place(wanted, [line("main", a, b) for a, b in itertools.pairwise(corners)])
    for one, own in zip(wanted, labels, strict=True):
        for leader in leaders([one], [own]):
            others = [box(label) for label in labels if label is not own]
            assert all(shape(leader).distance(other) > 0.4 for other in others), own.text


def test_leaders_go_through_other_lettered_points_only_where_there_is_hardly_another_way() -> None:
    """Twelve points on 24 by 12 mm, joined one after the other: 5 % of the leaders; 24 % if it cost nothing."""
    through = count = 0
    for seed in range(40):
        pick, spots = random.Random(seed), list[complex]()
        while len(spots) < 12:
            spot = complex(pick.uniform(0, 24), pick.uniform(0, 12))
            spots += [spot] if all(abs(spot - other) > 2.2 for other in spots) else []
        wanted = [
            Wanted(f"{letter}_1", z, 3.5) for letter, z in zip("abcdefghiklm", spots, strict=True)
        ]
        walls = [line("main", a, b) for a, b in itertools.pairwise(spots)]
        for one, own in zip(wanted, place(wanted, walls), strict=True):
            for leader in leaders([one], [own]):
                count += 1
                others = [shapely.Point(z.real, z.imag) for z in spots if abs(z - one.at) > 2.0]
                through += any(shape(leader).distance(other) < 1.0 for other in others)
    assert count > 150
    assert through <= 0.1 * count


def level(a: Label, b: Label) -> float:
    """The gap between two labels that stand level with each other, mm; infinite if they do not."""
    (x0, y0, x1, y1), (u0, v0, u1, v1) = box(a).bounds, box(b).bounds
    if min(y1, v1) - max(y0, v0) < 0.6 * min(y1 - y0, v1 - v0):
        return math.inf
    return max(u0 - x1, x0 - u1)


@pytest.mark.parametrize("apart", [9.0, 10.0, 11.0, 12.0])
def test_letters_of_two_vectors_side_by_side_do_not_read_as_a_product(apart: float) -> None:
    wanted = [
        Wanted(text, complex(at), 5.0, 1.0, 1j)
        for text, at in (("R_{34}", 0.0), ("R_{34}^n", apart))
    ]
    assert level(*place(wanted, [])) > 3.5


@pytest.mark.parametrize("long", [3.0, 4.0])
def test_a_stroke_between_two_labels_does_not_read_as_a_minus(long: float) -> None:
    taken = Label("S_2", -4.0 - 1.75j, 3.5)
    (_, low, right, high) = box(taken).bounds
    middle = (low + high) / 2
    stroke = line("thin", complex(right + 1, middle), complex(right + 1 + long, middle))
    one = Wanted("1", complex(right + 2 + long, middle), 3.5, 1.0, 1 + 0j)
    (label,) = place([one], [stroke._replace(data=(("mm", "3"),))], [taken])
    low, high = box(label).bounds[1::2]
    assert level(taken, label) > 8.0 or abs((low + high) / 2 - middle) > 1.2


def test_a_leader_leads_past_other_points_that_bear_letters() -> None:
    """Its own point is hemmed in; the nearest way out goes through another point."""
    walls = [line("main", complex(x, -14), complex(x, 6)) for x in (-2.0, 2.0)]
    walls += [line("main", complex(-2, -14), complex(2, -14))]
    walls += [line("main", complex(x, y), complex(x + 9, y)) for x in (-11, 2) for y in (-3, 2, 6)]
    wanted = [Wanted("b_4", 7j, 3.5, toward=1j), Wanted("s_3", 0j, 3.5)]
    labels = place(wanted, walls)
    for leader in leaders(wanted[1:], labels[1:]):
        assert shape(leader).distance(shapely.Point(0, 7)) > 0.9


def fine(stroke: Stroke | Bezier) -> shapely.LineString:
    """A stroke as a polyline of short pieces."""
    if not isinstance(stroke, Bezier):
        return shape(stroke)
    spots = []
    for k in range(0, len(stroke.controls) - 1, 3):
        a, b, c, d = stroke.controls[k : k + 4]
        for u in (n / 300 for n in range(301)):
            v = 1 - u
            spots.append(v**3 * a + 3 * v * v * u * b + 3 * v * u * u * c + u**3 * d)
    return shapely.LineString([(z.real, z.imag) for z in spots])


@each("seed", range(20))
def test_circles_arcs_and_curves_are_broken_too_and_keep_their_kind(seed: int) -> None:
    """What is left runs along the old line, and together with what stands under the letter is all of it."""
    chance = random.Random(seed)
    label = Label("O_2", complex(chance.uniform(-9, 5), chance.uniform(-9, 5)), 5.0)
    controls = tuple(complex(chance.uniform(-15, 15), chance.uniform(-15, 15)) for _ in range(7))
    for stroke in (
        circle("thin", 0j, chance.uniform(6, 10)),
        arc("centre", 1 + 1j, 8.0, chance.uniform(0, 360), chance.uniform(40, 350)),
        Bezier("thin", controls),
    ):
        marked = stroke._replace(of=(3, 5), position=2, part="link")
        made = interrupt([marked], [label])
        frame = box(label).buffer(0.4, join_style="mitre")
        whole = fine(stroke)
        left = sum(fine(one).length for one in made)
        due = whole.difference(frame).length
        assert left <= due + 0.05 * whole.length
        assert left >= due - 0.05 * whole.length - 0.8 * (len(made) + 2)
        for one in made:
            assert (type(one), one.of, one.position, one.part) == (type(stroke), (3, 5), 2, "link")
            assert whole.buffer(0.2).covers(fine(one))
            assert fine(one).intersection(frame.buffer(-0.1)).length < 0.2


@pytest.mark.parametrize("seed", range(8))
def test_large_circles_and_curves_are_broken_under_letters_too(seed: int) -> None:
    """However large a circle is, its chords do not stand for it: what is left of it clears the letters."""
    chance = random.Random(seed)
    radius = 10 ** chance.uniform(1.5, 3)
    ends = [radius * cmath.exp(1j * turn) for turn in (0.0, 1.5)]
    rims = [
        circle("thin", 0j, radius),
        Bezier("thin", (ends[0], ends[0] * (1 + 0.5j), ends[1], 0j)),
    ]
    turns = [chance.uniform(0.1, 1.4) for _ in range(4)]
    wanted = [Wanted("b_2", radius * cmath.exp(1j * turn), 5.0) for turn in turns]
    for rim in rims:
        labels = place(wanted, [rim])
        left = [fine(one) for one in interrupt([rim], labels)]
        if not isinstance(rim, Bezier):
            left = [arcs(one) for one in interrupt([rim], labels)]
        assert not any(one.intersects(box(k)) for one in left for k in labels)


def arcs(stroke: Stroke | Bezier) -> shapely.LineString:
    """A stroke of arcs about the origin as a polyline of short pieces."""
    assert isinstance(stroke, Stroke)
    spots = [complex(x, y) for x, y, _ in stroke.path]
    made: list[complex] = []
    for a, b in itertools.pairwise(spots + spots[: stroke.closed]):
        way = cmath.phase(b / a) % math.tau
        made += [a * cmath.exp(1j * way * k / 2000) for k in range(2001)]
    return shapely.LineString([(z.real, z.imag) for z in made])


def test_hatching_vanishes_under_a_letter_and_what_says_something_does_not() -> None:
    label = Label("O", -2 - 2j, 5.0)
    short = line("thin", -0.5 + 0j, 0.5 + 0.5j)
    assert interrupt([short, short._replace(part="hatching")], [label]) == (short,)


@pytest.mark.parametrize("seed", range(6))
def test_letters_keep_off_short_lines(seed: int) -> None:
    """Of which nothing would be left."""
    chance = random.Random(seed)
    dash = line("thin", 2 + 2j, 2 + 2j + 2 * cmath.exp(1j * chance.uniform(0, math.pi)))
    (label,) = place([Wanted("A_3", 0j, 3.5, toward=1 + 1j)], [dash])
    assert box(label).disjoint(shape(dash))


def test_what_a_page_tells_the_length_of_is_not_broken() -> None:
    told = line("thin", -30 + 0j, 30 + 0j)._replace(data=(("mm", "60"),))
    assert interrupt([told], [Label("O", -2 - 2j, 5.0)]) == (told,)
